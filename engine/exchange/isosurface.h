#pragma once
// Surfaces of equal value in a sampled field, as triangles.

#include "engine/radiation/field_sampler.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bask {

/// A triangulated surface. Points and normals are in the field's axes, in their order: m or rad.
struct Isosurface {
    double value = 0.0;
    std::vector<Eigen::Vector3d> points;
    /// Unit vectors against the field's gradient (in the direction of decrease), one for each point; zero
    /// where there is none.
    std::vector<Eigen::Vector3d> normals;
    std::vector<std::array<int, 3>> triangles; ///< indices of points

    bool empty() const { return triangles.empty(); }
};

/// Returns the surfaces of a field with three axes at `values`, one for each value, in their order, linear
/// between samples (VTK's flying edges). A value that does not occur in the field gives a surface without
/// triangles; cells with a NaN have none. Throws std::invalid_argument unless the field has three axes of at
/// least two samples.
std::vector<Isosurface> isosurfaces(const Field& field, const std::vector<double>& values);

} // namespace bask
