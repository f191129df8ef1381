// What a start of `bask` costs, in time and memory, beside that of a program that has nothing but Qt's core.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

namespace {

/// Starts a program, silent, and waits for its end.
void startOf(benchmark::State& state, std::vector<std::string> words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t silent;
    posix_spawn_file_actions_init(&silent);
    for (const int end : {1, 2})
        posix_spawn_file_actions_addopen(&silent, end, "/dev/null", O_WRONLY, 0);
    long peak_kB = 0;
    for (auto _ : state) {
        pid_t process = 0;
        int status = 0;
        rusage usage{};
        if (posix_spawn(&process, arguments[0], &silent, nullptr, arguments.data(), environ) != 0 ||
            wait4(process, &status, 0, &usage) != process || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
            state.SkipWithError("it does not run");
            break;
        }
        peak_kB = std::max(peak_kB, usage.ru_maxrss);
    }
    state.counters["peak_MB"] = static_cast<double>(peak_kB) / 1024.0;
    posix_spawn_file_actions_destroy(&silent);
}

} // namespace

BENCHMARK_CAPTURE(startOf, baselineQtCore, {BASK_BASELINE})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(startOf, version, {BASK_PROGRAM, "--version"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, viewFactor, {BASK_PROGRAM, "view-factor", BASK_ONE_CASE})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, feasibility, {BASK_PROGRAM, "feasibility", BASK_EXAMPLES "/two-circles.json"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(startOf, feasibilityWithPictures,
                  {BASK_PROGRAM, "feasibility", BASK_EXAMPLES "/three-objects.json"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
