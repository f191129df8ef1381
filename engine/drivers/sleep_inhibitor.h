#pragma once
// Keeps this computer from going to sleep, where its system has logind.

#include <memory>
#include <string>

namespace bask {

/// Asks on a thread of its own: no call here waits for the system.
class SleepInhibitor {
public:
    /// `bus`: the address of the D-Bus that logind is on; empty: the system's.
    explicit SleepInhibitor(std::string bus = {});
    ~SleepInhibitor(); ///< it may sleep again

    /// Whether it is to stay awake ("sleep:idle" blocked).
    void keepAwake(bool isWanted);
    bool isKept() const;
    /// Why it could not be kept awake when that was asked last; empty: it could, or is asked still.
    std::string problem() const;

private:
    struct Lock;
    std::shared_ptr<Lock> m_lock; ///< the thread that asks has it too
    bool m_isWanted = false;
    std::string m_bus;
};

} // namespace bask
