#pragma once
// The dock under the pages: alarms, events and the recipe.

#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/alarm_groups.h"

#include <QDockWidget>

class QTabWidget;
class QToolButton;

namespace bask {

class AlarmList;
class EventList;
class RecipePanel;

/// Object names: "eventDock", its tabs "dockTabs". A new alarm that is not a notice brings its tab to the
/// front; the keyboard focus does not move.
class BottomDock : public QDockWidget {
    Q_OBJECT

public:
    explicit BottomDock(QWidget* parent = nullptr);

    void apply(const Snapshot& snapshot);
    void setAnswering(bool answering);
    /// The alarm of a robot whose place is not sure has a button with it.
    void setHomeAction(QAction* home);
    /// Shows the alarms of earlier runs, too: a button beside the tabs, "allAlarmsButton", and in the list.
    void setHistoryAction(QAction* history);
    void setTemperatureUnit(TemperatureUnit unit);
    /// A recorded run is shown, and its events on the page: the dock is there without those of the present,
    /// so that an alarm moves nothing.
    void setReviewing(bool isReviewing);
    void showAlarm(std::uint64_t id);
    RecipePanel& recipe() { return *m_recipe; }
    void showRecipe();
    /// Another experiment is open: what happened before is listed no more.
    void beginExperiment();
    /// Events of the current or last run, also those that are listed no more.
    const std::vector<TraceEvent>& events() const { return m_events; }

signals:
    void commandIssued(const bask::Command& command);
    /// Time of a chosen event or note, s since Start.
    void timeChosen(double time_s);
    /// The front tab needs this height at once: the dock checks its height again before the layouts do.
    void heightWanted(int height);

protected:
    void changeEvent(QEvent* event) override;

private:
    void takeAlarms(const std::vector<Alarm>& alarms);
    void takeRows(const Snapshot& snapshot);
    void addEvent(const TraceEvent& event);
    void addNote(const TraceNote& note);
    void showEvents();
    void showParts();
    void bringAlarmsToFront();
    void fit();
    void retranslate();

    QTabWidget* m_tabs;
    QToolButton* m_history;
    AlarmList* m_alarmList;
    EventList* m_eventList;
    RecipePanel* m_recipe;
    std::vector<Alarm> m_alarms;
    AlarmGroups m_groups; ///< the listed alarms in groups
    std::uint64_t m_runId = 0;
    std::vector<TraceEvent> m_events;
    std::vector<TraceNote> m_notes;
    std::size_t m_firstEvent = 0, m_firstNote = 0; ///< that are listed
    bool m_isReviewing = false;
    int m_lowHeight = 0;           ///< height before the recipe was in front; 0 if it is not
    bool m_isBackToEvents = false; ///< show the events again after the review
};

} // namespace bask
