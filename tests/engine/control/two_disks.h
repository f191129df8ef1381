#pragma once
// Two disks on the end-effector over a hot disk, and the question that tests ask there.

#include "engine/control/velocity_solve.h"

namespace bask {

/// 8 cm apart along y.
inline RigGeometry twoDisks(const RobotLimits& limits) {
    Vector6d left = Vector6d::Zero();
    Vector6d right = Vector6d::Zero();
    left[kY] = -0.04;
    right[kY] = 0.04;
    return RigGeometry(Disk{0.1}, {Disk{0.015}, Disk{0.015}}, {left, right}, limits);
}

/// Wanted rates of both view factors at q.
inline VelocityProblem problemAt(const RigGeometry& geometry, const Vector6d& q,
                                 const Eigen::Vector2d& wanted) {
    VelocityProblem problem;
    problem.rows = geometry.viewFactors(q).dF;
    problem.wanted = wanted;
    problem.coordinates = q;
    return problem;
}

} // namespace bask
