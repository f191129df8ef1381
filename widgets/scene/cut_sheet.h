#pragma once
// A plane through a field of three axes.

#include "engine/radiation/field_sampler.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Samples in rows, and where they are in the field's coordinates.
struct CutSheet {
    int columns = 0;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> values; ///< one a point; NaN: none
    std::vector<double> lines;  ///< values that get a contour line
};

/// The field where its axis number `axis` is at `position`, or at its end nearest to that; linear between the
/// two layers beside it. Without lines.
CutSheet sheetOf(const Field& field, int axis, double position);

} // namespace bask
