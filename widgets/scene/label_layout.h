#pragma once
// Places labels near their anchors so that they hide neither each other nor anything marked as taken.

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <limits>
#include <vector>

namespace bask {

/// Greedy layout in the order asked. Remembers where a label stood last time and keeps it there while that is
/// about as good, so that labels do not jump as objects move.
class LabelLayout {
public:
    /// Starts a new picture. Labels stay within `area`.
    void begin(QRectF area);
    /// Nothing is to be put on this, if it can be helped; `weight` 1 is as bad as hiding another label.
    void take(QRectF rect, double weight = 1.0);
    bool isFree(const QRectF& rect) const;
    /// Where label number `key` goes: beside the anchor, which has a size of its own. Takes the place; or
    /// gives an empty rectangle and takes none when every place costs more than `max` (1: a quarter of the
    /// label hides another).
    QRectF place(std::size_t key, QRectF anchor, QSizeF size,
                 double max = std::numeric_limits<double>::infinity());

private:
    struct Taken {
        QRectF rect;
        double weight = 1.0;
    };
    double cost(const QRectF& rect) const;

    QRectF m_area;
    std::vector<Taken> m_taken;
    std::vector<int> m_last; ///< candidate chosen last time, by key; -1: none
};

} // namespace bask
