#pragma once
// Thermometers on the objects, all read together.

#include "engine/base/result.h"

#include <vector>

namespace bask {

/// One channel's newest reading; an open, shorted or implausible sensor is invalid, never a number.
struct Reading {
    double time_s = 0.0; ///< when it was measured, on the engine's clock
    double value_K = 0.0;
    bool valid = false;
};

/// Used on the engine thread only.
class Thermometer {
public:
    virtual ~Thermometer() = default;
    virtual int channels() const = 0;
    /// Newest reading of every channel, or an Error when the device does not answer.
    virtual Result<std::vector<Reading>> read() = 0;
};

} // namespace bask
