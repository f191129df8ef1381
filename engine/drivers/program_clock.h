#pragma once
// A program's clock beside ours, from the times that it writes into its answers.

#include <algorithm>
#include <optional>

namespace bask {

class ProgramClock {
public:
    /// Takes an answer that says `told_s`; it was written between its request at `sent_s` and now. Returns
    /// how far the program's clock is off since the first answer at least; 0 for that one.
    double off_s(double told_s, double sent_s, double now_s) {
        const double min_s = told_s - now_s, max_s = told_s - sent_s;
        if (!m_first)
            m_first = {min_s, max_s, now_s};
        return std::max({min_s - m_first->max_s, m_first->min_s - max_s, 0.0});
    }
    /// Returns for how long it is watched.
    double since_s(double now_s) const { return m_first ? now_s - m_first->at_s : 0.0; }

private:
    /// The program's clock minus ours, and when that was known.
    struct Offset {
        double min_s, max_s, at_s;
    };
    std::optional<Offset> m_first;
};

} // namespace bask
