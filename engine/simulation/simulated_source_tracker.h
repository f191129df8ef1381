#pragma once
// A simulated tracker of the source's pose, with noise, delay, and loss of sight.

#include "engine/base/clock.h"
#include "engine/devices/source_tracker.h"

#include <cstdint>
#include <deque>
#include <random>

namespace bask {

struct SimulatedTrackerConfig {
    double noise_m = 0.0;   ///< standard deviation of each coordinate in R
    double noise_rad = 0.0; ///< of each component of a rotation vector in R
    double delay_s = 0.0;
    std::uint64_t seed = 1;
};

/// Measures the true pose that observe() receives.
class SimulatedSourceTracker final : public SourceTracker {
public:
    SimulatedSourceTracker(const SimulatedTrackerConfig& config, const Clock& clock);

    /// Returns the newest pose that is at least delay_s old, with its time.
    Result<PoseReading> read() override;

    /// Takes the true pose at the clock's time.
    void observe(const Pose& X_RS);
    void setLost(bool lost) { m_lost = lost; }

private:
    struct Moment {
        double time_s;
        Pose X_RS;
    };
    SimulatedTrackerConfig m_config;
    const Clock& m_clock;
    std::mt19937_64 m_random;
    std::deque<Moment> m_history;
    bool m_lost = false;
};

} // namespace bask
