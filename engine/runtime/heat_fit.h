#pragma once
// Which heating and losses of an object explain what its sensor told: all of them, not the best.

#include "engine/runtime/heat_bounds.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// What lies between two moments: between which the absorbed energy (K, as estimated) and the time integral
/// of the temperature over the room's (K s) are.
struct HeatSpan {
    double minEnergy_K = 0.0, maxEnergy_K = 0.0;
    double minLoss_K_s = 0.0, maxLoss_K_s = 0.0;
};

/// The object's temperature changes by k E - a Q over a span, with constants k, by how much the estimated
/// power is wrong, and a, its losses. Keeps every (k, a) that explains all changes that it was shown: a
/// convex polygon, at first the whole of what may be.
class HeatFit {
public:
    explicit HeatFit(LossRange losses);

    struct Change {
        double min_K = 0.0, max_K = 0.0;
    };
    /// Between which the temperature changes over a span, by all that is left.
    Change expected(const HeatSpan& span) const;
    /// It changed by this, within the tolerance.
    void learn(const HeatSpan& span, double change_K, double tolerance_K);
    /// No constants explain all that was shown: the sensor lags otherwise, the air began to move, the object
    /// was changed.
    bool isEmpty() const { return m_corners.empty(); }

private:
    /// Keeps (k, a) with u k + v a <= w.
    void clip(double u, double v, double w);

    std::vector<Eigen::Vector2d> m_corners; ///< (k, a)
};

} // namespace bask
