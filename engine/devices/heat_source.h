#pragma once
// The hot surface: its measured temperature, its set point, and heat that goes off unless it is requested
// repeatedly.

#include "engine/base/message_code.h"
#include "engine/devices/device.h"
#include "engine/devices/thermometer.h"

#include <optional>

namespace bask {

/// Use it only on the engine thread.
class HeatSource {
public:
    virtual ~HeatSource() = default;
    virtual Result<Reading> read() = 0;
    /// Heats towards `setPoint_K` until validFor_s has passed without another call; then the heat goes off by
    /// itself.
    virtual Result<void> keepHeating(double setPoint_K, double validFor_s) = 0;
    virtual Result<void> heatOff() = 0;
    virtual bool heating() const = 0;
    /// The state that may be shown to people: unlike heating() it is Off only if the device has confirmed
    /// that recently.
    virtual HeatState heatState() const = 0;
    /// Returns the set point as the device reads it back, K; empty if the device does not report it.
    virtual std::optional<double> setPoint_K() const { return std::nullopt; }
    /// Returns whether a person heats the source: the program cannot switch it.
    virtual bool isManual() const { return false; }
    /// Sets the temperature that a person reads at a source that a person heats, K. Errors: ValueOutOfRange;
    /// RigIncomplete for any other source.
    virtual Result<void> setTemperature(double temperature_K) {
        (void)temperature_K;
        return Error(MessageCode::RigIncomplete, {}, {"heat source kept by hand"});
    }
    /// Returns why it cannot heat, whatever is requested; None if it can. Reported before a run is armed.
    virtual Message cannotHeat() const { return {}; }
    /// Returns a problem of the guard process, which switches the heat off if Bask dies: it has done so, or
    /// it is gone. None if there is no problem.
    virtual Message guardProblem() const { return {}; }
    /// Starts a new guard, after a person has checked the source.
    virtual void renewGuard() {}
    /// Returns whether it goes off by itself if Bask or the computer dies. If false, it stays hot then.
    virtual bool hasWatchdog() const { return true; }
};

} // namespace bask
