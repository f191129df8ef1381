#pragma once
// Remarks about an arrangement of objects on the end-effector, before anything is heated.

#include "engine/model/experiment.h"

namespace bask {

struct MountingRemark {
    Message message;
    std::vector<int> objects; ///< the objects it is about, not fixtures and shields
};

/// The pose that a sentence about shade speaks of.
enum class ShadedPose { Start, Here };

/// Returns remarks on an experiment that validates. First, as the gravest, objects that overlap in one plane
/// or pass through one another, and fixtures or shields that pass through what stands or moves with them; one
/// above another, or inside the hole of another, does not (see shadeRemarks). Objects farther from E than
/// RobotLimits::maxMountingRadius_m. Three objects on a line, which cannot be at similar temperatures: a line
/// meets a convex surface of equal view factor at most twice (docs/model.md, section 7). Then what the free
/// axes can do: objects whose view factors they cannot change independently
/// (engine/control/dependent_objects.h) and, if there are none, that as many objects as free axes leave no
/// redundancy. Takes 1 ms for three objects, at most 4 ms.
std::vector<MountingRemark> mountingRemarks(const Experiment& experiment);

/// Refuses two objects, fixtures or shields in one place or that cross each other, which nobody can build,
/// with the sentence of the remark, at the place of the second (engine/model/passing_shapes.h). Shields are
/// held against one another only: what is held stays above them. Objects that touch, overlap a part
/// in one plane or only shade one another are accepted.
Result<void> checkMounting(const Experiment& experiment);

/// Returns remarks on every two objects that overlap a part in one plane.
std::vector<MountingRemark> overlapsInPlane(const Experiment& experiment);

/// Returns a remark on each share of its light, of at least kMinToldShare, that an object loses to another
/// one, a fixture or a shield at a pose of the end-effector (MountedObjects::takenLight), the largest first.
/// Takes about 1 ms for each two objects of which one stands in the light of the other, nothing for objects
/// in one plane.
std::vector<MountingRemark> shadeRemarks(const Experiment& experiment, const Vector6d& pose,
                                         ShadedPose which);

/// Returns whether an object may be in the shade of another one, a fixture or a shield at some pose.
bool mayShade(const Experiment& experiment);

/// Returns the shape for drawings and remarks: a polygon of many points simplified to 0.2 mm, others
/// unchanged.
Shape thinned(const Shape& shape);

/// Returns the outline (m) of a mounted object, projected on the plane of two of E's axes, followed by its
/// holes.
std::vector<std::vector<Eigen::Vector2d>> mountedRings(const ObjectSpec& object, int points,
                                                       Coordinate right = kX, Coordinate up = kY);

} // namespace bask
