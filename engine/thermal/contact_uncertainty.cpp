#include "engine/thermal/contact_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kSameReading_K = 1e-6; // what sums leave of equal readings

} // namespace

void ReadingScatter::add(double T_K) {
    if (!std::isfinite(T_K))
        return gap();
    if (!m_newest_K.empty())
        if (const double change_K = std::abs(T_K - m_newest_K.back()); change_K > kSameReading_K)
            m_step_K = m_step_K > 0.0 ? std::min(m_step_K, change_K) : change_K;
    m_newest_K.push_back(T_K);
    if (m_newest_K.size() > kNewest + 2)
        m_newest_K.pop_front();
}

std::optional<double> ReadingScatter::deviation_K() const {
    constexpr double kOfSecondDifference = 6.0; // its variance over that of a reading: 1 + 4 + 1
    if (m_newest_K.size() < kMin + 2)
        return std::nullopt;
    double squares_K2 = 0.0;
    for (std::size_t k = 2; k < m_newest_K.size(); ++k) {
        const double second_K = m_newest_K[k] - 2.0 * m_newest_K[k - 1] + m_newest_K[k - 2];
        squares_K2 += second_K * second_K;
    }
    const auto count = static_cast<double>(m_newest_K.size() - 2);
    return std::sqrt(squares_K2 / count / kOfSecondDifference);
}

double ContactUncertainty::ofMean_K(std::size_t readings) const {
    const double noise = noise_K / std::sqrt(static_cast<double>(readings));
    return std::hypot(std::hypot(room_K, zeroing_K), std::hypot(resolution_K, noise));
}

std::optional<ContactUncertainty> contactUncertainty(std::span<const double> offsets_K, int window,
                                                     const ReadingScatter& scatter) {
    if (offsets_K.empty() || window < 1)
        throw std::invalid_argument("contactUncertainty: no offsets or no window");
    const std::optional<double> noise_K = scatter.deviation_K();
    if (!noise_K)
        return std::nullopt;
    const auto sensors = static_cast<double>(offsets_K.size());
    const double squares_K2 =
        std::inner_product(offsets_K.begin(), offsets_K.end(), offsets_K.begin(), 0.0); // their mean is 0
    const double spread_K = offsets_K.size() > 1 ? std::sqrt(squares_K2 / (sensors - 1.0)) : 0.0;
    ContactUncertainty out;
    out.room_K = std::max(kClassB_K, spread_K) / std::sqrt(sensors);
    out.resolution_K = scatter.step_K() / std::sqrt(12.0);
    out.zeroing_K = std::hypot(out.resolution_K, *noise_K / std::sqrt(static_cast<double>(window)));
    out.noise_K = *noise_K;
    return out;
}

} // namespace bask
