#include "engine/runtime/heat_fit.h"

#include <algorithm>

namespace bask {

HeatFit::HeatFit(LossRange losses) {
    // Otherwise errors of the energy would push constants at the edge out of the range, and others with them.
    constexpr double kBeyond = 1.25;
    const double minK = 1.0 / (kBeyond * kBorneFactor), maxK = kBeyond * kBorneFactor;
    const double minA = losses.min_1_s / kBeyond, maxA = kBeyond * losses.max_1_s;
    m_corners = {{minK, minA}, {maxK, minA}, {maxK, maxA}, {minK, maxA}};
}

HeatFit::Change HeatFit::expected(const HeatSpan& span) const {
    Change change{1e300, -1e300};
    for (const Eigen::Vector2d& corner : m_corners) { // the extremes of a linear function
        change.min_K = std::min(change.min_K, corner.x() * span.minEnergy_K - corner.y() * span.maxLoss_K_s);
        change.max_K = std::max(change.max_K, corner.x() * span.maxEnergy_K - corner.y() * span.minLoss_K_s);
    }
    return {change.min_K - span.unsure_K, change.max_K + span.unsure_K};
}

void HeatFit::learn(const HeatSpan& span, double change_K, double tolerance_K) {
    tolerance_K += span.unsure_K;
    clip(span.minEnergy_K, -span.maxLoss_K_s, change_K + tolerance_K);
    clip(-span.maxEnergy_K, span.minLoss_K_s, tolerance_K - change_K);
}

void HeatFit::clip(double u, double v, double w) {
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const Eigen::Vector2d& a = m_corners[i];
        const Eigen::Vector2d& b = m_corners[(i + 1) % m_corners.size()];
        const double overA = u * a.x() + v * a.y() - w, overB = u * b.x() + v * b.y() - w;
        if (overA <= 0.0)
            kept.push_back(a);
        if ((overA < 0.0 && overB > 0.0) || (overA > 0.0 && overB < 0.0))
            kept.push_back(a + overA / (overA - overB) * (b - a));
    }
    m_corners = std::move(kept);
}

} // namespace bask
