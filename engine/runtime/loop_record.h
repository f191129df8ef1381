#pragma once
// The rows that a servo loop has recorded since they were last taken, and writing them into the session file.

#include "engine/drivers/traffic_log.h"
#include "engine/model/trace.h"
#include "engine/recording/session_file.h"

#include <memory>
#include <vector>

namespace bask {

struct LoopRecord {
    std::vector<TraceSample> samples;
    std::vector<TraceEvent> events;
    std::vector<TraceNote> notes;
    std::vector<CommandRow> commands;
    std::vector<TraceFrame> frames;
    std::vector<TrafficLog::Line> traffic;            ///< with a fault
    double start_s = 0.0;                             ///< time of Start on the clock of `traffic`
    std::shared_ptr<const PredictedRun> prediction{}; ///< null: none
};

/// Adds all rows, kind by kind; stops at the first failure.
Result<void> write(const LoopRecord& rows, SessionWriter& writer);

} // namespace bask
