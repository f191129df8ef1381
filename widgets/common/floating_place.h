#pragma once
// Keeps a bar over the lower edge of a page, so that nothing moves under the pointer when it comes and goes.

#include <QObject>

class QWidget;

namespace bask {

/// What a bar must not hide, if there is room above it: a property of widgets with so many px from their
/// lower edge, such as a plot's axis, or kWholeWidget_px.
inline constexpr const char* kKeptFree_px = "keptFree_px";
inline constexpr int kWholeWidget_px = 1 << 20;

/// Places `bar`, a child of `page` in no layout, over what is seen of the page, in its middle, as high as its
/// words need. It belongs to the bar.
class FloatingPlace : public QObject {
    Q_OBJECT

public:
    FloatingPlace(QWidget& bar, QWidget& page);

    /// Places a bar that is shown anew: something else is on the page.
    void place();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_bar;
    QWidget& m_page;
};

} // namespace bask
