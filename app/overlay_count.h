#pragma once
// The metrics of the runs that are laid over the open one, counted one after another.

#include "engine/recording/run_metrics.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

namespace bask {

class ReplayView;

/// On a thread of its own: beside the count of the open run it would keep the pool from files for long.
class OverlayCount : public QObject {
    Q_OBJECT

public:
    /// Counts what is laid over the view's run, which must outlive it.
    explicit OverlayCount(ReplayView& view);

    /// Lets go of a file that is about to be changed, until resume().
    void release(const QString& path);
    void resume();

signals:
    void failed(const bask::Error& error);

private:
    void countNext();

    ReplayView& m_view;
    QString m_counted; ///< path of the run that is being counted; empty for none
    QString m_released;
    QThreadPool m_pool;
    LatestJob<Result<RunMetrics>> m_job{m_pool};
};

} // namespace bask
