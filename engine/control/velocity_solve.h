#pragma once
// The robot's velocity for wanted rates of change: damped least squares with speed, workspace and clearance
// limits inside.

#include "engine/control/rig_geometry.h"

namespace bask {

/// What a velocity solve is asked.
struct VelocityProblem {
    Eigen::Matrix<double, Eigen::Dynamic, 6>
        rows;                                ///< N x 6, change of the wanted quantity by pose coordinate
    Eigen::VectorXd wanted;                  ///< N, wanted rates
    Vector6d coordinates = Vector6d::Zero(); ///< present pose
    double dt_s = 1.0;                       ///< how long the velocity will hold
    double rotationLength_m = 0.1;           ///< a radian counts as this length
    double damping = 1e-3;                   ///< relative to the largest singular value
};

/// Rates of the six pose coordinates (fixed ones zero), m/s and rad/s.
struct VelocitySolution {
    Vector6d rates = Vector6d::Zero();
    double smallestSingularValue = 0.0; ///< of the rows in the free coordinates, rotation scaled
    bool limited = false;               ///< a limit is active
};

/// min |rows rates - wanted|^2 + mu^2 |rates|^2 under |v| <= maxSpeed, |w| <= maxRotation, the workspace's
/// box and the clearance of every object at the end of dt. The two norms enter through their Lagrange
/// multipliers, the rest as linear rows.
VelocitySolution solveVelocity(const RigGeometry& geometry, const VelocityProblem& problem);

/// Rates that go straight from q to `goal` as fast as the robot may, not past it within dt_s, keeping the
/// clearance.
VelocitySolution velocityTowards(const RigGeometry& geometry, const Vector6d& q, const Vector6d& goal,
                                 double dt_s);

/// Where a retreat from q ends: along the source's normal to the end of the workspace, the angles as they
/// are.
Vector6d poseOffSource(const RigGeometry& geometry, const Vector6d& q);

/// Time to go from a to b at the robot's limits, s.
double travelTime_s(const RobotLimits& limits, const Vector6d& a, const Vector6d& b);

/// Rows G y >= h (h <= 0) that keep a step y in the free coordinates, q + y, inside workspace and clearance
/// (linearised).
void stepLimits(const RigGeometry& geometry, const Vector6d& q, Eigen::MatrixXd& G, Eigen::VectorXd& h);

} // namespace bask
