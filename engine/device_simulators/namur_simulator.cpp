#include "engine/device_simulators/namur_simulator.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/fault_names.h"
#include "engine/protocols/namur_lines.h"
#include "engine/protocols/plain_number.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace bask {
namespace {

const std::vector<std::string> kNamurFaults{"none",     "silent",  "garbage",      "wrong-channel",
                                            "stuck-on", "no-heat", "setpoint-zero"};
constexpr double kStuckAt_degC = 300.0; ///< where an element that nobody switches off ends
/// What a line with the wrong speed gives.
constexpr std::string_view kGarbage = "\x81\xfe~8\x03.\xff\x10 2\r\n";

/// The number after a command's words, "OUT_SP_1 80.0".
std::optional<double> numberAfter(std::string_view command, std::string_view words) {
    return command.starts_with(words) ? plainNumber(withoutBlanks(command.substr(words.size())))
                                      : std::nullopt;
}

} // namespace

NamurSimulator::NamurSimulator(const NamurSimulatorConfig& config)
    : m_config(config), m_temperature_K(config.ambient_K), m_setPoint_K(kZeroCelsius_K) {}

std::vector<std::string> NamurSimulator::faults() const {
    return kNamurFaults;
}

Result<void> NamurSimulator::setFault(const std::string& name) {
    if (const auto known = checkFault(name, kNamurFaults); !known)
        return known;
    m_fault = name;
    m_answers.clear();
    return {};
}

void NamurSimulator::warm(double dt_s) {
    const bool isHot = m_fault == "stuck-on" || (m_isOn && m_fault != "no-heat");
    const double wanted_K = m_fault == "stuck-on" ? kelvinFromCelsius(kStuckAt_degC) : m_setPoint_K;
    const bool isHeated = isHot && wanted_K > m_temperature_K;
    const double towards_K = isHot && wanted_K > m_config.ambient_K ? wanted_K : m_config.ambient_K;
    const double constant_s = isHeated ? m_config.heating_s : m_config.cooling_s;
    m_temperature_K += (towards_K - m_temperature_K) * -std::expm1(-dt_s / constant_s);
}

/// To now, with the watchdog's end on the way.
void NamurSimulator::advance(double now_s) {
    if (!std::exchange(m_hasBegun, true))
        m_now_s = now_s;
    if (m_watchdog_s > 0.0 && now_s >= m_watchdogAt_s) {
        warm(m_watchdogAt_s - m_now_s);
        m_now_s = m_watchdogAt_s;
        m_watchdog_s = 0.0;
        m_isOn = false;
        m_isTripped = true;
    }
    warm(now_s - m_now_s);
    m_now_s = now_s;
}

void NamurSimulator::receive(std::string_view bytes, double now_s) {
    advance(now_s);
    if (m_fault == "silent")
        return;
    m_lines.add(bytes);
    while (const auto line = m_lines.next()) {
        std::string said = answer(withoutBlanks(*line));
        if (!said.empty() && m_fault == "garbage")
            said = kGarbage;
        if (!said.empty())
            m_answers.push_back({now_s + m_config.delay_s, said});
    }
}

std::string NamurSimulator::transmit(double now_s) {
    advance(now_s);
    std::string said;
    for (; !m_answers.empty() && m_answers.front().due_s <= now_s; m_answers.pop_front())
        said += m_answers.front().bytes;
    return said;
}

std::string NamurSimulator::value(double temperature_K, int channel) const {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.1f %d \r\n", celsiusFromKelvin(temperature_K),
                  m_fault == "wrong-channel" ? channel + 3 : channel);
    return text.data();
}

/// Empty to what is only done, or not known.
std::string NamurSimulator::answer(std::string_view command) {
    if (command == namur::kName)
        return m_config.name + " \r\n";
    if (command == namur::kProbe)
        return value(m_temperature_K, 1);
    if (command == namur::kPlate)
        return value(m_temperature_K, 2);
    if (command == namur::kSetPoint)
        return value(m_setPoint_K, 1);
    if (command == namur::kStart) {
        m_isOn = true;
        m_isTripped = false;
    }
    if (command == namur::kStop)
        m_isOn = false;
    if (const auto wanted = numberAfter(command, "OUT_SP_1 "))
        if (*wanted >= 0.0 && *wanted <= namur::kHighest_degC)
            m_setPoint_K = kelvinFromCelsius(m_fault == "setpoint-zero" ? 0.0 : *wanted);
    const auto watchdog = numberAfter(command, "OUT_WD1@");
    if (!watchdog || *watchdog < namur::kShortestWatchdog_s || *watchdog > namur::kLongestWatchdog_s)
        return {};
    m_watchdog_s = *watchdog;
    m_watchdogAt_s = m_now_s + *watchdog;
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.1f \r\n", *watchdog);
    return text.data();
}

} // namespace bask
