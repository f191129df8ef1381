#include "app/session_actions.h"

#include "app/error_text.h"
#include "app/examples.h"
#include "app/report/report_figures.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/rig_file.h"
#include "engine/experiment/text_file.h"
#include "engine/model/limits_widened.h"
#include "engine/recipe/recipe.h"
#include "engine/recording/nexus_file.h"
#include "engine/recording/recording_name.h"
#include "widgets/common/file_folders.h"
#include "widgets/plots/figure_dialog.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/rig/way_up_question.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QScopeGuard>

namespace bask {
namespace {

QString withSuffix(const QString& path, const QString& suffix) {
    return path.isEmpty() || suffix.isEmpty() || !QFileInfo(path).suffix().isEmpty() ? path
                                                                                     : path + u'.' + suffix;
}

} // namespace

SessionActions::SessionActions(Document& document, SettingsStore& settings, QWidget* window)
    : QObject(window), m_document(document), m_settings(settings), m_window(window) {
    m_export.setDrawGuard([this] { return !refusedToDraw(); });
    connect(&m_export, &SessionExport::problem, this, &SessionActions::problem);
    connect(&m_export, &SessionExport::exported, this, &SessionActions::exported);
}

QString SessionActions::ask(const FileQuestion& question) {
    if (m_chooser)
        return remembered(withSuffix(m_chooser(question), question.suffix), question.place);
    switch (question.kind) {
    case FileQuestion::Kind::Folder:
        return askFolder(m_window, question.title, question.place, question.folder);
    case FileQuestion::Kind::OpenFile:
        return askFileToOpen(m_window, question.title, question.filter, question.place, question.folder);
    case FileQuestion::Kind::SaveFile:
        break;
    }
    return askPlace(question);
}

/// Once: a dialog that asks whether to replace what is then refused has asked in vain.
QString SessionActions::askPlace(const FileQuestion& question) {
    QString proposed = question.folder;
    for (;;) {
        const QString path = withSuffix(askFileToSave(m_window, question.title, proposed, question.filter,
                                                      question.place, nullptr, Replacing::NotAsked),
                                        question.suffix);
        if (path.isEmpty() || !QFileInfo::exists(path) || mayReplaceFile(question, path))
            return path;
        proposed = path;
    }
}

bool SessionActions::mayReplaceFile(const FileQuestion& question, const QString& path) {
    constexpr qint64 kReadAtOnce = 1 << 20; // bytes: the window waits; the export looks at larger ones
    if (question.mayReplace && (!question.readsAll || QFileInfo(path).size() <= kReadAtOnce))
        if (const auto allowed = question.mayReplace(path.toStdString()); !allowed) {
            QMessageBox refusal(QMessageBox::Warning, question.title, sentence(allowed.error()),
                                QMessageBox::NoButton, m_window);
            refusal.setObjectName(QStringLiteral("replaceRefusal"));
            refusal.setTextFormat(Qt::PlainText); // the file's name is in it
            refusal.addButton(tr("Choose another name"), QMessageBox::AcceptRole);
            refusal.exec();
            return false;
        }
    QMessageBox box(QMessageBox::Question, question.title,
                    tr("%1 is there already.").arg(QFileInfo(path).fileName()), QMessageBox::NoButton,
                    m_window);
    box.setObjectName(QStringLiteral("replaceQuestion"));
    box.setTextFormat(Qt::PlainText);
    QPushButton* replacing = box.addButton(tr("Replace"), QMessageBox::AcceptRole);
    QPushButton* staying = box.addButton(tr("Choose another name"), QMessageBox::RejectRole);
    box.setDefaultButton(staying);
    box.setEscapeButton(staying);
    box.exec();
    return box.clickedButton() == replacing;
}

QString SessionActions::lastFolder(FileFolder kind) const {
    return m_settings.lastFolder(kind);
}

TemperatureUnit SessionActions::temperatureUnit() const {
    return m_settings.temperatureUnit();
}

void SessionActions::remember(const QString& path) {
    m_settings.addRecentFile(path);
    emit recentChanged();
}

bool SessionActions::refusedByRun() {
    if (!m_runIsOn || !m_runIsOn())
        return false;
    emit problem(sentence(Message{MessageCode::SessionAlreadyRunning, {}}));
    return true;
}

bool SessionActions::mayDiscard() {
    if (!m_document.modified())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved experiment"),
                    tr("\"%1\" was changed and not saved.").arg(m_document.displayName()),
                    QMessageBox::NoButton, m_window);
    box.setObjectName(QStringLiteral("unsavedQuestion"));
    QPushButton* saving = box.addButton(tr("Save"), QMessageBox::AcceptRole);
    QPushButton* discarding = box.addButton(tr("Discard changes"), QMessageBox::DestructiveRole);
    QPushButton* staying = box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    box.setDefaultButton(saving);
    box.setEscapeButton(staying);
    box.exec();
    if (box.clickedButton() == saving)
        return save();
    return box.clickedButton() == discarding;
}

