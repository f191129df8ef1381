#include "engine/thermal/rate_estimator.h"

#include <Eigen/QR>

#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

/// Powers 0 .. order of the times, centred and scaled to [-1, 1]; the last row is the newest, at 1.
Eigen::MatrixXd powers(const Eigen::VectorXd& t, int order) {
    Eigen::MatrixXd A(t.size(), order + 1);
    A.col(0).setOnes();
    for (int k = 1; k <= order; ++k)
        A.col(k) = A.col(k - 1).cwiseProduct(t);
    return A;
}

/// Derivative of the powers at t = 1.
Eigen::VectorXd slopeAtEnd(int order) {
    return Eigen::VectorXd::LinSpaced(order + 1, 0.0, order);
}

/// Index of the sample with the largest externally studentised residual, if that is over the bound.
std::optional<int> outlier(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double floor_K) {
    const auto freedom = static_cast<double>(A.rows() - A.cols() - 1); // of the fit without one
    if (freedom < 2.0)
        return std::nullopt;
    const Eigen::MatrixXd Q =
        A.householderQr().householderQ() * Eigen::MatrixXd::Identity(A.rows(), A.cols());
    const Eigen::VectorXd residual = b - Q * (Q.transpose() * b);
    const double total = residual.squaredNorm();
    double largest = RateEstimator::kOutlier;
    std::optional<int> worst;
    for (int i = 0; i < residual.size(); ++i) {
        const double left = 1.0 - Q.row(i).squaredNorm(); // 1 - leverage
        if (left < 1e-9)
            continue; // no other sample determines its value
        const double others = std::max(0.0, total - residual[i] * residual[i] / left) / freedom;
        const double deviation = std::max(std::sqrt(others), floor_K);
        const double studentised = std::abs(residual[i]) / (deviation * std::sqrt(left));
        if (studentised > largest) {
            largest = studentised;
            worst = i;
        }
    }
    return worst;
}

} // namespace

NoiseGain noiseGain(const std::vector<double>& times_s, int order) {
    const auto n = static_cast<Eigen::Index>(times_s.size());
    if (order < 1 || n <= order)
        throw std::invalid_argument("noiseGain: more times than the order, which is at least 1");
    const double scale_s = 0.5 * (times_s.back() - times_s.front());
    const Eigen::VectorXd t =
        (Eigen::Map<const Eigen::VectorXd>(times_s.data(), n).array() - times_s.front()) / scale_s - 1.0;
    const Eigen::MatrixXd A = powers(t, order);
    const Eigen::MatrixXd R = A.householderQr().matrixQR().topRows(order + 1);
    const auto gain = [&](const Eigen::VectorXd& a) {
        return R.triangularView<Eigen::Upper>().transpose().solve(a).norm();
    };
    return {gain(Eigen::VectorXd::Ones(order + 1)), gain(slopeAtEnd(order)) / scale_s};
}

RateEstimator::RateEstimator(int window, int order, double noiseFloor_K)
    : m_window(window), m_order(order), m_noiseFloor_K(noiseFloor_K) {
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
    const double first_s = m_samples.front().time_s;
    const double scale_s = 0.5 * (m_samples.back().time_s - first_s);
    const double offset_K = m_samples.back().temperature_K;
    Eigen::VectorXd t(m_window);
    Eigen::VectorXd b(m_window);
    for (int i = 0; i < m_window; ++i) {
        const Sample& sample = m_samples[static_cast<std::size_t>(i)];
        t[i] = (sample.time_s - first_s) / scale_s - 1.0;
        b[i] = sample.temperature_K - offset_K;
    }
    Eigen::MatrixXd A = powers(t, m_order);
    RateEstimate out;
    out.leftOut = outlier(A, b, m_noiseFloor_K);
    const Sample& newest = m_samples[static_cast<std::size_t>(m_window) - 1];
    const Sample& before = m_samples[static_cast<std::size_t>(m_window) - 2];
    if (out.leftOut == m_window - 1 &&
        std::abs(newest.temperature_K - before.temperature_K) <= kOnset_K_s * (newest.time_s - before.time_s))
        out.leftOut.reset(); // it may be a real change; the next sample decides
    if (out.leftOut) {
        A.row(*out.leftOut).setZero();
        b[*out.leftOut] = 0.0;
    }
    const Eigen::VectorXd c = A.householderQr().solve(b);
    out.temperature_K = offset_K + c.sum(); // the newest sample is at t = 1
    out.rate_K_s = slopeAtEnd(m_order).dot(c) / scale_s;
    return out;
}

} // namespace bask
