#include "engine/device_simulators/stream_simulator.h"

#include "engine/base/units.h"
#include "engine/device_simulators/fault_names.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

const std::vector<std::string> kStreamFaults{"none", "silent", "open", "short", "frozen", "garbage"};
constexpr double kOpen_degC = 988.79, kShort_degC = -242.02; ///< what the converter makes of them
constexpr int kLate = 5; ///< rounds that a device without a reader has behind it; older ones are lost

template <class... Numbers> std::string printed(const char* format, Numbers... numbers) {
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), format, numbers...);
    return text.data();
}

} // namespace

StreamSimulator::StreamSimulator(const StreamSimulatorConfig& config)
    : m_config(config),
      m_true_K(static_cast<std::size_t>(std::max(config.channels, 0)), kelvinFromCelsius(25.0)),
      m_random(config.seed) {
    if (config.channels < 1 || (config.format == StreamFormat::Sketch && config.channels != 1) ||
        !(config.period_s > 0.0))
        throw std::invalid_argument("StreamSimulator: channels or period");
}

std::vector<std::string> StreamSimulator::faults() const {
    return kStreamFaults;
}

Result<void> StreamSimulator::setFault(const std::string& name) {
    if (const auto known = checkFault(name, kStreamFaults); !known)
        return known;
    m_fault = name;
    return {};
}

std::string StreamSimulator::transmit(double now_s) {
    if (!std::exchange(m_hasBegun, true))
        m_next_s = now_s;
    m_next_s = std::max(m_next_s, now_s - kLate * m_config.period_s);
    std::string said;
    for (; m_next_s <= now_s; m_next_s += m_config.period_s)
        said += print();
    return said;
}

std::string StreamSimulator::print() {
    if (m_fault != "frozen" || m_shown_degC.empty()) {
        std::normal_distribution<double> noise(0.0, 1.0);
        m_shown_degC.clear();
        for (const double true_K : m_true_K)
            m_shown_degC.push_back(celsiusFromKelvin(true_K) + m_config.noise_K * noise(m_random));
    }
    if (m_fault == "silent")
        return {};
    if (m_fault == "garbage")
        return "\x83T\xf1 =\x19 2\xb3.4\r\n";
    std::vector<double> values = m_shown_degC;
    if (m_fault == "open" || m_fault == "short")
        values.front() = m_fault == "open" ? kOpen_degC : kShort_degC;
    if (m_config.format == StreamFormat::Sketch)
        return printSketch(values.front());
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
        text += m_config.format == StreamFormat::Named
                    ? printed("T%d = %.2f\r\n", static_cast<int>(i) + 1, values[i])
                    : printed(i == 0 ? "%.2f" : ",%.2f", values[i]);
    if (m_config.format == StreamFormat::Row)
        return text + "\r\n";
    if (values.front() == kOpen_degC)
        text += "T1 Fault 0x80\r\n";
    if (values.front() == kShort_degC)
        text += "T1 Fault 0x40\r\n";
    return text;
}

/// Reference 430 ohm, R(t) linear: nobody reads these numbers.
std::string StreamSimulator::printSketch(double value_degC) const {
    const double resistance = std::clamp(100.0 + 0.385 * value_degC, 0.0, 430.0), ratio = resistance / 430.0;
    std::string text =
        printed("RTD value: %d\r\nRatio = %.8f\r\n", static_cast<int>(ratio * 32768.0), ratio) +
        printed("Resistance = %.8f\r\nTemperature = %.2f\r\n", resistance, value_degC);
    if (m_fault == "open")
        text += "Fault 0x80\r\nRTD High Threshold\r\n";
    if (m_fault == "short")
        text += "Fault 0x40\r\nRTD Low Threshold\r\n";
    return text + "\r\n";
}

} // namespace bask
