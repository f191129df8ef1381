// What a start of `bask` costs, in time and memory, beside that of a program that has nothing but Qt's core.

#include "benchmarks/program_run.h"

namespace bask {
namespace {

void startOf(benchmark::State& state, std::vector<std::string> words) {
    programRun(state, std::move(words));
}

BENCHMARK_CAPTURE(startOf, baselineQtCore, {BASK_BASELINE})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(startOf, version, {BASK_PROGRAM, "--version"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, viewFactor, {BASK_PROGRAM, "view-factor", BASK_ONE_CASE})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, feasibilityAlone,
                  {BASK_PROGRAM, "feasibility", "--no-prediction", BASK_EXAMPLES "/three-objects.json"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, feasibility, {BASK_PROGRAM, "feasibility", BASK_EXAMPLES "/two-circles.json"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, feasibilityWithPictures,
                  {BASK_PROGRAM, "feasibility", BASK_EXAMPLES "/three-objects.json"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace bask