void SessionActions::newExperiment() {
    if (mayReplace())
        m_document.open(Document::blank(), {});
}

void SessionActions::openExample(const QString& name, bool remember) {
    if (refusedByRun() || (remember && !mayDiscard()))
        return;
    m_readExperiment.run([name] { return readExample(name); },
                         [this, name, remember, since = m_document.generation()](const auto& read) {
                             if (!remember && isEditedSince(since))
                                 return; // nobody has asked for it
                             adopt(read, {name}, since);
                         });
}

void SessionActions::askAndOpen() {
    const QString path = ask({FileQuestion::Kind::OpenFile,
                              tr("Open an experiment or a session"),
                              m_settings.lastFolder(FileFolder::Experiments),
                              tr("Experiments and sessions (*.json *.bask);;Experiments (*.json);;Sessions "
                                 "(*.bask);;All files (*)"),
                              {}});
    if (!path.isEmpty())
        open(path);
}

void SessionActions::askAndOpenSession() {
    const QString path = ask({FileQuestion::Kind::OpenFile,
                              tr("Open a session"),
                              m_settings.lastFolder(FileFolder::Recordings),
                              tr("Sessions (*.bask);;All files (*)"),
                              {},
                              FileFolder::Recordings});
    if (!path.isEmpty())
        openSession(path);
}

QString SessionActions::sessionFolder() const {
    return m_settings.sessionFolder();
}

QString SessionActions::sessionSorting() const {
    return m_settings.sessionSorting();
}

void SessionActions::setSessionSorting(const QString& sorting) {
    m_settings.setSessionSorting(sorting);
}

QString SessionActions::askSessionFolder() {
    const QString folder = ask({FileQuestion::Kind::Folder,
                                tr("Folder of recorded runs"),
                                m_settings.sessionFolder(),
                                {},
                                {},
                                FileFolder::Recordings});
    if (!folder.isEmpty())
        m_settings.setSessionFolder(folder);
    return folder;
}

void SessionActions::open(const QString& path) {
    if (isSessionFile(path))
        return openSession(path);
    if (isRecipeFile(path.toStdString()))
        return emit recipeChosen(path);
    if (refusedByRun())
        return;
    if (isRigFile(path.toStdString()))
        readRig(path);
    else if (mayDiscard())
        openExperiment(path);
}

void SessionActions::openExperiment(const QString& path) {
    m_readExperiment.run([file = path.toStdString()] { return readExperiment(file); },
                         [this, path, since = m_document.generation()](const auto& read) {
                             adopt(read, {QFileInfo(path).fileName(), path}, since);
                         });
}

bool SessionActions::refusedByEdits(int since, const QString& name) {
    if (!isEditedSince(since))
        return false;
    emit problem(tr("\"%1\" was not opened: edits were made or recovered while it was read. Open it again to "
                    "replace them.")
                     .arg(name));
    return true;
}

void SessionActions::openAsNew(const SessionRecord& recorded) {
    const QString path = QString::fromStdString(recorded.path);
    if (mayReplace())
        adopt(recorded.experiment, {QFileInfo(path).fileName(), {}, path}, m_document.generation());
}

void SessionActions::openAsNew(const QString& recording) {
    if (!mayReplace())
        return;
    const auto read = [file = recording.toStdString()]() -> Result<Experiment> {
        const auto session = RecordedSession::open(file);
        if (!session)
            return session.error();
        return (*session)->facts().experiment;
    };
    m_readExperiment.run(read, [this, recording, since = m_document.generation()](const auto& experiment) {
        adopt(experiment, {QFileInfo(recording).fileName(), {}, recording}, since);
    });
}

