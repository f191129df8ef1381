#include "engine/simulation/area_paint.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

/// Of pixels; right and bottom are beyond the last.
struct Box {
    int left, top, right, bottom;

    bool isEmpty() const { return left >= right || top >= bottom; }
    std::size_t stride() const { return static_cast<std::size_t>(right - left) + 2; }
};

Box boxOf(std::span<const Ring> rings, const GreyCanvas& canvas) {
    Eigen::Array2d lower(HUGE_VAL, HUGE_VAL), upper = -lower;
    for (const Ring& ring : rings)
        for (const Eigen::Vector2d& p : ring) {
            lower = lower.min(p.array());
            upper = upper.max(p.array());
        }
    const auto within = [](double v, int size) {
        return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
    };
    return {
        within(std::floor(lower.x() + 0.5), canvas.width), within(std::floor(lower.y() + 0.5), canvas.height),
        within(std::ceil(upper.x() + 0.5), canvas.width), within(std::ceil(upper.y() + 0.5), canvas.height)};
}

// An edge's part in one row, from x0 to x1 (least first) in columns of the box: what lies right of it is
// covered by `d` more.
void addPiece(float* row, double x0, double x1, double d) {
    const int first = static_cast<int>(x0), last = static_cast<int>(std::ceil(x1));
    if (last <= first + 1) {
        const double right = 0.5 * (x0 + x1) - first;
        row[first] += static_cast<float>(d * (1.0 - right));
        row[first + 1] += static_cast<float>(d * right);
        return;
    }
    // Share of each column that is left uncovered: the integral of the edge's height over it.
    const double slope = d / (x1 - x0);
    double before = 0.0;
    for (int x = first; x < last; ++x) {
        const double from = std::max(x0, static_cast<double>(x)), to = std::min(x1, x + 1.0);
        const double covered = slope * (to - from) * (x + 1.0 - 0.5 * (from + to)) + slope * (from - x0);
        row[x] += static_cast<float>(covered - before);
        before = covered;
    }
    row[last] += static_cast<float>(d - before);
}

void addEdge(std::vector<float>& change, const Box& box, Eigen::Vector2d a, Eigen::Vector2d b) {
    const Eigen::Vector2d shift(0.5 - box.left, 0.5 - box.top);
    a += shift;
    b += shift;
    if (a.y() == b.y())
        return;
    const double sign = a.y() < b.y() ? 1.0 : -1.0;
    if (sign < 0.0)
        std::swap(a, b);
    const double slope = (b.x() - a.x()) / (b.y() - a.y());
    const double width = box.right - box.left, height = box.bottom - box.top;
    const double end = std::min(b.y(), height);
    for (double y = std::max(a.y(), 0.0); y < end;) {
        const double row = std::floor(y), next = std::min(row + 1.0, end);
        const double x = std::clamp(a.x() + slope * (y - a.y()), 0.0, width);
        const double xNext = std::clamp(a.x() + slope * (next - a.y()), 0.0, width);
        addPiece(change.data() + static_cast<std::size_t>(row) * box.stride(), std::min(x, xNext),
                 std::max(x, xNext), sign * (next - y));
        y = next;
    }
}

} // namespace

void AreaPainter::paint(GreyCanvas& canvas, std::span<const Ring> rings, float grey) {
    const Box box = boxOf(rings, canvas);
    if (box.isEmpty())
        return;
    m_change.assign(box.stride() * static_cast<std::size_t>(box.bottom - box.top), 0.0F);
    for (const Ring& ring : rings)
        for (std::size_t k = 0; k < ring.size(); ++k)
            addEdge(m_change, box, ring[k], ring[(k + 1) % ring.size()]);
    const float* change = m_change.data();
    for (int y = box.top; y < box.bottom; ++y, change += box.stride()) {
        float* const pixels =
            canvas.values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width);
        float sum = 0.0F;
        for (int x = box.left; x < box.right; ++x) {
            sum += change[x - box.left];
            pixels[x] += std::min(std::abs(sum), 1.0F) * (grey - pixels[x]);
        }
    }
}

} // namespace bask
