#pragma once
// Whether the source heats when it is asked to, and does not when it is not.

#include "engine/model/safety_spec.h"

#include <optional>

namespace bask {

class SourceWatch {
public:
    SourceWatch(const SafetySpec& limits, double room_K) : m_limits(limits), m_room_K(room_K) {}

    /// A valid reading; the set point while its heat is on. Times grow.
    void add(double time_s, double temperature_K, std::optional<double> setPoint_K);

    /// How long it has come no nearer to a set point far above it, s; empty: it heats as it should.
    std::optional<double> notHeatingFor_s() const;
    struct Warming {
        double gained_K = 0.0;
        double time_s = 0.0;
    };
    /// With its heat off.
    std::optional<Warming> heatsUnasked() const;
    /// How long it has become no cooler with its heat off, s, where it is hotter than this; empty: it cools,
    /// or is too slow to tell yet.
    std::optional<double> notCoolingFor_s(double above_K) const;

    /// Ever: one that cools slowly may pass the room's number, too.
    bool wasHeated() const { return m_wasHeated; }
    void use(bool wasHeated) { m_wasHeated = wasHeated; }
    /// What its heat did before is over; where it rests is not.
    void restart();
    /// As it tells and keeps it, degC, where a source that was not heated stands at the number that the room
    /// has in degrees Fahrenheit; empty: it does not.
    std::optional<double> roomInFahrenheit_degC() const;

private:
    static constexpr double kAtRest_s = 120.0;   ///< so long it has kept its temperature
    static constexpr double kAtRest_K = 0.5;     ///< a source that cools does not
    static constexpr double kCoolingTimes = 3.0; ///< as slow as heating may be: nothing drives it
    static constexpr double kOffTime_s = 1.5;    ///< until the order is taken, and seen in the readings
    SafetySpec m_limits;
    double m_room_K;
    bool m_wasOn = false;
    double m_turned_s = -1e300;                      ///< on or off
    double m_time_s = -1e300, m_temperature_K = 0.0; ///< newest
    double m_since_s = 0.0;                          ///< of the last progress; of the least with heat off
    double m_from_K = 0.0;                           ///< temperature then
    bool m_wasHeated = false;
    std::optional<double> m_restSince_s{}; ///< within kAtRest_K of the next since then
    double m_restAt_K = 0.0;
    double m_coolSince_s = 0.0, m_coolFrom_K = 0.0; ///< the last time it had become cooler
};

} // namespace bask
