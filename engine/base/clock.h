#pragma once
// Time as a dependency: the engine reads a Clock, so that a simulation or a test can set the time.

namespace bask {

/// Monotonic time in seconds since an arbitrary start.
class Clock {
public:
    virtual ~Clock() = default;
    virtual double now_s() const = 0;
};

/// The computer's clock. It never goes back and continues while the computer sleeps (CLOCK_BOOTTIME), so that
/// a value from before the sleep counts as old.
class SteadyClock final : public Clock {
public:
    double now_s() const override;
};

/// A clock that stands still until it is advanced.
class ManualClock final : public Clock {
public:
    double now_s() const override { return m_now_s; }
    /// Advances the clock by dt_s. Throws std::logic_error if dt_s is negative.
    void advance(double dt_s) { advanceTo(m_now_s + dt_s); }
    /// Advances the clock to time_s. Throws std::logic_error if time_s is in the past.
    void advanceTo(double time_s);

private:
    double m_now_s = 0.0;
};

/// The time of day in UTC, seconds since 1970: for people and files. It can jump.
double utcNow_s();

} // namespace bask
