#include "engine/runtime/loss_fit.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr int kFactors = 16; // above 1, and as many below
constexpr double kBent =
    0.05; // standard deviation: losses are not quite in proportion to the distance from the room
constexpr double kFree = 1e-9; // keeps the matrix regular where the readings say nothing
constexpr double kParameters = 3.0;

} // namespace

/// Of the readings with the energies of one lag: what a fit needs of them.
struct LossFit::Sums {
    Eigen::Vector3d change, energy; ///< products with the design
    double changes_K2, both_K2, energies_K2;
};

LossFit::LossFit(LossRange losses, const Room& room, double temperature_K, Eigen::MatrixX3d design,
                 Eigen::VectorXd change_K)
    : m_losses(losses), m_room(room), m_over_K(temperature_K - room.temperature_K),
      m_design(std::move(design)), m_change_K(std::move(change_K)),
      m_normal(m_design.transpose() * m_design) {
    m_normal.diagonal() += Eigen::Vector3d(1.0, kFree, kFree); // c is as sure as one reading
}

LossFit::Fit LossFit::fit(const Sums& sums, double k, double sigma_K) const {
    const double middle_1_s = 0.5 * (m_losses.max_1_s + m_losses.min_1_s);
    const double half_1_s = 0.5 * (m_losses.max_1_s - m_losses.min_1_s);
    const double weightOfSlope = std::pow(kSigmas * sigma_K / half_1_s, 2);
    const Eigen::Vector3d tie(0.0, 1.0, -m_over_K), right = sums.change - k * sums.energy;
    const double rest_K_s = k * m_room.rest_K_s;
    Eigen::Vector3d x(0.0, 0.0, middle_1_s);
    Eigen::Matrix3d inverse;
    double weightOfTie = 0.0;
    for (int i = 0; i < 2; ++i) { // the tie is as loose as the losses are large
        const double tied_K_s = (kBent * std::abs(m_over_K) + m_room.deviation_K) *
                                std::clamp(x[2], m_losses.min_1_s, m_losses.max_1_s);
        weightOfTie = std::pow(sigma_K / tied_K_s, 2);
        Eigen::Matrix3d normal = m_normal + weightOfTie * tie * tie.transpose();
        normal(2, 2) += weightOfSlope;
        inverse = normal.inverse();
        x = inverse *
            (right + weightOfTie * rest_K_s * tie + Eigen::Vector3d(0.0, 0.0, weightOfSlope * middle_1_s));
    }
    Fit out{{k, x[1], sigma_K * std::sqrt(inverse(1, 1))}};
    const double left_K2 = sums.changes_K2 - 2.0 * k * sums.both_K2 + k * k * sums.energies_K2;
    out.data_K2 = std::max(0.0, left_K2 - 2.0 * x.dot(right) + x.dot(m_normal * x));
    out.miss = (out.data_K2 + weightOfTie * std::pow(tie.dot(x) - rest_K_s, 2) +
                weightOfSlope * std::pow(x[2] - middle_1_s, 2)) /
               (sigma_K * sigma_K);
    return out;
}

std::vector<std::vector<LossFit::Explanation>>
LossFit::explain(const std::vector<Eigen::VectorXd>& energies_K, double sigma_K) const {
    std::vector<std::vector<Fit>> fits;
    const auto fitAll = [&] {
        fits.assign(energies_K.size(), {});
        for (std::size_t lag = 0; lag < energies_K.size(); ++lag) {
            const Eigen::VectorXd& energy_K = energies_K[lag];
            const Sums sums{m_design.transpose() * m_change_K, m_design.transpose() * energy_K,
                            m_change_K.squaredNorm(), m_change_K.dot(energy_K), energy_K.squaredNorm()};
            fits[lag].reserve(2 * kFactors + 1);
            for (int i = -kFactors; i <= kFactors; ++i)
                fits[lag].push_back(
                    fit(sums, std::pow(kBorneFactor, static_cast<double>(i) / kFactors), sigma_K));
        }
    };
    const auto least = [&](double Fit::*what) {
        double out = std::numeric_limits<double>::infinity();
        for (const std::vector<Fit>& ofLag : fits)
            for (const Fit& each : ofLag)
                out = std::min(out, each.*what);
        return out;
    };
    fitAll();
    const double scatter_K =
        std::sqrt(least(&Fit::data_K2) / (static_cast<double>(m_change_K.size()) - kParameters));
    if (scatter_K > sigma_K) {
        sigma_K = scatter_K;
        fitAll();
    }
    const double leastMiss = least(&Fit::miss);
    std::vector<std::vector<Explanation>> out(fits.size());
    for (std::size_t lag = 0; lag < fits.size(); ++lag)
        for (const Fit& each : fits[lag]) {
            const double left = kSigmas * kSigmas - (each.miss - leastMiss);
            if (left < 0.0)
                continue;
            out[lag].push_back(each.explanation);
            out[lag].back().unsure_K_s *= std::sqrt(left);
        }
    return out;
}

} // namespace bask
