#pragma once
// A plane through a field of three axes.

#include "engine/radiation/field_sampler.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Samples in rows, with their positions in the field's coordinates.
struct CutSheet {
    int columns = 0;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> values; ///< one for each point; NaN if there is none
    std::vector<double> lines;  ///< values of the contour lines
};

/// Returns the field where axis number `axis` is at `position`, or at the nearest end of the axis; linear
/// between the two neighbouring layers. Without contour lines.
CutSheet sheetOf(const Field& field, int axis, double position);

} // namespace bask
