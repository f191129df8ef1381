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
    /// Unit vectors against the field's gradient (where it falls), one a point; zero where it has none.
    std::vector<Eigen::Vector3d> normals;
    std::vector<std::array<int, 3>> triangles; ///< indices of points

    bool empty() const { return triangles.empty(); }
};

/// The surfaces of a field with three axes at `values`, one each, in their order, linear between samples
/// (VTK's flying edges). A value that the field does not take gives a surface without triangles; cells with a
/// NaN have none. Throws std::invalid_argument on a field that has not three axes of at least two samples.
std::vector<Isosurface> isosurfaces(const Field& field, const std::vector<double>& values);

} // namespace bask
