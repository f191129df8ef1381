#include "app/run_forecast.h"

#include "engine/base/thread_priority.h"
#include "engine/runtime/simulated_run.h"

#include <QDeadlineTimer>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

namespace bask {
namespace {

// What has changed by less is not predicted anew.
constexpr double kNear_m = 1e-3, kNear_rad = 0.01, kNear_K = 2.0;
// A source that cools would begin it again and again: so late may one be by the time that it is there.
constexpr double kDrift_K = 20.0;

bool isWithin(double a_K, double b_K, double near_K) {
    return std::abs(a_K - b_K) <= near_K;
}

/// Calls `compute(stop, progress)`, which is stopped when nobody wants it any more or it takes too long.
template <class F> void atMost(int longest_ms, const std::stop_token& stop, F&& compute) {
    giveWay();
    std::stop_source over;
    const std::stop_callback unwanted(stop, [&over] { over.request_stop(); });
    const QDeadlineTimer deadline(longest_ms);
    try {
        compute(over.get_token(), [&](double) {
            if (deadline.hasExpired())
                over.request_stop();
        });
    } catch (const std::exception&) { // one that cannot run has no prediction
    }
}

} // namespace

RunForecast::RunForecast() {
    m_pool.setMaxThreadCount(1);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &RunForecast::predict);
}

void RunForecast::setLongest_ms(int longest_ms) {
    m_longest_ms = longest_ms;
}

void RunForecast::setExperiment(const Experiment& experiment) {
    m_experiment = experiment;
    m_isOfRun = false;
    drop();
}

void RunForecast::apply(const Snapshot& snapshot, bool isWatched) {
    const bool isOn = isRunOn(snapshot.state) || snapshot.state == RunState::Fault;
    const bool isNewRun = std::exchange(m_runId, snapshot.runId) != snapshot.runId; // not compared when armed
    m_isOfRun = isOn || (m_isOfRun && snapshot.runTime_s > 0.0);
    if (m_isOfRun && !isNewRun)
        return pause();
    const std::optional<Beginning> now = beginningOf(snapshot);
    m_isKnown = now.has_value();
    if (!now)
        return drop();
    if (m_from && !isNear(*m_from, *now, m_job.busy() ? kDrift_K : SourceWarmUp::kWarm_K))
        drop();
    if (m_isOfRun || !isWatched)
        return pause();
    m_newest_K = now->source_K;
    if (m_from && (m_rest.isActive() || m_job.busy()))
        return;
    if (m_isMade && m_spread)
        return m_spread(); // nobody looked meanwhile
    if (m_isMade)
        return;
    if (!m_from)
        m_from = now;
    m_rest.start();
}

RunForecast::Missing RunForecast::missing() const {
    if (!m_predicted.samples.empty())
        return Missing::Nothing;
    if (isPending())
        return Missing::NotFinished;
    if (!m_isKnown)
        return Missing::NotKnown;
    return m_isMade ? Missing::NotPossible : Missing::NotSeen;
}

std::optional<RunForecast::Beginning> RunForecast::beginningOf(const Snapshot& snapshot) const {
    const std::size_t count = m_experiment.objects.size();
    if (count == 0 || snapshot.objects.size() != count || snapshot.toldReadings_K.size() != count)
        return std::nullopt; // of another experiment
    const auto isFinite = [](double value) { return std::isfinite(value); };
    if (snapshot.place != PlaceState::Sure || !isInside(snapshot.latest.coordinates) ||
        !std::ranges::all_of(snapshot.toldReadings_K, isFinite))
        return std::nullopt;
    Beginning now;
    now.coordinates = snapshot.latest.coordinates;
    now.environment_K = snapshot.zeroing ? snapshot.zeroing->environment_K : m_experiment.environment_K;
    now.source_K = snapshot.source_K.value_or(sourceSetPoint_K(m_experiment.source, 0.0));
    now.objects_K = snapshot.toldReadings_K;
    return now;
}

/// Of the workspace, but for what a robot tells to its last digit.
bool RunForecast::isInside(const Vector6d& coordinates) const {
    Vector6d slack;
    slack << Eigen::Vector3d::Constant(kNear_m), Eigen::Vector3d::Constant(kNear_rad);
    const RobotLimits& robot = m_experiment.robot; // NaN is not inside
    return ((coordinates - robot.lower + slack).array() >= 0.0).all() &&
           ((robot.upper - coordinates + slack).array() >= 0.0).all();
}

bool RunForecast::isNear(const Beginning& a, const Beginning& b, double sourceNear_K) {
    const Vector6d way = a.coordinates - b.coordinates;
    return way.head<3>().norm() <= kNear_m && way.tail<3>().norm() <= kNear_rad &&
           isWithin(a.source_K, b.source_K, sourceNear_K) &&
           isWithin(a.environment_K, b.environment_K, kNear_K) &&
           std::ranges::equal(a.objects_K, b.objects_K,
                              [](double x_K, double y_K) { return isWithin(x_K, y_K, kNear_K); });
}

/// What is shown stays.
void RunForecast::pause() {
    m_rest.stop();
    m_job.forget();
}

void RunForecast::drop() {
    pause();
    m_from.reset();
    m_isMade = false;
    m_spread = nullptr;
    if (m_predicted.samples.empty())
        return;
    m_predicted = {};
    emit changed();
}

void RunForecast::predict() {
    Experiment experiment = m_experiment;
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
    const auto compute = [experiment, from, longest_ms = m_longest_ms](const std::stop_token& stop) {
        PredictedRun made;
        atMost(longest_ms, stop, [&](std::stop_token over, const auto& progress) {
            if (auto run = predictedRun(experiment, from, std::move(over), progress))
                made = std::move(*run);
        });
        return made;
    };
    m_job.run(compute, [this, experiment, from](const PredictedRun& run) {
        m_isMade = true;
        m_from->source_K = m_newest_K;
        m_predicted = run;
        emit changed();
        if (run.end != PredictedEnd::Settled || run.samples.empty())
            return;
        m_spread = [this, experiment, from] { spread(experiment, from); };
        m_spread();
    });
}

/// Of a run that settles: another is told to be doubtful by its words.
void RunForecast::spread(const Experiment& experiment, const RigCondition& from) {
    const auto compute = [run = m_predicted, experiment, from,
                          longest_ms = m_longest_ms](const std::stop_token& stop) {
        PredictedRun wide = run;
        atMost(longest_ms, stop, [&](std::stop_token over, const auto& progress) {
            (void)addSpread(wide, experiment, from, PredictedRun::kDraws, std::move(over), progress);
        });
        return wide;
    };
    m_job.run(compute, [this](const PredictedRun& run) {
        m_spread = nullptr;
        m_from->source_K = m_newest_K;
        m_predicted = run;
        emit changed();
    });
}

} // namespace bask
