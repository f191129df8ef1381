#pragma once
// Measures how long the computer slept, by comparing a clock that stops during sleep with one that does not.

#include "engine/base/clock.h"

namespace bask {

/// A clock that stops while the computer sleeps (CLOCK_MONOTONIC).
class AwakeClock final : public Clock {
public:
    double now_s() const override;
};

class SuspendWatch {
public:
    static constexpr double kMin_s = 1.0; ///< a shorter time does not count as sleep

    /// Both clocks must outlive this object.
    SuspendWatch(const Clock& always, const Clock& awake);
    /// Returns how long the computer slept since the last call, s; 0 if it did not.
    double slept_s();

private:
    const Clock& m_always;
    const Clock& m_awake;
    double m_apart_s;
};

} // namespace bask
