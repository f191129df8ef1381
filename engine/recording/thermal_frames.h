#pragma once
// What exports need of a session's recorded pictures beyond readThermalFrames (session_file.h).

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// Returns when the recorded pictures of the thermal camera were taken, s since Start, in the order of
/// readThermalFrames; nothing without a camera. Errors: those of SessionStore::open.
Result<std::vector<double>> thermalFrameTimes(const std::string& path);

} // namespace bask
