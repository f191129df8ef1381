#pragma once
// The report of a recorded run: one HTML file with everything in it, or a PDF.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_verify.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <optional>

namespace bask {

/// The content of a report. The report is in the window's language.
struct RunReportInput {
    SessionRecord session;
    std::optional<JointVerdict> verdict; ///< verdict on lastTargets_K(session); empty if not computed
    /// Whether the session file is as it was recorded; empty if nobody could look.
    std::optional<SessionVerdict> integrity;
    QString sha256; ///< checksum of the session file, hexadecimal
    qint64 fileBytes = 0;
    QDateTime now; ///< when the report is created
    TemperatureUnit unit = TemperatureUnit::Celsius;
    QString language = QStringLiteral("en"); ///< language code of the report
};

/// Both functions need a QApplication and its thread, but no display.
QByteArray runReportHtml(const RunReportInput& input);
QByteArray runReportPdf(const RunReportInput& input);

/// Marks of Bask's own reports, within this number of bytes from the start or end of the file.
inline constexpr const char* kReportMark = "Bask run report";

} // namespace bask
