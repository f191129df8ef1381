#pragma once
// The report of a recorded run: one HTML file with everything in it, or a PDF.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"
#include "engine/recording/session_file.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <optional>

namespace bask {

/// What a report is made of. It is in the window's language.
struct RunReportInput {
    SessionRecord session;
    std::optional<JointVerdict> verdict; ///< of lastTargets_K(session); empty: not computed
    QString sha256;                      ///< of the session file, hexadecimal
    qint64 fileBytes = 0;
    QDateTime now; ///< when the report is made
    TemperatureUnit unit = TemperatureUnit::Celsius;
    QString language = QStringLiteral("en"); ///< Language's code of what it is in
};

/// Both need a QApplication and its thread, no display.
QByteArray runReportHtml(const RunReportInput& input);
QByteArray runReportPdf(const RunReportInput& input);

/// Marks of Bask's own reports, within so many bytes from the start or end of the file.
inline constexpr const char* kReportMark = "Bask run report";

} // namespace bask
