#include "widgets/common/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {

namespace {

// Directions in order of liking: right, left, above, below, then the corners (y down).
constexpr std::array<std::array<double, 2>, 8> kDirections{
    {{1.0, 0.0}, {-1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}, {0.8, -0.8}, {-0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}}};
constexpr std::array<double, 4> kDistances{8.0, 22.0, 44.0, 80.0};

constexpr double kLineStep_px = 8.0;
constexpr double kMaxLinePoints = 1000.0; ///< of a piece that is much longer than the view is wide
/// Of each point of a line that is covered: a line along a label is about as bad as another label under it.
constexpr double kLinePointCost = 0.4;

double areaOf(const QRectF& rect) {
    return std::max(0.0, rect.width()) * std::max(0.0, rect.height());
}

QRectF candidate(int index, const QRectF& anchor, QSizeF size) {
    const auto& direction = kDirections[static_cast<std::size_t>(index) % kDirections.size()];
    const double distance = kDistances[static_cast<std::size_t>(index) / kDirections.size()];
    const QPointF centre =
        anchor.center() + QPointF(direction[0] * (0.5 * (anchor.width() + size.width()) + distance),
                                  direction[1] * (0.5 * (anchor.height() + size.height()) + distance));
    return {centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
}

} // namespace

void LabelLayout::begin(QRectF area) {
    m_area = area;
    m_taken.clear();
    m_lines.clear();
}

void LabelLayout::take(QRectF rect, double weight) {
    m_taken.push_back({rect, weight});
}

void LabelLayout::takeLine(const QPolygonF& line) {
    double left = 0.0; // until the next point
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF way = line[i] - line[i - 1];
        const double length = std::hypot(way.x(), way.y());
        if (!std::isfinite(length))
            continue;
        const double step = std::max(kLineStep_px, length / kMaxLinePoints);
        double at = left;
        for (; at < length; at += step)
            if (const QPointF point = line[i - 1] + at / length * way; m_area.contains(point))
                m_lines.push_back(point);
        left = at - length;
    }
}

bool LabelLayout::crossesLine(const QRectF& rect) const {
    return std::ranges::any_of(m_lines, [&](const QPointF& point) { return rect.contains(point); });
}

bool LabelLayout::isFree(const QRectF& rect) const {
    return std::none_of(m_taken.begin(), m_taken.end(),
                        [&rect](const Taken& taken) { return taken.rect.intersects(rect); });
}

double LabelLayout::cost(const QRectF& rect) const {
    const double own = std::max(1.0, areaOf(rect));
    double sum = 4.0 * (1.0 - areaOf(rect & m_area) / own);
    for (const Taken& taken : m_taken)
        sum += 4.0 * taken.weight * areaOf(rect & taken.rect) / own;
    const auto covered =
        std::ranges::count_if(m_lines, [&](const QPointF& point) { return rect.contains(point); });
    return sum + kLinePointCost * static_cast<double>(covered);
}

QRectF LabelLayout::place(std::size_t key, QRectF anchor, QSizeF size, double max) {
    if (key >= m_last.size())
        m_last.resize(key + 1, -1);
    constexpr int kCount = static_cast<int>(kDirections.size() * kDistances.size());
    double min = std::numeric_limits<double>::infinity();
    int best = 0;
    for (int i = 0; i < kCount; ++i) {
        const int ring = i / static_cast<int>(kDirections.size());
        const int direction = i % static_cast<int>(kDirections.size());
        const double liking = 0.5 * ring + 0.04 * direction - (i == m_last[key] ? 0.3 : 0.0);
        const double hidden = cost(candidate(i, anchor, size));
        const double total = hidden + liking;
        if (hidden <= max && total < min) {
            min = total;
            best = i;
        }
    }
    if (!std::isfinite(min))
        return {};
    m_last[key] = best;
    QRectF rect = candidate(best, anchor, size);
    rect.moveLeft(
        std::clamp(rect.left(), m_area.left(), std::max(m_area.left(), m_area.right() - rect.width())));
    rect.moveTop(
        std::clamp(rect.top(), m_area.top(), std::max(m_area.top(), m_area.bottom() - rect.height())));
    take(rect);
    return rect;
}

} // namespace bask
