#include "engine/runtime/loop_record.h"

namespace bask {

Result<void> write(const LoopRecord& rows, SessionWriter& writer) {
    Result<void> result;
    const auto addAll = [&](const auto& list) {
        for (const auto& row : list)
            if (result.ok())
                result = writer.add(row);
    };
    addAll(rows.samples);
    addAll(rows.events);
    addAll(rows.notes);
    addAll(rows.commands);
    addAll(rows.frames);
    for (const TrafficLog::Line& line : rows.traffic)
        if (result.ok())
            result = writer.add(*line, rows.start_s);
    if (result.ok() && rows.prediction)
        result = writer.add(*rows.prediction);
    return result;
}

} // namespace bask
