#pragma once
// Converts a profile's word for a sensor's fault to that of thermometers.

#include "engine/devices/thermometer.h"

#include <string>

namespace bask {

inline SensorFault sensorFault(const std::string& word) {
    return word.empty()             ? SensorFault::None
           : word == "open"         ? SensorFault::Open
           : word == "short"        ? SensorFault::Short
           : word == "out_of_range" ? SensorFault::OutOfRange
                                    : SensorFault::Other;
}

} // namespace bask
