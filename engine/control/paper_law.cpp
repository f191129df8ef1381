#include "engine/control/paper_law.h"

#include "engine/control/steady_states.h"

#include "engine/control/velocity_solve.h"

namespace bask {

Eigen::VectorXd neighbourGainRates_K4_s(const RigGeometry& geometry, const Observation& observation) {
    const auto N = static_cast<Eigen::Index>(observation.objects.size());
    Eigen::VectorXd T_K(N), rates_K_s(N);
    for (Eigen::Index i = 0; i < N; ++i) {
        const ObjectObservation& object = observation.objects[static_cast<std::size_t>(i)];
        T_K[i] = object.temperature_K;
        rates_K_s[i] = object.rate_K_s;
    }
    return neighbourGainRates_K4_s(geometry.neighbours(), T_K, rates_K_s);
}

ControlOutput followWanted(const RigGeometry& geometry, const ControllerSettings& settings,
                           const Observation& observation, double dt_s,
                           const Eigen::Matrix<double, Eigen::Dynamic, 6>& rows,
                           const Eigen::VectorXd& wanted) {
    VelocityProblem problem;
    problem.rows = rows;
    problem.wanted = wanted;
    problem.coordinates = observation.coordinates;
    problem.lastRates = observation.lastRates;
    problem.dt_s = dt_s;
    problem.rotationLength_m = settings.rotationLength_m;
    problem.damping = settings.damping;
    const VelocitySolution solution = solveVelocity(geometry, problem);
    ControlOutput out;
    out.rates = solution.rates;
    out.smallestSingularValue = solution.smallestSingularValue;
    out.limits = solution.limits;
    return out;
}

void leaveDark(const RigGeometry& geometry, const Observation& observation, const ViewFactors& seen,
               const std::vector<double>& targets_K, double dt_s, ControlOutput& out) {
    constexpr double kDark = 1e-9;  // view factor, and its derivatives
    constexpr double kCold_K = 0.5; // that noise alone leads nowhere
    const bool isDark = seen.F.maxCoeff() <= kDark && seen.dF.cwiseAbs().maxCoeff() <= kDark;
    bool isCold = false;
    for (std::size_t i = 0; i < targets_K.size(); ++i)
        isCold = isCold || observation.objects[i].temperature_K < targets_K[i] - kCold_K;
    if (!isDark || !isCold)
        return;
    const Vector6d& q = observation.coordinates;
    const VelocitySolution way =
        velocityTowards(geometry, q, poseFacingSource(geometry, q), dt_s, observation.lastRates);
    out.rates = way.rates;
    out.limits = way.limits;
}

} // namespace bask
