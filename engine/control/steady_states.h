#pragma once
// Temperatures of objects that exchange radiation with one another: every object's rates depend on the
// others' temperatures.

#include "engine/radiation/neighbours.h"
#include "engine/thermal/heat_balance.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Returns by how much the neighbours at T_K (N) raise the room's fourth power for each object, K4 (N).
Eigen::VectorXd neighbourGains_K4(const std::vector<HeatRates>& rates, const Neighbours& neighbours,
                                  const Eigen::VectorXd& T_K);
/// Returns its derivative by time for temperatures that change at these rates, K4/s (N).
Eigen::VectorXd neighbourGainRates_K4_s(const Neighbours& neighbours, const Eigen::VectorXd& T_K,
                                        const Eigen::VectorXd& rates_K_s);
/// Returns each object's rates beside neighbours at T_K (N).
std::vector<HeatRates> ratesAmong(std::vector<HeatRates> rates, const Neighbours& neighbours,
                                  const Eigen::VectorXd& T_K);

/// Returns the temperatures at which all rates are zero at the view factors F (N), K; those of neighbours to
/// 1e-9 K.
Eigen::VectorXd steadyTemperatures_K(const std::vector<HeatRates>& rates, const Neighbours& neighbours,
                                     const Eigen::VectorXd& F);
/// Returns the derivatives of the steady temperatures T_K (N) by the view factors, K (N x N).
Eigen::MatrixXd steadySlopes_K(const std::vector<HeatRates>& rates, const Neighbours& neighbours,
                               const Eigen::VectorXd& T_K);

} // namespace bask
