#pragma once
// A part that is scrolled up and down only.

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace bask {

/// Never narrower than what is in it, which nothing would bring into view.
class UprightScroll : public QScrollArea {
public:
    explicit UprightScroll(QWidget* content, QWidget* parent, int min_px = 0)
        : QScrollArea(parent), m_min_px(min_px) {
        setWidget(content); // whose events it sees from then on
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setFocusPolicy(Qt::NoFocus);
    }
    QSize minimumSizeHint() const override {
        return {
            std::max(m_min_px, widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width()),
            QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) // of another language, say
            updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }

private:
    int m_min_px;
};

} // namespace bask
