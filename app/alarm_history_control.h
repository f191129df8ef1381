#pragma once
// The window's side of the alarms of the listed runs, and of those without a run: their dialog, made when it
// is first wanted, and reading them.

#include "engine/recording/alarm_history.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QPointer>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <memory>
#include <string>

namespace bask {

class AlarmHistoryDialog;
class SessionList;

/// On a thread of its own: a year of recordings would keep the pool from files for seconds. What is read is
/// what the list shows when the dialog is asked for; closing the dialog ends the reading.
class AlarmHistoryControl : public QObject {
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 100; ///< interval between shown percentages

    /// Serves the list, which must outlive it. The file is that of the alarms without a run; with an empty
    /// name there are none.
    explicit AlarmHistoryControl(SessionList& list, std::string unrecordedFile = {});
    ~AlarmHistoryControl() override;

    void open();
    void retranslate();

signals:
    /// A person wants to see a run, at this time since Start.
    void runChosen(const QString& path, double time_s);
    void readFailed(const bask::Error& error); ///< of a listed run

private:
    void make();
    void read();

    SessionList& m_list;
    std::string m_unrecordedFile;
    QPointer<AlarmHistoryDialog> m_dialog; ///< null if it is not open
    std::shared_ptr<std::atomic<int>> m_percent;
    QTimer m_timer;
    QThreadPool m_pool;
    LatestJob<AlarmHistory> m_job{m_pool};
};

} // namespace bask
