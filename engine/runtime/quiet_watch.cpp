#include "engine/runtime/quiet_watch.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kShare = 0.01; ///< weight of one reading in the variance
constexpr int kKnown = 100;     ///< readings until the noise is known
constexpr int kResting = 5;     ///< more equal values in a row say nothing about the noise
constexpr int kMinSame = 20;    ///< minimum number of equal readings, whatever their period
constexpr double kNoisy = 0.75; ///< deviation over the step: 20 in a row are then less likely than 1e-5

} // namespace

void QuietWatch::add(double time_s, double value_K) {
    const bool isSame = m_count > 0 && value_K == m_last_K[0];
    m_same = isSame ? m_same + 1 : 1;
    if (!isSame)
        m_since_s = time_s;
    m_time_s = time_s;
    if (m_count > 0 && !isSame) {
        const double change_K = std::abs(value_K - m_last_K[0]);
        m_step_K = m_step_K > 0.0 ? std::min(m_step_K, change_K) : change_K;
    }
    if (m_same > kResting)
        return;
    if (m_count > 1) {
        // The second difference of independent readings has six times their variance; for a ramp it is zero.
        const double second_K = value_K - 2.0 * m_last_K[0] + m_last_K[1];
        const double share = std::max(kShare, 1.0 / (m_count - 1));
        m_variance_K2 += share * (second_K * second_K / 6.0 - m_variance_K2);
    }
    m_last_K[1] = m_last_K[0];
    m_last_K[0] = value_K;
    ++m_count;
}

double QuietWatch::quietFor_s() const {
    const bool isNoisy = m_count >= kKnown && m_step_K > 0.0 && std::sqrt(m_variance_K2) >= kNoisy * m_step_K;
    const double same_s = m_time_s - m_since_s;
    return isNoisy && m_same >= kMinSame && same_s >= kQuiet_s ? same_s : 0.0;
}

void QuietWatch::confirm() {
    *this = QuietWatch();
}

} // namespace bask
