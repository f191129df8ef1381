#pragma once
// Files: opens and saves experiments, opens, copies and exports sessions. Everything except saving an
// experiment (some 100 kB) runs off the GUI thread.

#include "app/document.h"
#include "app/session_export.h"
#include "app/settings_store.h"
#include "engine/base/units.h"
#include "engine/recording/recorded_session.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

class QWidget;

namespace bask {

class PlotPlace;
class TracePlot;
enum class PlotForm;

/// A question for a file name, so that a test can answer it.
struct FileQuestion {
    enum class Kind { OpenFile, SaveFile, Folder };
    Kind kind = Kind::OpenFile;
    QString title;
    QString folder; ///< where the dialog begins; for SaveFile, with the proposed name
    QString filter;
    QString suffix;                             ///< added if the typed name has none
    FileFolder place = FileFolder::Experiments; ///< where the answer's folder is remembered
    /// Refuses to replace a file, before anybody is asked about it; empty: any may be replaced.
    std::function<Result<void>(const std::string& path)> mayReplace{};
    bool readsAll = true; ///< mayReplace reads the whole file, not its first bytes
};

class SessionActions : public QObject {
    Q_OBJECT

public:
    SessionActions(Document& document, SettingsStore& settings, QWidget* window);

    /// Answers file questions instead of the dialog; an empty answer means cancelled.
    void setFileChooser(std::function<QString(const FileQuestion&)> chooser) {
        m_chooser = std::move(chooser);
    }
    /// Answers the question for the size of a figure; empty means cancelled. Without it, where files are not
    /// asked for by dialogs, a figure is as the last one.
    void setFigureChooser(std::function<std::optional<FigureLayout>(const FigureLayout&)> chooser) {
        m_figureChooser = std::move(chooser);
    }
    /// Sets the check whether a run forbids another experiment, called before one is opened.
    void setRunGuard(std::function<bool()> runIsOn) { m_runIsOn = std::move(runIsOn); }
    /// Sets the check whether a recipe is on: also between its runs, nothing is drawn that takes long.
    void setRecipeGuard(std::function<bool()> recipeIsOn) { m_recipeIsOn = std::move(recipeIsOn); }
    /// Sets the check whether heat is asked for, the robot moves or a start counts down, also without a run:
    /// nothing is drawn then.
    void setRigGuard(std::function<bool()> rigIsActive) { m_rigIsActive = std::move(rigIsActive); }
    void setRecording(const QString& path);
    /// Returns the chosen file; empty if cancelled.
    QString ask(const FileQuestion& question);
    QString lastFolder(FileFolder kind) const;
    TemperatureUnit temperatureUnit() const;
    /// Adds the file to the recent files.
    void remember(const QString& path);

    void newExperiment();
    void openExample(const QString& name, bool remember = true);
    void askAndOpen();
    void askAndOpenSession();
    /// The folder whose runs are listed; asks for another one. Empty if it does not change.
    QString sessionFolder() const;
    QString askSessionFolder();
    /// What these runs are sorted by, a word of SessionList.
    QString sessionSorting() const;
    void setSessionSorting(const QString& sorting);
    /// Opens a file: *.bask is a session; the content of a .json shows whether it is a recipe, a rig or an
    /// experiment.
    void open(const QString& path);
    /// Opens a session, if wanted at a time since Start instead of its beginning.
    void openSession(const QString& path, std::optional<double> at_s = {});
    /// Opens the experiment of a recording as a new one, which has no file and is not saved.
    void openAsNew(const SessionRecord& recorded);
    void openAsNew(const QString& recording);
    bool save(); ///< false: cancelled or refused
    bool saveAs();
    void saveSession();
    /// Exports the open session in another form, to a folder or file that is asked for. Figures and reports
    /// are not exported while a run, recipe, heat or motion is on or if one begins, since drawing blocks the
    /// window.
    void exportSession(SessionForm form);
    /// Saves a comparison of metrics (CSV) as a file that is asked for.
    void exportComparison(const QString& csv);
    /// Exports what a plot shows to a file that is asked for, a figure in a size that is asked for. No figure
    /// while a run, recipe, heat or motion is on or if one begins.
    void exportPlot(const PlotPlace& place, PlotForm form);
    /// Returns the files and folders whose export is not finished.
    QStringList unfinishedExports() const { return m_export.unfinished(); }
    /// Reads the devices of a rig file; saves those of the open experiment.
    void openRig();
    void saveRig();
    /// Saves a problem report, as the person has read it.
    void saveReport(const QString& text);

    /// Asks to save if a changed experiment would be lost. Returns false to stay.
    bool mayDiscard();
    /// Returns whether a run is on, and then tells that this forbids another experiment.
    bool refusedByRun();
    /// Returns whether neither of the two forbids another experiment.
    bool mayReplace() { return !refusedByRun() && mayDiscard(); }
    /// Returns whether there are unsaved edits after generation `since` of the document, when the file was
    /// requested; then tells that `name` is not opened over them.
    bool refusedByEdits(int since, const QString& name);

    /// Returns the file for the next run, and creates its folder; empty if that is impossible (reported as a
    /// problem).
    QString nextRecordingPath();
    bool hasRecording() const { return !m_recording.isEmpty(); }

signals:
    void problem(const QString& sentence);
    void told(const QString& sentence);
    /// Files were written for others to read.
    void exported(const QString& sentence, const QStringList& files);
    /// `at_s`: the time since Start that openSession() was asked for.
    void sessionOpened(std::shared_ptr<bask::RecordedSession> session, std::optional<double> at_s);
    void rigRead(const bask::RigSpec& rig);
    /// A recipe file was chosen to be opened.
    void recipeChosen(const QString& path);
    void recentChanged();
    void recordingChanged();

private:
    bool isEditedSince(int since) const { return m_document.modified() && m_document.generation() != since; }
    /// Where an experiment comes from.
    struct Origin {
        QString name;        ///< in sentences
        QString path{};      ///< its file; empty if it has none
        QString recording{}; ///< the session that it is taken from, if any
    };
    void askAboutLimits(const Experiment& experiment, const Origin& origin, int since);
    void put(const Experiment& experiment, const Origin& origin);
    void adopt(const Result<Experiment>& read, const Origin& origin, int since);
    void openExperiment(const QString& path);
    void forgetMissing(const QString& path);
    void readRig(const QString& path);
    bool write(const QString& path);
    bool refusedToDraw();
    QString askPlace(const FileQuestion& question);
    bool mayReplaceFile(const FileQuestion& question, const QString& path);
    std::optional<FigureLayout> askFigure();
    void exportTable(const TracePlot& plot);

    Document& m_document;
    SettingsStore& m_settings;
    QWidget* m_window;
    std::function<QString(const FileQuestion&)> m_chooser;
    std::function<std::optional<FigureLayout>(const FigureLayout&)> m_figureChooser;
    std::function<bool()> m_runIsOn, m_recipeIsOn, m_rigIsActive;
    QString m_recording;
    QString m_openSession;
    LatestJob<Result<Experiment>> m_readExperiment;
    LatestJob<Result<std::shared_ptr<RecordedSession>>> m_readSession;
    LatestJob<Result<void>> m_copy;
    SessionExport m_export;
};

} // namespace bask
