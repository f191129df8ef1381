// What a line to a program and its answer take over ProgramLink, beside two pipes without it.

#include "engine/base/clock.h"
#include "engine/drivers/confirmed_programs.h"
#include "engine/drivers/program_files.h"
#include "engine/drivers/program_link.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr std::string_view kLine = "{\"id\":12345,\"do\":\"read\"}\n";

void tell(benchmark::State& state, std::vector<double>& times_us) {
    std::ranges::sort(times_us);
    state.counters["median_us"] = times_us[times_us.size() / 2];
    state.counters["p99_us"] = times_us[times_us.size() * 99 / 100];
}

template <class Turn> void measure(benchmark::State& state, Turn turn) {
    const SteadyClock clock;
    std::vector<double> times_us;
    for (auto _ : state) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2)); // as the engine, which does not spin
        const double from_s = clock.now_s();
        turn();
        const double took_s = clock.now_s() - from_s;
        state.SetIterationTime(took_s);
        times_us.push_back(1e6 * took_s);
    }
    tell(state, times_us);
}

void linkThereAndBack(benchmark::State& state) {
    const std::string command = "cat -u";
    auto confirmed = std::make_shared<ConfirmedPrograms>();
    confirmed->add(programFiles(command).value().hash);
    ProgramLink link(command, "benchmark", confirmed);
    link.open();
    while (!link.isOpen())
        std::this_thread::yield();
    measure(state, [&] {
        link.write(kLine);
        std::string answer;
        while (answer.size() < kLine.size()) {
            answer += link.read();
            std::this_thread::yield();
        }
    });
}

/// The baseline.
void pipesThereAndBack(benchmark::State& state) {
    std::array<int, 2> to{}, from{};
    if (::pipe(to.data()) != 0 || ::pipe(from.data()) != 0)
        throw std::runtime_error("pipe");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to[0], 0);
    posix_spawn_file_actions_adddup2(&actions, from[1], 1);
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    std::string cat = "cat", option = "-u";
    std::array<char*, 3> words{cat.data(), option.data(), nullptr};
    pid_t pid = 0;
    ::posix_spawnp(&pid, "cat", &actions, nullptr, words.data(), environ);
    measure(state, [&] {
        std::array<char, 64> answer{};
        std::size_t got = 0;
        if (::write(to[1], kLine.data(), kLine.size()) < 0)
            throw std::runtime_error("write");
        while (got < kLine.size())
            got += static_cast<std::size_t>(::read(from[0], answer.data(), answer.size()));
    });
    for (const int end : {to[0], to[1], from[0], from[1]})
        ::close(end);
    ::waitpid(pid, nullptr, 0);
    posix_spawn_file_actions_destroy(&actions);
}

BENCHMARK(pipesThereAndBack)->UseManualTime()->Iterations(2000);
BENCHMARK(linkThereAndBack)->UseManualTime()->Iterations(2000);

} // namespace
} // namespace bask

BENCHMARK_MAIN();
