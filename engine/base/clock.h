#pragma once
// Time as a dependency: the engine asks a Clock, a simulation or a test turns it by hand.

namespace bask {

/// Monotonic time in seconds since an arbitrary start.
class Clock {
public:
    virtual ~Clock() = default;
    virtual double now_s() const = 0;
};

/// The computer's own: it never goes back, and goes on while the computer sleeps (CLOCK_BOOTTIME), so that
/// what is from before is old then.
class SteadyClock final : public Clock {
public:
    double now_s() const override;
};

/// A clock that stands still until it is advanced.
class ManualClock final : public Clock {
public:
    double now_s() const override { return m_now_s; }
    /// Throws std::logic_error when dt_s is negative.
    void advance(double dt_s) { advanceTo(m_now_s + dt_s); }
    /// Throws std::logic_error when time_s has passed.
    void advanceTo(double time_s);

private:
    double m_now_s = 0.0;
};

} // namespace bask
