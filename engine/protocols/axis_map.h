#pragma once
// A robot's axes and the end-effector's coordinates: which drives which, in which direction, from where.

#include "engine/base/pose.h"
#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// One axis as its controller has it: millimetres where it drives x, y or z, degrees where it turns.
struct AxisSpec {
    char letter = 'X';
    int coordinate = 0;    ///< of (x, y, z, theta_x, theta_y, theta_z) in R that it drives
    bool reversed = false; ///< it counts the other way
    double origin = 0.0;   ///< that coordinate (m, rad) where the axis reads zero
    bool operator==(const AxisSpec&) const = default;
};

/// Coordinates without an axis keep the values of `fixed`.
class AxisMap {
public:
    /// Throws std::invalid_argument on what checkAxes refuses.
    AxisMap(std::vector<AxisSpec> axes, const Vector6d& fixed);

    const std::vector<AxisSpec>& axes() const { return m_axes; }
    /// mm and degrees, in the order of the axes.
    std::vector<double> positions(const Vector6d& coordinates) const;
    Vector6d coordinates(const std::vector<double>& positions) const;

private:
    std::vector<AxisSpec> m_axes;
    Vector6d m_fixed;
};

/// Refuses no axis, a letter or a coordinate twice, and letters that are no axis (X Y Z A B C, R).
Result<void> checkAxes(const std::vector<AxisSpec>& axes);

} // namespace bask
