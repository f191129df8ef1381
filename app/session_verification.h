#pragma once
// Whether the recordings that are open on the Review page are as they were recorded.

#include "engine/recording/session_verify.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <deque>

namespace bask {

/// Looks at one file after another, on a thread of its own: of a day that takes some ten seconds.
class SessionVerification : public QObject {
    Q_OBJECT

public:
    SessionVerification();

    /// Verifies the run that is opened, and forgets those asked for before.
    void start(const QString& path);
    /// Verifies a run that is laid over it, too.
    void add(const QString& path);
    /// Lets go of a file that is about to be changed.
    void release(const QString& path);
    bool isBusy() const { return !m_looked.isEmpty(); }

signals:
    void busyChanged();
    void verified(const QString& path, const bask::SessionVerdict& verdict);
    void failed(const QString& path, const bask::Error& error);

private:
    void next();

    std::deque<QString> m_waiting;
    QString m_looked; ///< path of the run that is looked at; empty for none
    QThreadPool m_pool;
    LatestJob<Result<SessionVerdict>> m_job{m_pool};
};

} // namespace bask
