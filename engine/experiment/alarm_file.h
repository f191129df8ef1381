#pragma once
// The file that stores alarms between program starts.

#include "engine/model/alarm.h"

#include <string>
#include <vector>

namespace bask {

/// Reads the alarms as last written; none if there is no file. Errors: a file that is damaged or of a newer
/// version.
Result<std::vector<Alarm>> readAlarms(const std::string& path);
/// Writes all alarms or leaves the old file.
Result<void> writeAlarms(const std::vector<Alarm>& alarms, const std::string& path);

} // namespace bask
