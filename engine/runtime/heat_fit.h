#pragma once
// All combinations of heating and loss that explain an object's readings, not only the best one.

#include "engine/runtime/heat_bounds.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// What happened between two moments: the ranges of the absorbed energy (K, as estimated) and of the time
/// integral of the temperature above room temperature (K s), and by how much the temperature may have changed
/// besides (K).
struct HeatSpan {
    double minEnergy_K = 0.0, maxEnergy_K = 0.0;
    double minLoss_K_s = 0.0, maxLoss_K_s = 0.0;
    double unsure_K = 0.0;
};

/// The object's temperature changes by k E - a Q over a span. The constants are k, the error factor of the
/// estimated power, and a, the loss coefficient. Keeps every (k, a) that explains all changes learnt so far:
/// a convex polygon, at first the full allowed range.
class HeatFit {
public:
    explicit HeatFit(LossRange losses);

    struct Change {
        double min_K = 0.0, max_K = 0.0;
    };
    /// Returns the range of the temperature change over a span, for all remaining (k, a).
    Change expected(const HeatSpan& span) const;
    /// Removes all (k, a) that do not explain this change within the tolerance.
    void learn(const HeatSpan& span, double change_K, double tolerance_K);
    /// Returns whether no constants explain all changes: the sensor has another lag, the air began to move,
    /// or the object was changed.
    bool isEmpty() const { return m_corners.empty(); }

private:
    /// Keeps (k, a) with u k + v a <= w.
    void clip(double u, double v, double w);

    std::vector<Eigen::Vector2d> m_corners; ///< (k, a)
};

} // namespace bask
