#pragma once
// Objects whose view factors the free axes cannot change independently of one another, wherever the robot is.

#include "engine/control/rig_geometry.h"

#include <vector>

namespace bask {

/// A least such set: without any one of them the others are independent.
struct DependentObjects {
    std::vector<int> objects;
    bool alike = false; ///< two whose view factors are equal at every pose of the sample
};

/// Least sets of objects whose rows of the interaction matrix (free coordinates, a radian counting as
/// 10 cm) are linearly dependent at each of some hundred poses spread over the workspace. A set
/// of one: no free axis changes its view factor. Rows count as dependent where the smallest singular value is
/// under 1e-3 of the matrix's norm or 1e-5 1/m. Empty as soon as one pose is found at which all rows are
/// independent, which is the first one for most rigs, and where no pose of the sample is allowed. The rank is
/// a statement about velocities: objects that are not dependent may still have targets that no pose serves.
/// Coordinates that are not free are taken from `held`.
std::vector<DependentObjects> dependentObjects(const RigGeometry& rig, const Vector6d& held);

} // namespace bask
