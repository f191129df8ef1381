#pragma once
// What the heat source is told: a set point that expires, or off.

#include "engine/runtime/rig_readings.h"

#include <optional>

namespace bask {

/// Borrows its arguments for its life. One thread. When heat may be on is for its owner to say.
class HeatOrders {
public:
    HeatOrders(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings);

    /// Keeps the heat on for some sampling periods more. Errors: those of the device.
    Result<void> keep(double setPoint_K);
    void off();
    /// Repeats an order to go off that was not taken, and orders off a source that is on by itself.
    void keepOff();
    /// Set point, K, while the heat is asked for.
    const std::optional<double>& asked_K() const { return m_asked_K; }
    /// Why the last order to go off was not taken; of code None if it was.
    const Message& offProblem() const { return m_offProblem; }
    /// Wanted, or not yet seen to be off; says nothing of a source that is lost.
    bool isOn() const { return m_devices.source.heating(); }
    HeatState state() const { return m_devices.source.heatState(); }
    /// The source does not heat the objects.
    bool isSourceDark() const;

    /// Set point of an operator, K; empty: none.
    const std::optional<double>& manual_K() const { return m_manual_K; }
    /// Errors: outside of what the experiment asks for.
    Result<void> setManual(double setPoint_K);
    void endManual() { m_manual_K.reset(); }

private:
    double max_K() const; ///< that the experiment asks for

    const Experiment& m_experiment;
    const RigDevices& m_devices;
    const RigReadings& m_readings;
    std::optional<double> m_asked_K;
    std::optional<double> m_manual_K;
    Message m_offProblem;
};

} // namespace bask
