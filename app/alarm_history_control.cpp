#include "app/alarm_history_control.h"

#include "engine/base/thread_priority.h"
#include "widgets/review/alarm_history_dialog.h"
#include "widgets/review/run_differences.h"
#include "widgets/review/session_list.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace bask {

AlarmHistoryControl::AlarmHistoryControl(SessionList& list, std::string unrecordedFile)
    : m_list(list), m_unrecordedFile(std::move(unrecordedFile)) {
    m_pool.setMaxThreadCount(1);
    m_timer.setInterval(kInterval_ms);
    connect(&m_timer, &QTimer::timeout, this, [this] { m_dialog->setReading(*m_percent); });
    connect(&m_list, &SessionList::alarmsRequested, this, &AlarmHistoryControl::open);
}

AlarmHistoryControl::~AlarmHistoryControl() {
    delete m_dialog;
}

void AlarmHistoryControl::make() {
    m_dialog = new AlarmHistoryDialog(m_list.window());
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &AlarmHistoryDialog::runChosen, this, &AlarmHistoryControl::runChosen);
    connect(m_dialog, &QDialog::finished, this, [this] {
        m_timer.stop();
        m_job.forget();
        m_dialog.clear(); // it is deleted a little later
    });
}

void AlarmHistoryControl::open() {
    if (!m_dialog)
        make();
    read();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void AlarmHistoryControl::retranslate() {
    if (m_dialog)
        m_dialog->retranslate();
}

void AlarmHistoryControl::read() {
    m_percent = std::make_shared<std::atomic<int>>(0);
    m_dialog->setReading(0);
    m_timer.start();
    m_job.run(
        [runs = m_list.listed(), file = m_unrecordedFile,
         percent = m_percent](const std::stop_token& stop) mutable {
            giveWay();
            std::ranges::stable_sort(runs, std::ranges::greater(), recordedAt); // as the dialog dates them
            AlarmHistory history = readAlarmHistory(
                std::move(runs), stop, [&](double share) { *percent = static_cast<int>(100.0 * share); });
            addUnrecorded(history, file);
            return history;
        },
        [this](AlarmHistory history) {
            m_timer.stop();
            for (const std::size_t run : history.unreadable)
                emit readFailed(*history.runs[run].error);
            m_dialog->setHistory(std::move(history));
        });
}

} // namespace bask
