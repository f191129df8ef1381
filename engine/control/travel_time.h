#pragma once
// Time that the robot needs from one pose to others.

#include "engine/base/pose.h"
#include "engine/control/robot_limits.h"

#include <algorithm>

namespace bask {

/// Travel at the robot's limits from one pose. Stores the trigonometry of that pose, for tables.
class TravelTime {
public:
    TravelTime(const RobotLimits& limits, const Vector6d& from)
        : m_from(from), m_axes(rotationAxes(from) / limits.maxRotation_rad_s),
          m_perLength_s_m(1.0 / limits.maxSpeed_m_s) {}

    /// Returns the time to a pose, s.
    double to(const Vector6d& pose) const {
        const Vector6d way = pose - m_from;
        return std::max(way.head<3>().norm() * m_perLength_s_m, (m_axes * way.tail<3>()).norm());
    }

private:
    Vector6d m_from;
    Eigen::Matrix3d m_axes; ///< s
    double m_perLength_s_m;
};

} // namespace bask
