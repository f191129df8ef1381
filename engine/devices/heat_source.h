#pragma once
// The hot surface: its measured temperature, its set point, and heat that is off unless something keeps
// saying on.

#include "engine/devices/thermometer.h"

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
};

} // namespace bask
