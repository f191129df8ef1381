#include "tests/support/hold_up_watch.h"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <fstream>
#include <numeric>
#include <poll.h>
#include <pthread.h>
#include <pty.h>
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
        Waiter& sleeper = *m_sleepers.emplace_back(std::make_unique<Waiter>());
        sleeper.due = Clock::now().time_since_epoch();
        sleeper.thread = std::thread([this, &sleeper, i] { sleep(sleeper, i); });
    }
    m_terminal.due = Clock::now().time_since_epoch();
    m_terminal.thread = std::thread([this] { sendBytes(m_terminal); });
    begin();
}

HoldUpWatch::~HoldUpWatch() {
    m_isOver = true;
    for (const auto& sleeper : m_sleepers)
        sleeper->thread.join();
    m_terminal.thread.join();
}

void HoldUpWatch::begin() {
    m_begun = Clock::now().time_since_epoch();
    for (const auto& sleeper : m_sleepers)
        sleeper->late = Clock::duration::zero();
    m_terminal.late = Clock::duration::zero();
    m_ticks = ticks();
}

HoldUp HoldUpWatch::seen() const {
    Clock::duration late{};
    for (const auto& sleeper : m_sleepers)
        late = std::max(late, latest(*sleeper));
    const Ticks ended = ticks();
    const double all = ended.all - m_ticks.all, stolen = ended.stolen - m_ticks.stolen;
    using Seconds = std::chrono::duration<double>;
    return {Seconds(late).count(), Seconds(latest(m_terminal)).count(),
            stolen / static_cast<double>(::sysconf(_SC_CLK_TCK)), all > 0.0 ? stolen / all : 0.0};
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

HoldUpWatch::Clock::duration HoldUpWatch::lateNow(const Waiter& waiter) const {
    return Clock::now().time_since_epoch() - std::max(waiter.due.load(), m_begun.load());
}

HoldUpWatch::Clock::duration HoldUpWatch::latest(const Waiter& waiter) const {
    const Clock::duration now = lateNow(waiter); // before what it keeps, where it goes once it is over
    return std::max(now, waiter.late.load());
}

void HoldUpWatch::pause(Waiter& waiter) const {
    waiter.late = std::max(waiter.late.load(), lateNow(waiter)); // also when it began late
    const auto due = Clock::now() + std::chrono::milliseconds(20);
    waiter.due = due.time_since_epoch();
    std::this_thread::sleep_until(due);
}

void HoldUpWatch::sleep(Waiter& sleeper, int processor) const {
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(processor, &only);
    ::pthread_setaffinity_np(::pthread_self(), sizeof only, &only);
    while (!m_isOver)
        pause(sleeper);
}

void HoldUpWatch::sendBytes(Waiter& terminal) const {
    int near = -1, far = -1;
    termios raw{};
    ::cfmakeraw(&raw);
    if (::openpty(&near, &far, nullptr, &raw, nullptr) != 0) {
        terminal.due = Clock::duration::max(); // it tells nothing
        return;
    }
    for (const int end : {near, far})
        ::fcntl(end, F_SETFD, FD_CLOEXEC);
    ::fcntl(far, F_SETFL, O_NONBLOCK);
    while (!m_isOver) {
        pause(terminal);
        char byte = '.';
        if (::write(near, &byte, 1) != 1)
            continue;
        pollfd arrived{far, POLLIN, 0};
        while (!m_isOver && ::read(far, &byte, 1) != 1)
            ::poll(&arrived, 1, 20);
    }
    ::close(near);
    ::close(far);
}

} // namespace bask::test
