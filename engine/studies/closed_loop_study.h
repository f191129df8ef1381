#pragma once
// How well a controller reaches targets that are feasible: many random runs on the simulated rig, each
// compared with the physical minimum time.

#include "engine/base/result.h"
#include "engine/model/experiment.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Where the objects are mounted in each run.
enum class StudyMountings {
    AsGiven,
    InPlane, ///< at random places in one plane, turned anyhow
    Heights, ///< also at random heights and tilts: they shade one another and exchange radiation
};

/// The settings of the study.
struct ClosedLoopStudy {
    /// Rig, sensors, controller and the error factor of its estimated rates. Targets, start and seed are
    /// drawn for each run. The rig must have poses that keep every object kStudyRise_K above its environment.
    Experiment rig;
    StudyMountings mountings = StudyMountings::AsGiven;
    int count = 200;
    std::uint64_t seed = 1;
    // Drawn for each run from zero to these; none of them is told to the controller.
    double convection_W_m2K = 0.0;
    double sensorLag_s = 0.0;
    double robotLatency_s = 0.0;
    /// Each of the seven parts of the true source (see drawUnevenness) is hotter or colder than the source by
    /// up to this share of its temperature above the room, at most 1. The rig's source must be a disk then.
    double uneven = 0.0;
};

/// Smallest distance of a target above the environment.
inline constexpr double kStudyRise_K = 2.0;
inline constexpr double kStudyMountingRadius_m = 0.06; ///< random mountings: of the centroids about E
inline constexpr double kStudyHeight_m = 0.03;         ///< random heights: above or below E
inline constexpr double kStudyTilt_rad = 0.349066;     ///< random tilts: 20 degrees
inline constexpr double kStudyRestAfter_s = 60.0;    ///< after settling: from then on the robot should stand
inline constexpr double kStudyBounds = 3.0;          ///< a run lasts this many times the bound
inline constexpr double kStudyMinDuration_s = 400.0; ///< plus this

/// Minimum times for any controller to bring an experiment's objects from the environment's temperature and
/// its start to their targets; infinite for a target that no view factor reaches.
struct SettlingBound {
    /// Until the slowest object is within the settled band, with F = 1 from the start (F = 0 if it must
    /// cool).
    double radiation_s = 0.0;
    /// The same with the largest (smallest) view factor of any pose that the robot can reach by then, and 1
    /// (0) once the best pose of all can be reached: includes travel at full speed.
    double bound_s = 0.0;
};
SettlingBound settlingBound(const Experiment& experiment);

/// One draw: targets that are steady at the pose `goal`, and the minimum times.
struct ClosedLoopCase {
    std::uint64_t seed = 0; ///< seed of noise, sensor offsets and wrong estimates
    std::vector<Vector6d> mountings;
    Vector6d start = Vector6d::Zero(); ///< end-effector's coordinates in S
    Vector6d goal = Vector6d::Zero();
    std::vector<double> targets_K;
    double convection_W_m2K = 0.0;
    double sensorLag_s = 0.0;
    double robotLatency_s = 0.0;
    double uneven = 0.0;       ///< the share drawn for this run
    Unevenness sourceUneven{}; ///< with that share
    double radiation_s = 0.0;  ///< SettlingBound
    double bound_s = 0.0;
    double travel_s = 0.0; ///< straight from start to goal at full speed
    double duration_s() const { return kStudyBounds * bound_s + kStudyMinDuration_s; }
};

/// Returns draw number `index` (from 0), which depends only on the study's seed and the index, not on the
/// controller. Throws std::invalid_argument for a rig without such poses, and as the study's conditions ask.
ClosedLoopCase drawClosedLoopCase(const ClosedLoopStudy& study, int index);
/// Returns the experiment of one draw.
Experiment closedLoopExperiment(const ClosedLoopStudy& study, const ClosedLoopCase& drawn);

/// The result of one run, judged on true temperatures.
struct ClosedLoopRow {
    ClosedLoopCase drawn;
    std::optional<double> settling_s; ///< of the last object to settle; empty: not settled
    /// Farthest past a target, seen from the start's temperature; not negative.
    double overshoot_K = 0.0;
    double way_m = 0.0; ///< of the end-effector, whole run
    /// Mean speed of the end-effector from kStudyRestAfter_s after settling_s to the end of the run, m/s;
    /// empty: not settled, or not that long before the end.
    std::optional<double> restSpeed_m_s;
    /// Largest change of the commanded velocity (translation) from one sample to the next, per time, m/s2.
    double commandAcceleration_m_s2 = 0.0;
    std::vector<double> final_K;
    bool toldCompromise = false; ///< the controller reported that the targets cannot be reached together
    std::string failure;         ///< why it did not settle, in words; empty if it settled
};

/// Errors: a rig that does not validate.
Result<void> check(const ClosedLoopStudy& study);
/// Returns the row of draw number `index` (from 0), which depends on nothing else. Thread-safe.
Result<ClosedLoopRow> runClosedLoopCase(const ClosedLoopStudy& study, int index);
/// Runs all draws on `threads` threads (0: one for each core); the rows do not depend on their number.
/// `progress` may be empty; it is called on the calling thread with the number of finished runs. Errors:
/// those of check().
Result<std::vector<ClosedLoopRow>> runClosedLoopStudy(const ClosedLoopStudy& study, int threads,
                                                      const std::function<void(int done)>& progress);

struct ClosedLoopSummary {
    double successRate = 0.0; ///< 0 to 1
    // Of the settled runs; empty if there are none.
    std::optional<double> medianOverBound, medianOverRadiation, tenthOverBound; ///< tenth: 90th percentile
    double worstOvershoot_K = 0.0;                                              ///< of all runs
    // Of the runs that have a speed at rest.
    std::optional<double> meanRestSpeed_m_s, worstRestSpeed_m_s;
    std::optional<double> medianWay_m; ///< of all runs
};
ClosedLoopSummary summarize(const std::vector<ClosedLoopRow>& rows);

/// Returns the table as CSV, with definitions in comment lines before the header.
std::string closedLoopCsv(const ClosedLoopStudy& study, const std::vector<ClosedLoopRow>& rows);

} // namespace bask
