#pragma once
// The shadows of held objects on the source, as lines for a scene; private to widgets/scene.

#include "engine/model/experiment.h"

#include <vector>

namespace bask {

/// Returns the lines on the source (R, m; each even point to the odd one after it) that bound what the other
/// objects, fixtures and shields hide from the centre of an object, at the end-effector's pose q. From other
/// points of the object the shadows lie elsewhere: by its view factor it loses a mean of them. Lines outside
/// the source are left out, and what stands behind the object's face or behind the source throws none.
std::vector<Eigen::Vector3d> shadowLines(const Experiment& experiment, std::size_t object, const Vector6d& q);

} // namespace bask
