#pragma once
// Thermometers on the objects, all read together.

#include "engine/base/result.h"

#include <vector>

namespace bask {

/// What a device says of a sensor that gives no temperature.
enum class SensorFault { None, Open, Short, OutOfRange, Other };

/// One channel's newest reading; an open, shorted or implausible sensor is invalid, never a number.
struct Reading {
    double time_s = 0.0; ///< when it was measured, on the engine's clock
    double value_K = 0.0;
    bool valid = false;
    SensorFault fault = SensorFault::None; ///< of one that is not valid, where the device tells
};

/// Used on the engine thread only.
class Thermometer {
public:
    virtual ~Thermometer() = default;
    virtual int channels() const = 0;
    /// So often readings are wanted, s. One that is asked is asked so often, where it can be.
    virtual void setPeriod(double period_s) { (void)period_s; }
    /// Newest reading of every channel, or an Error when the device does not answer.
    virtual Result<std::vector<Reading>> read() = 0;
};

} // namespace bask
