#pragma once
// How much of a longer work is done, and how long the rest may take, on standard error.

#include "engine/base/share_done.h"

#include <chrono>
#include <functional>
#include <string>

namespace bask {

/// On a terminal one line that is written over, from the second second on; else a line a minute. Use it on
/// one thread.
class Progress {
public:
    /// `unit` of what is counted ("runs"); empty: a share in percent is told. AtMost: the work may end before
    /// all of it is done, so what is left is the longest time.
    enum class Total { Exact, AtMost };
    explicit Progress(double total, std::string unit = {}, Total kind = Total::Exact);
    ~Progress(); ///< ends the line

    /// `besides` is asked only when something is told, and stands at the end of the line.
    void tell(double done, const std::function<std::string()>& besides = {});
    /// Erases the line where it is shown, so that something else can be written there.
    void makeRoom();
    /// For a work that tells its share, on the thread of this; `this` outlives it.
    ShareDone share();

    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    double m_total;
    std::string m_unit;
    Total m_kind;
    bool m_isTerminal;
    bool m_isShown = false;
    Clock::time_point m_start = Clock::now(), m_told = m_start;
};

/// "40 s", "12 min", "3 h 20 min", "4 days".
std::string roughDuration(double time_s);

} // namespace bask
