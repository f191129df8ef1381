#pragma once
// The commands to the heat source: a set point that expires, or off.

#include "engine/runtime/rig_readings.h"

#include <optional>

namespace bask {

/// Borrows its arguments for its lifetime. One thread. Its owner decides when heat may be on.
class HeatOrders {
public:
    HeatOrders(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings);

    /// Keeps the heat on for a few more sampling periods. Errors: those of the device.
    Result<void> keep(double setPoint_K);
    void off();
    /// Repeats an off command that failed, and switches off a source that is on without a command.
    void keepOff();
    /// Commanded set point, K; empty if no heat is commanded.
    const std::optional<double>& asked_K() const { return m_asked_K; }
    /// Why the last off command failed; its code is None if it succeeded.
    const Message& offProblem() const { return m_offProblem; }
    /// Heat is commanded, or not yet confirmed off. Says nothing about a source that does not answer.
    bool isOn() const { return m_devices.source.heating(); }
    HeatState state() const { return m_devices.source.heatState(); }
    /// Returns whether the source does not heat the objects: no heat is commanded, and a real source is cool.
    bool isSourceDark() const;

    /// Manual set point of an operator, K; empty if there is none.
    const std::optional<double>& manual_K() const { return m_manual_K; }
    /// Sets the manual set point. Error: ValueOutOfRange if it is not above the room's temperature, or above
    /// the experiment's highest source temperature.
    Result<void> setManual(double setPoint_K);
    void endManual() { m_manual_K.reset(); }

private:
    double max_K() const; ///< highest source temperature of the experiment

    const Experiment& m_experiment;
    const RigDevices& m_devices;
    const RigReadings& m_readings;
    std::optional<double> m_asked_K;
    std::optional<double> m_manual_K;
    Message m_offProblem;
};

} // namespace bask
