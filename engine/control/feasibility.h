#pragma once
// First feasibility condition: can each target be a steady temperature anywhere in the workspace (necessary,
// not sufficient).

#include "engine/control/rig_geometry.h"
#include "engine/thermal/heat_balance.h"

#include <vector>

namespace bask {

enum class FeasibilityVerdict {
    Reachable, ///< within the steady temperatures of the workspace
    TooCold,   ///< below the coldest steady temperature within the workspace
    TooHot,    ///< above the hottest steady temperature within the workspace
};

/// Condition 1 for one object.
struct TargetVerdict {
    double target_K = 0.0;
    double lowest_K = 0.0;         ///< steady temperature at F = 0
    double highest_K = 0.0;        ///< steady temperature at F = 1
    double neededViewFactor = 0.0; ///< F* of the target (may lie outside [0, 1])
    double reachableMin_F = 0.0;   ///< least and largest F within workspace and clearance
    double reachableMax_F = 0.0;
    double reachableMin_K = 0.0; ///< their steady temperatures
    double reachableMax_K = 0.0;
    FeasibilityVerdict verdict = FeasibilityVerdict::Reachable;
};

/// Verdict of each object by itself. `rest` gives the fixed coordinates. The extremes come from a sampled
/// workspace refined with the exact gradient. Takes some 0.1 s: run it as a job.
std::vector<TargetVerdict> targetVerdicts(const std::shared_ptr<const RigGeometry>& geometry,
                                          const Vector6d& rest, const std::vector<HeatRates>& rates,
                                          const std::vector<double>& targets_K);

} // namespace bask
