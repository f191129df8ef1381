#pragma once
// Keeps a bar over the lower edge of a page, so that nothing moves under the pointer when it comes and goes.

#include <QObject>

class QWidget;

namespace bask {

/// Places `bar` over what is seen of `page`, in its middle, as high as its words need. It belongs to the bar,
/// which becomes a child of the page.
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
