#pragma once
// Two necessary conditions on targets: each must be a steady temperature somewhere in the workspace, and each
// pair must be able to differ by as much. They are not sufficient; see engine/control/joint_feasibility.h.

#include "engine/control/rig_geometry.h"
#include "engine/thermal/heat_balance.h"

#include <memory>
#include <vector>

namespace bask {

class PoseLookup;
class SteadySearch;

/// A target counts as reached if a steady temperature is this close to it: half of the last digit that can be
/// typed, a tenth of the band in which a run counts as settled.
inline constexpr double kReachedWithin_K = 0.05;

enum class FeasibilityVerdict {
    Reachable, ///< within the steady temperatures of the workspace
    TooCold,   ///< below the coldest steady temperature within the workspace
    TooHot,    ///< above the hottest steady temperature within the workspace
};

/// Condition 1 for one object.
struct TargetVerdict {
    double target_K = 0.0;
    double lowest_K = 0.0; ///< steady temperature at F = 0
    double highest_K =
        0.0; ///< steady temperature at the largest F of all: 1, or more for a source with hotter parts
    double neededViewFactor = 0.0; ///< F* of the target (may lie outside [0, 1])
    double reachableMin_F = 0.0;   ///< smallest and largest F within workspace and clearance
    double reachableMax_F = 0.0;
    double reachableMin_K = 0.0; ///< the steady temperatures at these
    double reachableMax_K = 0.0;
    FeasibilityVerdict verdict = FeasibilityVerdict::Reachable; ///< with the tolerance kReachedWithin_K
};

/// Condition 2 for two objects: steady temperature of `first` minus that of `second`.
struct PairVerdict {
    int first = 0;
    int second = 0;
    double wanted_K = 0.0;
    double min_K = 0.0; ///< smallest and largest difference within workspace and clearance
    double largest_K = 0.0;
    bool holds = true; ///< whether the condition is satisfied, with twice the tolerance kReachedWithin_K
};

/// Returns the sampled workspace for feasibility. It depends only on the geometry and the fixed coordinates
/// of `rest`. Takes about 10 ms for three objects.
std::shared_ptr<const PoseLookup> feasibilityLookup(const std::shared_ptr<const RigGeometry>& geometry,
                                                    const Vector6d& rest);

/// Returns the verdict of each object by itself. `rest` gives the fixed coordinates. The extremes are sampled
/// in the workspace and refined with the exact gradient. Takes about 0.1 s: run it as a job.
std::vector<TargetVerdict> targetVerdicts(const std::shared_ptr<const RigGeometry>& geometry,
                                          const Vector6d& rest, const std::vector<HeatRates>& rates,
                                          const std::vector<double>& targets_K);

/// Returns the verdicts from an existing search.
std::vector<TargetVerdict> targetVerdicts(const SteadySearch& search, const std::vector<double>& targets_K);

/// Returns the verdict of each pair once, first < second, in lexical order. The search must not be empty.
std::vector<PairVerdict> pairVerdicts(const SteadySearch& search, const std::vector<double>& targets_K);

} // namespace bask
