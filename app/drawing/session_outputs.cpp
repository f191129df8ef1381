#include "app/drawing/session_outputs.h"

#include "app/commands/output_file.h"
#include "app/report/report_figures.h"
#include "app/report/report_setup.h"
#include "engine/base/message_code.h"
#include "engine/experiment/text_file.h"
#include "engine/recording/ro_crate.h"
#include "engine/recording/session_verify.h"
#include "engine/recording/staged_files.h"
#include "engine/rig/rig_setup.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace bask {
namespace {

/// A mark in a file, in one byte a letter or, in a PDF, in two.
bool holds(const QByteArray& bytes, const QString& mark) {
    QByteArray wide;
    for (const QChar letter : mark)
        wide.append('\0').append(letter.toLatin1());
    return bytes.contains(mark.toLatin1()) || bytes.contains(wide);
}

QString endingOf(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).suffix().toLower();
}

} // namespace

Result<void> checkOwn(const std::string& path, const QString& mark, const char* kind) {
    QFile old(QString::fromStdString(path));
    if (old.exists() && old.size() > 0 && (!old.open(QIODevice::ReadOnly) || !holds(old.readAll(), mark)))
        return Error(MessageCode::OutputForeign, path, {kind});
    return {};
}

Result<std::vector<std::string>> exportFigures(const SessionRecord& session, const std::string& folder,
                                               TemperatureUnit unit, const FigureLayout& layout,
                                               const ShareDone& told) {
    auto files = StagedFiles::into(folder);
    if (!files)
        return files.error();
    const RunFigures figures(session, unit, layout, true);
    const std::vector<RunFigure> all = runFigures(session);
    ShareCount count(told, static_cast<double>(all.size() * std::size(kFigureFormats)));
    for (const RunFigure figure : all)
        for (const FigureFormat format : kFigureFormats) {
            const std::string name = runFigureStem(figure) + figureEnding(format);
            auto done = checkOwn(files->target(name), kRunFigureMark,
                                 QT_TRANSLATE_NOOP("Parameter", "a figure drawn by Bask"));
            if (done)
                done = files->write(name, figures.draw(figure, format).toStdString());
            if (!done)
                return done.error();
            count.add();
        }
    if (const auto done = addCrate(*files, session); !done)
        return done.error();
    return files->commit();
}

RunReportInput reportInput(SessionRecord session, TemperatureUnit unit) {
    RunReportInput input;
    Experiment asked = session.experiment;
    if (setTargets(asked, lastTargets_K(session)))
        input.verdict = jointVerdict(asked);
    QFile file(QString::fromStdString(session.path));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (file.open(QIODevice::ReadOnly) && hash.addData(&file)) {
        input.sha256 = QString::fromLatin1(hash.result().toHex());
        input.fileBytes = file.size();
    }
    if (auto looked = verifyOpenSession(session.path)) {
        session.verification = verificationWords(*looked);
        input.integrity = std::move(*looked);
    }
    input.session = std::move(session);
    input.now = QDateTime::currentDateTimeUtc();
    input.unit = unit;
    return input;
}

Result<void> checkReportFile(const std::string& path, const std::string& session) {
    const QString ending = endingOf(path);
    if (ending != QLatin1String("html") && ending != QLatin1String("pdf"))
        return Error(MessageCode::ValueUnknown, path, {ending.toStdString(), "html, pdf"});
    if (auto place = checkOutputs({session}, {{path}}); !place)
        return place;
    return checkOwn(path, QString::fromLatin1(kReportMark),
                    QT_TRANSLATE_NOOP("Parameter", "a report written by Bask"));
}

Result<void> writeReport(const RunReportInput& input, const std::string& path) {
    if (auto place = checkReportFile(path, input.session.path); !place)
        return place;
    const QByteArray report =
        endingOf(path) == QLatin1String("pdf") ? runReportPdf(input) : runReportHtml(input);
    return writeTextFile(path, report.toStdString());
}

Result<void> setLanguage(Language& language, const QString& code) {
    const QStringList known = Language::codes();
    const QString nearest = code.startsWith(QLatin1String("zh_")) ? Language::nearest(QLocale(code)) : code;
    if (!known.contains(nearest))
        return Error(MessageCode::ValueUnknown, "--language",
                     {code.toStdString(), known.join(QStringLiteral(", ")).toStdString()});
    language.set(nearest);
    return {};
}

} // namespace bask
