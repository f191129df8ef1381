#pragma once
// The thermometers as the loop uses them: zeroed against each other, checked for age and plausibility, with
// their estimators.

#include "engine/base/result.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/runtime/heat_bounds.h"
#include "engine/runtime/zeroing.h"
#include "engine/thermal/contact_uncertainty.h"
#include "engine/thermal/rate_estimator.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Limits for accepting a sensor's readings.
struct SensorLimits {
    double stalePeriods = 3.0;
    std::vector<double> largestRates_K_s{}; ///< for each channel; empty: not checked
    int jumps = 3;                          ///< after so many in a row the sensor is distrusted
    /// for each channel's object; if empty, any reading is accepted after a long enough gap
    std::vector<HeatBounds> bounds{};
};

/// A reading that changed faster than heat can explain.
struct Jump {
    int inARow = 0;        ///< 0 if the newest reading is not a jump
    double rate_K_s = 0.0; ///< of the first of them
    double time_s = 0.0;   ///< of the newest
    double min_K = 0.0;    ///< minimum of the newest jumped readings that make a fault
    double began_s = 0.0;  ///< time of the first
    double from_K = 0.0;   ///< accepted before it
    double to_K = 0.0;     ///< the first
};

/// One sensor for each channel, in the objects' order. A sensor is distrusted if its readings jump, or come
/// back after a gap at a temperature that the heat cannot explain. Its readings are then rejected until
/// several in a row agree with the heat balance, if that distinguishes them from the wrong ones or determines
/// the temperature to kTold_K, or until a person confirms the sensor.
class SensorChannels {
public:
    SensorChannels(std::size_t channels, const SamplingSpec& sampling, SensorLimits limits = {});

    /// Takes new readings; invalid, implausible or repeated ones do not enter an estimator.
    void add(const std::vector<Reading>& readings);

    /// Call with the powers, K/s, that the objects have absorbed since the last call, dt_s ago.
    void advance(double dt_s, const std::vector<double>& powers_K_s);
    bool isDistrusted(std::size_t i) const { return m_channels[i].isDistrusted; }
    bool isTrusted(std::size_t i) const { return !isDistrusted(i) && !isDoubted(i); }
    /// Marks a sensor that does not follow its object's heat, until a person confirms it. Its readings are
    /// still accepted, so that a hot object is detected.
    void doubt(std::size_t i) { m_channels[i].isDoubted = true; }
    bool isDoubted(std::size_t i) const { return m_channels[i].isDoubted; }
    /// Returns the temperature range of the object by the heat balance; null if it is not computed.
    const HeatBounds* bounds(std::size_t i) const;
    /// Keeps distrust and doubt from `before`, which has the same sensors; additional channels are not
    /// changed.
    void useDistrust(const SensorChannels& before);
    /// Keeps readings, offsets, distrust and doubt from `before`, which has the same sensors and sampling.
    void useReadings(const SensorChannels& before);
    /// The same for other objects on the same rig: `from` has, for each channel, its channel in `before`; one
    /// without stays as it is.
    void useReadings(const SensorChannels& before, const std::vector<std::optional<std::size_t>>& from);
    /// Takes earlier readings of an object that rests at the room's temperature, and zeroes its sensor by
    /// them if the others are zeroed.
    void rest(std::size_t i, const std::vector<Reading>& readings);
    /// Whether the channel has no accepted reading.
    bool isEmpty(std::size_t i) const { return m_channels[i].window.empty(); }
    /// Newest plausible reading, trusted or not; NaN if there is none, or it is older than the stale periods.
    double told_K(std::size_t i, double now_s) const;
    /// Time of the newest plausible reading, s.
    double toldTime_s(std::size_t i) const { return m_channels[i].told.time_s; }
    /// Accepts the sensor's current reading and forgets its earlier ones. Returns false if there is no
    /// current plausible reading.
    bool confirm(std::size_t i, double now_s);

    static constexpr double kTold_K = 5.0;

    std::size_t size() const { return m_channels.size(); }
    /// Whether the newest accepted reading is not older than the stale periods: a single missing reading is
    /// not a lost sensor.
    bool fresh(std::size_t i, double now_s) const;
    /// Age of the newest accepted reading, s; infinite if there is none.
    double age_s(std::size_t i, double now_s) const;
    bool lastInvalid(std::size_t i) const { return m_channels[i].lastInvalid; }
    SensorFault lastFault(std::size_t i) const { return m_channels[i].lastFault; }
    /// Why the last reading was invalid, if its device says so; code None if it was not, or does not.
    const Message& lastReason(std::size_t i) const { return m_channels[i].lastReason; }
    Jump jump(std::size_t i) const { return m_channels[i].jump; }
    double largestRate_K_s(std::size_t i) const;
    double measured_K(std::size_t i) const;
    /// Standard uncertainty of measured_K(i) as its device tells it, else by the zeroing and the scatter of
    /// the readings (engine/thermal/contact_uncertainty.h); NaN while it is not known.
    double uncertainty_K(std::size_t i) const;
    std::optional<RateEstimate> estimate(std::size_t i) const { return m_channels[i].estimator.estimate(); }
    /// Whether all estimators have a full window.
    bool full() const;
    Message filling() const; ///< ReasonEstimatorFilling: how long it takes until it is

    /// Finds the offsets that make all channels agree at ambient temperature, from the window's readings, and
    /// T3. Refuses if the window is not full, or the readings are not those of objects at rest at ambient
    /// temperature.
    Result<Zeroing> findZero(double expectedEnvironment_K) const;
    /// Applies one offset to each channel. Throws std::invalid_argument for another number of offsets.
    void use(const Zeroing& zeroing);
    const std::optional<Zeroing>& zeroing() const { return m_zeroing; }

private:
    struct Channel {
        RateEstimator estimator;
        std::vector<Reading> window{}; ///< readings without the offset
        ReadingScatter scatter{};
        double offset_K = 0.0;
        bool lastInvalid = false;
        SensorFault lastFault = SensorFault::None;
        Message lastReason{};
        Jump jump{};
        std::vector<double> jumped_K{}; ///< newest rejected readings
        bool isDistrusted = false;
        bool isDoubted = false;
        bool isKnown = false;    ///< its window was full once; before that, its first readings may be wrong
        double power_K_s = 0.0;  ///< maximum of the last seconds, since a sensor lags behind its object
        int losses = 0;          ///< number of recent times that it was distrusted
        double lossEnds_s = 0.0; ///< end of the last of them
        int agreed = 0;          ///< agreeing readings in a row, while it is distrusted
        Reading told{};          ///< newest plausible reading
    };
    bool isJump(std::size_t i, const Reading& reading);
    bool isPossible(std::size_t i, const Reading& reading) const;
    void accept(std::size_t i, const Reading& reading);
    int minCount() const; ///< readings of the estimator that has the fewest

    SamplingSpec m_sampling;
    SensorLimits m_limits;
    std::vector<Channel> m_channels;
    std::optional<Zeroing> m_zeroing;
};

} // namespace bask
