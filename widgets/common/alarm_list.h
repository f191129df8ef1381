#pragma once
// The alarms, the gravest first, and of the chosen one what to do.

#include "engine/base/units.h"
#include "engine/session/alarm.h"

#include <QDate>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

class QPushButton;
class QTextEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace bask {

/// Object names: "alarmList", "alarmListTree" (priority, state, raised, times, what), "alarmGuidance",
/// "acknowledgeAlarm" (the chosen one), "acknowledgeAllAlarms".
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

protected:
    void changeEvent(QEvent* event) override;

private:
    void showRows();
    void fill(QTreeWidgetItem* item, const Alarm& alarm) const;
    void showChosen();
    QString guidance() const;
    const Alarm* chosen() const;
    void retranslateUi();

    std::vector<Alarm> m_alarms;
    QDate m_today;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStale = false;
    std::optional<std::uint64_t> m_chosen;
    QString m_shown; ///< as guidance
    QTreeWidget* m_tree;
    QTextEdit* m_guidance;
    QPushButton* m_acknowledge;
    QPushButton* m_acknowledgeAll;
};

} // namespace bask
