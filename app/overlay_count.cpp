#include "app/overlay_count.h"

#include "engine/base/thread_priority.h"
#include "engine/recording/recorded_session.h"
#include "widgets/review/replay_view.h"

namespace bask {
namespace {

Result<RunMetrics> metricsOf(const SessionRecord& facts, const std::stop_token& stop) {
    giveWay();
    RunMetricsCount count(facts);
    const auto read = readSamples(
        facts.path, [&](const TraceSample& sample) { count.add(sample); }, stop);
    return read ? Result<RunMetrics>(count.metrics()) : read.error();
}

} // namespace

OverlayCount::OverlayCount(ReplayView& view) : m_view(view) {
    m_pool.setMaxThreadCount(1);
    connect(&m_view, &ReplayView::overlaysChanged, this, &OverlayCount::countNext);
}

void OverlayCount::release(const QString& path) {
    m_released = path;
    countNext();
}

void OverlayCount::resume() {
    m_released.clear();
    countNext();
}

void OverlayCount::countNext() {
    const std::shared_ptr<RecordedSession> run = m_view.uncounted(m_released);
    const QString path = run ? QString::fromStdString(run->facts().path) : QString();
    if (path == m_counted)
        return;
    m_counted = path;
    if (!run)
        return m_job.forget();
    m_job.run([facts = run->facts()](const std::stop_token& stop) { return metricsOf(facts, stop); },
              [this, path](const Result<RunMetrics>& metrics) {
                  m_counted.clear();
                  m_view.setMetrics(path, metrics ? &*metrics : nullptr);
                  if (!metrics)
                      emit failed(metrics.error());
                  countNext();
              });
}

} // namespace bask
