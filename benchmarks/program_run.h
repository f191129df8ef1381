#pragma once
// A program as a benchmark: its time from start to end, its processor time and its memory, with all that it
// starts and waits for.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

namespace bask {

/// Starts a program, silent, and waits for its end, once an iteration. Counters: the largest peak_MB of a
/// process, and cpu_s.
inline void programRun(benchmark::State& state, std::vector<std::string> words) {
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
    double cpu_s = 0.0;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
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
        cpu_s += seconds(usage.ru_utime) + seconds(usage.ru_stime);
    }
    state.counters["peak_MB"] = static_cast<double>(peak_kB) / 1024.0;
    state.counters["cpu_s"] = benchmark::Counter(cpu_s, benchmark::Counter::kAvgIterations);
    posix_spawn_file_actions_destroy(&silent);
}

} // namespace bask
