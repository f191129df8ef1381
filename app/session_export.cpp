#include "app/session_export.h"

#include "app/error_text.h"
#include "app/report/report_figures.h"
#include "engine/base/message_code.h"
#include "engine/experiment/text_file.h"
#include "engine/recording/nexus_file.h"
#include "engine/recording/session_verify.h"
#include "engine/recording/session_vtk.h"
#include "widgets/review/metric_comparison.h"

#include <QCursor>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QScopeGuard>

#include <filesystem>
#include <utility>

namespace bask {
namespace {

Result<std::vector<std::string>> written(SessionForm form, const std::string& session, const std::string& to,
                                         const std::stop_token& stop) {
    if (form == SessionForm::Csv || form == SessionForm::CsvAllDigits)
        return exportSessionCsv(session, to, {},
                                form == SessionForm::Csv ? CsvDigits::Meaningful : CsvDigits::All);
    auto record = readSession(session);
    if (!record)
        return record.error();
    record->verification = verificationOf(session);
    if (form == SessionForm::Vtk)
        return exportVtk(*record, to, stop);
    const std::filesystem::path path(to);
    const auto file = exportNexus(*record, path.parent_path().string(), {}, path.filename().string());
    return file ? Result<std::vector<std::string>>(std::vector{*file}) : file.error();
}

Result<std::vector<std::string>> drawn(SessionForm form, const RunReportInput& input, const std::string& to,
                                       const FigureLayout& layout) {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    const auto restored = qScopeGuard(&QGuiApplication::restoreOverrideCursor);
    if (form == SessionForm::Figures)
        return exportFigures(input.session, to, input.unit, layout);
    const auto done = writeReport(input, to);
    return done ? Result<std::vector<std::string>>(std::vector{to}) : done.error();
}

/// Where the check of the place allows it.
Result<std::vector<std::string>> fileWritten(const std::string& bytes, const std::string& to,
                                             Result<void> done) {
    if (done)
        done = writeTextFile(to, bytes);
    return done ? Result<std::vector<std::string>>(std::vector{to}) : done.error();
}

} // namespace

bool SessionExport::isReport(SessionForm form) {
    return form == SessionForm::ReportPdf || form == SessionForm::ReportHtml;
}

void SessionExport::start(SessionForm form, const QString& session, const QString& to, TemperatureUnit unit,
                          const QString& language, const FigureLayout& layout) {
    const std::string from = session.toStdString();
    if (!isDrawn(form))
        return write(m_files[form], to, [form, from, path = to.toStdString()](const std::stop_token& stop) {
            return written(form, from, path, stop);
        });
    const auto read = [from, unit](const std::stop_token&) -> Result<RunReportInput> {
        auto record = readSession(from);
        return record ? Result<RunReportInput>(reportInput(std::move(*record), unit)) : record.error();
    };
    const auto draw = [this, form, to, language, layout](Result<RunReportInput> input) {
        if (!input)
            return tell(input.error(), to);
        if (m_mayDraw && !m_mayDraw())
            return;
        input->language = language;
        tell(drawn(form, *input, to.toStdString(), layout), to);
    };
    Drawings& drawings = m_drawings[form];
    drawings.unfinished.push_back({to, read, draw});
    drawNext(drawings);
}

Result<void> SessionExport::checkComparison(const std::string& path) {
    return checkOwn(path, QString::fromLatin1(kComparisonMark),
                    QT_TRANSLATE_NOOP("Parameter", "a comparison written by Bask"));
}

Result<void> SessionExport::checkFigure(const std::string& path) {
    return checkOwn(path, kRunFigureMark, QT_TRANSLATE_NOOP("Parameter", "a figure drawn by Bask"));
}

/// In its place, where a note of another table may not have it: at the end of the headers.
Result<void> SessionExport::checkTable(const std::string& path) {
    QFile old(QString::fromStdString(path));
    const QByteArray end = ',' + kPlotTableMark.toUtf8() + '\n';
    if (old.exists() && old.size() > 0 && (!old.open(QIODevice::ReadOnly) || !old.readLine().endsWith(end)))
        return Error(MessageCode::OutputForeign, path,
                     {QT_TRANSLATE_NOOP("Parameter", "a table written by Bask")});
    return {};
}

void SessionExport::writeComparison(const QString& csv, const QString& to) {
    write(m_small, to, [csv = csv.toStdString(), path = to.toStdString()](const std::stop_token&) {
        return fileWritten(csv, path, checkComparison(path));
    });
}

void SessionExport::writeFigure(const QByteArray& bytes, const QString& to) {
    write(m_small, to, [bytes = bytes.toStdString(), path = to.toStdString()](const std::stop_token&) {
        return fileWritten(bytes, path, checkFigure(path));
    });
}

void SessionExport::writeTable(const PlotTable& table, const QString& to) {
    write(m_tables, to, [table, path = to.toStdString()](const std::stop_token& stop) -> Files {
        if (auto place = checkTable(path); !place) // before all that reading
            return place.error();
        const auto csv = plotTableCsv(table, stop);
        if (!csv)
            return csv.error();
        if (stop.stop_requested())
            return std::vector<std::string>();
        return fileWritten(*csv, path, checkTable(path));
    });
}

void SessionExport::write(Queue& queue, const QString& to, LatestJob<Files>::Work work) {
    queue.unfinished.push_back({to, std::move(work)});
    writeNext(queue);
}

void SessionExport::writeNext(Queue& queue) {
    if (queue.job.busy() || queue.unfinished.empty())
        return;
    queue.job.run(std::move(queue.unfinished.front().work), [this, &queue](const Files& files) {
        const QString to = queue.unfinished.front().to;
        queue.unfinished.pop_front();
        tell(files, to);
        writeNext(queue);
    });
}

void SessionExport::drawNext(Drawings& drawings) {
    if (drawings.input.busy() || drawings.unfinished.empty())
        return;
    drawings.input.run(std::move(drawings.unfinished.front().read),
                       [this, &drawings](Result<RunReportInput> input) {
                           const Drawing next = std::move(drawings.unfinished.front());
                           drawings.unfinished.pop_front();
                           next.draw(std::move(input));
                           drawNext(drawings);
                       });
}

QStringList SessionExport::unfinished() const {
    QStringList places;
    const auto add = [&](const Queue& queue) {
        for (const Output& output : queue.unfinished)
            places << output.to;
    };
    add(m_small);
    add(m_tables);
    for (const auto& [form, queue] : m_files)
        add(queue);
    for (const auto& [form, drawings] : m_drawings)
        for (const Drawing& drawing : drawings.unfinished)
            places << drawing.to;
    return places;
}

void SessionExport::tell(const Files& files, const QString& to) {
    if (!files)
        return emit problem(sentence(files.error()));
    QStringList paths;
    for (const std::string& file : *files)
        paths << QString::fromStdString(file);
    emit exported(paths.size() == 1
                      ? tr("%1 written to %2")
                            .arg(QFileInfo(paths.front()).fileName(),
                                 QDir::toNativeSeparators(QFileInfo(paths.front()).path()))
                      : tr("%n file(s) written to %1", nullptr, static_cast<int>(paths.size())).arg(to),
                  paths);
}

} // namespace bask
