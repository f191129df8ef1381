#pragma once
// The mapping between a robot's axes and the end-effector's coordinates: which axis, direction and origin.

#include "engine/base/pose.h"
#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// One axis of the robot's controller: in millimetres if it drives x, y or z, in degrees if it turns.
struct AxisSpec {
    char letter = 'X';
    int coordinate = 0;    ///< the coordinate (x, y, z, theta_x, theta_y, theta_z) in R that it drives
    bool reversed = false; ///< whether it counts in the opposite direction
    double origin = 0.0;   ///< value of that coordinate (m, rad) where the axis reads zero
    bool operator==(const AxisSpec&) const = default;
};

/// Coordinates without an axis have the values of `fixed`.
class AxisMap {
public:
    /// Throws std::invalid_argument for what checkAxes refuses.
    AxisMap(std::vector<AxisSpec> axes, const Vector6d& fixed);

    const std::vector<AxisSpec>& axes() const { return m_axes; }
    /// Returns the axis positions, mm and degrees, in the order of the axes.
    std::vector<double> positions(const Vector6d& coordinates) const;
    Vector6d coordinates(const std::vector<double>& positions) const;

private:
    std::vector<AxisSpec> m_axes;
    Vector6d m_fixed;
};

/// Refuses an empty list, a letter or a coordinate that appears twice, and letters that are not an axis (X Y
/// Z A B C, R).
Result<void> checkAxes(const std::vector<AxisSpec>& axes);

} // namespace bask
