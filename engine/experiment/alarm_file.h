#pragma once
// The file that keeps alarms over a restart.

#include "engine/model/alarm.h"

#include <string>
#include <vector>

namespace bask {

/// As written last; none where there is no file. Errors: a file that is damaged or of a newer version.
Result<std::vector<Alarm>> readAlarms(const std::string& path);
/// Whole or not at all.
Result<void> writeAlarms(const std::vector<Alarm>& alarms, const std::string& path);

} // namespace bask
