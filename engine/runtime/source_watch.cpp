#include "engine/runtime/source_watch.h"

#include "engine/base/units.h"
#include "engine/model/hand_warm.h"

#include <algorithm>
#include <cmath>

namespace bask {

void SourceWatch::use(bool wasHeated, double unasked_K) {
    m_wasHeated = wasHeated;
    m_before_K = unasked_K;
}

void SourceWatch::restart() {
    if (heatsUnasked()) // no reset makes it cool
        return;
    SourceWatch anew(m_limits, m_room_K);
    anew.m_wasHeated = m_wasHeated;
    anew.m_restSince_s = m_restSince_s;
    anew.m_restAt_K = m_restAt_K;
    anew.m_before_K = m_before_K;
    *this = anew;
}

void SourceWatch::add(double time_s, double temperature_K, std::optional<double> setPoint_K) {
    const bool isOn = setPoint_K.has_value();
    const bool isNearEnough = isOn && *setPoint_K - temperature_K <= m_limits.sourceBand_K;
    const bool isFirst = m_time_s < -1e299;
    const bool isBegun = isFirst || isOn != m_wasOn;
    if (isOn != m_wasOn)
        m_turned_s = time_s;
    const bool isTurning = !isOn && time_s - m_turned_s < kOffTime_s;
    const bool isAtRest = m_restSince_s && time_s - *m_restSince_s >= kAtRest_s;
    const bool isUnasked = heatsUnasked().has_value();
    const bool mayRest = !isUnasked || temperature_K <= m_room_K + kHandWarm_K;
    // One that is stuck on swings about a set point of its own, and its readings have noise.
    const double fall_K = isUnasked ? neededFall_K() : SafetySpec::kSourceGain_K;
    const bool isCooling = temperature_K <= std::max(m_from_K, m_peak_K - fall_K) || (isAtRest && mayRest);
    const bool isProgress = isOn ? temperature_K >= m_from_K + SafetySpec::kSourceGain_K : isCooling;
    if (isBegun || isNearEnough || isTurning || isProgress) {
        m_from_K = m_peak_K = temperature_K;
        m_since_s = m_peak_s = time_s;
    }
    if (isFirst && !isOn)
        m_from_K -= m_before_K;
    m_before_K = 0.0;
    if (temperature_K > m_peak_K) {
        m_peak_K = temperature_K;
        m_peak_s = time_s;
    }
    if (isBegun || isOn || temperature_K <= m_coolFrom_K - SafetySpec::kSourceGain_K) {
        m_coolFrom_K = temperature_K;
        m_coolSince_s = time_s;
    }
    m_wasHeated = m_wasHeated || isOn;
    if (!m_restSince_s || isOn || std::abs(temperature_K - m_restAt_K) > kAtRest_K) {
        m_restSince_s = time_s;
        m_restAt_K = temperature_K;
    }
    addOver(time_s, temperature_K, setPoint_K);
    m_wasOn = isOn;
    m_time_s = time_s;
    m_temperature_K = temperature_K;
}

void SourceWatch::addOver(double time_s, double temperature_K, std::optional<double> setPoint_K) {
    if (!setPoint_K || *setPoint_K < m_setPoint_K - kLowered_K)
        m_lowered_s = time_s;
    if (!setPoint_K || m_lowered_s == time_s)
        m_setPoint_K = 0.0;
    m_setPoint_K = std::max(m_setPoint_K, setPoint_K.value_or(0.0));
    const double over_K = setPoint_K ? temperature_K - *setPoint_K : 0.0;
    if (over_K <= std::max(kOver_K, kOverSetPoint * (setPoint_K.value_or(0.0) - m_room_K))) {
        m_over_K.reset();
        return;
    }
    if (!m_over_K)
        m_overSince_s = time_s;
    if (!m_over_K || temperature_K <= m_overPeak_K - kOverFall_K) {
        m_overFrom_s = time_s;
        m_overFrom_K = m_overPeak_K = temperature_K;
    }
    m_over_K = over_K;
    m_overPeak_K = std::max(m_overPeak_K, temperature_K);
}

std::optional<double> SourceWatch::over_K() const {
    const bool isShort = m_time_s - m_overSince_s < kOverTime_s || m_time_s - m_lowered_s < kLowered_s;
    const bool isWarming = m_overPeak_K >= m_overFrom_K + kOverRise_K;
    if (!m_over_K || isShort || !(isWarming || m_time_s - m_overFrom_s >= kOverStays_s))
        return std::nullopt;
    return m_over_K;
}

std::optional<double> SourceWatch::notHeatingFor_s() const {
    if (!m_wasOn || m_time_s - m_since_s < m_limits.sourceHeating_s)
        return std::nullopt;
    return m_time_s - m_since_s;
}

std::optional<SourceWatch::Warming> SourceWatch::heatsUnasked() const {
    if (m_wasOn || m_time_s < -1e299 || m_peak_K < m_from_K + m_limits.sourceUnasked_K)
        return std::nullopt;
    return Warming{m_peak_K - m_from_K, m_peak_s - m_since_s};
}

double SourceWatch::neededFall_K() const {
    return std::min(m_limits.sourceUnasked_K, kOverShare * (m_peak_K - m_from_K));
}

std::optional<UnaskedFall> SourceWatch::unaskedFall() const {
    if (!heatsUnasked())
        return std::nullopt;
    return UnaskedFall{m_peak_K - m_temperature_K, neededFall_K()};
}

std::optional<double> SourceWatch::roomInFahrenheit_degC() const {
    constexpr double kWithin_K = 5.0; // the room may differ from the stated one by 2.8 K
    const double told_degC = celsiusFromKelvin(m_temperature_K);
    const double room_degF = displayTemperature(m_room_K, TemperatureUnit::Fahrenheit);
    const bool isAtRest = !m_wasHeated && m_restSince_s && m_time_s - *m_restSince_s >= kAtRest_s;
    return isAtRest && std::abs(told_degC - room_degF) <= kWithin_K ? std::optional(told_degC) : std::nullopt;
}

std::optional<double> SourceWatch::notCoolingFor_s(double above_K) const {
    const double for_s = m_time_s - m_coolSince_s;
    if (m_wasOn || m_time_s < -1e299 || m_temperature_K <= above_K ||
        for_s < kCoolingTimes * m_limits.sourceHeating_s)
        return std::nullopt;
    return for_s;
}

} // namespace bask
