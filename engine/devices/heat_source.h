#pragma once
// The hot surface: its measured temperature, its set point, and heat that is off unless something keeps
// saying on.

#include "engine/base/message_code.h"
#include "engine/devices/device.h"
#include "engine/devices/thermometer.h"

#include <optional>

namespace bask {

/// Used on the engine thread only.
class HeatSource {
public:
    virtual ~HeatSource() = default;
    virtual Result<Reading> read() = 0;
    /// Heat towards `setPoint_K` until validFor_s has passed without another call; then the heat goes off by
    /// itself.
    virtual Result<void> keepHeating(double setPoint_K, double validFor_s) = 0;
    virtual Result<void> heatOff() = 0;
    virtual bool heating() const = 0;
    /// What may be told to people: unlike heating() it is Off only where the device has confirmed that
    /// lately.
    virtual HeatState heatState() const = 0;
    /// As the device reads it back, K; empty where it does not tell.
    virtual std::optional<double> setPoint_K() const { return std::nullopt; }
    /// A person keeps it hot: it cannot be switched from here.
    virtual bool isByHand() const { return false; }
    /// What a person reads at a source that a person keeps hot, K. Errors: ValueOutOfRange; RigIncomplete of
    /// any other source.
    virtual Result<void> setTemperature(double temperature_K) {
        (void)temperature_K;
        return Error(MessageCode::RigIncomplete, {}, {"heat source kept by hand"});
    }
    /// Why there is no heat whatever is asked, None: there can be. Told before a run is armed.
    virtual Message cannotHeat() const { return {}; }
    /// The guard process that switches it off when Bask dies has done so, or is gone; None: neither.
    virtual Message guardProblem() const { return {}; }
    /// A person has seen to it: a new guard.
    virtual void renewGuard() {}
    /// It goes off by itself when Bask or the computer dies. False: then it stays hot.
    virtual bool hasWatchdog() const { return true; }
};

} // namespace bask
