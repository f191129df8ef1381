#include "widgets/scene/source_glow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bask {

namespace {

/// Cells, with a margin of one all round, whose middle lies inside.
std::vector<char> insideOf(const std::vector<Eigen::Vector2d>& outline, const Eigen::AlignedBox2d& box,
                           int n) {
    std::vector<char> inside(static_cast<std::size_t>((n + 2) * (n + 2)), 0);
    const Eigen::Vector2d step = box.sizes() / n;
    for (int row = 0; row < n; ++row) {
        const std::vector<double> ends = outlineCrossings(outline, 0, box.min().y() + (row + 0.5) * step.y());
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
            for (int column = 0; column < n; ++column) {
                const double x = box.min().x() + (column + 0.5) * step.x();
                if (x > ends[k] && x < ends[k + 1])
                    inside[static_cast<std::size_t>((row + 1) * (n + 2) + column + 1)] = 1;
            }
    }
    return inside;
}

} // namespace

std::vector<Eigen::Vector2d> chained(const std::vector<std::vector<Eigen::Vector2d>>& rings) {
    std::vector<Eigen::Vector2d> chain = rings.front();
    for (std::size_t k = 1; k < rings.size(); ++k) {
        chain.push_back(rings.front().front());
        chain.insert(chain.end(), rings[k].begin(), rings[k].end());
        chain.push_back(rings[k].front());
    }
    return chain;
}

Eigen::AlignedBox2d boxOf(const std::vector<Eigen::Vector2d>& outline) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : outline)
        box.extend(p);
    return box;
}

std::vector<double> outlineCrossings(const std::vector<Eigen::Vector2d>& outline, int axis, double at) {
    const int across = 1 - axis;
    std::vector<double> crossings;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Eigen::Vector2d& a = outline[k];
        const Eigen::Vector2d& b = outline[(k + 1) % outline.size()];
        if ((a[across] <= at) != (b[across] <= at))
            crossings.push_back(a[axis] + (at - a[across]) / (b[across] - a[across]) * (b[axis] - a[axis]));
    }
    std::ranges::sort(crossings);
    return crossings;
}

std::vector<double> sourceGlow(const std::vector<Eigen::Vector2d>& outline, const Eigen::AlignedBox2d& box,
                               int n) {
    const std::vector<char> inside = insideOf(outline, box, n);
    std::vector<double> u(inside.size(), 0.0);
    const Eigen::Vector2d step = box.sizes() / n;
    const double wx = 1.0 / (step.x() * step.x()), wy = 1.0 / (step.y() * step.y());
    const double overrelaxation = 2.0 / (1.0 + std::sin(std::numbers::pi / n));
    const int width = n + 2;
    for (int sweep = 0; sweep < 2 * n; ++sweep)
        for (int cell = width; cell < width * (width - 1); ++cell) {
            const auto at = [&](int offset) { return u[static_cast<std::size_t>(cell + offset)]; };
            if (inside[static_cast<std::size_t>(cell)] == 0)
                continue;
            const double settled =
                (1.0 + wx * (at(-1) + at(1)) + wy * (at(-width) + at(width))) / (2.0 * (wx + wy));
            u[static_cast<std::size_t>(cell)] += overrelaxation * (settled - at(0));
        }
    const double max = *std::ranges::max_element(u);
    std::vector<double> glow;
    glow.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int row = 1; row <= n; ++row)
        for (int column = 1; column <= n; ++column)
            glow.push_back(max > 0.0 ? u[static_cast<std::size_t>(row * width + column)] / max : 0.0);
    return glow;
}

} // namespace bask
