#include "engine/simulation/simulated_sensors.h"

#include "engine/base/message_code.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {

SimulatedThermometer::SimulatedThermometer(const SimulatedThermometerConfig& config, const Clock& clock)
    : m_config(config), m_clock(clock), m_random(config.seed),
      m_lost(static_cast<std::size_t>(config.channels), false) {
    std::uniform_real_distribution<double> offset(-config.offset_K, config.offset_K);
    for (int i = 0; i < config.channels; ++i)
        m_offset_K.push_back(config.offset_K > 0.0 ? offset(m_random) : 0.0);
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
        if (m_lost[i] || dropped)
            out[i] = {m_clock.now_s(), std::numeric_limits<double>::quiet_NaN(), false};
        else
            out[i] = {m_clock.now_s(), value, true};
    }
    return out;
}

SimulatedHeatSource::SimulatedHeatSource(double temperature_K, double environment_K, const Clock& clock)
    : m_temperature_K(temperature_K), m_environment_K(environment_K), m_clock(clock),
      m_setPoint_K(temperature_K) {}

Result<Reading> SimulatedHeatSource::read() {
    if (m_linkLost)
        return Error(MessageCode::ReasonSourceLost, {}, {"simulated link lost"});
    return Reading{m_clock.now_s(), m_temperature_K, true};
}

Result<void> SimulatedHeatSource::keepHeating(double setPoint_K, double validFor_s) {
    if (m_linkLost)
        return Error(MessageCode::ReasonSourceLost, {}, {"simulated link lost"});
    m_setPoint_K = setPoint_K;
    m_expires_s = m_clock.now_s() + validFor_s;
    m_on = true;
    m_everOn = true;
    return {};
}

Result<void> SimulatedHeatSource::heatOff() {
    m_on = false;
    if (m_linkLost)
        return Error(MessageCode::ReasonSourceLost, {}, {"simulated link lost"});
    return {};
}

bool SimulatedHeatSource::heating() const {
    return m_on && m_clock.now_s() < m_expires_s + 1e-9;
}

void SimulatedHeatSource::advance(double dt_s) {
    if (heating())
        m_temperature_K += (m_setPoint_K - m_temperature_K) * -std::expm1(-dt_s / kHeating_s);
    else if (m_everOn)
        m_temperature_K += (m_environment_K - m_temperature_K) * -std::expm1(-dt_s / kCooling_s);
}

} // namespace bask
