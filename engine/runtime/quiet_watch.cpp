#include "engine/runtime/quiet_watch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bask {
namespace {

constexpr std::size_t kWindow = 100; // second differences that the noise is from
constexpr std::size_t kKnown = 30;   // of them until the noise is known
constexpr int kResting = 20;         // more equal values in a row say nothing about the noise
constexpr int kMinSame = 10;         // minimum number of equal readings
// The largest fifth of the second differences is left out: a few wrong readings are no noise.
constexpr double kKept = 0.8;
constexpr double kKeptOfNoise = 1.368; // mean of those kept of normal readings, over their deviation
constexpr double kSure = 1.5;          // the true variance may be smaller by this
// A ramp, or a rest between two steps, makes the readings of a sensor without noise look as if kSure had left
// this variance, in squared steps.
constexpr double kStepVariance = 0.4;
constexpr double kMinNoise = 0.3; // in steps

} // namespace

void QuietWatch::add(double time_s, double value_K) {
    const bool isSame = m_count > 0 && value_K == m_last_K[0];
    if (!isSame) {
        if (quietFor_s() == 0.0) // one that was told is not usual
            m_longest = std::max(m_longest, m_same);
        m_since_s = time_s;
        m_same = 0;
        m_seconds_K.insert(m_seconds_K.end(), m_newSeconds_K.begin(), m_newSeconds_K.end());
        m_newSeconds_K.clear();
        while (m_seconds_K.size() > kWindow)
            m_seconds_K.pop_front();
        if (m_count > 0) {
            const double change_K = std::abs(value_K - m_last_K[0]);
            m_step_K = m_step_K > 0.0 ? std::min(m_step_K, change_K) : change_K;
        }
    }
    m_time_s = time_s;
    if (++m_same > kResting)
        return;
    if (m_count > 1) // for a ramp it is zero
        m_newSeconds_K.push_back(std::abs(value_K - 2.0 * m_last_K[0] + m_last_K[1]));
    m_last_K[1] = m_last_K[0];
    m_last_K[0] = value_K;
    ++m_count;
}

// At rest in the middle of a step a reading repeats with the probability that the noise is less than half a
// step; anywhere else, and on a ramp, less often.
std::optional<int> QuietWatch::enough() const {
    if (m_seconds_K.size() < kKnown || m_step_K <= 0.0)
        return std::nullopt;
    std::vector<double> kept(m_seconds_K.begin(), m_seconds_K.end());
    std::ranges::sort(kept);
    kept.resize(static_cast<std::size_t>(kKept * static_cast<double>(kept.size())));
    const double mean_K = std::accumulate(kept.begin(), kept.end(), 0.0) / static_cast<double>(kept.size());
    const double seen = mean_K / kKeptOfNoise / m_step_K;
    const double noise = std::sqrt(std::max(0.0, seen * seen / kSure - kStepVariance));
    if (noise < kMinNoise)
        return std::nullopt;
    const double repeats = std::erf(0.5 / (std::sqrt(2.0) * noise));
    const int byNoise = static_cast<int>(std::ceil(std::log(kFalse) / std::log(repeats)));
    return std::max(byNoise, kTimesUsual * m_longest);
}

double QuietWatch::quietFor_s() const {
    if (m_same <= kMinSame)
        return 0.0;
    const std::optional<int> same = enough();
    return same && m_same > *same ? m_time_s - m_since_s : 0.0;
}

void QuietWatch::confirm() {
    *this = QuietWatch();
}

} // namespace bask
