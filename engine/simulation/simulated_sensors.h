#pragma once
// Simulated thermometers (offset, noise, resolution, lag, delay, dropouts, lost) and the simulated heat
// source behind a shutter.

#include "engine/base/clock.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/thermometer.h"

#include <deque>
#include <optional>
#include <random>
#include <utility>

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

/// The faults of a simulated sensor.
enum class SensorTrouble {
    None,
    Lost,    ///< gives no value
    Open,    ///< gives no value and reports it
    Short,   ///< gives no value and reports it
    Frozen,  ///< repeats its last value
    Jumping, ///< reads kJump_K too much in every other kJumping_s
    Off      ///< has come off its object: approaches the room's temperature, see setOffLag
};

/// Measures the true temperatures that observe() receives.
class SimulatedThermometer final : public Thermometer {
public:
    SimulatedThermometer(const SimulatedThermometerConfig& config, const Clock& clock);

    int channels() const override { return m_config.channels; }
    Result<std::vector<Reading>> read() override;

    /// Takes the true temperatures at the clock's time.
    void observe(const std::vector<double>& true_K);
    void setLost(std::size_t channel, bool lost) {
        setTrouble(channel, lost ? SensorTrouble::Lost : SensorTrouble::None);
    }
    /// Sets a fault; `room_K` is the reading of a sensor that has come off.
    void setTrouble(std::size_t channel, SensorTrouble trouble, double room_K = 298.15);
    /// Lets two channels give each other's readings, or no longer; one pair at a time.
    void setSwapped(std::size_t a, std::size_t b, bool isOn);
    SensorTrouble trouble(std::size_t channel) const { return m_troubles.at(channel).kind; }
    /// Returns the swapped pair; empty: none.
    const std::optional<std::pair<std::size_t, std::size_t>>& swapped() const { return m_swapped; }
    /// Sets the time constant in still air of sensors that come off, s; 0: they read the room's temperature
    /// at once.
    void setOffLag(double lag_s) { m_offLag_s = lag_s; }
    /// The constant error of each channel, K.
    const std::vector<double>& offsets_K() const { return m_offset_K; }
    /// Takes the finite ones of them, a channel each.
    void useOffsets(const std::vector<double>& offsets_K);

    static constexpr double kJump_K = 30.0;
    static constexpr double kJumping_s = 10.0;

private:
    struct Moment {
        double time_s;
        std::vector<double> felt_K; ///< temperature of the sensor itself, which lags behind its object
    };
    struct Trouble {
        SensorTrouble kind = SensorTrouble::None;
        double since_s = 0.0;
        double room_K = 0.0;
        double felt_K = 0.0; ///< when it started
        double last_K = 0.0; ///< last reported
    };
    Reading troubled(std::size_t channel, double value_K);

    SimulatedThermometerConfig m_config;
    const Clock& m_clock;
    std::mt19937_64 m_random;
    double m_offLag_s = 0.0;
    std::vector<double> m_offset_K;
    std::vector<Trouble> m_troubles;
    std::optional<std::pair<std::size_t, std::size_t>> m_swapped;
    std::deque<Moment> m_history;
};

/// The faults of a simulated source.
enum class SourceTrouble {
    None,
    LinkLost,
    Silent,     ///< reports no temperature
    NotHeating, ///< accepts commands, and cools
    HeatsAlone, ///< warms by kAlone_K_s with its heat off
    Overheats,  ///< warms by kOverheating_K_s, at any set point
    Limited,    ///< limits itself to kLimited_K below its set point
    KeepsHeat   ///< does not obey the command to switch off
};

/// A plate at its set temperature behind a shutter: heat on opens the shutter, heat off closes it and lets
/// the plate cool slowly.
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
    HeatState heatState() const override;
    std::optional<double> setPoint_K() const override;

    void advance(double dt_s);
    double temperature_K() const { return m_temperature_K; }
    /// Temperature of a plate that was heated once; empty: it is as at the start.
    std::optional<double> heatedTo_K() const {
        return m_wasHeated ? std::optional(m_temperature_K) : std::nullopt;
    }
    void setHeatedTo(double temperature_K) {
        m_temperature_K = temperature_K;
        m_wasHeated = true;
    }
    void setLinkLost(bool lost) { m_trouble = lost ? SourceTrouble::LinkLost : SourceTrouble::None; }
    void setTrouble(SourceTrouble trouble) { m_trouble = trouble; }
    SourceTrouble trouble() const { return m_trouble; }
    /// Returns how long it takes to come within this of a set point if it is heated from now on, s; empty
    /// with a fault.
    std::optional<double> heatingTime_s(double setPoint_K, double within_K) const;

    static constexpr double kAlone_K_s = 1.0;
    static constexpr double kOverheating_K_s = 2.0;
    static constexpr double kLimited_K = 20.0;

private:
    double m_temperature_K;
    double m_environment_K;
    const Clock& m_clock;
    double m_setPoint_K;
    double m_expires_s = 0.0;
    bool m_on = false;
    bool m_wasHeated = false;
    SourceTrouble m_trouble = SourceTrouble::None;
};

} // namespace bask
