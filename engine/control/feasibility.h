#pragma once
// The two necessary conditions on targets: can each be a steady temperature anywhere in the workspace, and
// can each pair differ by as much. Neither is sufficient: engine/control/joint_feasibility.h is.

#include "engine/control/rig_geometry.h"
#include "engine/thermal/heat_balance.h"

#include <memory>
#include <vector>

namespace bask {

class PoseLookup;
class SteadySearch;

/// A target counts as held by a steady temperature this close to it: half of the last digit that is typed, a
/// tenth of the band in which a run counts as settled.
inline constexpr double kHeldWithin_K = 0.05;

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
    FeasibilityVerdict verdict = FeasibilityVerdict::Reachable; ///< to kHeldWithin_K
};

/// Condition 2 for two objects: steady temperature of `first` minus that of `second`.
struct PairVerdict {
    int first = 0;
    int second = 0;
    double wanted_K = 0.0;
    double least_K = 0.0; ///< within workspace and clearance
    double largest_K = 0.0;
    bool holds = true; ///< to 2 kHeldWithin_K
};

/// The sampled workspace that feasibility is asked of; of a geometry and the fixed coordinates of `rest`
/// only. Takes some 10 ms for three objects.
std::shared_ptr<const PoseLookup> feasibilityLookup(const std::shared_ptr<const RigGeometry>& geometry,
                                                    const Vector6d& rest);

/// Verdict of each object by itself. `rest` gives the fixed coordinates. The extremes come from a sampled
/// workspace refined with the exact gradient. Takes some 0.1 s: run it as a job.
std::vector<TargetVerdict> targetVerdicts(const std::shared_ptr<const RigGeometry>& geometry,
                                          const Vector6d& rest, const std::vector<HeatRates>& rates,
                                          const std::vector<double>& targets_K);

/// The same from a search that is there already.
std::vector<TargetVerdict> targetVerdicts(const SteadySearch& search, const std::vector<double>& targets_K);

/// Each pair once, first < second, in lexical order. The search must not be empty.
std::vector<PairVerdict> pairVerdicts(const SteadySearch& search, const std::vector<double>& targets_K);

} // namespace bask
