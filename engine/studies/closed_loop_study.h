#pragma once
// How well a controller reaches targets that can be held: many runs at random on the simulated rig, each
// against the least time that physics needs.

#include "engine/base/result.h"
#include "engine/model/experiment.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What is studied.
struct ClosedLoopStudy {
    /// Rig, sensors, controller and factor of its wrong beliefs. Targets, start and seed are drawn anew for
    /// each run. The rig must have poses that hold every object kStudyRise_K above its environment.
    Experiment rig;
    bool randomMountings = false; ///< the objects' places on the end-effector are drawn too
    int count = 200;
    std::uint64_t seed = 1;
};

inline constexpr double kStudyRise_K = 2.0;            ///< least height of a target above the environment
inline constexpr double kStudyMountingRadius_m = 0.06; ///< random mountings: of the centroids about E
inline constexpr double kStudyBounds = 3.0;            ///< a run lasts this many bounds
inline constexpr double kStudyMinDuration_s = 400.0;   ///< and this besides

/// Times below which no controller brings an experiment's objects from the environment's temperature and its
/// start to their targets; infinite for a target that no view factor holds.
struct SettlingBound {
    /// Until the slowest object is within the settled band, at F = 1 from the first moment (F = 0 where it
    /// must cool).
    double radiation_s = 0.0;
    /// The same with the largest (least) view factor that any pose within the robot's reach by then offers,
    /// and 1 (0) from when the best of all is within reach: travel at full speed included.
    double bound_s = 0.0;
};
SettlingBound settlingBound(const Experiment& experiment);

/// One draw: targets that the pose `goal` holds, and the times below which nobody can be.
struct ClosedLoopCase {
    std::uint64_t seed = 0; ///< of noise, sensor offsets and wrong beliefs
    std::vector<Vector6d> mountings;
    Vector6d start = Vector6d::Zero(); ///< end-effector's coordinates in S
    Vector6d goal = Vector6d::Zero();
    std::vector<double> targets_K;
    double radiation_s = 0.0; ///< SettlingBound
    double bound_s = 0.0;
    double travel_s = 0.0; ///< straight from start to goal at full speed
    double duration_s() const { return kStudyBounds * bound_s + kStudyMinDuration_s; }
};

/// Draw number `index` (from 0): of the study's seed and the index alone, whatever the controller. Throws
/// std::invalid_argument on a rig without such poses.
ClosedLoopCase drawClosedLoopCase(const ClosedLoopStudy& study, int index);
/// The experiment of one draw.
Experiment closedLoopExperiment(const ClosedLoopStudy& study, const ClosedLoopCase& drawn);

/// One run's outcome, judged on true temperatures.
struct ClosedLoopRow {
    ClosedLoopCase drawn;
    std::optional<double> settling_s; ///< of the last object to settle; empty: failed
    double overshoot_K = 0.0; ///< farthest past a target, seen from the start's temperature; at least 0
    std::vector<double> final_K;
    bool toldCompromise = false; ///< the controller said that the targets cannot be held together
    std::string failure;         ///< why not settled, in words; empty: settled
};

/// Runs all draws on `threads` threads (0: one a core); the rows do not depend on them. `progress` is called
/// on the calling thread with the number of runs done; may be empty. Errors: a rig that does not validate.
Result<std::vector<ClosedLoopRow>> runClosedLoopStudy(const ClosedLoopStudy& study, int threads,
                                                      const std::function<void(int done)>& progress);

struct ClosedLoopSummary {
    double successRate = 0.0; ///< 0 to 1
    // Of the settled runs; empty when there are none.
    std::optional<double> medianOverBound, medianOverRadiation, tenthOverBound; ///< tenth: 90th percentile
    double worstOvershoot_K = 0.0;                                              ///< of all runs
};
ClosedLoopSummary summarize(const std::vector<ClosedLoopRow>& rows);

/// The table as CSV, with definitions in comment lines before the header.
std::string closedLoopCsv(const ClosedLoopStudy& study, const std::vector<ClosedLoopRow>& rows);

} // namespace bask
