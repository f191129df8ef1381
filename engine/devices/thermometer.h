#pragma once
// Thermometers on the objects, all read together.

#include "engine/base/message.h"
#include "engine/base/result.h"

#include <vector>

namespace bask {

/// What a device reports about a sensor that gives no temperature.
enum class SensorFault { None, Open, Short, OutOfRange, Other };

/// The newest reading of one channel; with an open, shorted or implausible sensor it is invalid, never a
/// number.
struct Reading {
    double time_s = 0.0; ///< time of the measurement, on the engine's clock
    double value_K = 0.0;
    bool valid = false;
    SensorFault fault = SensorFault::None; ///< fault of an invalid reading, if the device reports it
    double standardUncertainty_K = 0.0;    ///< 0: the device does not tell it
    Message reason{};                      ///< why an invalid reading tells nothing, if that is known
};

/// Use it only on the engine thread.
class Thermometer {
public:
    virtual ~Thermometer() = default;
    virtual int channels() const = 0;
    /// Sets the wanted time between readings, s. A thermometer that is polled is polled at this period, if it
    /// is fast enough.
    virtual void setPeriod(double period_s) { (void)period_s; }
    /// Returns the newest reading of every channel, or an Error if the device does not answer.
    virtual Result<std::vector<Reading>> read() = 0;
};

} // namespace bask
