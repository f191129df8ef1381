#pragma once
// Keeps a bar over the lower edge of a page, so that nothing moves under the pointer when it comes and goes.

#include <QObject>

class QWidget;

namespace bask {

/// Places `bar`, a child of `page` in no layout, over what is seen of the page, in its middle, as high as its
/// words need. It belongs to the bar.
class FloatingPlace : public QObject {
    Q_OBJECT

public:
    FloatingPlace(QWidget& bar, QWidget& page);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QWidget& m_bar;
    QWidget& m_page;
};

} // namespace bask
