#pragma once
// What is published of a run: values, and their forms as JSON and as text for Prometheus
// (docs/monitoring.md).

#include "engine/runtime/snapshot.h"

#include <string>
#include <vector>

namespace bask {

/// An event of a run with the time at which it was told.
struct MonitorEvent {
    double utc_s = 0.0;
    TraceEvent event;
};

/// The parts of a snapshot that are published, and the time at which it came.
struct MonitorStatus {
    double utc_s = 0.0;
    bool isClosed = false; ///< Bask ends, or its monitoring: nothing follows
    Snapshot snapshot;     ///< without rows
};

/// One JSON object on one line; what is not known is null. Temperatures in degC, lengths in m, angles in rad.
std::string statusJson(const MonitorStatus& status);
/// A JSON array: the alarms of the status, the most serious first.
std::string alarmsJson(const MonitorStatus& status);
std::string eventJson(const MonitorEvent& event);
/// Metrics in the text format of Prometheus, all with the prefix bask_.
std::string statusMetrics(const MonitorStatus& status);

} // namespace bask
