// Whole runs on the simulated clock, headless: the three-object example, and eight simulated hours of the
// bare-aluminium circle. Wanted: under 10 s and under 60 s of wall time.

#include "engine/experiment/experiment_file.h"
#include "engine/runtime/simulated_run.h"

#include <QCoreApplication>

#include <benchmark/benchmark.h>

namespace bask {
namespace {

void runExample(benchmark::State& state, const std::string& name, std::optional<double> duration_s) {
    const auto experiment = readExperiment(BASK_EXAMPLES "/" + name);
    if (!experiment) {
        state.SkipWithError(describe(experiment.error()).c_str());
        return;
    }
    SimulatedRunOptions options;
    options.duration_s = duration_s;
    double simulated_s = 0.0;
    for (auto _ : state) {
        const auto outcome = runSimulated(*experiment, options);
        if (!outcome) {
            state.SkipWithError(describe(outcome.error()).c_str());
            return;
        }
        simulated_s = outcome->simulated_s;
    }
    state.counters["simulated_s"] = simulated_s;
}

void threeObjects(benchmark::State& state) {
    runExample(state, "three-objects.json", std::nullopt);
}
void bareAluminiumEightHours(benchmark::State& state) {
    runExample(state, "bare-aluminium.json", 8.0 * 3600.0);
}

BENCHMARK(threeObjects)->Unit(benchmark::kSecond);
BENCHMARK(bareAluminiumEightHours)->Unit(benchmark::kSecond)->Iterations(1);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const QCoreApplication application(argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
