#pragma once
// Places labels near their anchors so that they cover neither each other nor anything marked as taken.

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QSizeF>

#include <limits>
#include <vector>

namespace bask {

/// Greedy layout in the order of the calls. Remembers the last position of a label and keeps it there while
/// that is about as good, so that labels do not jump when objects move.
class LabelLayout {
public:
    /// Starts a new picture. Labels stay within `area`.
    void begin(QRectF area);
    /// Marks an area that labels should avoid; `weight` 1 is as bad as covering another label.
    void take(QRectF rect, double weight = 1.0);
    /// Marks a line that labels should leave visible. What is outside of the area does not count.
    void takeLine(const QPolygonF& line);
    bool isFree(const QRectF& rect) const;
    /// Whether a line of takeLine() runs through it.
    bool crossesLine(const QRectF& rect) const;
    /// Returns the place of label number `key`, beside the anchor, which has its own size, and marks it as
    /// taken. Returns an empty rectangle if every place costs more than `max` (1: a quarter of the label
    /// covers another).
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
    std::vector<QPointF> m_lines; ///< points of the lines, closer than a label is high
    std::vector<int> m_last;      ///< candidate chosen last time, by key; -1 for none
};

} // namespace bask
