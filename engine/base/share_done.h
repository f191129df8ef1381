#pragma once
// How much of a longer work is done, for whoever waits for it.

#include <functional>

namespace bask {

/// Is told the share of a work that is done, 0 to 1, never less than before and some hundred times at most,
/// on the thread that the work was asked of. Empty: nobody wants to know.
using ShareDone = std::function<void(double share)>;

/// Returns what a part of a work tells, which goes from `begin` to `end` of the whole; empty if `whole` is.
ShareDone partOf(const ShareDone& whole, double begin, double end);

/// Tells it, if anybody wants to know.
void tellShare(const ShareDone& done, double share);

/// Counts the steps of a work, and tells each hundredth of it once.
class ShareCount {
public:
    /// `steps`: about how many there are; more are told as all.
    ShareCount(ShareDone told, double steps);

    void add(double steps = 1.0) {
        m_done += steps;
        if (m_done >= m_next)
            tell();
    }

private:
    void tell();

    ShareDone m_told;
    double m_steps;
    double m_done = 0.0;
    double m_next; ///< when it is told again
};

} // namespace bask
