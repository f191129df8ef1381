#include "engine/simulation/simulated_sensors.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {

SimulatedThermometer::SimulatedThermometer(const SimulatedThermometerConfig& config, const Clock& clock)
    : m_config(config), m_clock(clock), m_random(config.seed),
      m_troubles(static_cast<std::size_t>(config.channels)) {
    std::uniform_real_distribution<double> offset(-config.offset_K, config.offset_K);
    for (int i = 0; i < config.channels; ++i)
        m_offset_K.push_back(config.offset_K > 0.0 ? offset(m_random) : 0.0);
}

void SimulatedThermometer::useOffsets(const std::vector<double>& offsets_K) {
    for (std::size_t i = 0; i < std::min(offsets_K.size(), m_offset_K.size()); ++i)
        if (std::isfinite(offsets_K[i]))
            m_offset_K[i] = offsets_K[i];
}

void SimulatedThermometer::observe(const std::vector<double>& true_K) {
    if (true_K.size() != m_offset_K.size())
        throw std::invalid_argument("SimulatedThermometer: one temperature a channel");
    std::vector<double> felt_K = true_K;
    if (m_config.lag_s > 0.0 && !m_history.empty()) {
        const Moment& last = m_history.back();
        const double lagging = std::exp(-(m_clock.now_s() - last.time_s) / m_config.lag_s);
        for (std::size_t i = 0; i < felt_K.size(); ++i)
            felt_K[i] += (last.felt_K[i] - felt_K[i]) * lagging;
    }
    m_history.push_back({m_clock.now_s(), std::move(felt_K)});
    while (m_history.size() > 1 && m_history[1].time_s <= m_clock.now_s() - m_config.delay_s)
        m_history.pop_front();
}

Result<std::vector<Reading>> SimulatedThermometer::read() {
    std::vector<Reading> out(m_offset_K.size());
    if (m_history.empty())
        return out;
    std::normal_distribution<double> noise(0.0, 1.0);
    std::bernoulli_distribution dropout(m_config.dropout);
    const Moment& moment = m_history.front();
    for (std::size_t i = 0; i < out.size(); ++i) {
        double value = moment.felt_K[i] + m_offset_K[i] + m_config.noise_K * noise(m_random);
        if (m_config.resolution_K > 0.0)
            value = std::round(value / m_config.resolution_K) * m_config.resolution_K;
        const bool dropped = m_config.dropout > 0.0 && dropout(m_random);
        out[i] = troubled(i, value);
        if (dropped)
            out[i] = {m_clock.now_s(), std::numeric_limits<double>::quiet_NaN(), false};
    }
    if (m_swapped)
        std::swap(out.at(m_swapped->first), out.at(m_swapped->second));
    return out;
}

void SimulatedThermometer::setSwapped(std::size_t a, std::size_t b, bool isOn) {
    if (isOn)
        m_swapped = {a, b};
    else if (m_swapped == std::pair(a, b))
        m_swapped.reset();
}

void SimulatedThermometer::setTrouble(std::size_t channel, SensorTrouble trouble, double room_K) {
    Trouble& now = m_troubles.at(channel);
    if (now.kind != trouble) {
        now.since_s = m_clock.now_s();
        now.felt_K = m_history.empty() ? room_K : m_history.front().felt_K[channel];
    }
    now.kind = trouble;
    now.room_K = room_K;
}

