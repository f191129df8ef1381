#pragma once
// Rows of the studies as JSON, for parts: nothing is rounded, so that a table of rows that went through a
// part is the same to the last digit, and so are infinite and unknown numbers.

#include "engine/studies/alarm_study.h"
#include "engine/studies/closed_loop_study.h"

#include <optional>
#include <string>

namespace bask {

/// All that a row's table, figures and summary need; not the uneven source that was drawn.
std::string bytesOf(const ClosedLoopRow& row);
std::string bytesOf(const AlarmStudyRow& row);

/// Empty if the bytes are not such a row, or not one of `objects` objects.
std::optional<ClosedLoopRow> closedLoopRowOf(const std::string& bytes, std::size_t objects);
std::optional<AlarmStudyRow> alarmRowOf(const std::string& bytes);

} // namespace bask
