// What a Targets page waits for: fields of the three example objects at the paper's 1 cm grid, and their
// target surfaces.

#include "engine/exchange/target_surfaces.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/model/experiment_rig.h"

#include <benchmark/benchmark.h>

#include <array>
#include <stdexcept>

namespace bask {
namespace {

Experiment example() {
    auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    if (!experiment)
        throw std::runtime_error(describe(experiment.error()));
    return *experiment;
}

TargetGeometry geometry(const Experiment& experiment) {
    TargetGeometry out{RadiatingContour(experiment.source.shape),
                       poseFromCoordinates(experiment.source.pose),
                       {},
                       {},
                       surfaceAxes(PoseSubset::Translation, experiment.robot, kSurfaceStep_m)};
    for (const ObjectSpec& object : experiment.objects)
        out.objects.push_back({RadiatingContour(object.shape), poseFromCoordinates(object.mounting)});
    out.fixed = experiment.start;
    out.clearance_m = experiment.robot.clearance_m;
    return out;
}

void fields(benchmark::State& state) {
    TargetGeometry of = geometry(example());
    of.fixed[kThetaX] = static_cast<double>(state.range(0)) / 100.0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(targetFields(of));
}
BENCHMARK(fields)
    ->Name("target_fields")
    ->Arg(0)
    ->Arg(30)
    ->Arg(60)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The same objects 3 cm above one another, which shade one another; on a grid of so many cm.
void shadedFields(benchmark::State& state) {
    Experiment experiment = example();
    for (std::size_t i = 0; i < experiment.objects.size(); ++i)
        experiment.objects[i].mounting[kZ] = 0.03 * (1.0 - static_cast<double>(i));
    TargetGeometry of = geometry(experiment);
    of.axes = surfaceAxes(PoseSubset::Translation, experiment.robot,
                          kSurfaceStep_m * static_cast<double>(state.range(0)));
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(targetFields(of));
}
BENCHMARK(shadedFields)
    ->Name("target_fields_with_shade")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void surfaces(benchmark::State& state) {
    const Experiment experiment = example();
    const auto sampled = *targetFields(geometry(experiment));
    std::vector<double> values;
    for (const ObjectSpec& object : experiment.objects)
        values.push_back(heatRates(object, surroundingsOf(experiment)).steadyViewFactor(object.target_K));
    std::size_t triangles = 0;
    for ([[maybe_unused]] auto _ : state) {
        const auto cut = targetSurfaces(sampled, values);
        triangles = 0;
        for (const Isosurface& surface : *cut)
            triangles += surface.triangles.size();
    }
    state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(surfaces)->Name("target_surfaces")->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask
