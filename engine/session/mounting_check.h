#pragma once
// What an arrangement of objects on the end-effector means, in words, before anything is heated.

#include "engine/session/experiment.h"

namespace bask {

struct MountingRemark {
    Message message;
    std::vector<int> objects; ///< whom it is about
};

/// Objects that overlap as seen along E's z axis (they shade one another, which the view factors leave out;
/// one in the hole of another does not),
/// objects farther from E than RobotLimits::maxMountingRadius_m, and three objects in a line, which cannot
/// be held at like temperatures: a line meets a convex surface of equal view factor twice at most (MODEL
/// section 8).
std::vector<MountingRemark> mountingRemarks(const Experiment& experiment);

/// Outline (m) of an object as mounted, projected on the xy-plane of E, followed by its holes.
std::vector<std::vector<Eigen::Vector2d>> mountedRings(const ObjectSpec& object, int points);

} // namespace bask
