#pragma once
// Objects whose view factors the free axes cannot change independently, at any pose of the robot.

#include "engine/control/rig_geometry.h"

#include <vector>

namespace bask {

/// A minimal set of such objects: if any one is removed, the others are independent.
struct DependentObjects {
    std::vector<int> objects;
    bool alike = false; ///< whether it has two objects whose view factors are equal at every sampled pose
};

/// Returns the minimal sets of objects whose rows of the interaction matrix (free coordinates, one radian
/// counting as 10 cm) are linearly dependent at each of about a hundred poses spread over the workspace. A
/// set of one object means that no free axis changes its view factor. Rows count as dependent if the smallest
/// singular value is below 1e-3 of the matrix's norm or 1e-5 1/m. Empty as soon as all rows are independent
/// at one pose, which is the first pose for most rigs, and if no sampled pose is allowed. The rank is about
/// velocities: independent objects may still have targets that no pose reaches. Coordinates that are not free
/// are taken from the second argument.
std::vector<DependentObjects> dependentObjects(const RigGeometry& rig, const Vector6d& fixed);

} // namespace bask
