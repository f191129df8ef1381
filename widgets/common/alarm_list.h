#pragma once
// The alarms, the most serious first: consequences under their cause, shelved ones at the end, and what to do
// about the selected one.

#include "engine/base/units.h"
#include "widgets/common/alarm_groups.h"

#include <QDate>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

class QGridLayout;
class QMenu;
class QPushButton;
class QTextEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace bask {

class ShelfPopup;

/// Object names: "alarmList", "alarmListTree" (priority, state, raised, times, what; consequences of an alarm
/// are folded under it, the last row contains the shelved ones), "alarmGuidance", "acknowledgeAlarm" (the
/// selected one), "acknowledgeAllAlarms", "homeFromAlarm" (while one of the robot's place is selected),
/// "shelveAlarm" (for a shelved one: unshelve), "alarmMenu" (of the right button), "shelfPopup" (see there).
class AlarmList : public QWidget {
    Q_OBJECT

public:
    explicit AlarmList(QWidget* parent = nullptr);

    /// Alarms as sorted by the engine. What is selected stays, as scroll position and focus do: Acknowledge
    /// must not hit another than the one that was read. Where none is selected, or one that needs no
    /// acknowledgement and that no person has selected, the gravest is. When an alarm disappears that a
    /// person has selected or acknowledged, none is until the alarms change again. A graver one that comes
    /// takes the place of one that no person has selected, as the gravest does when that one is folded under
    /// a cause, or of one that a person has selected and that is over, acknowledged or shelved; for a
    /// second nothing is acknowledged then. A cause is unfolded over one that a person selected.
    void setAlarms(const std::vector<Alarm>& alarms);
    /// What homes the robot; shown with an alarm that its place is not sure.
    void setHomeAction(QAction* home);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Marks the alarms as possibly old because the engine does not answer.
    void setStale(bool isStale);
    /// Selects the alarm because a person asked for it, and moves the keyboard focus there.
    void choose(std::uint64_t id);

    /// Of the narrower arrangement.
    QSize minimumSizeHint() const override;

signals:
    void acknowledgeRequested(quint64 id);
    void acknowledgeAllRequested();
    void shelveRequested(quint64 id, double for_s, const QString& reason);
    void unshelveRequested(quint64 id);
    /// A person wants to see the alarms of earlier runs, too.
    void historyRequested();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    void placeButtons(bool isNarrow);
    int minWidth(bool isNarrow) const;
    void showRows();
    void showGroup(QTreeWidgetItem* item, const AlarmGroup& group);
    void showShelf(QTreeWidgetItem* item);
    void fill(QTreeWidgetItem* item, const Alarm& alarm, std::size_t following = 0) const;
    void setFolded(const QTreeWidgetItem* item, bool isFolded);
    void showMenu(const QPoint& at);
    void openShelf();
    void showChosen();
    bool chooseGravest();
    bool isFolded(std::uint64_t id) const;
    bool unfoldOver(std::uint64_t id);
    const AlarmGroup* groupOver(std::uint64_t id) const;
    QString guidance() const;
    const Alarm* chosen() const;
    bool isShelvable(const Alarm& alarm) const;
    void retranslateUi();

    std::vector<Alarm> m_alarms;
    AlarmGroups m_groups; ///< the alarms in groups
    std::set<std::uint64_t> m_unfolded;
    bool m_isShelfFolded = false;
    QDate m_today;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStale = false;
    std::optional<std::uint64_t> m_chosen;
    bool m_isChosenByPerson = false;
    QTimer m_unread; ///< a graver alarm has just taken the place of the selected one
    std::optional<std::uint64_t> m_acknowledged; ///< the last one that was asked for here
    QPointer<QMenu> m_menu;                      ///< of the right button
    std::optional<std::uint64_t> m_menuId;       ///< its alarm
    QString m_shown;                             ///< the shown guidance
    std::optional<std::uint64_t> m_shownId{};    ///< its alarm
    QTreeWidget* m_tree;
    QTextEdit* m_guidance;
    bool m_isNarrow = false;
    QGridLayout* m_buttons; ///< two beside each other, or where there is little room each below another
    QPushButton* m_acknowledge;
    QPushButton* m_acknowledgeAll;
    QToolButton* m_shelve;
    QToolButton* m_home;
    ShelfPopup* m_shelf;
};

} // namespace bask
