#pragma once
// Results that need all samples of a recorded run: metrics, the path of its objects, heat rates. One pass
// over the file, off the GUI thread.

#include "app/session_rates.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/run_metrics.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <limits>
#include <memory>
#include <vector>

namespace bask {

struct SessionNumbers {
    RunMetrics metrics;
    std::vector<TraceSample> way; ///< a selection of samples from the whole run
    Result<SessionRates> rates;
    /// The largest share of its view factor that an object lost to the others; NaN: not known.
    double shade = std::numeric_limits<double>::quiet_NaN();
};

/// Any thread; `done` increases up to the number of samples. Errors: those of readSamples.
Result<SessionNumbers> countSession(const SessionRecord& facts, std::size_t samples,
                                    std::atomic<std::size_t>& done, const std::stop_token& stop = {});

class SessionCount : public QObject {
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 100; ///< interval between progressed() signals

    SessionCount();

    /// Starts counting and replaces a count in progress.
    void start(const RecordedSession& session);
    void stop();

signals:
    void progressed(int percent);
    void counted(std::shared_ptr<const bask::SessionNumbers> numbers);
    void failed(const bask::Error& error);

private:
    LatestJob<Result<SessionNumbers>> m_job;
    std::shared_ptr<std::atomic<std::size_t>> m_done;
    std::size_t m_samples = 0;
    QTimer m_timer;
};

} // namespace bask
