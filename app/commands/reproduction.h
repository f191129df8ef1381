#pragma once
// Runs the paper's experiments by the paper's controller and by the level servo, and says what came of it.

#include "app/commands/paper_experiments.h"
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
    std::string compromise;           ///< the controller's words when it called the targets infeasible
    std::optional<double> settling_s; ///< of the last object; empty: not settled
    double wall_s = 0.0;
};

struct ReproducedExperiment {
    PaperExperiment paper;
    SettlingBound bound;
    JointVerdict feasibility;
    std::array<ReproducedRun, 2> runs; ///< kByThePaper, kByTheLevelServo

    bool asExpected(std::size_t by) const;
};

/// Runs every experiment twice, to the end of its duration, with the file's seed; by the file's controller
/// and by the level servo with everything else the same. On `threads` threads (0: one a core); what comes out
/// does not depend on them. `progress` is called on the calling thread with the number of runs done, also now
/// and then in between. Errors: an experiment that cannot run.
Result<std::vector<ReproducedExperiment>> reproduce(const std::vector<PaperExperiment>& experiments,
                                                    int threads,
                                                    const std::function<void(int done, int all)>& progress);

/// "+0.12, -1.40": true temperatures less targets at the end, K.
std::string finalErrorWords(const ReproducedRun& run);

/// Centre of an object in the source's frame.
Eigen::Vector3d objectCentre_m(const Experiment& experiment, const TraceSample& sample, std::size_t object);

/// One sentence on a run: agrees with the paper or not and why; whether it is what was expected.
std::string verdictWords(const ReproducedExperiment& experiment, std::size_t by);

/// A run's samples as CSV, with what it is in comment lines before the header.
std::string reproductionCsv(const ReproducedExperiment& experiment, std::size_t by, const std::string& mark);

} // namespace bask
