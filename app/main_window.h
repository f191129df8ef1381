#pragma once
// The window: state bar, pages, alarms and events, status line. It only composes the parts; every part does
// its own work.

#include "app/actions.h"
#include "app/autosave.h"
#include "app/close_question.h"
#include "app/document.h"
#include "app/engine_client.h"
#include "app/horn.h"
#include "app/page_host.h"
#include "app/session_actions.h"
#include "app/settings_store.h"
#include "widgets/common/language.h"

#include <QElapsedTimer>
#include <QMainWindow>

class QToolBar;

namespace bask {

class BottomDock;
class Coach;
class CutOffRun;
class ManualWindow;
class MaterialControl;
class MonitorControl;
class RecipeControl;
class RecoveryOffer;
class StateBar;
class StatusLine;
class UndoActions;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow();
    ~MainWindow() override;

    /// Starts the engine and opens a file; the first example is also opened if the file is not an experiment.
    void begin(const QString& path);

    SessionActions& files() { return m_files; }
    Document& document() { return m_document; }
    PageHost& pages() { return *m_pages; }
    EngineClient& engine() { return m_engine; }
    Actions& actions() { return m_actions; }
    Horn& horn() { return m_horn; }
    const Snapshot& lastSnapshot() const { return m_last; }
    RecipeControl& recipe() { return *m_recipe; }
    /// Replaces the question to the person, for tests.
    void setCloseQuestion(std::function<Closing()> question) { m_closeQuestion = std::move(question); }

    void setLanguage(const QString& code);
    void setTheme(Theme theme);
    void setTextSize(int percent); ///< takes effect at the next start
    void setTemperatureUnit(TemperatureUnit unit);
    void setHornMode(HornMode mode);

signals:
    void snapshotApplied(const bask::Snapshot& snapshot);

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window_build.cpp
    void buildLayout();
    void buildNavigation();
    void turnToChosenPage();
    void connectActions();
    void connectParts();
    void connectCoach();
    void connectRecipe();

    void apply(const Snapshot& snapshot);
    void perform(Verb verb);
    void showRun();
    void askLabels(bool isBeforeArm);
    void armWithLabels(const Snapshot& snapshot);
    void askToArm();
    void askRetreat();
    void askHome();
    QString openQuestion() const;
    QString whyRefused(const Snapshot& snapshot, Verb verb) const;
    bool isAnswerAwaited();
    void dropOldQuestions(const Snapshot& snapshot);
    void arm();
    void askInfeasible();
    void refuse(const Message& refusal);
    void sayWhyNot(Verb verb);
    void showReason(int index);
    void showControl(Page page, const QString& name);
    void showManual(const QString& page);
    void reportProblem();
    void showTitle();
    void takeAges(); ///< updates the ages of the calibrations, and which objects overlap
    void showRemedy();
    QStringList askedFirst() const;
    QString askedCaption() const;
    QString whyNotHeld() const;
    void showNotes(); ///< shows the notes in the list of the state chip
    void retranslate();
    void restyle();
    bool runIsOn() const;
    bool mayClose();
    bool mayEndRecording();
    bool mayLeaveExports();
    void endRun();
    void closeAtRest();
    bool endEngine(); ///< returns false if it did not answer
    void showSilence();

    SettingsStore m_settings;
    const int m_textSize_percent = m_settings.textSize_percent(); ///< text size at the start
    Language m_language;
    Document m_document;
    Autosave m_autosave;
    EngineClient m_engine;
    SessionActions m_files;
    Actions m_actions;
    Horn m_horn;
    StateBar* m_stateBar = nullptr;
    PageHost* m_pages = nullptr;
    UndoActions* m_undo = nullptr;
    RecoveryOffer* m_recovery = nullptr;
    CutOffRun* m_cutOff = nullptr;
    Coach* m_coach = nullptr;
    RecipeControl* m_recipe = nullptr;
    MonitorControl* m_monitor = nullptr;
    MaterialControl* m_materials = nullptr;
    QToolBar* m_navigation = nullptr;
    BottomDock* m_dock = nullptr;
    StatusLine* m_statusLine = nullptr;
    ManualWindow* m_manual = nullptr;

    Snapshot m_last;
    QStringList m_ages;                  ///< ages of the calibrations, in words
    QStringList m_overlaps;              ///< what the experiment says of objects that overlap, in words
    std::optional<RunLabels> m_armsWith; ///< arms when the engine has these
    std::optional<Verb> m_refused;       ///< the verb that the message bar says is not possible
    std::function<Closing()> m_closeQuestion;
    RunState m_retreatAskedIn = RunState::Idle, m_homeAskedIn = RunState::Idle;
    bool m_closesAtRest = false; ///< a person asked to close when the run has ended
    bool m_isHeatLeft = false;   ///< a real source was not seen to go off at the engine's end
    QElapsedTimer m_sinceAnswer;
    QTimer m_silence; ///< updates ages while the engine does not answer
};

} // namespace bask
