#pragma once
// The alarms of the listed runs, and those without a run: how often each was raised, and in which runs.

#include "engine/recording/alarm_history.h"

#include <QDialog>

#include <cstddef>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace bask {

/// Reading is the receiver's work. Not modal, so that STOP stays reachable. Object names:
/// "alarmHistoryDialog", "alarmHistoryFilter", "alarmHistorySummary" (also that there is none),
/// "alarmHistoryAlarms" (a row for each alarm, up to kMaxShown), "alarmHistoryRuns" (a row for each run of
/// the selected alarm, and for each time without a run, up to kMaxShown), "alarmHistoryUnread",
/// "alarmHistoryCopy", "alarmHistoryOpen", "alarmHistoryClose".
class AlarmHistoryDialog : public QDialog {
    Q_OBJECT

public:
    static constexpr std::size_t kMaxShown = 1000; ///< alarms; of more, the gravest

    explicit AlarmHistoryDialog(QWidget* parent = nullptr);

    /// The runs are being read: the shown content may be old.
    void setReading(int percent);
    void setHistory(AlarmHistory history);
    /// Says all again, in the reader's language and unit of temperature.
    void retranslate();

signals:
    /// A person wants to see a run, at the time since Start when the selected alarm was last raised in it.
    void runChosen(const QString& path, double raised_s);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showAlarms(const Message& chosen);
    Message chosen() const;
    QTreeWidgetItem* alarmRow(std::size_t place) const;
    std::vector<std::size_t> shownAlarms() const;
    void filter();
    void hideOthers();
    void showRuns();
    QTreeWidgetItem* runRow(const AlarmInRun& in) const;
    QTreeWidgetItem* unrecordedRow(const UnrecordedSpell& spell) const;
    QString selectedPath() const;
    void enableOpen();
    void showSummary();
    QString raisedWords(int read) const;
    void showUnread();
    void openRun();
    void copy() const;
    const PastAlarm* selected() const;

    AlarmHistory m_history;
    bool m_isReading = true;
    int m_percent = 0;
    QLineEdit* m_filter;
    QLabel* m_summary;
    QTreeWidget *m_alarms, *m_runs;
    QLabel* m_unread;
    QPushButton *m_copy, *m_open, *m_close;
};

} // namespace bask
