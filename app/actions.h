#pragma once
// All actions of the window: texts, tool tips, shortcuts, and which of them the engine's reported state
// allows.

#include "app/deaf_keys.h"
#include "app/fault_menu.h"
#include "app/horn.h"
#include "engine/base/units.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/theme.h"

#include <QAction>
#include <QObject>

#include <array>

class QActionGroup;
class QMenu;
class QMenuBar;
class QWidget;

namespace bask {

/// Verbs of a run, in the order of use.
enum class Verb { Arm, Start, Hold, Resume, Stop, Retreat, EmergencyStop, Reset };
inline constexpr int kVerbs = 8;
inline constexpr int kPages = 6;

/// Returns whether the engine accepts the verb now; nothing else enables a button.
bool allows(const Snapshot& snapshot, Verb verb);

/// Returns whether another experiment, or other sensors, robot or source may be used: no run is armed or on.
bool allowsEdits(RunState state);

/// Returns whether a reason is an error of checkTargets(): with these targets nothing can be armed.
bool isUnfitTarget(MessageCode reason);

class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QWidget* window);

    void fillMenus(QMenuBar* bar);
    void retranslate();
    void restyle(const QPalette& palette);

    void apply(const Snapshot& snapshot);
    void setRecent(const QStringList& files);
    void showTemperatureUnit(TemperatureUnit unit);
    void showTheme(Theme theme);
    void showTextSize(int percent);
    void showHornMode(HornMode mode);
    void showLanguage(const QString& code);
    void showPage(int page);

    QAction* verb(Verb verb) const { return m_verbs[static_cast<std::size_t>(verb)]; }
    FaultMenu& faults() { return m_faults; }
    QAction* page(int index) const { return m_pages[static_cast<std::size_t>(index)]; }
    QMenu* unitMenu() const { return m_unitMenu; }
    QMenu* languageMenu() const { return m_languageMenu; }

    QAction *newExperiment, *open, *save, *saveAs, *saveSession, *quit;
    QAction *undo, *redo; ///< UndoActions sets their texts
    QAction* homeRobot;   ///< moves it: the window asks first
    QAction *endRecording, *acknowledgeAlarms, *labels, *allAlarms, *largeNumbers, *monitoring;
    QAction *manual, *firstFiveMinutes, *reportProblem, *about;

signals:
    void verbTriggered(bask::Verb verb);
    /// The key of a verb was pressed that is not possible now.
    void verbRefused(bask::Verb verb);
    /// The key of another action was pressed that is not possible now.
    void keyRefused(const QString& why);
    void pageChosen(int page);
    void unitChosen(bask::TemperatureUnit unit);
    void themeChosen(bask::Theme theme);
    void textSizeChosen(int percent);
    void hornModeChosen(bask::HornMode mode);
    void languageChosen(const QString& code);
    void exampleChosen(const QString& name);
    void recentChosen(const QString& path);
    void recentCleared();

private:
    QAction* make(const char* name, const QKeySequence& keys = {});
    void makeVerbs();
    void makeView();
    void retranslateFile();
    void retranslateRun();
    void showTip(Verb verb);
    void retranslateView();
    void hear(QAction* deaf);
    void showReasons();

    QWidget* m_window;
    QAction* m_clearRecent;
    std::array<QAction*, kVerbs> m_verbs{};
    std::array<QString, kVerbs> m_meanings; ///< sentences of their tips
    DeafKeys m_deafKeys;
    Snapshot m_told; ///< only what reasons depend on: state, place, recording and alarms
    std::array<QAction*, kPages> m_pages{};
    QActionGroup *m_pageGroup, *m_unitGroup, *m_themeGroup, *m_textSizeGroup, *m_hornGroup, *m_languageGroup;
    std::array<QAction*, 3> m_units{}, m_themes{}, m_horns{};
    QList<QAction*> m_textSizes, m_languages;
    FaultMenu m_faults;
    QMenu *m_fileMenu, *m_exampleMenu, *m_recentMenu, *m_editMenu, *m_runMenu, *m_viewMenu, *m_unitMenu,
        *m_themeMenu, *m_textSizeMenu, *m_hornMenu, *m_languageMenu, *m_toolsMenu, *m_helpMenu;
};

} // namespace bask
