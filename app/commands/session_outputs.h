#pragma once
// What is written of a recorded session with letters and lines: its figures and its report.

#include "app/report/run_report.h"
#include "widgets/common/language.h"

#include <string>
#include <vector>

namespace bask {

/// Draws every figure as PNG, SVG and PDF into the folder, all or none; the files. Needs the QApplication's
/// thread. Errors: FileUnwritable, OutputForeign.
Result<std::vector<std::string>> exportFigures(const SessionRecord& session, const std::string& folder,
                                               TemperatureUnit unit);

/// What a report needs besides the record: verdict and checksum. Some 0.1 s and the reading of the file; any
/// thread.
RunReportInput reportInput(SessionRecord session, TemperatureUnit unit);

/// Whether a report may be written there: ".html" or ".pdf", not the session, nobody else's file.
Result<void> checkReportFile(const std::string& path, const std::string& session);
/// Whole or not at all. Needs the QApplication's thread. Errors: FileUnwritable, those of checkReportFile.
Result<void> writeReport(const RunReportInput& input, const std::string& path);

/// The subcommands' --language. Error: ValueUnknown.
Result<void> setLanguage(Language& language, const QString& code);

} // namespace bask
