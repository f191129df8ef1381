#include "app/session_count.h"

#include "engine/model/trace_sample.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr std::size_t kMaxOfWay = 10'000; // samples; nobody could tell more of them in the scene

/// The larger one of a share and those of a sample.
double largerShade(double shade, const TraceSample& sample) {
    for (const ObjectSample& object : sample.objects)
        shade = std::fmax(shade, shadedShare(object)); // the other one where one is NaN
    return shade;
}

} // namespace

Result<SessionNumbers> countSession(const SessionRecord& facts, std::size_t samples,
                                    std::atomic<std::size_t>& done, const std::stop_token& stop) {
    RunMetricsCount metrics(facts);
    HeatRecords heat(facts);
    std::vector<TraceSample> way;
    double shade = std::numeric_limits<double>::quiet_NaN();
    const std::size_t every = samples / kMaxOfWay + 1;
    const auto read = readSamples(
        facts.path,
        [&](const TraceSample& sample) {
            metrics.add(sample);
            heat.add(sample);
            shade = largerShade(shade, sample);
            if (done++ % every == 0)
                way.push_back(sample);
        },
        stop);
    if (!read)
        return read.error();
    if (stop.stop_requested()) // nobody will hear of it
        return SessionNumbers{metrics.metrics(), {}, SessionRates(), shade};
    return SessionNumbers{metrics.metrics(), std::move(way), sessionRates(facts, heat), shade};
}

SessionCount::SessionCount() {
    m_timer.setInterval(kInterval_ms);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        emit progressed(static_cast<int>(std::min<std::size_t>(*m_done * 100 / m_samples, 100)));
    });
}

void SessionCount::start(const RecordedSession& session) {
    m_done = std::make_shared<std::atomic<std::size_t>>(0);
    m_samples = std::max<std::size_t>(session.size(), 1);
    m_timer.start();
    m_job.run([facts = session.facts(), samples = m_samples, done = m_done](
                  const std::stop_token& stop) { return countSession(facts, samples, *done, stop); },
              [this](Result<SessionNumbers> numbers) {
                  m_timer.stop();
                  if (numbers)
                      emit counted(std::make_shared<const SessionNumbers>(std::move(*numbers)));
                  else
                      emit failed(numbers.error());
              });
}

void SessionCount::stop() {
    m_timer.stop();
    m_job.forget();
}

} // namespace bask
