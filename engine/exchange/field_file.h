#pragma once
// A sampled field as a VTK image file (.vti) and surfaces in it as VTK poly data (.vtp), which ParaView and
// other VTK programs open.

#include "engine/exchange/isosurface.h"
#include "engine/radiation/field_sampler.h"

#include <string>
#include <vector>

namespace bask {

inline constexpr int kMaxFourthAxisSamples = 1000;

/// What can be known before the sampling: refuses a file that is there and was not written by writeField,
/// since it would be lost (an empty one may go), and a fourth axis of too many samples.
Result<void> checkFieldFile(const std::string& path, const std::vector<FieldAxis>& axes);

/// Writes the field, whole or not at all, without a copy of its samples. `title` says in words what it is.
///
/// The first three axes are the image's x, y and z, origin and spacing in m and rad. Point data: the samples
/// as "view_factor", or as quantity and unit, "steady_temperature_K"; with the gradient also
/// "view_factor_gradient" (1/m, 1/rad), six components by the pose coordinates. A fourth axis gives one such
/// array (or pair) a step, "view_factor at theta_x=0.1 rad": VTK's own time steps of a .vti lose the image's
/// origin and spacing when they are read (seen with VTK 9.1). Field data, so that the file explains itself:
/// made_by, title, axis_names, axis_units, axis_first, axis_step, axis_count, held_names, held_units,
/// held_values, tolerance, undefined_samples.
/// Errors: FileUnwritable, and those of checkFieldFile.
Result<void> writeField(const Field& field, const std::string& path, const std::string& title);

/// Surfaces of one field of view factors in one file.
struct SurfaceSet {
    std::vector<Isosurface> surfaces; ///< of `field`
    /// Of each surface, K; empty: not said.
    std::vector<double> steadyTemperatures_K = {};
    std::string title; ///< says in words what they are
};

/// Refuses a file that is there and was not written by writeSurfaces (an empty one may go).
Result<void> checkSurfaceFile(const std::string& path);

/// Writes the surfaces as one VTK poly data, whole or not at all. Points in m and rad by the field's axes;
/// point data "Normals" (unit vectors to where the view factor falls), "view_factor" and, where they are
/// given, "steady_temperature_K". Field data as of writeField, and "values", the surfaces' view factors.
/// Errors: FileUnwritable, and those of checkSurfaceFile.
Result<void> writeSurfaces(const Field& field, const SurfaceSet& set, const std::string& path);

} // namespace bask
