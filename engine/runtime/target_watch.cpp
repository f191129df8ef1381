#include "engine/runtime/target_watch.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace bask {

void TargetWatch::add(double time_s, double error_K) {
    if (m_count > 0 && time_s >= m_from_s + kBin_s) {
        take(m_sum_K / m_count);
        m_count = 0;
        m_sum_K = 0.0;
    }
    if (m_count == 0)
        m_from_s = time_s;
    m_sum_K += error_K;
    ++m_count;
}

void TargetWatch::take(double mean_K) {
    std::rotate(m_means_K.begin(), m_means_K.begin() + 1, m_means_K.end());
    m_means_K.back() = mean_K;
    m_known = std::min(m_known + 1, kBins);
    const auto isFarther = [](double before_K, double after_K) {
        return before_K * after_K >= 0.0 && std::abs(after_K) >= std::abs(before_K) + kMinStep_K;
    };
    const bool isLeaving = m_known == kBins && std::abs(mean_K) >= kFar_K &&
                           std::ranges::adjacent_find(m_means_K, std::not_fn(isFarther)) == m_means_K.end();
    if (!isLeaving)
        m_leaving.reset();
    else if (m_leaving)
        m_leaving = Leaving{mean_K, m_leaving->for_s + kBin_s};
    else
        m_leaving = Leaving{mean_K, kBin_s * (kBins - 1)};
}

} // namespace bask
