#pragma once
// The robot's velocity for wanted rates of change: damped least squares with the limits of speed,
// acceleration, workspace and clearance inside.

#include "engine/control/rig_geometry.h"

namespace bask {

/// What a velocity solve is asked.
struct VelocityProblem {
    Eigen::Matrix<double, Eigen::Dynamic, 6>
        rows;                                ///< N x 6, change of the wanted quantity by pose coordinate
    Eigen::VectorXd wanted;                  ///< N, wanted rates
    Vector6d coordinates = Vector6d::Zero(); ///< present pose
    Vector6d lastRates = Vector6d::Zero();   ///< that the robot has now, from which it accelerates
    double dt_s = 1.0;                       ///< how long the velocity will hold
    double rotationLength_m = 0.1;           ///< a radian counts as this length
    double damping = 1e-3;                   ///< relative to the largest singular value
};

/// Rates of the six pose coordinates (fixed ones zero), m/s and rad/s.
struct VelocitySolution {
    Vector6d rates = Vector6d::Zero();
    double smallestSingularValue = 0.0; ///< of the rows in the free coordinates, rotation scaled
    ActiveLimits limits;                ///< that hold it back
};

/// Extreme singular values of rows (N x 6, N at most 6) in the free coordinates, a radian counting as
/// `rotationLength_m`.
struct SingularRange {
    double smallest = 0.0;
    double largest = 0.0;
};
SingularRange singularRange(const RigGeometry& geometry, const Eigen::Matrix<double, Eigen::Dynamic, 6>& rows,
                            double rotationLength_m);

/// min |rows rates - wanted|^2 + mu^2 |rates|^2 under |v| <= maxSpeed, |w| <= maxRotation, |v - v_last| <=
/// maxAcceleration dt, |w - w_last| <= maxAngularAcceleration dt (w of both by the axes of the present pose),
/// the workspace's box and the clearance of every object.
///
/// Without limits of acceleration the end of dt must lie within workspace and clearance. With them the robot
/// must afterwards still be able to brake before these, on a straight line: a velocity p towards a bound at
/// distance d keeps
///
///     dt max(p, (p + p_last) / 2) + p T <= d,     T = max(maxSpeed / a, maxRotation / alpha),
///
/// which braking at full strength keeps for ever (a speed within maxSpeed needs at most T to stop, and half
/// of p T of way), whether the robot takes up a new velocity at once or over the period. Braking at full
/// strength is always among the answers, so there always is one.
VelocitySolution solveVelocity(const RigGeometry& geometry, const VelocityProblem& problem);

/// Rates that go straight from q to `goal` as fast as the robot may, brake to arrive, and do not go past it,
/// keeping every limit. `lastRates` are those that the robot has now.
VelocitySolution velocityTowards(const RigGeometry& geometry, const Vector6d& q, const Vector6d& goal,
                                 double dt_s, const Vector6d& lastRates = Vector6d::Zero());

/// Where a retreat from q ends: along the source's normal to the end of the workspace, the angles as they
/// are.
Vector6d poseOffSource(const RigGeometry& geometry, const Vector6d& q);

/// Time to go from a to b at the robot's limits of speed, s.
double travelTime_s(const RobotLimits& limits, const Vector6d& a, const Vector6d& b);

/// Rows G y >= h (h <= 0) that keep a step y in the free coordinates, q + y, inside workspace and clearance
/// (linearised).
void stepLimits(const RigGeometry& geometry, const Vector6d& q, Eigen::MatrixXd& G, Eigen::VectorXd& h);

} // namespace bask
