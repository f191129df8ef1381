#pragma once
// How much of a longer work is done, and how long the rest may take, on standard error.

#include <chrono>
#include <string>

namespace bask {

/// On a terminal one line that is written over, from the second second on; else a line a minute. Use it on
/// one thread.
class Progress {
public:
    /// `unit` of what is counted ("runs"); empty: a share in percent is told.
    explicit Progress(double total, std::string unit = {});
    ~Progress(); ///< ends the line

    void tell(double done);

    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    double m_total;
    std::string m_unit;
    bool m_isTerminal;
    bool m_isShown = false;
    Clock::time_point m_start = Clock::now(), m_told = m_start;
};

/// "40 s", "12 min", "3 h 20 min", "4 days".
std::string roughDuration(double time_s);

} // namespace bask
