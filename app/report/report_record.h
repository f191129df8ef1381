#pragma once
// Sections of a run's report: its metrics with their definitions, its events, alarms, notes and commands, and
// where the numbers come from. HTML.

#include "app/report/run_report.h"

namespace bask {

QString summarySection(const RunReportInput& input);
QString metricsSection(const SessionRecord& session, TemperatureUnit unit);
QString eventsSection(const SessionRecord& session, TemperatureUnit unit);
QString originSection(const RunReportInput& input);

/// Returns how the run ended, in a sentence.
QString outcomeWords(const SessionRecord& session);

inline constexpr int kMaxReportRows = 400; ///< maximum number of listed events; the rest is only counted

} // namespace bask
