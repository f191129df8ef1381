#pragma once
// Keeps bars over the lower part of a page, so that nothing moves under the pointer when they come and go.

#include <QObject>
#include <QPointer>
#include <QRect>

#include <initializer_list>
#include <vector>

class QWidget;

namespace bask {

/// What a bar must not hide, if there is room above it: a property of widgets with so many px from their
/// lower edge, such as a plot's axis, or kWholeWidget_px.
inline constexpr const char* kKeptFree_px = "keptFree_px";
inline constexpr int kWholeWidget_px = 1 << 20;

/// Places bars, children of `page` in no layout, over what is seen of the page, in its middle, each as high
/// as its words need: as low as no control and nothing that is kept free is under them, if there is such a
/// place. They do not lie over each other while there is room, and one that is shown stays where it is when
/// others come and go. The first lies over the others where there is none. It belongs to the page.
class FloatingPlace : public QObject {
    Q_OBJECT

public:
    FloatingPlace(QWidget& bar, QWidget& page) : FloatingPlace({&bar}, page) {}
    FloatingPlace(std::initializer_list<QWidget*> bars, QWidget& page);

    /// Places bars that are shown anew: something else is on the page.
    void place();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place(QWidget& bar, const std::vector<QRect>& others, int bottom);
    int lowest() const;
    QSize wantedSize(const QWidget& bar) const;
    QRect freePlace(const QRect& wanted, const std::vector<QRect>& others, int highest) const;
    void raiseInOrder();

    std::vector<QPointer<QWidget>> m_bars;
    QWidget& m_page;
};

} // namespace bask