void SessionActions::adopt(const Result<Experiment>& read, const Origin& origin, int since) {
    if (!read) {
        emit problem(sentence(read.error()));
        forgetMissing(origin.recording.isEmpty() ? origin.path : origin.recording);
        return;
    }
    if (refusedByRun() || refusedByEdits(since, origin.name)) // which may have begun while the file was read
        return;
    if (widenedOnRealRig(m_document.experiment(), *read, m_document.realRobot()).empty())
        put(*read, origin);
    else
        askAboutLimits(*read, origin, since);
}

/// Like an edit that raises a limit: a file brings in nothing that nobody was asked about.
void SessionActions::askAboutLimits(const Experiment& experiment, const Origin& origin, int since) {
    QStringList lines;
    for (const Message& limit : widenedOnRealRig(m_document.experiment(), experiment, m_document.realRobot()))
        lines << sentence(limit);
    askOnTheWayUp(m_window, QStringLiteral("limitsOfFile"), tr("Limits of the real rig"),
                  tr("\"%1\" allows the real rig more than now:").arg(origin.name) + QStringLiteral("\n\n") +
                      lines.join(u'\n') + QStringLiteral("\n\n") +
                      tr("Do robot, source, objects and sensors bear it?"),
                  tr("Open with these limits"), [this, experiment, origin, since] {
                      if (!refusedByRun() && !refusedByEdits(since, origin.name))
                          put(experiment, origin);
                  });
}

void SessionActions::put(const Experiment& experiment, const Origin& origin) {
    if (!origin.recording.isEmpty()) {
        m_document.openUnsaved(experiment, {});
        return emit told(
            tr("The experiment of %1 is open as a new one, which is not saved yet.").arg(origin.name));
    }
    m_document.open(experiment, origin.path);
    if (!origin.path.isEmpty()) {
        m_settings.addRecentFile(origin.path);
        emit recentChanged();
    }
}

/// One that is there and cannot be read stays in the list: it may be mended.
void SessionActions::forgetMissing(const QString& path) {
    if (QFileInfo::exists(path))
        return;
    m_settings.removeRecentFile(path);
    emit recentChanged();
}

void SessionActions::openSession(const QString& path, std::optional<double> at_s) {
    m_readSession.run([file = path.toStdString()] { return RecordedSession::open(file); },
                      [this, path, at_s](const Result<std::shared_ptr<RecordedSession>>& read) {
                          if (!read) {
                              emit problem(sentence(read.error()));
                              return forgetMissing(path);
                          }
                          m_openSession = path;
                          m_settings.addRecentFile(path);
                          emit sessionOpened(*read, at_s);
                          emit recentChanged();
                      });
}

bool SessionActions::write(const QString& path) {
    if (const auto written = writeExperiment(m_document.experiment(), path.toStdString()); !written) {
        emit problem(sentence(written.error()));
        return false;
    }
    m_document.markSaved(path);
    m_settings.addRecentFile(path);
    emit recentChanged();
    emit told(tr("Saved %1").arg(QFileInfo(path).fileName()));
    return true;
}

bool SessionActions::save() {
    return m_document.path().isEmpty() ? saveAs() : write(m_document.path());
}

bool SessionActions::saveAs() {
    const QString proposed =
        m_document.path().isEmpty()
            ? QDir(m_settings.lastFolder(FileFolder::Experiments)).filePath(QStringLiteral("experiment.json"))
            : m_document.path();
    const QString path = ask({FileQuestion::Kind::SaveFile, tr("Save the experiment"), proposed,
                              tr("Experiments (*.json)"), QStringLiteral("json")});
    return !path.isEmpty() && write(path);
}

void SessionActions::setRecording(const QString& path) {
    if (path.isEmpty() || path == m_recording)
        return;
    m_recording = path;
    emit recordingChanged();
}

