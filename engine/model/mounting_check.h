#pragma once
// What an arrangement of objects on the end-effector means, in words, before anything is heated.

#include "engine/model/experiment.h"

namespace bask {

struct MountingRemark {
    Message message;
    std::vector<int> objects; ///< whom it is about
};

/// Of an experiment that validates. Objects that overlap as seen along E's z axis (they shade one another,
/// which the view factors leave out; one in the hole of another does not), objects farther from E than
/// RobotLimits::maxMountingRadius_m, and three objects in a line, which cannot be held at like temperatures:
/// a line meets a convex surface of equal view factor twice at most (docs/model.md, section 7). Then what the
/// free axes can do with them: objects whose view factors they cannot change independently
/// (engine/control/dependent_objects.h) and, where there are none, that as many objects as free axes leave no
/// freedom over. Takes 1 ms for three objects, 4 ms at worst.
std::vector<MountingRemark> mountingRemarks(const Experiment& experiment);

/// The shape as drawings and remarks need it: a polygon of many points within 0.2 mm, others as they are.
Shape thinned(const Shape& shape);

/// Outline (m) of an object as mounted, projected on the xy-plane of E, followed by its holes.
std::vector<std::vector<Eigen::Vector2d>> mountedRings(const ObjectSpec& object, int points);

} // namespace bask
