#pragma once
// Inputs for computing the targets' surfaces of an experiment.

#include "engine/control/joint_feasibility.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment.h"

#include <optional>
#include <utility>
#include <vector>

namespace bask {

/// Grids of the surfaces: the paper's, or one of twice its step, for a first look or for many frames where
/// shade makes the fine one slow.
enum class SurfaceGrid { Fine, Coarse };

TargetGeometry surfaceGeometry(const Experiment& experiment, PoseSubset subset, const Vector6d& fixed,
                               SurfaceGrid grid = SurfaceGrid::Fine);

/// Returns the view factors that the verdict's targets need, one for each object.
std::vector<double> neededViewFactors(const JointVerdict& verdict);

/// Returns the two of the verdict's surface points that are farthest apart.
std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> surfaceGap(const JointVerdict& verdict);

/// Returns whether the surfaces of two experiments differ by more than their values.
bool isOtherGeometry(const Experiment& a, const Experiment& b);

/// Returns the coordinates that are fixed in a subset and that the robot can move.
std::vector<Coordinate> fixedCoordinates(PoseSubset subset, const RobotLimits& robot);
/// Returns the one of them that an animation varies: the first angle, or the last position (z if it is free).
/// Empty if none is free.
std::optional<Coordinate> sweptCoordinate(PoseSubset subset, const RobotLimits& robot);
/// Returns this number of values of a coordinate over the robot's range, including both ends.
std::vector<double> sweptValues(const RobotLimits& robot, Coordinate coordinate, int count);

} // namespace bask
