#include "app/run_forecast.h"

#include "engine/runtime/simulated_run.h"

#include <QDeadlineTimer>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

// What has changed by less is not predicted anew.
constexpr double kNear_m = 1e-3, kNear_rad = 0.01, kNear_K = 2.0;

bool isWithin(double a_K, double b_K, double near_K) {
    return std::abs(a_K - b_K) <= near_K;
}

/// Without what only a simulated rig knows: a run that differs by that is to be seen to.
Experiment asAssumed(Experiment experiment) {
    for (ObjectSpec& object : experiment.objects)
        object.simulatedMaterial.reset();
    experiment.simulation.sourceEmittance.reset();
    experiment.simulation.sourcePose.reset();
    experiment.simulation.sourceUneven.reset();
    return experiment;
}

PredictedRun forecast(const Experiment& experiment, const RigCondition& from, const std::stop_token& stop) {
    std::stop_source over;
    const std::stop_callback unwanted(stop, [&over] { over.request_stop(); });
    const QDeadlineTimer deadline(RunForecast::kLongest_ms);
    auto run = predictedRun(experiment, from, over.get_token(), [&](double) {
        if (deadline.hasExpired())
            over.request_stop();
    });
    return run ? std::move(*run) : PredictedRun(); // one that cannot run has no prediction
}

} // namespace

RunForecast::RunForecast() {
    m_pool.setMaxThreadCount(1);
    m_pool.setThreadPriority(QThread::LowPriority);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &RunForecast::predict);
}

void RunForecast::setExperiment(const Experiment& experiment) {
    m_experiment = experiment;
    drop();
}

void RunForecast::apply(const Snapshot& snapshot, bool isWatched) {
    const bool isBefore = !isRunOn(snapshot.state) && snapshot.state != RunState::Fault &&
                          snapshot.runTime_s == 0.0 && snapshot.place != PlaceState::Unknown;
    if (!isBefore || !isWatched) {
        m_rest.stop();
        return m_job.forget();
    }
    const std::optional<Beginning> now = beginningOf(snapshot);
    if (!now)
        return; // of another experiment
    if (!m_from || !isNear(*m_from, *now)) {
        drop();
        m_from = now;
        m_rest.start();
    } else if (!m_isMade && !m_rest.isActive() && !m_job.busy()) { // nobody looked meanwhile
        m_rest.start();
    }
}

std::optional<RunForecast::Beginning> RunForecast::beginningOf(const Snapshot& snapshot) const {
    const std::size_t count = m_experiment.objects.size();
    if (count == 0 || snapshot.objects.size() != count || snapshot.toldReadings_K.size() != count ||
        !snapshot.latest.coordinates.allFinite())
        return std::nullopt;
    Beginning now;
    now.coordinates = snapshot.latest.coordinates;
    now.environment_K = snapshot.zeroing ? snapshot.zeroing->environment_K : m_experiment.environment_K;
    now.source_K = snapshot.source_K.value_or(sourceSetPoint_K(m_experiment.source, 0.0));
    now.objects_K.reserve(count);
    for (const double told_K : snapshot.toldReadings_K)
        now.objects_K.push_back(std::isfinite(told_K) ? told_K : now.environment_K);
    return now;
}

bool RunForecast::isNear(const Beginning& a, const Beginning& b) {
    const Vector6d way = a.coordinates - b.coordinates;
    return way.head<3>().norm() <= kNear_m && way.tail<3>().norm() <= kNear_rad &&
           isWithin(a.source_K, b.source_K, SourceWarmUp::kWarm_K) &&
           isWithin(a.environment_K, b.environment_K, kNear_K) &&
           std::ranges::equal(a.objects_K, b.objects_K,
                              [](double x_K, double y_K) { return isWithin(x_K, y_K, kNear_K); });
}

void RunForecast::drop() {
    m_rest.stop();
    m_job.forget();
    m_from.reset();
    m_isMade = false;
    if (m_predicted.samples.empty())
        return;
    m_predicted = {};
    emit changed();
}

void RunForecast::predict() {
    Experiment experiment = asAssumed(m_experiment);
    experiment.environment_K = m_from->environment_K;
    experiment.simulation.durationLimit_s = std::min(experiment.simulation.durationLimit_s, kMaxPredicted_s);
    RigCondition from;
    from.coordinates = m_from->coordinates;
    for (const double object_K : m_from->objects_K) // those as cold as the room are zeroed there
        from.objects_K.push_back(isWithin(object_K, m_from->environment_K, kNear_K)
                                     ? std::numeric_limits<double>::quiet_NaN()
                                     : object_K);
    if (!isWithin(m_from->source_K, sourceSetPoint_K(experiment.source, 0.0), SourceWarmUp::kWarm_K))
        from.source_K = m_from->source_K;
    m_job.run([experiment, from](const std::stop_token& stop) { return forecast(experiment, from, stop); },
              [this](const PredictedRun& run) {
                  m_isMade = true;
                  m_predicted = run;
                  emit changed();
              });
}

} // namespace bask
