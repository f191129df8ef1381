#pragma once
// A profile's word for what is wrong with a sensor, as thermometers tell it.

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
