#pragma once
// The drawn output of a recorded session: its figures and its report.

#include "app/report/run_report.h"
#include "engine/base/share_done.h"
#include "widgets/common/language.h"
#include "widgets/plots/figure_format.h"

#include <string>
#include <vector>

namespace bask {

/// Draws every figure as PNG, SVG and PDF of one size into the folder, all or none, and returns the files.
/// Needs the QApplication's thread. Errors: FileUnwritable, OutputForeign.
Result<std::vector<std::string>> exportFigures(const SessionRecord& session, const std::string& folder,
                                               TemperatureUnit unit, const FigureLayout& layout = {},
                                               const ShareDone& done = {});

/// Refuses to replace a file that is not empty and does not hold the mark of what Bask writes; `kind` says
/// what that is, in English words marked for translation ("Parameter"). Error: OutputForeign.
Result<void> checkOwn(const std::string& path, const QString& mark, const char* kind);

/// Returns what a report needs besides the record: verdict and checksum. Takes about 0.1 s and the reading of
/// the file; any thread.
RunReportInput reportInput(SessionRecord session, TemperatureUnit unit);

/// Checks that a report may be written there: ".html" or ".pdf", not the session, and not a foreign file.
Result<void> checkReportFile(const std::string& path, const std::string& session);
/// Writes the report, completely or not at all. Needs the QApplication's thread. Errors: FileUnwritable,
/// those of checkReportFile.
Result<void> writeReport(const RunReportInput& input, const std::string& path);

/// Sets the language of the subcommands' --language. Error: ValueUnknown.
Result<void> setLanguage(Language& language, const QString& code);

} // namespace bask
