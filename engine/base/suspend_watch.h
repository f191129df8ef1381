#pragma once
// Time in which the computer slept: a clock that stands still then, beside one that does not.

#include "engine/base/clock.h"

namespace bask {

/// Stands still while the computer sleeps (CLOCK_MONOTONIC).
class AwakeClock final : public Clock {
public:
    double now_s() const override;
};

class SuspendWatch {
public:
    static constexpr double kMin_s = 1.0; ///< less is no sleep

    /// Both outlive it.
    SuspendWatch(const Clock& always, const Clock& awake);
    /// How long it slept since the last call, s; 0: not.
    double slept_s();

private:
    const Clock& m_always;
    const Clock& m_awake;
    double m_apart_s;
};

} // namespace bask
