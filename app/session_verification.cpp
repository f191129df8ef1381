#include "app/session_verification.h"

#include "engine/base/thread_priority.h"

#include <algorithm>
#include <utility>

namespace bask {

SessionVerification::SessionVerification() {
    m_pool.setMaxThreadCount(1);
}

void SessionVerification::start(const QString& path) {
    m_waiting = {path};
    next();
}

void SessionVerification::add(const QString& path) {
    if (path == m_looked || std::ranges::find(m_waiting, path) != m_waiting.end())
        return;
    m_waiting.push_back(path);
    if (m_looked.isEmpty())
        next();
}

void SessionVerification::release(const QString& path) {
    std::erase(m_waiting, path);
    if (path == m_looked)
        next();
}

void SessionVerification::next() {
    const bool wasBusy = isBusy();
    m_looked.clear();
    if (m_waiting.empty()) {
        m_job.forget();
        if (wasBusy)
            emit busyChanged();
        return;
    }
    const QString path = m_looked = m_waiting.front();
    m_waiting.pop_front();
    m_job.run(
        [file = path.toStdString()](const std::stop_token& stop) {
            giveWay();
            return verifyOpenSession(file, stop);
        },
        [this, path](const Result<SessionVerdict>& verdict) {
            next();
            if (verdict)
                emit verified(path, *verdict);
            else
                emit failed(path, verdict.error());
        });
    if (!wasBusy)
        emit busyChanged();
}

} // namespace bask