void SessionActions::saveSession() {
    if (m_recording.isEmpty())
        return;
    const QString proposed =
        QDir(m_settings.lastFolder(FileFolder::Recordings)).filePath(QFileInfo(m_recording).fileName());
    const QString path = ask({FileQuestion::Kind::SaveFile, tr("Save the session"), proposed,
                              tr("Sessions (*.bask)"), QStringLiteral("bask"), FileFolder::Recordings});
    if (path.isEmpty())
        return;
    m_copy.run([from = m_recording.toStdString(), to = path.toStdString()] { return copySession(from, to); },
               [this, path](Result<void> copied) {
                   if (!copied) {
                       emit problem(sentence(copied.error()));
                       return;
                   }
                   m_settings.addRecentFile(path);
                   emit recentChanged();
                   emit exported(tr("Session saved as %1").arg(QFileInfo(path).fileName()), {path});
               });
}

bool SessionActions::refusedToDraw() {
    const auto isOn = [](const std::function<bool()>& guard) { return guard && guard(); };
    if (!isOn(m_runIsOn) && !isOn(m_recipeIsOn) && !isOn(m_rigIsActive))
        return false;
    emit problem(
        tr("Figures and reports are drawn only while no run and no recipe is on or begins, no "
           "heat is asked for and the robot stands still: the window, with its STOP, would have to wait for "
           "them. Nothing was written."));
    return true;
}

std::optional<FigureLayout> SessionActions::askFigure() {
    const FigureLayout last = m_settings.figureLayout();
    std::optional<FigureLayout> chosen = last;
    if (m_figureChooser) {
        chosen = m_figureChooser(last);
    } else if (!m_chooser) {
        FigureDialog dialog(last, m_window);
        chosen = dialog.exec() == QDialog::Accepted ? std::optional(dialog.chosen()) : std::nullopt;
    }
    if (chosen)
        m_settings.setFigureLayout(*chosen);
    return chosen;
}

void SessionActions::exportSession(SessionForm form) {
    if (m_openSession.isEmpty() || (SessionExport::isDrawn(form) && refusedToDraw()))
        return;
    const QString from = m_openSession; // another may be opened meanwhile
    const auto layout = form == SessionForm::Figures ? askFigure() : FigureLayout();
    if (!layout)
        return;
    const QString folder = m_settings.lastFolder(FileFolder::Exports);
    QString to;
    if (SessionExport::isReport(form)) {
        const QString ending =
            form == SessionForm::ReportPdf ? QStringLiteral("pdf") : QStringLiteral("html");
        to = ask({FileQuestion::Kind::SaveFile, tr("Save the report"),
                  QDir(folder).filePath(QFileInfo(from).completeBaseName() + u'.' + ending),
                  form == SessionForm::ReportPdf ? tr("PDF (*.pdf)") : tr("HTML (*.html)"), ending,
                  FileFolder::Exports, [session = from.toStdString()](const std::string& path) {
                      return checkReportFile(path, session);
                  }});
    } else if (form == SessionForm::Nexus) {
        const QString name = QString::fromStdString(nexusName(from.toStdString()));
        to = ask({FileQuestion::Kind::SaveFile, tr("Save the NeXus file"), QDir(folder).filePath(name),
                  tr("NeXus (*.nxs)"), QStringLiteral("nxs"), FileFolder::Exports, checkNexus, false});
    } else {
        to = ask({FileQuestion::Kind::Folder,
                  tr("Folder for the exported files"),
                  folder,
                  {},
                  {},
                  FileFolder::Exports});
        // Their names are the same for every run: those of another one must not take their place.
        if (const QString run = QFileInfo(from).completeBaseName();
            !to.isEmpty() && QFileInfo(to).fileName() != run)
            to = QDir(to).filePath(run);
    }
    if (!to.isEmpty())
        m_export.start(form, from, to, m_settings.temperatureUnit(), m_settings.language(), *layout);
}

void SessionActions::exportComparison(const QString& csv) {
    const QString to = ask(
        {FileQuestion::Kind::SaveFile, tr("Save the comparison"),
         QDir(m_settings.lastFolder(FileFolder::Exports)).filePath(QStringLiteral("comparison.csv")),
         tr("Tables (*.csv)"), QStringLiteral("csv"), FileFolder::Exports, SessionExport::checkComparison});
    if (!to.isEmpty())
        m_export.writeComparison(csv, to);
}

