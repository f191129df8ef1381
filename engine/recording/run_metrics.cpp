#include "engine/recording/run_metrics.h"

#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace bask {
namespace {

/// What its thermometer told; NaN where that is no reading.
double read_K(const ObjectSample& object) {
    return object.valid ? object.measured_K : std::numeric_limits<double>::quiet_NaN();
}

/// When T first passes a level, linear between samples; samples without T are left out.
class LevelCrossing {
public:
    LevelCrossing() = default;
    LevelCrossing(double level_K, bool isUpward) : m_level_K(level_K), m_isUpward(isUpward) {}

    void add(double time_s, double T_K) {
        const double now = m_isUpward ? T_K - m_level_K : -(T_K - m_level_K);
        if (m_at_s || !std::isfinite(now))
            return;
        if (now < 0.0)
            m_before = std::pair{time_s, now};
        else if (!m_before)
            m_at_s = time_s;
        else
            m_at_s =
                m_before->first + (time_s - m_before->first) * m_before->second / (m_before->second - now);
    }
    std::optional<double> at_s() const { return m_at_s; }

private:
    double m_level_K = 0.0;
    bool m_isUpward = true;
    std::optional<std::pair<double, double>> m_before; ///< time and distance, the last one below the level
    std::optional<double> m_at_s;
};

} // namespace

struct RunMetricsCount::ObjectCount {
    explicit ObjectCount(const Pose& X_EO) : centre_E(X_EO.translation()) {
        metrics.target_K = std::numeric_limits<double>::quiet_NaN();
    }

    void add(const TraceSample& sample, std::size_t i, double T_K, double band_K) {
        const ObjectSample& object = sample.objects[i];
        if (!isBegun || object.target_K != metrics.target_K) // an unknown one is another each time
            beginStep(sample.time_s, object.target_K, T_K, band_K);
        metrics.final_K = std::isfinite(T_K) ? std::optional(T_K) : std::nullopt;
        if (metrics.final_K)
            addTemperature(sample.time_s, T_K, band_K);
        const Eigen::Vector3d centre = poseFromCoordinates(sample.coordinates) * centre_E;
        if (isBegun) {
            const double way_m = (centre - lastCentre).norm();
            metrics.pathLength_m += std::isfinite(way_m) ? way_m : 0.0;
        }
        lastCentre = centre;
        isBegun = true;
    }

    void addTemperature(double time_s, double T_K, double band_K) {
        const double error_K = T_K - metrics.target_K;
        if (isJudged) {
            begun.add(time_s, T_K);
            done.add(time_s, T_K);
            const double over_K = *metrics.step_K > 0.0 ? error_K : -error_K;
            if (std::isfinite(over_K))
                metrics.overshoot_K = std::max(*metrics.overshoot_K, over_K);
        }
        if (!(std::abs(error_K) <= band_K))
            metrics.settledFrom_s.reset();
        else if (!metrics.settledFrom_s)
            metrics.settledFrom_s = time_s;
        lately.emplace_back(time_s, error_K);
        while (lately.front().first < time_s - kSteadyWindow_s)
            lately.pop_front();
    }

    void beginStep(double time_s, double target_K, double T_K, double band_K) {
        metrics.target_K = target_K;
        metrics.from_s = time_s;
        metrics.step_K.reset();
        metrics.overshoot_K.reset();
        if (std::isfinite(T_K) && std::isfinite(target_K))
            metrics.step_K = target_K - T_K;
        else
            metrics.settledFrom_s.reset(); // at the target before
        lately.clear();
        isJudged = metrics.step_K && std::abs(*metrics.step_K) >= 2.0 * band_K;
        if (!isJudged)
            return;
        const double step_K = *metrics.step_K, first_K = target_K - step_K;
        begun = LevelCrossing(first_K + 0.1 * step_K, step_K > 0.0);
        done = LevelCrossing(first_K + 0.9 * step_K, step_K > 0.0);
        metrics.overshoot_K = 0.0;
    }

    ObjectMetrics judged(double last_s) const {
        ObjectMetrics out = metrics;
        if (isJudged && begun.at_s() && done.at_s())
            out.rise_s = *done.at_s() - *begun.at_s();
        if (!metrics.settledFrom_s)
            return out;
        out.settling_s = std::max(*metrics.settledFrom_s - metrics.from_s, 0.0);
        const double from_s = std::max({*metrics.settledFrom_s, metrics.from_s, last_s - kSteadyWindow_s});
        double sum_K = 0.0, squares = 0.0;
        std::size_t count = 0; // none: all of them are older than the window
        for (const auto& [time_s, error_K] : lately) {
            if (time_s < from_s)
                continue;
            sum_K += error_K;
            squares += error_K * error_K;
            ++count;
        }
        if (count == 0)
            return out;
        const double mean_K = sum_K / static_cast<double>(count);
        out.steadyError_K = mean_K;
        if (count > 1)
            out.steadyDeviation_K =
                std::sqrt(std::max(squares - static_cast<double>(count) * mean_K * mean_K, 0.0) /
                          static_cast<double>(count - 1));
        return out;
    }

