#pragma once
// What the robot may do: free coordinates, speed limits, workspace, clearance to the source plane.

#include "engine/base/pose.h"

#include <array>

namespace bask {

/// Limits in the end-effector's coordinates (x, y, z, theta_x, theta_y, theta_z; m, rad) in the robot's base
/// R.
struct RobotLimits {
    std::array<bool, 6> free{true, true, true, true, false, false};
    double maxSpeed_m_s = 0.02;     ///< of the translation's norm
    double maxRotation_rad_s = 0.1; ///< of the angular velocity's norm
    Vector6d lower{-0.2, -0.2, 0.01, -0.6108652381980153, 0.0, 0.0};
    Vector6d upper{0.2, 0.2, 0.3, 0.6108652381980153, 0.0, 0.0};
    double clearance_m = 0.01; ///< least distance of any contour point from the source plane

    int degreesOfFreedom() const;
    bool operator==(const RobotLimits&) const = default;
};

} // namespace bask
