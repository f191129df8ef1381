#pragma once
// How far the machine holds this program up: other programs on it, or the host of a virtual one.

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace bask::test {

struct HoldUp {
    double late_s = 0.0;         ///< the most that a sleeping thread woke too late
    double terminalLate_s = 0.0; ///< the most that a byte needed through a pseudo-terminal
    double stolen_s = 0.0;       ///< of all processors together, taken by the host
    double stolenShare = 0.0;    ///< of what all processors have
};

/// A thread on each processor sleeps 20 ms at a time and looks how late it wakes; another one sends bytes
/// through a pseudo-terminal, which the kernel hands over by threads of its own.
class HoldUpWatch {
public:
    HoldUpWatch();
    ~HoldUpWatch();
    HoldUpWatch(const HoldUpWatch&) = delete;
    HoldUpWatch& operator=(const HoldUpWatch&) = delete;

    void begin();
    /// Since it began; a thread that has not woken yet counts.
    HoldUp seen() const;

private:
    using Clock = std::chrono::steady_clock;
    /// A thread that waits for a moment again and again, and how late it was at the latest.
    struct Waiter {
        std::atomic<Clock::duration> due{};
        std::atomic<Clock::duration> late{};
        std::thread thread;
    };
    /// Ticks of /proc/stat; zero where there is none.
    struct Ticks {
        double all = 0.0, stolen = 0.0;
    };
    static Ticks ticks();
    Clock::duration lateNow(const Waiter& waiter) const;
    Clock::duration latest(const Waiter& waiter) const;
    void pause(Waiter& waiter) const;
    void sleep(Waiter& sleeper, int processor) const;
    void sendBytes(Waiter& terminal) const;

    std::atomic<bool> m_isOver = false;
    std::atomic<Clock::duration> m_begun{};
    std::vector<std::unique_ptr<Waiter>> m_sleepers;
    Waiter m_terminal;
    Ticks m_ticks; ///< when it began
};

} // namespace bask::test
