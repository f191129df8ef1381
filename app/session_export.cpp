#include "app/session_export.h"

#include "app/error_text.h"
#include "app/report/report_figures.h"
#include "engine/experiment/text_file.h"
#include "engine/recording/nexus_file.h"
#include "engine/recording/session_vtk.h"
#include "widgets/review/metric_comparison.h"

#include <QCursor>
#include <QFileInfo>
#include <QGuiApplication>

namespace bask {
namespace {

constexpr const char* kTableMark = "time (s)"; // a column of every table of a plot

Result<std::vector<std::string>> written(SessionForm form, const std::string& session,
                                         const std::string& folder, const std::stop_token& stop) {
    if (form == SessionForm::Csv || form == SessionForm::CsvAllDigits)
        return exportSessionCsv(session, folder, {},
                                form == SessionForm::Csv ? CsvDigits::Meaningful : CsvDigits::All);
    const auto record = readSession(session);
    if (!record)
        return record.error();
    if (form == SessionForm::Vtk)
        return exportVtk(*record, folder, stop);
    const auto file = exportNexus(*record, folder);
    return file ? Result<std::vector<std::string>>(std::vector{*file}) : file.error();
}

Result<std::vector<std::string>> drawn(SessionForm form, const RunReportInput& input, const std::string& to) {
    if (form == SessionForm::Figures)
        return exportFigures(input.session, to, input.unit);
    const auto done = writeReport(input, to);
    return done ? Result<std::vector<std::string>>(std::vector{to}) : done.error();
}

/// Over nothing but an earlier file with the same mark.
Result<std::vector<std::string>> fileWritten(const std::string& bytes, const std::string& to,
                                             const QString& mark, const char* kind) {
    auto done = checkOwn(to, mark, kind);
    if (done)
        done = writeTextFile(to, bytes);
    return done ? Result<std::vector<std::string>>(std::vector{to}) : done.error();
}

} // namespace

bool SessionExport::isReport(SessionForm form) {
    return form == SessionForm::ReportPdf || form == SessionForm::ReportHtml;
}

void SessionExport::start(SessionForm form, const QString& session, const QString& to, TemperatureUnit unit,
                          const QString& language) {
    const std::string from = session.toStdString();
    if (!isDrawn(form))
        return m_files[form].run(
            [form, from, folder = to.toStdString()](const std::stop_token& stop) {
                return written(form, from, folder, stop);
            },
            [this, to](const Files& files) { tell(files, to); });
    m_inputs[form].run(
        [from, unit]() -> Result<RunReportInput> {
            auto record = readSession(from);
            return record ? Result<RunReportInput>(reportInput(std::move(*record), unit)) : record.error();
        },
        [this, form, to, language](Result<RunReportInput> input) {
            if (!input)
                return tell(input.error(), to);
            if (m_mayDraw && !m_mayDraw())
                return;
            input->language = language;
            QGuiApplication::setOverrideCursor(Qt::WaitCursor);
            const Files files = drawn(form, *input, to.toStdString());
            QGuiApplication::restoreOverrideCursor();
            tell(files, to);
        });
}

void SessionExport::writeComparison(const QString& csv, const QString& to) {
    m_comparison.run(
        [csv = csv.toStdString(), path = to.toStdString()] {
            return fileWritten(csv, path, QString::fromLatin1(kComparisonMark),
                               "a comparison written by Bask");
        },
        [this, to](const Files& files) { tell(files, to); });
}

void SessionExport::writePlot(const QByteArray& bytes, const QString& to, bool isTable) {
    m_plot.run(
        [bytes = bytes.toStdString(), path = to.toStdString(), isTable] {
            return isTable
                       ? fileWritten(bytes, path, QString::fromLatin1(kTableMark), "a table written by Bask")
                       : fileWritten(bytes, path, kRunFigureMark, "a figure drawn by Bask");
        },
        [this, to](const Files& files) { tell(files, to); });
}

void SessionExport::tell(const Files& files, const QString& to) {
    if (!files)
        return emit problem(sentence(files.error()));
    QStringList paths;
    for (const std::string& file : *files)
        paths << QString::fromStdString(file);
    emit exported(paths.size() == 1
                      ? tr("%1 written").arg(QFileInfo(paths.front()).fileName())
                      : tr("%n file(s) written to %1", nullptr, static_cast<int>(paths.size())).arg(to),
                  paths);
}

} // namespace bask
