#pragma once
// The robot's velocity for demanded rates of change: damped least squares subject to the limits of speed,
// acceleration, workspace and clearance.

#include "engine/control/rig_geometry.h"

namespace bask {

/// The input of a velocity solve.
struct VelocityProblem {
    Eigen::Matrix<double, Eigen::Dynamic, 6>
        rows;                                ///< N x 6, change of the wanted quantity by pose coordinate
    Eigen::VectorXd wanted;                  ///< N, wanted rates
    Vector6d coordinates = Vector6d::Zero(); ///< present pose
    Vector6d lastRates = Vector6d::Zero();   ///< present rates of the robot, from which it accelerates
    double dt_s = 1.0;                       ///< how long the velocity will be kept
    double rotationLength_m = 0.1;           ///< a radian counts as this length
    double damping = 1e-3;                   ///< relative to the largest singular value
};

/// Rates of the six pose coordinates (fixed ones zero), m/s and rad/s.
struct VelocitySolution {
    Vector6d rates = Vector6d::Zero();
    double smallestSingularValue = 0.0; ///< of the rows in the free coordinates, rotation scaled
    ActiveLimits limits;                ///< limits that restrict it
};

/// Smallest and largest singular value of rows (N x 6, N at most 6) in the free coordinates, a radian
/// counting as `rotationLength_m`.
struct SingularRange {
    double smallest = 0.0;
    double largest = 0.0;
};
SingularRange singularRange(const RigGeometry& geometry, const Eigen::Matrix<double, Eigen::Dynamic, 6>& rows,
                            double rotationLength_m);

/// Minimises |rows rates - wanted|^2 + mu^2 |rates|^2 under |v| <= maxSpeed, |w| <= maxRotation, |v - v_last|
/// <= maxAcceleration dt, |w - w_last| <= maxAngularAcceleration dt (w of both by the axes of the present
/// pose), the workspace's box and the clearance of every object.
///
/// Without limits of acceleration the pose at the end of dt must be within workspace and clearance. With them
/// the robot must afterwards still be able to brake before these, on a straight line: a velocity p towards a
/// bound at distance d satisfies
///
///     dt max(p, (p + p_last) / 2) + p T <= d,     T = max(maxSpeed / a, maxRotation / alpha),
///
/// Braking at full strength always continues to satisfy this (a speed within maxSpeed needs at most T to
/// stop, and a distance of half of p T), whether the robot takes up a new velocity at once or over the
/// period. Braking at full strength is always a solution, so a solution always exists.
VelocitySolution solveVelocity(const RigGeometry& geometry, const VelocityProblem& problem);

/// Returns rates that go straight from q to `goal` as fast as the robot may, brake to arrive, and do not go
/// past it, within every limit. `lastRates` are the present rates of the robot.
VelocitySolution velocityTowards(const RigGeometry& geometry, const Vector6d& q, const Vector6d& goal,
                                 double dt_s, const Vector6d& lastRates = Vector6d::Zero());

/// Returns where a retreat from q ends: along the source's normal at the end of the workspace, with unchanged
/// angles.
Vector6d poseOffSource(const RigGeometry& geometry, const Vector6d& q);

/// Returns the pose at the height of q on the source's axis, parallel to the source, as far as the free
/// coordinates and the workspace allow.
Vector6d poseFacingSource(const RigGeometry& geometry, const Vector6d& q);

/// Returns the time from a to b at the robot's limits of speed, s.
double travelTime_s(const RobotLimits& limits, const Vector6d& a, const Vector6d& b);

/// Returns rows G y >= h (h <= 0) that keep a step y in the free coordinates, to q + y, inside workspace and
/// clearance (linearised).
void stepLimits(const RigGeometry& geometry, const Vector6d& q, Eigen::MatrixXd& G, Eigen::VectorXd& h);

} // namespace bask
