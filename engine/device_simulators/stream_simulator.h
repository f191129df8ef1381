#pragma once
// A simulated thermometer that prints its temperatures unasked, as sketches for the MAX31865 do.

#include "engine/device_simulators/byte_device.h"

#include <random>

namespace bask {

enum class StreamFormat {
    Sketch, ///< "Temperature = 15.09" with its register and ratio, one channel: Adafruit's demo
    Named,  ///< "T1 = 23.40"
    Row     ///< "23.40,25.10,30.00"
};

struct StreamSimulatorConfig {
    int channels = 3;
    StreamFormat format = StreamFormat::Named;
    double period_s = 0.1;
    double noise_K = 0.02; ///< standard deviation
    std::uint64_t seed = 1;
};

/// Faults of the first channel: "open" and "short" as the converter reports them. Faults of all channels:
/// "silent", "frozen" (the same values again and again), "garbage".
class StreamSimulator final : public ByteDevice {
public:
    /// Throws std::invalid_argument for no channel, or a sketch with several.
    explicit StreamSimulator(const StreamSimulatorConfig& config = {});

    /// Ignores what it receives.
    void receive(std::string_view, double) override {}
    std::string transmit(double now_s) override;
    std::vector<std::string> faults() const override;
    Result<void> setFault(const std::string& name) override;

    /// Sets the true temperatures, one for each channel; they are 25 degC before that.
    void setTemperatures(const std::vector<double>& temperatures_K) { m_true_K = temperatures_K; }

private:
    std::string print();
    std::string printSketch(double value_degC) const;

    StreamSimulatorConfig m_config;
    std::vector<double> m_true_K;
    std::vector<double> m_shown_degC;
    std::string m_fault = "none";
    std::mt19937_64 m_random;
    double m_next_s = 0.0;
    bool m_hasBegun = false;
};

} // namespace bask
