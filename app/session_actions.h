#pragma once
// Files: experiments opened and saved, sessions opened, copied and exported. All but saving an experiment
// (some 100 kB) runs off the GUI thread.

#include "app/document.h"
#include "app/session_export.h"
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

class SettingsStore;

/// A question for a file name, so that a test can answer it.
struct FileQuestion {
    enum class Kind { OpenFile, SaveFile, Folder };
    Kind kind = Kind::OpenFile;
    QString title;
    QString folder; ///< for SaveFile with the proposed name
    QString filter;
    QString suffix; ///< added to a name typed without one
};

class SessionActions : public QObject {
    Q_OBJECT

public:
    SessionActions(Document& document, SettingsStore& settings, QWidget* window);

    /// Answers file questions instead of the dialog; empty means cancelled.
    void setFileChooser(std::function<QString(const FileQuestion&)> chooser) {
        m_chooser = std::move(chooser);
    }
    /// Whether a run forbids another experiment, asked before it is put in.
    void setRunGuard(std::function<bool()> runIsOn) { m_runIsOn = std::move(runIsOn); }
    /// Whether a recipe is on: between its runs, too, nothing is drawn that takes long.
    void setRecipeGuard(std::function<bool()> recipeIsOn) { m_recipeIsOn = std::move(recipeIsOn); }
    void setRecording(const QString& path);
    /// Empty: cancelled.
    QString ask(const FileQuestion& question);
    QString lastFolder() const;
    TemperatureUnit temperatureUnit() const;
    /// Among the recent files.
    void remember(const QString& path);

    void newExperiment();
    void openExample(const QString& name, bool remember = true);
    void askAndOpen();
    void askAndOpenSession();
    /// The folder whose runs are listed; another one is asked for. Empty: it stays.
    QString sessionFolder() const;
    QString askSessionFolder();
    /// *.bask is a session; a .json says whether it is a recipe, a rig or an experiment.
    void open(const QString& path);
    bool save(); ///< false: cancelled or refused
    bool saveAs();
    void saveSession();
    /// The open session in another form, into a folder or file that is asked for. Figures and reports not
    /// during a run or recipe, whether it is on or begins meanwhile: drawing them takes the window's time.
    void exportSession(SessionForm form);
    static bool isSession(const QString& path);
    /// The devices of a rig file; the open experiment's into one.
    void openRig();
    void saveRig();
    /// A problem report, as it was read.
    void saveReport(const QString& text);

    /// A changed experiment may be lost: asks to save. False: stay.
    bool mayDiscard();
    /// A run is on, and it is told that this forbids another experiment.
    bool refusedByRun();
    /// Neither of the two stands against another experiment.
    bool mayReplace() { return !refusedByRun() && mayDiscard(); }
    /// What was asked for at generation `since` of the document has been read; there are unsaved edits of
    /// after that, and it is told that `name` is not opened over them.
    bool refusedByEdits(int since, const QString& name);

    /// File for the run that is armed next; its folder is made. Empty when that is impossible (said as a
    /// problem).
    QString nextRecordingPath();
    bool hasRecording() const { return !m_recording.isEmpty(); }

signals:
    void problem(const QString& sentence);
    void told(const QString& sentence);
    void sessionOpened(std::shared_ptr<bask::RecordedSession> session);
    void rigRead(const bask::RigSpec& rig);
    /// A recipe file is to be opened.
    void recipeChosen(const QString& path);
    void recentChanged();
    void recordingChanged();

private:
    bool isEditedSince(int since) const { return m_document.modified() && m_document.generation() != since; }
    void askAboutLimits(const Experiment& experiment, const QString& path, int since);
    void put(const Experiment& experiment, const QString& path);
    void adopt(const Result<Experiment>& read, const QString& path, const QString& name, int since);
    void openExperiment(const QString& path);
    void openSession(const QString& path);
    void forgetMissing(const QString& path);
    void readRig(const QString& path);
    bool write(const QString& path);
    bool refusedToDraw();

    Document& m_document;
    SettingsStore& m_settings;
    QWidget* m_window;
    std::function<QString(const FileQuestion&)> m_chooser;
    std::function<bool()> m_runIsOn, m_recipeIsOn;
    QString m_recording;
    QString m_openSession;
    LatestJob<Result<Experiment>> m_readExperiment;
    LatestJob<Result<std::shared_ptr<RecordedSession>>> m_readSession;
    LatestJob<Result<void>> m_copy;
    SessionExport m_export;
};

} // namespace bask
