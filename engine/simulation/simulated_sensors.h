#pragma once
// Simulated thermometers (offset, noise, resolution, lag, delay, dropouts, lost) and the simulated heat
// source behind a shutter.

#include "engine/base/clock.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/thermometer.h"

#include <deque>
#include <random>

namespace bask {

struct SimulatedThermometerConfig {
    int channels = 0;
    double noise_K = 0.02;     ///< standard deviation
    double resolution_K = 0.1; ///< 0: none
    double offset_K = 0.0;     ///< each channel's constant error is uniform in +- this
    double delay_s = 0.0;
    std::uint64_t seed = 1;
    double lag_s = 0.0;   ///< time constant, first order
    double dropout = 0.0; ///< probability that a channel gives no reading
};

/// Follows true temperatures that it is given by observe().
class SimulatedThermometer final : public Thermometer {
public:
    SimulatedThermometer(const SimulatedThermometerConfig& config, const Clock& clock);

    int channels() const override { return m_config.channels; }
    Result<std::vector<Reading>> read() override;

    /// True temperatures at the clock's time.
    void observe(const std::vector<double>& true_K);
    /// A lost channel answers, but as an open sensor.
    void setLost(std::size_t channel, bool lost) { m_lost.at(channel) = lost; }

private:
    struct Moment {
        double time_s;
        std::vector<double> felt_K; ///< of the sensor itself, which lags behind its object
    };
    SimulatedThermometerConfig m_config;
    const Clock& m_clock;
    std::mt19937_64 m_random;
    std::vector<double> m_offset_K;
    std::vector<bool> m_lost;
    std::deque<Moment> m_history;
};

/// A plate kept at its set temperature behind a shutter: heat on opens the shutter, heat off closes it and
/// lets the plate cool slowly.
class SimulatedHeatSource final : public HeatSource {
public:
    static constexpr double kCooling_s =
        600.0; ///< time constant of the plate with the heat off after it has been on
    static constexpr double kHeating_s = 60.0; ///< time constant towards the set point

    SimulatedHeatSource(double temperature_K, double environment_K, const Clock& clock);

    Result<Reading> read() override;
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    Result<void> heatOff() override;
    bool heating() const override;

    void advance(double dt_s);
    double temperature_K() const { return m_temperature_K; }
    void setLinkLost(bool lost) { m_linkLost = lost; }

private:
    double m_temperature_K;
    double m_environment_K;
    const Clock& m_clock;
    double m_setPoint_K;
    double m_expires_s = 0.0;
    bool m_on = false;
    bool m_everOn = false;
    bool m_linkLost = false;
};

} // namespace bask
