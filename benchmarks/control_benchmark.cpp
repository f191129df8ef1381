// One control step for three objects (the three-object example). Wanted: 20 us for the paper's two laws, 20
// ms for the level servo, 200 ms for the rebuilding of its look-up. Baseline: the same interaction matrix and
// a plain damped pseudo-inverse, without any limit. And what is said of a mounting and of
// targets.

#include "engine/base/units.h"
#include "engine/control/controller.h"
#include "engine/control/steady_search.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/mounting_check.h"
#include "engine/rig/rig_setup.h"

#include <QCoreApplication>

#include <Eigen/SVD>
#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>

namespace bask {
namespace {

const std::vector<ProfilePoint> kColdRim{{0.0, 1.05}, {0.06, 1.0}, {0.1, 0.85}};

struct Bench {
    Experiment experiment;
    std::shared_ptr<const RigGeometry> geometry;
    ControlModel model;
    Observation observation;
};

/// Half-way to the targets over the source, moving; `error_K` how far from them.
std::optional<Bench> makeBench(benchmark::State& state, double error_K, double acceleration_m_s2) {
    auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    if (!experiment) {
        state.SkipWithError(describe(experiment.error()).c_str());
        return std::nullopt;
    }
    experiment->robot.maxAcceleration_m_s2 = acceleration_m_s2;
    experiment->robot.maxAngularAcceleration_rad_s2 = 5.0 * acceleration_m_s2;
    Bench bench;
    bench.geometry = rigGeometry(*experiment);
    bench.model.geometry = bench.geometry;
    bench.model.estimated = nominalRates(*experiment, experiment->environment_K);
    bench.observation.coordinates = experiment->start;
    bench.observation.coordinates[kX] = 0.02;
    bench.observation.coordinates[kThetaX] = 0.1;
    for (const ObjectSpec& object : experiment->objects) {
        bench.model.targets_K.push_back(object.target_K);
        bench.observation.objects.push_back({object.target_K - error_K, 0.01});
    }
    bench.experiment = std::move(*experiment);
    return bench;
}

void stepOf(benchmark::State& state, ControllerKind kind, double error_K, double acceleration_m_s2) {
    auto bench = makeBench(state, error_K, acceleration_m_s2);
    if (!bench)
        return;
    bench->experiment.controller.kind = kind;
    const auto controller = makeController(bench->experiment.controller, bench->model);
    (void)controller->step(bench->observation, 1.0); // builds what it needs
    bool limited = false;
    for (auto _ : state) {
        bench->observation.time_s += 1.0;
        const ControlOutput output = controller->step(bench->observation, 1.0);
        limited = output.limits.any();
        benchmark::DoNotOptimize(output.rates.data());
    }
    state.counters["limited"] = limited ? 1.0 : 0.0;
}

void baselinePseudoInverse(benchmark::State& state) {
    const auto bench = makeBench(state, 0.1, 0.0);
    if (!bench)
        return;
    const Vector6d& q = bench->observation.coordinates;
    const Eigen::VectorXd wanted = Eigen::VectorXd::Constant(3, 1e-3);
    for (auto _ : state) {
        const ViewFactors fields = bench->geometry->viewFactors(q);
        const Eigen::MatrixXd J = fields.dF.leftCols<4>();
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
        const Eigen::VectorXd u = svd.solve(wanted);
        benchmark::DoNotOptimize(u.data());
    }
}

void lookUpRebuild(benchmark::State& state) {
    auto bench = makeBench(state, 0.1, 0.0);
    if (!bench)
        return;
    bench->experiment.controller.kind = ControllerKind::LevelServo;
    for (auto _ : state) { // its first step builds the look-up
        const auto controller = makeController(bench->experiment.controller, bench->model);
        const ControlOutput output = controller->step(bench->observation, 1.0);
        benchmark::DoNotOptimize(output.rates.data());
    }
}

/// The verdict on all targets together, three objects and four axes: 100 ms at most on 2 cores, with the
/// workspace sampled anew (a geometry was edited) or at hand (a target was). Line: the search finds nothing
/// and tries all its starts.
void jointFeasibilityOf(benchmark::State& state, const std::string& name, bool atHand, bool uneven = false) {
    auto experiment = readExperiment(BASK_EXAMPLES "/" + name);
    if (!experiment) {
        state.SkipWithError(describe(experiment.error()).c_str());
        return;
    }
    if (uneven)
        experiment->source.uneven.profile = kColdRim;
    FeasibilityRequest request = feasibilityRequest(*experiment);
    request.targets_K.assign(3, kelvinFromCelsius(45.0));
    if (atHand)
        request.lookup = feasibilityLookup(request.geometry, request.rest);
    for (auto _ : state)
        state.counters["feasible"] = jointFeasibility(request)->feasible ? 1.0 : 0.0;
}

/// From the file to the verdict, its pictures read: what `bask feasibility` without a prediction takes, but
/// for the program's start. 200 ms at most. Baseline: the file alone.
void verdictOfAFile(benchmark::State& state, bool readingAlone) {
    for (auto _ : state) {
        const auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
        if (!experiment) {
            state.SkipWithError(describe(experiment.error()).c_str());
            return;
        }
        if (!readingAlone)
            state.counters["feasible"] =
                jointFeasibility(feasibilityRequest(*experiment))->feasible ? 1.0 : 0.0;
    }
}

/// The same where the objects shade one another: three heights, and tilts. 300 ms at most, and 1 s for the
/// look-up. Baseline: the same objects in one plane.
std::optional<FeasibilityRequest> requestAtHeights(benchmark::State& state, bool inOnePlane,
                                                   bool uneven = false) {
    auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    if (!experiment) {
        state.SkipWithError(describe(experiment.error()).c_str());
        return std::nullopt;
    }
    if (uneven)
        experiment->source.uneven.profile = kColdRim;
    if (!inOnePlane) {
        experiment->objects[1].mounting[kZ] = 0.02;
        experiment->objects[1].mounting[kThetaX] = radFromDeg(8.0);
        experiment->objects[2].mounting[kZ] = -0.015;
        experiment->objects[2].mounting[kThetaX] = radFromDeg(-10.0);
    }
    return feasibilityRequest(*experiment);
}

void feasibilityAtHeights(benchmark::State& state, bool inOnePlane, const std::vector<double>& targets_degC,
                          bool uneven = false) {
    auto request = requestAtHeights(state, inOnePlane, uneven);
    if (!request)
        return;
    for (std::size_t i = 0; i < targets_degC.size(); ++i)
        request->targets_K[i] = kelvinFromCelsius(targets_degC[i]);
    request->lookup = feasibilityLookup(request->geometry, request->rest);
    for (auto _ : state)
        state.counters["feasible"] = jointFeasibility(*request)->feasible ? 1.0 : 0.0;
}

void lookUpAtHeights(benchmark::State& state, bool inOnePlane, bool uneven = false) {
    const auto request = requestAtHeights(state, inOnePlane, uneven);
    if (!request)
        return;
    for (auto _ : state)
        benchmark::DoNotOptimize(feasibilityLookup(request->geometry, request->rest));
}

/// Baseline: the best of a grid of 1.5 million poses, without gradients. How far off it still is: best_K.
void feasibilityByGrid(benchmark::State& state) {
    const auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    if (!experiment) {
        state.SkipWithError(describe(experiment.error()).c_str());
        return;
    }
    const FeasibilityRequest request = feasibilityRequest(*experiment);
    for (auto _ : state) {
        const SteadySearch grid(request.geometry,
                                std::make_shared<PoseLookup>(request.geometry, request.rest, 1500000),
                                request.rates);
        const Eigen::ArrayXXd residuals_K = grid.table_K() - kelvinFromCelsius(45.0);
        state.counters["best_K"] = std::sqrt(residuals_K.square().rowwise().mean().minCoeff());
    }
}

/// Told at every edit on the Objects page, on the GUI thread: 5 ms at most. At worst six outlines over a
/// round source, all axes free: as many as the axes, dependent, so that the whole sample is looked at.
void mountingRemarksOf(benchmark::State& state, bool worst, int polygonPoints) {
    auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    if (!experiment) {
        state.SkipWithError(describe(experiment.error()).c_str());
        return;
    }
    if (worst) {
        experiment->robot.free.fill(true);
        experiment->robot.lower.tail<2>().setConstant(-0.5);
        experiment->robot.upper.tail<2>().setConstant(0.5);
        experiment->objects.assign(6, experiment->objects[1]);
        for (int i = 0; i < 6; ++i)
            experiment->objects[static_cast<std::size_t>(i)].mounting.head<2>() =
                0.12 * Eigen::Vector2d(std::cos(i * M_PI / 3.0), std::sin(i * M_PI / 3.0));
    }
    for (ObjectSpec& object : experiment->objects)
        if (polygonPoints > 0)
            object.shape = Contour{shapeOutline(object.shape, polygonPoints)};
    for (auto _ : state) {
        const std::vector<MountingRemark> remarks = mountingRemarks(*experiment);
        benchmark::DoNotOptimize(remarks.data());
        state.counters["remarks"] = static_cast<double>(remarks.size());
    }
}

constexpr double kNear_K = 0.02; // nothing limits
constexpr double kFar_K = 15.0;  // the robot goes as fast as it may
constexpr double kAcceleration_m_s2 = 0.005;

#define BASK_STEP(name, kind, error_K, acceleration_m_s2, unit)                                              \
    BENCHMARK_CAPTURE(stepOf, name, ControllerKind::kind, error_K, acceleration_m_s2)->Unit(unit)

BENCHMARK(baselinePseudoInverse)->Unit(benchmark::kMicrosecond);
BASK_STEP(modelBasedFree, ModelBased, kNear_K, 0.0, benchmark::kMicrosecond);
BASK_STEP(modelBasedLimited, ModelBased, kFar_K, 0.0, benchmark::kMicrosecond);
BASK_STEP(modelBasedAccelerating, ModelBased, kFar_K, kAcceleration_m_s2, benchmark::kMicrosecond);
BASK_STEP(adaptiveFree, Adaptive, kNear_K, 0.0, benchmark::kMicrosecond);
BASK_STEP(adaptiveLimited, Adaptive, kFar_K, 0.0, benchmark::kMicrosecond);
BASK_STEP(adaptiveAccelerating, Adaptive, kFar_K, kAcceleration_m_s2, benchmark::kMicrosecond);
BASK_STEP(levelServoNear, LevelServo, kNear_K, 0.0, benchmark::kMillisecond);
BASK_STEP(levelServoFar, LevelServo, kFar_K, 0.0, benchmark::kMillisecond);
BENCHMARK_CAPTURE(verdictOfAFile, threeObjects, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(verdictOfAFile, baseline_readingAlone, true)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(mountingRemarksOf, threeObjects, false, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mountingRemarksOf, polygonsOf60000, false, 60000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mountingRemarksOf, worst, true, 0)->Unit(benchmark::kMillisecond);
#define BASK_FEASIBILITY(name, file, atHand)                                                                 \
    BENCHMARK_CAPTURE(jointFeasibilityOf, name, file, atHand)->Unit(benchmark::kMillisecond)->UseRealTime()
BASK_FEASIBILITY(triangle, "three-objects.json", false);
BASK_FEASIBILITY(triangleAtHand, "three-objects.json", true);
BENCHMARK_CAPTURE(jointFeasibilityOf, triangleColdRim, "three-objects.json", false, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BASK_FEASIBILITY(line, "three-objects-in-line.json", false);
BASK_FEASIBILITY(lineAtHand, "three-objects-in-line.json", true);
#define BASK_IN_PLANE_OR_NOT(function, name, inOnePlane, ...)                                                \
    BENCHMARK_CAPTURE(function, name, inOnePlane __VA_OPT__(, ) __VA_ARGS__)                                 \
        ->Unit(benchmark::kMillisecond)                                                                      \
        ->MeasureProcessCPUTime()                                                                            \
        ->UseRealTime()
#define BASK_AT_HEIGHTS(function, name, ...)                                                                 \
    BASK_IN_PLANE_OR_NOT(function, name##OnePlane, true __VA_OPT__(, ) __VA_ARGS__);                         \
    BASK_IN_PLANE_OR_NOT(function, name##ThreeHeights, false __VA_OPT__(, ) __VA_ARGS__)
BASK_AT_HEIGHTS(feasibilityAtHeights, feasible, std::vector{40.0, 40.0, 40.0});
BASK_AT_HEIGHTS(feasibilityAtHeights, tooFarApart, std::vector{85.0, 30.0, 60.0});
BASK_AT_HEIGHTS(feasibilityAtHeights, feasibleColdRim, std::vector{40.0, 40.0, 40.0}, true);
BASK_AT_HEIGHTS(lookUpAtHeights, lookUp);
BASK_AT_HEIGHTS(lookUpAtHeights, lookUpColdRim, true);
BENCHMARK(feasibilityByGrid)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(lookUpRebuild)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const QCoreApplication application(argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
