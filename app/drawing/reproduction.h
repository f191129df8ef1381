#pragma once
// Runs the paper's experiments by the paper's controller and by the level servo, and reports the results.

#include "app/studies/paper_experiments.h"
#include "engine/control/joint_feasibility.h"
#include "engine/runtime/simulated_run.h"
#include "engine/studies/closed_loop_study.h"

#include <functional>
#include <optional>
#include <vector>

namespace bask {

struct ReproducedRun {
    ControllerKind controller = ControllerKind::LevelServo;
    RunOutcome outcome;
    std::vector<TraceSample> samples;
    RunEnding ending = RunEnding::Fault;
    std::string compromise;           ///< the controller's message if it found the targets infeasible
    std::optional<double> settling_s; ///< settling time of the last object; empty if not settled
    double wall_s = 0.0;
};

struct ReproducedExperiment {
    PaperExperiment paper;
    SettlingBound bound;
    JointVerdict feasibility;
    std::array<ReproducedRun, 2> runs; ///< by kByThePaper and kByTheLevelServo

    bool asExpected(std::size_t by) const;
};

/// Runs every experiment twice, until the end of its duration, with the file's seed: by the file's
/// controller, and by the level servo with everything else the same. Uses `threads` threads (0: one for each
/// core); the results do not depend on them. `progress` is called on the calling thread with the number of
/// finished runs, sometimes repeatedly with the same number. Errors: an experiment that cannot run.
Result<std::vector<ReproducedExperiment>> reproduce(const std::vector<PaperExperiment>& experiments,
                                                    int threads,
                                                    const std::function<void(int done, int all)>& progress);

/// Returns the targets in degC: "50, 40".
std::string targetWords(const Experiment& experiment);

/// Returns "+0.12, -1.40": true temperatures minus targets at the end, K.
std::string finalErrorWords(const ReproducedRun& run);

/// Returns the centre of an object in the source's frame.
Eigen::Vector3d objectCentre_m(const Experiment& experiment, const TraceSample& sample, std::size_t object);

/// Returns one sentence about a run: whether it agrees with the paper, why, and whether this was expected.
std::string verdictWords(const ReproducedExperiment& experiment, std::size_t by);

/// Returns a run's samples as CSV, with a description in comment lines before the header.
std::string reproductionCsv(const ReproducedExperiment& experiment, std::size_t by, const std::string& mark);

} // namespace bask
