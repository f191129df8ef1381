#include "widgets/common/reading_trend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kSteadyRate_K_s = 1.0 / 60.0; ///< slower than this is neither heating nor cooling
constexpr double kMinScatter_K = 0.029;        ///< of readings rounded to 0.1 K
constexpr double kStandardErrors = 2.5;
constexpr double kMinSpan_s = 4.0;
constexpr double kStep_K = 0.15; ///< times the span: the slope of readings that step once by 0.1 K, at most
constexpr std::size_t kMinReadings = 3;

} // namespace

void ReadingTrend::passTo(double time_s) {
    if (time_s < (m_readings.empty() ? m_begin_s.value_or(time_s) : m_readings.back().time_s))
        clear();
    while (!m_readings.empty() && m_readings.front().time_s <= time_s - kOver_s)
        m_readings.pop_front();
}

void ReadingTrend::add(double time_s, double reading_K, double rate_K_s) {
    if (m_readings.empty() || time_s > m_readings.back().time_s)
        m_readings.push_back({time_s, reading_K, rate_K_s});
    m_begin_s = m_begin_s.value_or(time_s);
}

/// Not of the first few: from one to the next the noise of an estimate is several K/min.
double ReadingTrend::meanRate_K_s() const {
    if (m_readings.empty() || m_readings.back().time_s - *m_begin_s < kMinSpan_s)
        return std::numeric_limits<double>::quiet_NaN();
    double sum_K_s = 0.0;
    int count = 0;
    for (const Reading& each : m_readings)
        if (std::isfinite(each.rate_K_s)) { // not before the estimator's first
            sum_K_s += each.rate_K_s;
            ++count;
        }
    return sum_K_s / count;
}

ReadingTrend::Line ReadingTrend::fitted() const {
    const auto n = static_cast<double>(m_readings.size());
    double time_s = 0.0, mean_K = 0.0;
    for (const Reading& each : m_readings) {
        time_s += each.time_s / n;
        mean_K += each.reading_K / n;
    }
    double tt = 0.0, ty = 0.0, yy = 0.0;
    for (const Reading& each : m_readings) {
        const double t = each.time_s - time_s, y = each.reading_K - mean_K;
        tt += t * t;
        ty += t * y;
        yy += y * y;
    }
    const double slope_K_s = ty / tt;
    const double scatter_K = std::sqrt(std::max(0.0, yy - ty * slope_K_s) / std::max(n - 2.0, 1.0));
    return {slope_K_s, scatter_K, std::sqrt(tt)};
}

double ReadingTrend::slope_K_s() const {
    return m_readings.size() < kMinReadings ? std::numeric_limits<double>::quiet_NaN() : fitted().slope_K_s;
}

double ReadingTrend::told_K_s() const {
    if (m_readings.size() < 2)
        return 0.0;
    const double span_s = m_readings.back().time_s - m_readings.front().time_s;
    if (span_s < kMinSpan_s)
        return 0.0;
    const Line line = fitted();
    const double noise_K_s =
        std::max(kStandardErrors * std::max(line.scatter_K, kMinScatter_K) / line.spread_s, kStep_K / span_s);
    const bool isBeyond = std::abs(line.slope_K_s) > std::max(noise_K_s, kSteadyRate_K_s);
    const bool isContradicted = line.slope_K_s * meanRate_K_s() < 0.0; // by the number beside the word
    return isBeyond && !isContradicted ? line.slope_K_s : 0.0;
}

} // namespace bask
