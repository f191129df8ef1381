#include "engine/recording/run_metrics.h"

#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/zeroing_record.h"
#include "engine/thermal/contact_uncertainty.h"

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

/// When T first passes a share of a step, and how fast: by the chord from a little below that level to a
/// little above, since two readings in a row have too much noise for a slope.
class LevelPassing {
public:
    LevelPassing() = default;
    LevelPassing(double from_K, double step_K, double share) {
        const double size_K = std::abs(step_K), chord_K = std::max(kChord * size_K, kChord_K);
        m_below_K = std::min(chord_K, share * size_K);
        m_above_K = std::min(chord_K, 0.5 * (1.0 - share) * size_K);
        const double sign = step_K > 0.0 ? 1.0 : -1.0, level_K = from_K + share * step_K;
        m_below = LevelCrossing(level_K - sign * m_below_K, step_K > 0.0);
        m_at = LevelCrossing(level_K, step_K > 0.0);
        m_above = LevelCrossing(level_K + sign * m_above_K, step_K > 0.0);
    }

    void add(double time_s, double T_K) {
        for (LevelCrossing* const each : {&m_below, &m_at, &m_above})
            each->add(time_s, T_K);
    }
    std::optional<double> at_s() const { return m_at.at_s(); }
    /// In the step's direction, K/s; empty if it is not known.
    std::optional<double> slope_K_s() const {
        const auto from_s = m_below.at_s(), to_s = m_above.at_s() ? m_above.at_s() : m_at.at_s();
        if (!from_s || !to_s || !(*to_s > *from_s))
            return std::nullopt;
        return (m_below_K + (m_above.at_s() ? m_above_K : 0.0)) / (*to_s - *from_s);
    }

private:
    static constexpr double kChord = 0.05;   ///< of the step
    static constexpr double kChord_K = 0.25; ///< beyond steps and noise of a sensor
    double m_below_K = 0.0, m_above_K = 0.0;
    LevelCrossing m_below, m_at, m_above;
};

/// When an error was last above a level.
class LastAbove {
public:
    void add(double time_s, double error_K) {
        while (!m_peaks.empty() && m_peaks.back().error_K <= error_K)
            m_peaks.pop_back();
        if (!m_peaks.empty() && m_peaks.back().error_K - error_K < kSame_K)
            m_peaks.back().time_s = time_s;
        else if (error_K > -kFar_K)
            m_peaks.push_back({std::min(error_K, kFar_K), time_s});
    }
    void clear() { m_peaks.clear(); }
    /// Empty: never, for levels within +-kFar_K.
    std::optional<double> last_s(double level_K) const {
        const auto last = std::ranges::find_if(
            m_peaks.rbegin(), m_peaks.rend(), [level_K](const Peak& peak) { return peak.error_K > level_K; });
        return last == m_peaks.rend() ? std::nullopt : std::optional(last->time_s);
    }

private:
    static constexpr double kSame_K = 1e-3, kFar_K = 3.0; // so there are few of them
    struct Peak {
        double error_K;
        double time_s;
    };
    std::vector<Peak> m_peaks; ///< each the highest since the one before
};

/// Metrics of an object by one of its temperatures.
class TemperatureCount {
public:
    TemperatureCount() { m_metrics.target_K = std::numeric_limits<double>::quiet_NaN(); }

    void add(double time_s, double target_K, double T_K, double band_K) {
        if (target_K != m_metrics.target_K) // an unknown one is another each time
            beginStep(time_s, target_K, T_K, band_K);
        m_metrics.final_K = std::isfinite(T_K) ? std::optional(T_K) : std::nullopt;
        if (m_metrics.final_K)
            addTemperature(time_s, T_K, band_K);
    }

    /// Returns how well the moment is known from which T stays in the band, s, if T may be wrong by
    /// `error_K`: by the time since the reading before, and by how far such an error moves it. Infinite if it
    /// would not be in the band then; empty without such a moment.
    std::optional<double> settlingUncertainty_s(double error_K, double band_K) const {
        if (!m_metrics.settledFrom_s)
            return std::nullopt;
        const double from_s = m_metrics.from_s, found_s = outsideUntil_s(0.0, band_K).value_or(from_s);
        double moved_s = 0.0;
        for (const double wrong_K : {error_K, -error_K}) {
            const std::optional<double> until_s = outsideUntil_s(wrong_K, band_K);
            if (until_s == m_lately.back().first)
                return std::numeric_limits<double>::infinity();
            moved_s = std::max(moved_s, std::abs(until_s.value_or(from_s) - found_s));
        }
        const double u_s = std::hypot(m_gap_s / std::sqrt(12.0), moved_s);
        return u_s > 0.0 ? std::optional(u_s) : std::nullopt;
    }

    /// Returns how well the rise time is known, s, from readings of which each is wrong by `each_K` and all
    /// are by `all_K`. The first reading sets both levels. A reading too high by e lowers the time of its
    /// crossing by e/slope, and as the first one it raises the levels by 0.9 e and 0.1 e; so that
    ///
    ///     u^2 = each^2 (1/s10^2 + 1/s90^2 + (0.9/s10 - 0.1/s90)^2) + all^2 (0.9/s90 - 0.1/s10)^2.
    ///
    /// Of up to five readings while T moves by `each_K` the first that passes is about T's own crossing
    /// within that, however early it comes; of more it is earlier.
    std::optional<double> riseUncertainty_s(double each_K, double all_K) const {
        const auto s10 = m_begun.slope_K_s(), s90 = m_done.slope_K_s();
        if (!m_isJudged || !m_begun.at_s() || !m_done.at_s() || !s10 || !s90)
            return std::nullopt;
        const double ofEach = std::hypot(1.0 / *s10, 1.0 / *s90, 0.9 / *s10 - 0.1 / *s90);
        const double ofAll = 0.9 / *s90 - 0.1 / *s10;
        const double u_s = std::hypot(each_K * ofEach, all_K * ofAll);
        return u_s > 0.0 ? std::optional(u_s) : std::nullopt;
    }

    ObjectMetrics judged(double last_s, double pathLength_m) const {
        ObjectMetrics out = m_metrics;
        out.pathLength_m = pathLength_m;
        if (m_isJudged && m_begun.at_s() && m_done.at_s())
            out.rise_s = *m_done.at_s() - *m_begun.at_s();
        if (!m_metrics.settledFrom_s)
            return out;
        out.settling_s = std::max(*m_metrics.settledFrom_s - m_metrics.from_s, 0.0);
        const double from_s =
            std::max({*m_metrics.settledFrom_s, m_metrics.from_s, last_s - kSteadyWindow_s});
        double sum_K = 0.0, squares = 0.0;
        std::size_t count = 0; // none: all of them are older than the window
        for (const auto& [time_s, error_K] : m_lately) {
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
        out.steadySamples = count;
        if (count > 1)
            out.steadyDeviation_K =
                std::sqrt(std::max(squares - static_cast<double>(count) * mean_K * mean_K, 0.0) /
                          static_cast<double>(count - 1));
        return out;
    }

private:
    /// When T was last out of the band, all readings being too low by `wrong_K`; empty: never.
    std::optional<double> outsideUntil_s(double wrong_K, double band_K) const {
        return std::max(m_above.last_s(band_K - wrong_K), m_below.last_s(band_K + wrong_K));
    }

    void addTemperature(double time_s, double T_K, double band_K) {
        const double error_K = T_K - m_metrics.target_K;
        if (m_isJudged) {
            m_begun.add(time_s, T_K);
            m_done.add(time_s, T_K);
            const double over_K = *m_metrics.step_K > 0.0 ? error_K : -error_K;
            if (std::isfinite(over_K))
                m_metrics.overshoot_K = std::max(*m_metrics.overshoot_K, over_K);
        }
        if (!(std::abs(error_K) <= band_K)) {
            m_metrics.settledFrom_s.reset();
        } else if (!m_metrics.settledFrom_s) {
            m_metrics.settledFrom_s = time_s;
            m_gap_s = m_lately.empty() ? 0.0 : time_s - m_lately.back().first;
        }
        m_above.add(time_s, error_K);
        m_below.add(time_s, -error_K);
        m_lately.emplace_back(time_s, error_K);
        while (m_lately.front().first < time_s - kSteadyWindow_s)
            m_lately.pop_front();
    }

    void beginStep(double time_s, double target_K, double T_K, double band_K) {
        m_metrics.target_K = target_K;
        m_metrics.from_s = time_s;
        m_metrics.step_K.reset();
        m_metrics.overshoot_K.reset();
        if (std::isfinite(T_K) && std::isfinite(target_K))
            m_metrics.step_K = target_K - T_K;
        else
            m_metrics.settledFrom_s.reset(); // at the target before
        m_lately.clear();
        m_gap_s = 0.0;
        m_above.clear();
        m_below.clear();
        m_isJudged = m_metrics.step_K && std::abs(*m_metrics.step_K) >= 2.0 * band_K;
        if (!m_isJudged)
            return;
        const double step_K = *m_metrics.step_K, first_K = target_K - step_K;
        m_begun = LevelPassing(first_K, step_K, 0.1);
        m_done = LevelPassing(first_K, step_K, 0.9);
        m_metrics.overshoot_K = 0.0;
    }

    ObjectMetrics m_metrics;    ///< but for what judged() adds
    double m_gap_s = 0.0;       ///< when it came into the band: since the reading before; 0: there was none
    LastAbove m_above, m_below; ///< the target
    bool m_isJudged = false;    ///< the step is large enough
    LevelPassing m_begun, m_done;
    /// Times and errors since the step and in the last window.
    std::deque<std::pair<double, double>> m_lately;
};

} // namespace

struct RunMetricsCount::ObjectCount {
    explicit ObjectCount(const ObjectSpec& object)
        : centre_E(poseFromCoordinates(object.mounting).translation()),
          isByCamera(object.readBy == ReadBy::Camera) {}

    /// From the end-effector's pose before to that of now.
    void addMotion(const Pose& before, const Pose& now) {
        const double way_m = (now * centre_E - before * centre_E).norm();
        pathLength_m += std::isfinite(way_m) ? way_m : 0.0;
    }

    Eigen::Vector3d centre_E;
    double pathLength_m = 0.0;
    TemperatureCount read, truth;
    ReadingScatter scatter; ///< of what was read
    bool isByCamera = false;
};

