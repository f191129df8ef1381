#pragma once
// What the targets' surfaces of an experiment are computed from.

#include "engine/control/joint_feasibility.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment.h"

#include <optional>
#include <utility>
#include <vector>

namespace bask {

TargetGeometry surfaceGeometry(const Experiment& experiment, PoseSubset subset, const Vector6d& fixed);

/// View factors that the verdict's targets need, one an object.
std::vector<double> neededViewFactors(const JointVerdict& verdict);

/// The two of the verdict's surface points that are farthest apart.
std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> surfaceGap(const JointVerdict& verdict);

/// Whether the surfaces of two experiments differ by more than their values.
bool isOtherGeometry(const Experiment& a, const Experiment& b);

/// Coordinates that are held under a subset and that the robot moves.
std::vector<Coordinate> fixedCoordinates(PoseSubset subset, const RobotLimits& robot);
/// The one of them that is played through: the first angle, the highest-named position (z where it is free).
/// Nothing where none is free.
std::optional<Coordinate> sweptCoordinate(PoseSubset subset, const RobotLimits& robot);
/// So many values of a coordinate over the robot's range, both ends among them.
std::vector<double> sweptValues(const RobotLimits& robot, Coordinate coordinate, int count);

} // namespace bask
