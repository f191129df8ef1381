#pragma once
// The alarms, the gravest first, what follows from each under it, those put aside at the end, and of the
// chosen one what to do.

#include "engine/base/units.h"
#include "widgets/common/alarm_groups.h"

#include <QDate>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

class QPushButton;
class QTextEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace bask {

class ShelfPopup;

/// Object names: "alarmList", "alarmListTree" (priority, state, raised, times, what; what follows from an
/// alarm is folded under it, the last row holds the shelved ones), "alarmGuidance", "acknowledgeAlarm" (the
/// chosen one), "acknowledgeAllAlarms", "shelveAlarm" (or back, of a shelved one), "shelfPopup" (see there).
class AlarmList : public QWidget {
    Q_OBJECT

public:
    explicit AlarmList(QWidget* parent = nullptr);

    /// As the engine sorts them. What is chosen, scrolled and focused stays so; with nothing chosen, a new
    /// alarm is. One that leaves is not followed by its neighbour, which nobody has read.
    void setAlarms(const std::vector<Alarm>& alarms);
    void setTemperatureUnit(TemperatureUnit unit);
    /// The engine does not answer: what is shown may be old.
    void setStale(bool isStale);
    /// Chooses it, for a person who asked for it; the keyboard goes there.
    void choose(std::uint64_t id);

signals:
    void acknowledgeRequested(quint64 id);
    void acknowledgeAllRequested();
    void shelveRequested(quint64 id, double for_s, const QString& reason);
    void unshelveRequested(quint64 id);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showRows();
    void showGroup(QTreeWidgetItem* item, const AlarmGroup& group);
    void showShelf(QTreeWidgetItem* item);
    void fill(QTreeWidgetItem* item, const Alarm& alarm, std::size_t following = 0) const;
    void setFolded(const QTreeWidgetItem* item, bool isFolded);
    void openShelf();
    void showChosen();
    QString guidance() const;
    const Alarm* chosen() const;
    bool isShelvable(const Alarm& alarm) const;
    void retranslateUi();

    std::vector<Alarm> m_alarms;
    AlarmGroups m_groups; ///< of them
    std::set<std::uint64_t> m_unfolded;
    bool m_isShelfFolded = false;
    QDate m_today;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStale = false;
    std::optional<std::uint64_t> m_chosen;
    QString m_shown; ///< as guidance
    QTreeWidget* m_tree;
    QTextEdit* m_guidance;
    QPushButton* m_acknowledge;
    QPushButton* m_acknowledgeAll;
    QToolButton* m_shelve;
    ShelfPopup* m_shelf;
};

} // namespace bask
