#include "engine/thermal/rate_estimator.h"

#include <Eigen/QR>

#include <cmath>
#include <stdexcept>

namespace bask {

RateEstimator::RateEstimator(int window, int order) : m_window(window), m_order(order) {
    if (order < 1 || window <= order)
        throw std::invalid_argument(
            "RateEstimator: the window must be longer than the order, the order at least 1");
}

bool RateEstimator::add(double time_s, double temperature_K) {
    if (!std::isfinite(time_s) || !std::isfinite(temperature_K))
        return false;
    if (!m_samples.empty() && time_s <= m_samples.back().time_s)
        return false;
    m_samples.push_back({time_s, temperature_K});
    if (count() > m_window)
        m_samples.pop_front();
    return true;
}

std::optional<RateEstimate> RateEstimator::estimate() const {
    if (!full())
        return std::nullopt;
    const double newest_s = m_samples.back().time_s;
    const double centre_s = 0.5 * (m_samples.front().time_s + newest_s);
    const double scale_s = 0.5 * (newest_s - m_samples.front().time_s);
    const double offset_K = m_samples.back().temperature_K;
    Eigen::MatrixXd A(m_window, m_order + 1);
    Eigen::VectorXd b(m_window);
    for (int i = 0; i < m_window; ++i) {
        const Sample& sample = m_samples[static_cast<std::size_t>(i)];
        const double t = (sample.time_s - centre_s) / scale_s;
        A(i, 0) = 1.0;
        for (int k = 1; k <= m_order; ++k)
            A(i, k) = A(i, k - 1) * t;
        b[i] = sample.temperature_K - offset_K;
    }
    const Eigen::VectorXd c = A.householderQr().solve(b);
    RateEstimate out;
    out.temperature_K = offset_K + c.sum(); // the newest sample is at t = 1
    for (int k = 1; k <= m_order; ++k)
        out.rate_K_s += k * c[k] / scale_s;
    return out;
}

} // namespace bask
