#pragma once
// The thermometers as the loop sees them: zeroed against each other, checked for age and plausibility, with
// their estimators.

#include "engine/base/result.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/runtime/heat_bounds.h"
#include "engine/runtime/zeroing.h"
#include "engine/thermal/rate_estimator.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What is believed of a sensor's readings.
struct SensorLimits {
    double stalePeriods = 3.0;
    std::vector<double> largestRates_K_s{}; ///< of each channel; empty: not watched
    int jumps = 3;                          ///< so many in a row, and the sensor is distrusted
    std::vector<HeatBounds> bounds{}; ///< of each channel's object; empty: age lets a reading be anything
};

/// A reading that came faster than heat can.
struct Jump {
    int inARow = 0;        ///< 0: the newest reading is none
    double rate_K_s = 0.0; ///< of the first of them
    double time_s = 0.0;   ///< of the newest
    double min_K = 0.0;    ///< of the newest that make a fault
};

/// One sensor a channel, in the objects' order. A sensor whose readings jump, or come back after a gap where
/// the heat cannot have brought the object, is distrusted: no reading of it is taken until some in a row
/// agree with the heat balance, where that tells them from the wrong ones or tells the temperature to
/// kTold_K, or until a person confirms it.
class SensorChannels {
public:
    SensorChannels(std::size_t channels, const SamplingSpec& sampling, SensorLimits limits = {});

    /// Takes new readings; invalid, implausible or repeated ones never enter an estimator.
    void add(const std::vector<Reading>& readings);

    /// The objects have absorbed these powers, K/s, since the last call, which was so long ago.
    void advance(double dt_s, const std::vector<double>& powers_K_s);
    bool isDistrusted(std::size_t i) const { return m_channels[i].isDistrusted; }
    bool isTrusted(std::size_t i) const { return !isDistrusted(i) && !isDoubted(i); }
    /// It was seen not to follow its object's heat. Its readings are taken all the same, so that what is hot
    /// is seen, until a person confirms it.
    void doubt(std::size_t i) { m_channels[i].isDoubted = true; }
    bool isDoubted(std::size_t i) const { return m_channels[i].isDoubted; }
    /// Where the object is by the heat balance.
    const HeatBounds* bounds(std::size_t i) const;
    /// Those that were distrusted or doubted before are so still. Of the same sensors; not of more channels.
    void useDistrust(const SensorChannels& before);
    /// Newest plausible reading, believed or not; NaN: there is none, or it is older than some periods.
    double told_K(std::size_t i, double now_s) const;
    /// Believes what the sensor tells now, and forgets what it told before. False: it tells nothing.
    bool confirm(std::size_t i, double now_s);

    static constexpr double kTold_K = 5.0;

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
    int minCount() const;

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
        std::vector<double> jumped_K{}; ///< newest that were not believed
        bool isDistrusted = false;
        bool isDoubted = false;
        bool isKnown = false;    ///< its window has been full: before, its first readings may be wrong
        double power_K_s = 0.0;  ///< most of the last seconds: a sensor lags behind its object
        int losses = 0;          ///< how often it was distrusted, not long apart
        double lossEnds_s = 0.0; ///< of the last of them
        int agreed = 0;          ///< readings in a row, while it is distrusted
        Reading told{};          ///< newest plausible one
    };
    bool isJump(std::size_t i, const Reading& reading);
    bool isPossible(std::size_t i, const Reading& reading) const;
    void accept(std::size_t i, const Reading& reading);

    SamplingSpec m_sampling;
    SensorLimits m_limits;
    std::vector<Channel> m_channels;
    std::optional<Zeroing> m_zeroing;
};

} // namespace bask
