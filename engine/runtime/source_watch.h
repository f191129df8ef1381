#pragma once
// Checks that the source heats when commanded, not beyond its set point, and does not heat otherwise.

#include "engine/model/safety_spec.h"
#include "engine/runtime/unasked_fall.h"

#include <optional>

namespace bask {

class SourceWatch {
public:
    SourceWatch(const SafetySpec& limits, double room_K) : m_limits(limits), m_room_K(room_K) {}

    /// Takes a valid reading, and the set point while its heat is commanded. Times must increase.
    void add(double time_s, double temperature_K, std::optional<double> setPoint_K);

    /// How long the source has not come nearer to a set point far above it, s; empty if it heats as it
    /// should.
    std::optional<double> notHeatingFor_s() const;
    /// How far the source is above its set point, K, if that is far, and it warms or has not cooled for long;
    /// empty if not, and for a while after the set point was lowered.
    std::optional<double> over_K() const;
    struct Warming {
        double gained_K = 0.0;
        double time_s = 0.0;
    };
    /// The warming from the minimum to the maximum with the heat off; empty if it is within the limit, and
    /// once the source has lost half of it again, or as much as the limit, or is at rest and no hotter than a
    /// hand bears: one that is stuck on at a set point of its own rests as well, after an overshoot.
    std::optional<Warming> heatsUnasked() const;
    /// The fall of such a source; empty if there is none.
    std::optional<UnaskedFall> unaskedFall() const;
    /// How long the source has not become cooler with its heat off, s, if it is hotter than `above_K`; empty
    /// if it cools, or if the time is too short to tell.
    std::optional<double> notCoolingFor_s(double above_K) const;

    /// Whether the source was ever heated: one that cools slowly may also pass the number of the room's
    /// temperature.
    bool wasHeated() const { return m_wasHeated; }
    /// Continues the watch of an earlier one: `unasked_K` is the warming that it has found, 0 for none.
    void use(bool wasHeated, double unasked_K);
    /// Forgets the earlier heating and cooling, but not the temperature at which the source rests, nor that
    /// it heats unasked.
    void restart();
    /// The reading, degC, if a source that was never heated stays at the number that the room's temperature
    /// has in degrees Fahrenheit; otherwise empty.
    std::optional<double> roomInFahrenheit_degC() const;

private:
    double neededFall_K() const;

    /// the source is at rest if it has kept its temperature for this time
    static constexpr double kAtRest_s = 120.0;
    static constexpr double kAtRest_K = 0.5;      ///< a cooling source changes by more
    static constexpr double kOverShare = 0.5;     ///< of an unasked warming: lost again, it is over
    static constexpr double kCoolingTimes = 3.0;  ///< cooling may be slower than heating by this factor
    static constexpr double kOffTime_s = 1.5;     ///< until a command takes effect in the readings
    static constexpr double kOver_K = 10.0;       ///< far above a set point: this,
    static constexpr double kOverSetPoint = 0.05; ///< or this share of what the set point is over the room
    static constexpr double kOverTime_s = 5.0;    ///< a shorter time is none
    static constexpr double kOverRise_K = 3.0;    ///< more than the noise of a reading: it warms
    static constexpr double kOverFall_K = 2.0;    ///< it cools
    static constexpr double kOverStays_s = 120.0; ///< without cooling
    static constexpr double kLowered_K = 1.0;     ///< another set point than before
    static constexpr double kLowered_s = 30.0;    ///< a heavy source goes on warming for a while
    void addOver(double time_s, double temperature_K, std::optional<double> setPoint_K);
    SafetySpec m_limits;
    double m_room_K;
    bool m_wasOn = false;
    double m_turned_s = -1e300;                      ///< time when the heat was last switched on or off
    double m_time_s = -1e300, m_temperature_K = 0.0; ///< newest reading
    double m_since_s = 0.0;  ///< time of the last progress; with heat off, of the minimum
    double m_from_K = 0.0;   ///< temperature at m_since_s
    double m_peak_K = 0.0;   ///< maximum since then
    double m_peak_s = 0.0;   ///< its time
    double m_before_K = 0.0; ///< warming that an earlier watch has found, until the first reading
    bool m_wasHeated = false;
    std::optional<double> m_restSince_s{}; ///< since when the temperature is within kAtRest_K of m_restAt_K
    double m_restAt_K = 0.0;
    double m_coolSince_s = 0.0, m_coolFrom_K = 0.0; ///< when it had last become cooler
    std::optional<double> m_over_K{};               ///< above the set point, if that is far
    double m_overSince_s = 0.0;
    double m_overFrom_s = 0.0, m_overFrom_K = 0.0; ///< when it was far above, or had last become cooler
    double m_overPeak_K = 0.0;                     ///< since then
    double m_setPoint_K = 0.0;                     ///< the highest since it was lowered last
    double m_lowered_s = -1e300;
};

} // namespace bask
