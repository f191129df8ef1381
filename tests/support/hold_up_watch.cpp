#include "tests/support/hold_up_watch.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <numeric>
#include <pthread.h>
#include <sched.h>
#include <string>
#include <unistd.h>

namespace bask::test {

HoldUpWatch::HoldUpWatch() {
    cpu_set_t processors;
    CPU_ZERO(&processors);
    ::sched_getaffinity(0, sizeof processors, &processors);
    for (int i = 0; i < CPU_SETSIZE; ++i) {
        if (!CPU_ISSET(i, &processors))
            continue;
        Sleeper& sleeper = *m_sleepers.emplace_back(std::make_unique<Sleeper>());
        sleeper.due = Clock::now().time_since_epoch();
        sleeper.thread = std::thread([this, &sleeper, i] { sleep(sleeper, i); });
    }
    begin();
}

HoldUpWatch::~HoldUpWatch() {
    m_isOver = true;
    for (const auto& sleeper : m_sleepers)
        sleeper->thread.join();
}

void HoldUpWatch::begin() {
    m_begun = Clock::now().time_since_epoch();
    for (const auto& sleeper : m_sleepers)
        sleeper->late = Clock::duration::zero();
    m_ticks = ticks();
}

HoldUp HoldUpWatch::seen() const {
    Clock::duration late{};
    for (const auto& sleeper : m_sleepers) {
        const Clock::duration now = lateNow(*sleeper); // before what it keeps, where it goes once it is awake
        late = std::max({late, now, sleeper->late.load()});
    }
    const Ticks ended = ticks();
    const double all = ended.all - m_ticks.all, stolen = ended.stolen - m_ticks.stolen;
    return {std::chrono::duration<double>(late).count(), stolen / static_cast<double>(::sysconf(_SC_CLK_TCK)),
            all > 0.0 ? stolen / all : 0.0};
}

HoldUpWatch::Ticks HoldUpWatch::ticks() {
    std::ifstream file("/proc/stat");
    std::string name;
    file >> name; // "cpu": user, nice, system, idle, iowait, irq, softirq, steal
    std::array<double, 8> counts{};
    for (double& count : counts)
        file >> count;
    if (!file)
        return {};
    return {std::accumulate(counts.begin(), counts.end(), 0.0), counts.back()};
}

HoldUpWatch::Clock::duration HoldUpWatch::lateNow(const Sleeper& sleeper) const {
    return Clock::now().time_since_epoch() - std::max(sleeper.due.load(), m_begun.load());
}

void HoldUpWatch::sleep(Sleeper& sleeper, int processor) const {
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(processor, &only);
    ::pthread_setaffinity_np(::pthread_self(), sizeof only, &only);
    while (!m_isOver) {
        sleeper.late = std::max(sleeper.late.load(), lateNow(sleeper)); // also when it began late
        const auto due = Clock::now() + std::chrono::milliseconds(20);
        sleeper.due = due.time_since_epoch();
        std::this_thread::sleep_until(due);
    }
}

} // namespace bask::test
