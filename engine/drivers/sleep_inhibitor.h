#pragma once
// Prevents this computer from going to sleep, if its system has logind.

#include <memory>
#include <string>

namespace bask {

/// Uses its own thread, so no call here waits for the system.
class SleepInhibitor {
public:
    /// `bus` is the address of logind's D-Bus; empty: the system's bus.
    explicit SleepInhibitor(std::string bus = {});
    ~SleepInhibitor(); ///< the computer may sleep again

    /// Sets whether the computer must stay awake ("sleep:idle" blocked).
    void keepAwake(bool isWanted);
    bool isKept() const;
    /// Returns why the last request to stay awake failed; empty if it succeeded, or is in progress.
    std::string problem() const;

private:
    struct Lock;
    std::shared_ptr<Lock> m_lock; ///< shared with the thread that makes the request
    bool m_isWanted = false;
    std::string m_bus;
};

} // namespace bask
