#pragma once
// The path that a run is predicted to take, as dashes: VTK draws no dashed lines by itself.

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Cuts the line through these points (m) into dashes and gaps of this length > 0, from a dash on. Returns
/// the ends of straight pieces, from each even point to the odd one after it.
std::vector<Eigen::Vector3d> dashedLine(const std::vector<Eigen::Vector3d>& line, double dash_m);

/// Returns the dashed line with a cross at its last point, in the same form; empty for no points.
std::vector<Eigen::Vector3d> plannedPath(const std::vector<Eigen::Vector3d>& line, double dash_m);

} // namespace bask
