#include "engine/control/steady_states.h"

#include <Eigen/LU>

namespace bask {
namespace {

const HeatRates& ratesOf(const std::vector<HeatRates>& rates, Eigen::Index i) {
    return rates[static_cast<std::size_t>(i)];
}

} // namespace

Eigen::VectorXd neighbourGains_K4(const std::vector<HeatRates>& rates, const Neighbours& neighbours,
                                  const Eigen::VectorXd& T_K) {
    Eigen::VectorXd excess_K4 = T_K.array().square().square();
    for (Eigen::Index i = 0; i < T_K.size(); ++i)
        excess_K4[i] -= ratesOf(rates, i).rest_K4();
    return neighbours.gains_K4(excess_K4);
}

Eigen::VectorXd neighbourGainRates_K4_s(const Neighbours& neighbours, const Eigen::VectorXd& T_K,
                                        const Eigen::VectorXd& rates_K_s) {
    return neighbours.gains_K4(4.0 * T_K.array().cube() * rates_K_s.array());
}

std::vector<HeatRates> ratesAmong(std::vector<HeatRates> rates, const Neighbours& neighbours,
                                  const Eigen::VectorXd& T_K) {
    if (!neighbours.exchange())
        return rates;
    const Eigen::VectorXd gains_K4 = neighbourGains_K4(rates, neighbours, T_K);
    for (std::size_t i = 0; i < rates.size(); ++i)
        rates[i] = rates[i].inWarmerRoom(gains_K4[static_cast<Eigen::Index>(i)]);
    return rates;
}

Eigen::VectorXd steadyTemperatures_K(const std::vector<HeatRates>& rates, const Neighbours& neighbours,
                                     const Eigen::VectorXd& F) {
    const auto among = [&](const std::vector<HeatRates>& present) {
        Eigen::VectorXd T_K(F.size());
        for (Eigen::Index i = 0; i < F.size(); ++i)
            T_K[i] = ratesOf(present, i).steadyTemperature_K(F[i]);
        return T_K;
    };
    Eigen::VectorXd T_K = among(rates);
    if (!neighbours.exchange())
        return T_K;
    // Each object gets less from the others than they radiate, so this converges.
    constexpr int kRounds = 200;
    constexpr double kExact_K = 1e-9;
    for (int round = 0; round < kRounds; ++round) {
        const Eigen::VectorXd before_K = T_K;
        T_K = among(ratesAmong(rates, neighbours, T_K));
        if ((T_K - before_K).cwiseAbs().maxCoeff() < kExact_K)
            break;
    }
    return T_K;
}

Eigen::MatrixXd steadySlopes_K(const std::vector<HeatRates>& rates, const Neighbours& neighbours,
                               const Eigen::VectorXd& T_K) {
    const auto N = T_K.size();
    Eigen::MatrixXd losses = Eigen::MatrixXd::Zero(N, N), heating = losses;
    for (Eigen::Index j = 0; j < N; ++j) {
        const Eigen::VectorXd gains_K4_s =
            neighbourGainRates_K4_s(neighbours, T_K, Eigen::VectorXd::Unit(N, j));
        for (Eigen::Index i = 0; i < N; ++i)
            losses(i, j) = -ratesOf(rates, i).lambda2 * gains_K4_s[i];
        losses(j, j) += ratesOf(rates, j).lossSlope_1_s(T_K[j]);
        heating(j, j) = ratesOf(rates, j).lambda1;
    }
    return losses.partialPivLu().solve(heating);
}

} // namespace bask