    Eigen::Vector3d centre_E, lastCentre = Eigen::Vector3d::Zero();
    ObjectMetrics metrics; ///< but for what judged() adds
    bool isBegun = false;
    bool isJudged = false; ///< the step is large enough
    LevelCrossing begun, done;
    std::deque<std::pair<double, double>> lately; ///< times and errors since the step and in the last window
};

RunMetricsCount::RunMetricsCount(const SessionRecord& facts, double band_K)
    : m_until_s(controlledUntil_s(facts)) {
    m_metrics.band_K = band_K;
    for (const ObjectSpec& object : facts.experiment.objects)
        m_objects.emplace_back(poseFromCoordinates(object.mounting));
    m_trueObjects = m_objects;
    constexpr double kOpen_s = std::numeric_limits<double>::infinity();
    for (const TraceEvent& event : facts.events) {
        const bool isPaused = !m_pauses_s.empty() && m_pauses_s.back().second == kOpen_s;
        const MessageCode code = event.message.code;
        if ((code == MessageCode::EventHeld || code == MessageCode::EventHeldFor) && !isPaused)
            m_pauses_s.emplace_back(event.time_s, kOpen_s);
        else if (code == MessageCode::EventResumed && isPaused)
            m_pauses_s.back().second = event.time_s;
    }
}

RunMetricsCount::~RunMetricsCount() = default;

void RunMetricsCount::add(const TraceSample& sample) {
    if (sample.time_s > m_until_s)
        return;
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const double true_K = sample.objects[i].true_K;
        m_hasTruth = m_hasTruth || std::isfinite(true_K);
        m_objects[i].add(sample, i, read_K(sample.objects[i]), m_metrics.band_K);
        m_trueObjects[i].add(sample, i, true_K, m_metrics.band_K);
    }
    if (m_metrics.samples > 0)
        addMotion(sample);
    m_metrics.last = sample;
    m_metrics.duration_s = sample.time_s;
    ++m_metrics.samples;
}

/// From the last sample to this one.
void RunMetricsCount::addMotion(const TraceSample& sample) {
    const TraceSample& before = m_metrics.last;
    const Pose X0 = poseFromCoordinates(before.coordinates), X1 = poseFromCoordinates(sample.coordinates);
    const double way_m = (X1.translation() - X0.translation()).norm();
    if (std::isfinite(way_m)) {
        m_metrics.pathLength_m += way_m;
        m_metrics.turned_rad += Eigen::AngleAxisd(X0.linear().transpose() * X1.linear()).angle();
    }
    const double lasts_s = sample.time_s - before.time_s;
    const ActiveLimits& limits = before.limits;
    while (!m_pauses_s.empty() && m_pauses_s.front().second < before.time_s)
        m_pauses_s.pop_front();
    // Older files keep the limits of the last command throughout a hold.
    const bool isPaused = !m_pauses_s.empty() && m_pauses_s.front().first <= before.time_s;
    if (!limits.any() || isPaused || !(lasts_s > 0.0))
        return;
    m_metrics.clamped_s += lasts_s;
    for (int l = 0; l < static_cast<int>(m_metrics.atLimit_s.size()); ++l) {
        bool isActive = limits.has(static_cast<Limit>(l));
        for (int c = 1; static_cast<Limit>(l) == Limit::Workspace && c < 6; ++c)
            isActive = isActive || limits.has(Limit::Workspace, c);
        if (isActive)
            m_metrics.atLimit_s[static_cast<std::size_t>(l)] += lasts_s;
    }
    if (limits.has(Limit::Speed) || limits.has(Limit::Rotation))
        m_metrics.atVelocityLimit_s += lasts_s;
}

RunMetrics RunMetricsCount::metrics() const {
    RunMetrics out = m_metrics;
    for (const ObjectCount& object : m_objects)
        out.objects.push_back(object.judged(m_metrics.last.time_s));
    for (const ObjectCount& object : m_hasTruth ? m_trueObjects : std::vector<ObjectCount>())
        out.trueObjects.push_back(object.judged(m_metrics.last.time_s));
    return out;
}

std::optional<double> ObjectMetrics::overshootShare() const {
    return overshoot_K && step_K ? std::optional(*overshoot_K / std::abs(*step_K)) : std::nullopt;
}

RunMetrics runMetrics(const SessionRecord& session, double band_K) {
    RunMetricsCount count(session, band_K);
    for (const TraceSample& sample : session.samples)
        count.add(sample);
    return count.metrics();
}

} // namespace bask
