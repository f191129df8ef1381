#pragma once
// The thermometers as the loop sees them: zeroed against each other, checked for age and plausibility, with
// their estimators.

#include "engine/base/result.h"
#include "engine/devices/thermometer.h"
#include "engine/runtime/zeroing.h"
#include "engine/session/experiment.h"
#include "engine/thermal/rate_estimator.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What is believed of a sensor's readings.
struct SensorLimits {
    double stalePeriods = 3.0;
    std::vector<double> largestRates_K_s{}; ///< of each channel; empty: not watched
};

/// A reading that came faster than heat can.
struct Jump {
    int inARow = 0;        ///< 0: the newest reading is none
    double rate_K_s = 0.0; ///< of the first of them
    double time_s = 0.0;   ///< of the newest
    double least_K = 0.0;  ///< of them
};

/// One sensor a channel, in the objects' order.
class SensorChannels {
public:
    SensorChannels(std::size_t channels, const SamplingSpec& sampling, SensorLimits limits = {});

    /// Takes new readings; invalid, implausible or repeated ones never enter an estimator.
    void add(const std::vector<Reading>& readings);

    std::size_t size() const { return m_channels.size(); }
    /// The newest valid reading is not older than some periods: one that drops out is not a lost sensor.
    bool fresh(std::size_t i, double now_s) const;
    /// Age of the newest valid reading, s.
    double age_s(std::size_t i, double now_s) const;
    bool lastInvalid(std::size_t i) const { return m_channels[i].lastInvalid; }
    SensorFault lastFault(std::size_t i) const { return m_channels[i].lastFault; }
    Jump jump(std::size_t i) const { return m_channels[i].jump; }
    double largestRate_K_s(std::size_t i) const;
    double measured_K(std::size_t i) const;
    std::optional<RateEstimate> estimate(std::size_t i) const { return m_channels[i].estimator.estimate(); }
    /// All estimators have a full window.
    bool full() const;
    int leastCount() const;

    /// Offsets that make all channels agree at ambient, from the window's readings, and T3. Refuses when the
    /// window is not full or the readings are not those of objects at rest at ambient.
    Result<Zeroing> findZero(double expectedEnvironment_K) const;
    /// One offset a channel. Throws std::invalid_argument on another number.
    void use(const Zeroing& zeroing);
    const std::optional<Zeroing>& zeroing() const { return m_zeroing; }

private:
    struct Channel {
        RateEstimator estimator;
        std::vector<Reading> window{}; ///< raw
        double offset_K = 0.0;
        bool lastInvalid = false;
        SensorFault lastFault = SensorFault::None;
        Jump jump{};
    };
    bool isJump(std::size_t i, const Reading& reading);

    SamplingSpec m_sampling;
    SensorLimits m_limits;
    std::vector<Channel> m_channels;
    std::optional<Zeroing> m_zeroing;
};

} // namespace bask
