#include "engine/control/paper_law.h"

#include "engine/control/velocity_solve.h"

namespace bask {

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

} // namespace bask
