#pragma once
// What the robot may do: free coordinates, limits of speed and acceleration, workspace, clearance from the
// source plane; and which of these limits a command has reached.

#include "engine/base/pose.h"

#include <array>
#include <string>

namespace bask {

/// The length that one radian counts as, where the distance of poses is one number.
inline constexpr double kRadianLength_m = 0.1;

/// Limits in the end-effector's coordinates (x, y, z, theta_x, theta_y, theta_z; m, rad) in the robot's base
/// R.
struct RobotLimits {
    std::array<bool, 6> free{true, true, true, true, false, false};
    double maxSpeed_m_s = 0.02;               ///< of the translation's norm
    double maxRotation_rad_s = 0.1;           ///< of the angular velocity's norm
    double maxAcceleration_m_s2 = 0.0;        ///< of the translation's norm; 0: no limit
    double maxAngularAcceleration_rad_s2 = 0; ///< of the angular acceleration's norm; 0: no limit
    Vector6d lower{-0.2, -0.2, 0.01, -0.6108652381980153, 0.0, 0.0};
    Vector6d upper{0.2, 0.2, 0.3, 0.6108652381980153, 0.0, 0.0};
    double clearance_m = 0.01; ///< smallest allowed distance of any contour point from the source plane
    /// Largest distance from E at which the robot can carry an object; 0: no limit.
    double maxMountingRadius_m = 0.2;

    int degreesOfFreedom() const;
    bool limitsAcceleration() const {
        return maxAcceleration_m_s2 > 0.0 || maxAngularAcceleration_rad_s2 > 0.0;
    }
    bool operator==(const RobotLimits&) const = default;
};

/// The active limits are numbered so that Workspace + k is the bound of coordinate k.
enum class Limit { Speed, Rotation, Acceleration, AngularAcceleration, Clearance, Workspace };

/// Limits that restrict a command. Bit 0: any limit at all; bit 1 + l: limit l (the format of the session
/// file).
struct ActiveLimits {
    unsigned bits = 0;

    void add(Limit limit, int coordinate = 0) { bits |= 1U | (2U << (static_cast<int>(limit) + coordinate)); }
    void addUnnamed() { bits |= 1U; }
    bool any() const { return bits != 0; }
    bool has(Limit limit, int coordinate = 0) const {
        return (bits & (2U << (static_cast<int>(limit) + coordinate))) != 0;
    }
    bool operator==(const ActiveLimits&) const = default;
};

/// Returns "speed, workspace x"; empty if no limit is active or named.
std::string describe(const ActiveLimits& limits);

} // namespace bask