void SessionActions::exportPlot(const PlotPlace& place, PlotForm form) {
    if (form == PlotForm::Csv)
        return exportTable(*place.plot());
    if (refusedToDraw())
        return;
    const FigureFormat format = form == PlotForm::Pdf   ? FigureFormat::Pdf
                                : form == PlotForm::Svg ? FigureFormat::Svg
                                                        : FigureFormat::Png;
    const auto layout = askFigure();
    if (!layout)
        return;
    const QString ending = QLatin1String(figureEnding(format));
    const QString name = QString::fromStdString(runFigureStem(place.plot()->quantity())) + ending;
    const QString to =
        ask({FileQuestion::Kind::SaveFile, tr("Save the figure"),
             QDir(m_settings.lastFolder(FileFolder::Exports)).filePath(name), tr("Figures (*%1)").arg(ending),
             ending.mid(1), FileFolder::Exports, SessionExport::checkFigure});
    if (to.isEmpty() || refusedToDraw()) // a run may have begun behind the question
        return;
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    const auto restored = qScopeGuard(&QGuiApplication::restoreOverrideCursor);
    m_export.writeFigure(place.plot()->figure(place.words(), format, kRunFigureMark, *layout), to);
}

void SessionActions::exportTable(const TracePlot& plot) {
    const PlotTable table = plot.table(kPlotTableMark); // before it goes on behind the question
    if (table.isCut)
        return emit problem(
            tr("No table was written: the first samples of the shown time are in the recording "
               "only. Open it on the Review page and export the table there, or show a later "
               "stretch of time."));
    const QString name = QString::fromStdString(runFigureStem(plot.quantity())) + QStringLiteral(".csv");
    const QString to =
        ask({FileQuestion::Kind::SaveFile, tr("Save the table"),
             QDir(m_settings.lastFolder(FileFolder::Exports)).filePath(name), tr("Tables (*.csv)"),
             QStringLiteral("csv"), FileFolder::Exports, SessionExport::checkTable});
    if (!to.isEmpty())
        m_export.writeTable(table, to);
}

QString SessionActions::nextRecordingPath() {
    const QDir folder(recordingFolder());
    if (!folder.mkpath(QStringLiteral("."))) {
        emit problem(sentence(Error(MessageCode::FileUnwritable, folder.path().toStdString(),
                                    {tr("the folder cannot be made").toStdString()})));
        return {};
    }
    const qint64 now_s = QDateTime::currentSecsSinceEpoch();
    QString path;
    for (int n = 1; path.isEmpty() || QFileInfo::exists(path); ++n)
        path = folder.filePath(QString::fromStdString(recordingStem(now_s, n)) + QStringLiteral(".bask"));
    return path;
}

void SessionActions::openRig() {
    const QString path = ask({FileQuestion::Kind::OpenFile,
                              tr("Open a rig"),
                              m_settings.lastFolder(FileFolder::Experiments),
                              tr("Rigs (*.json);;All files (*)"),
                              {}});
    if (!path.isEmpty())
        readRig(path);
}

void SessionActions::readRig(const QString& path) {
    if (refusedByRun())
        return;
    if (const auto rig = readRigFile(path.toStdString()))
        emit rigRead(*rig);
    else
        emit problem(sentence(rig.error()));
}

void SessionActions::saveReport(const QString& text) {
    const QString path =
        ask({FileQuestion::Kind::SaveFile, tr("Save the report"),
             QDir(m_settings.lastFolder(FileFolder::Exports)).filePath(QStringLiteral("bask-report.txt")),
             tr("Texts (*.txt);;All files (*)"), QStringLiteral("txt"), FileFolder::Exports});
    if (path.isEmpty())
        return;
    if (const auto written = writeTextFile(path.toStdString(), text.toStdString()); !written)
        return emit problem(sentence(written.error()));
    emit exported(tr("The report was saved as %1.").arg(path), {path});
}

void SessionActions::saveRig() {
    const auto& rig = m_document.experiment().rig;
    if (!rig)
        return;
    const QString path =
        ask({FileQuestion::Kind::SaveFile, tr("Save the rig"),
             QDir(m_settings.lastFolder(FileFolder::Experiments)).filePath(QStringLiteral("rig.json")),
             tr("Rigs (*.json);;All files (*)"), QStringLiteral("json")});
    if (path.isEmpty())
        return;
    if (const auto written = writeRigFile(*rig, path.toStdString()); !written)
        return emit problem(sentence(written.error()));
    emit told(tr("The rig was saved as %1.").arg(path));
}

} // namespace bask
