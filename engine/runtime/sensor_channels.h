#pragma once
// The thermometers as the loop sees them: zeroed against each other, checked for age and plausibility, with
// their estimators.

#include "engine/base/result.h"
#include "engine/devices/thermometer.h"
#include "engine/session/experiment.h"
#include "engine/thermal/rate_estimator.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// One sensor a channel, in the objects' order.
class SensorChannels {
public:
    SensorChannels(std::size_t channels, const SamplingSpec& sampling);

    /// Takes new readings; invalid, implausible or repeated ones never enter an estimator.
    void add(const std::vector<Reading>& readings);

    std::size_t size() const { return m_channels.size(); }
    /// The newest valid reading is not older than three periods: one that drops out is not a lost sensor.
    bool fresh(std::size_t i, double now_s) const;
    /// Age of the newest valid reading, s.
    double age_s(std::size_t i, double now_s) const;
    bool lastInvalid(std::size_t i) const { return m_channels[i].lastInvalid; }
    double measured_K(std::size_t i) const;
    std::optional<RateEstimate> estimate(std::size_t i) const { return m_channels[i].estimator.estimate(); }
    /// All estimators have a full window.
    bool full() const;
    int leastCount() const;

    bool zeroed() const { return m_environment_K.has_value(); }
    /// Sets the offsets so that all channels agree at ambient, from the window's readings; also gives T3.
    /// Refuses when the window is not full or the readings are not those of objects at rest at ambient.
    Result<void> zero(double expectedEnvironment_K);
    /// T3 from zeroing, K.
    std::optional<double> environment_K() const { return m_environment_K; }

private:
    struct Channel {
        RateEstimator estimator;
        std::vector<Reading> window; ///< raw
        double offset_K = 0.0;
        bool lastInvalid = false;
    };
    SamplingSpec m_sampling;
    std::vector<Channel> m_channels;
    std::optional<double> m_environment_K;
};

} // namespace bask