Reading SimulatedThermometer::troubled(std::size_t channel, double value_K) {
    Trouble& trouble = m_troubles[channel];
    const double now_s = m_clock.now_s();
    const auto none = [&](SensorFault fault) {
        return Reading{now_s, std::numeric_limits<double>::quiet_NaN(), false, fault};
    };
    switch (trouble.kind) {
    case SensorTrouble::Lost:
        return none(SensorFault::None);
    case SensorTrouble::Open:
        return none(SensorFault::Open);
    case SensorTrouble::Short:
        return none(SensorFault::Short);
    case SensorTrouble::Frozen:
        return {now_s, trouble.last_K, true};
    case SensorTrouble::Jumping:
        if (std::fmod(now_s - trouble.since_s, 2.0 * kJumping_s) < kJumping_s)
            value_K += kJump_K;
        break;
    case SensorTrouble::Off: {
        const double left = m_offLag_s > 0.0 ? std::exp(-(now_s - trouble.since_s) / m_offLag_s) : 0.0;
        value_K +=
            trouble.room_K + (trouble.felt_K - trouble.room_K) * left - m_history.front().felt_K[channel];
        break;
    }
    case SensorTrouble::None:
        break;
    }
    trouble.last_K = value_K;
    return {now_s, value_K, true};
}

SimulatedHeatSource::SimulatedHeatSource(double temperature_K, double environment_K, const Clock& clock)
    : m_temperature_K(temperature_K), m_environment_K(environment_K), m_clock(clock),
      m_setPoint_K(temperature_K) {}

Result<Reading> SimulatedHeatSource::read() {
    if (m_trouble == SourceTrouble::LinkLost)
        return Error(MessageCode::ReasonSourceLost, {}, {"simulated link lost"});
    return Reading{m_clock.now_s(), m_temperature_K, m_trouble != SourceTrouble::Silent};
}

Result<void> SimulatedHeatSource::keepHeating(double setPoint_K, double validFor_s) {
    if (m_trouble == SourceTrouble::LinkLost)
        return Error(MessageCode::ReasonSourceLost, {}, {"simulated link lost"});
    m_setPoint_K = setPoint_K;
    m_expires_s = m_clock.now_s() + validFor_s;
    m_on = true;
    m_wasHeated = true;
    return {};
}

Result<void> SimulatedHeatSource::heatOff() {
    if (m_trouble == SourceTrouble::KeepsHeat && heating())
        return Error(MessageCode::SimulatedOrderNotTaken, {});
    m_on = false;
    if (m_trouble == SourceTrouble::LinkLost)
        return Error(MessageCode::ReasonSourceLost, {}, {"simulated link lost"});
    return {};
}

bool SimulatedHeatSource::heating() const {
    return m_on && m_clock.now_s() < m_expires_s + 1e-9;
}

HeatState SimulatedHeatSource::heatState() const {
    if (m_trouble == SourceTrouble::LinkLost)
        return HeatState::Unknown;
    return heating() ? HeatState::On : HeatState::Off;
}

std::optional<double> SimulatedHeatSource::setPoint_K() const {
    return m_setPoint_K - (m_trouble == SourceTrouble::Limited ? kLimited_K : 0.0);
}

std::optional<double> SimulatedHeatSource::heatingTime_s(double setPoint_K, double within_K) const {
    if (m_trouble != SourceTrouble::None)
        return std::nullopt;
    const double left_K = std::abs(setPoint_K - m_temperature_K);
    return left_K <= within_K ? 0.0 : kHeating_s * std::log(left_K / within_K);
}

void SimulatedHeatSource::advance(double dt_s) {
    const auto go = [&](double towards_K, double constant_s) {
        m_temperature_K += (towards_K - m_temperature_K) * -std::expm1(-dt_s / constant_s);
    };
    const bool isAlone = m_trouble == SourceTrouble::HeatsAlone && !heating();
    m_wasHeated = m_wasHeated || isAlone || m_trouble == SourceTrouble::Overheats;
    if (m_trouble == SourceTrouble::Overheats)
        m_temperature_K += kOverheating_K_s * dt_s;
    else if (isAlone)
        m_temperature_K += kAlone_K_s * dt_s;
    else if (heating() && m_trouble != SourceTrouble::NotHeating)
        go(*setPoint_K(), kHeating_s);
    else if (m_wasHeated)
        go(m_environment_K, kCooling_s);
}

} // namespace bask