RunMetricsCount::RunMetricsCount(const SessionRecord& facts, double band_K)
    : m_until_s(controlledUntil_s(facts)) {
    m_metrics.band_K = band_K;
    m_metrics.period_s = facts.experiment.sampling.period_s;
    const bool isByContact = std::ranges::all_of(
        facts.experiment.objects, [](const ObjectSpec& object) { return object.readBy == ReadBy::Contact; });
    const SimulationSpec& simulated = facts.experiment.simulation;
    if (facts.simulated && isByContact)
        m_metrics.resolution_K = std::max(simulated.sensorResolution_K, simulated.sensorNoise_K);
    m_offsets_K = zeroOffsets_K(facts);
    m_window = facts.experiment.sampling.window;
    m_stale_s = facts.experiment.safety.stalePeriods * m_metrics.period_s;
    for (const ObjectSpec& object : facts.experiment.objects)
        m_objects.emplace_back(object);
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
    const Pose X_RE = poseFromCoordinates(sample.coordinates);
    const bool isFirst = m_metrics.samples == 0;
    if (!isFirst)
        addMotion(sample.time_s, X_RE);
    const bool isLate = !isFirst && sample.time_s - m_metrics.last.time_s > m_stale_s;
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const ObjectSample& object = sample.objects[i];
        m_hasTruth = m_hasTruth || std::isfinite(object.true_K);
        if (isLate)
            m_objects[i].scatter.gap();
        m_objects[i].scatter.add(read_K(object));
        m_objects[i].read.add(sample.time_s, object.target_K, read_K(object), m_metrics.band_K);
        m_objects[i].truth.add(sample.time_s, object.target_K, object.true_K, m_metrics.band_K);
    }
    m_pose = X_RE;
    if (isFirst)
        m_metrics.first = sample;
    constexpr double kEarlyPeriods = 5.0;
    const bool isEarly = sample.time_s - m_metrics.first.time_s <= kEarlyPeriods * m_metrics.period_s;
    for (std::size_t i = 0; i < m_objects.size() && isEarly; ++i) { // one that adapts tells them a step later
        ObjectSample& first = m_metrics.first.objects[i];
        if (!std::isfinite(first.lambda1)) {
            first.lambda1 = sample.objects[i].lambda1;
            first.lambda2 = sample.objects[i].lambda2;
        }
    }
    m_metrics.last = sample;
    m_metrics.duration_s = sample.time_s;
    ++m_metrics.samples;
}

/// From the last sample to one at this time and pose.
void RunMetricsCount::addMotion(double time_s, const Pose& X_RE) {
    const TraceSample& before = m_metrics.last;
    for (ObjectCount& object : m_objects)
        object.addMotion(m_pose, X_RE);
    const double way_m = (X_RE.translation() - m_pose.translation()).norm();
    if (std::isfinite(way_m)) {
        m_metrics.pathLength_m += way_m;
        m_metrics.turned_rad += Eigen::AngleAxisd(m_pose.linear().transpose() * X_RE.linear()).angle();
    }
    const double lasts_s = time_s - before.time_s;
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

void RunMetricsCount::addUncertainties(std::size_t i, ObjectMetrics& out) const {
    const ObjectCount& object = m_objects[i];
    if (object.isByCamera) { // its parts are not recorded: a mean is taken to be no better
        if (out.final_K && std::isfinite(m_metrics.last.objects[i].camera.uncertainty_K))
            out.readingUncertainty_K = m_metrics.last.objects[i].camera.uncertainty_K;
        if (out.steadyError_K)
            out.steadyUncertainty_K = out.readingUncertainty_K;
        if (out.readingUncertainty_K) // what its errors share is not told: the larger of the two
            out.riseUncertainty_s = object.read.riseUncertainty_s(*out.readingUncertainty_K, 0.0);
    } else if (m_offsets_K.size() == m_objects.size()) {
        const auto sensor = contactUncertainty(m_offsets_K, m_window, object.scatter);
        if (!sensor)
            return;
        out.readingUncertainty_K = sensor->ofReading_K();
        if (out.steadyError_K)
            out.steadyUncertainty_K = sensor->ofMean_K(out.steadySamples);
        out.riseUncertainty_s = object.read.riseUncertainty_s(
            std::hypot(sensor->resolution_K, sensor->noise_K), std::hypot(sensor->room_K, sensor->zeroing_K));
    }
    if (out.readingUncertainty_K)
        out.settlingUncertainty_s =
            object.read.settlingUncertainty_s(*out.readingUncertainty_K, m_metrics.band_K);
}

RunMetrics RunMetricsCount::metrics() const {
    RunMetrics out = m_metrics;
    const double last_s = m_metrics.last.time_s;
    if (out.samples > 0 && std::isfinite(m_until_s))
        out.duration_s = m_until_s;
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const ObjectCount& object = m_objects[i];
        out.objects.push_back(object.read.judged(last_s, object.pathLength_m));
        addUncertainties(i, out.objects.back());
        if (m_hasTruth)
            out.trueObjects.push_back(object.truth.judged(last_s, object.pathLength_m));
    }
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
