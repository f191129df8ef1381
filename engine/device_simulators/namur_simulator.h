#pragma once
// A simulated NAMUR hotplate (IKA): lines, plate, and a watchdog that switches it off.

#include "engine/device_simulators/byte_device.h"
#include "engine/protocols/line_splitter.h"

#include <deque>

namespace bask {

struct NamurSimulatorConfig {
    double ambient_K = 293.15;
    double heating_s = 60.0;  ///< time constant towards the set point
    double cooling_s = 600.0; ///< towards ambient, or down to the set point
    double delay_s = 0.02;    ///< delay of an answer
    std::string name = "IKA simulated";
};

/// Faults: "silent" receives but sends nothing, "garbage" sends noise, "wrong-channel" answers for another
/// sensor, "stuck-on" heats although it is off, "no-heat" does not heat although it is on, "setpoint-zero"
/// stores no set point.
class NamurSimulator final : public ByteDevice {
public:
    explicit NamurSimulator(const NamurSimulatorConfig& config = {});

    void receive(std::string_view bytes, double now_s) override;
    std::string transmit(double now_s) override;
    std::vector<std::string> faults() const override;
    Result<void> setFault(const std::string& name) override;

    double temperature_K() const { return m_temperature_K; }
    /// Returns whether it is switched on; heat may also be stuck on.
    bool isOn() const { return m_isOn; }
    double setPoint_K() const { return m_setPoint_K; }
    /// Returns whether the watchdog has switched it off ("Er 2"). The manuals do not say whether a real one
    /// accepts START_1 then; this one does.
    bool isTripped() const { return m_isTripped; }

private:
    void advance(double now_s);
    void warm(double dt_s);
    std::string answer(std::string_view command);
    std::string value(double temperature_K, int channel) const;

    NamurSimulatorConfig m_config;
    LineSplitter m_lines;
    struct Answer {
        double due_s;
        std::string bytes;
    };
    std::deque<Answer> m_answers;
    std::string m_fault = "none";
    double m_now_s = 0.0;
    bool m_hasBegun = false;

    double m_temperature_K;
    double m_setPoint_K;
    bool m_isOn = false, m_isTripped = false;
    double m_watchdog_s = 0.0;   ///< 0: none
    double m_watchdogAt_s = 0.0; ///< when it expires
};

} // namespace bask
