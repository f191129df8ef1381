#pragma once
// The files of the monitoring, replaced as a whole: who reads one sees an old one or a new one.

#include "engine/monitor/monitor_status.h"

namespace bask {

inline constexpr const char* kStatusFile = "bask.json";
inline constexpr const char* kMetricsFile = "bask.prom"; ///< for the textfile collector of node_exporter

/// Waits for the disk. Errors: FileUnwritable; the files before it stay.
Result<void> writeStatusFiles(const MonitorStatus& status, const std::string& folder);

/// Makes and deletes a file in the folder. Errors: FileUnwritable.
Result<void> tryStatusFolder(const std::string& folder);

} // namespace bask
