#pragma once
// A sampled field as a VTK image file (.vti) and surfaces in it as VTK poly data (.vtp), which ParaView and
// other VTK programs open.

#include "engine/exchange/isosurface.h"
#include "engine/radiation/field_sampler.h"

#include <string>
#include <vector>

namespace bask {

inline constexpr int kMaxFourthAxisSamples = 1000;

/// Checks before sampling: refuses an existing file that was not written by writeField, because it would be
/// lost (an empty one may be replaced), and a fourth axis with too many samples.
Result<void> checkFieldFile(const std::string& path, const std::vector<FieldAxis>& axes);

/// Writes the whole field or nothing, without copying its samples. `title` describes it in words.
///
/// The first three axes are the image's x, y and z, origin and spacing in m and rad. Point data: the samples
/// as "view_factor", or as quantity and unit, "steady_temperature_K"; with the gradient also
/// "view_factor_gradient" (1/m, 1/rad), six components by the pose coordinates. A fourth axis gives one such
/// array (or pair) a step, "view_factor at theta_x=0.1 rad": VTK's own time steps of a .vti lose the image's
/// origin and spacing when they are read (seen with VTK 9.1). Field data, so that the file explains itself:
/// made_by, title, axis_names, axis_units, axis_first, axis_step, axis_count, held_names, held_units,
/// held_values, tolerance, undefined_samples; rough_shade where the shade of other objects is rough.
/// Errors: FileUnwritable, and those of checkFieldFile.
Result<void> writeField(const Field& field, const std::string& path, const std::string& title);

/// Surfaces of one field of view factors, for one file.
struct SurfaceSet {
    std::vector<Isosurface> surfaces; ///< of `field`
    /// For each surface, K; empty: not given.
    std::vector<double> steadyTemperatures_K = {};
    std::string title; ///< describes them in words
};

/// Refuses an existing file that was not written by writeSurfaces (an empty one may be replaced).
Result<void> checkSurfaceFile(const std::string& path);

/// Writes the surfaces as one VTK poly data, completely or not at all. Points are in m and rad by the field's
/// axes; point data: "Normals" (unit vectors in the direction in which the view factor decreases),
/// "view_factor" and, if given, "steady_temperature_K". Field data as in writeField, and "values", the
/// surfaces' view factors. Errors: FileUnwritable, and those of checkSurfaceFile.
Result<void> writeSurfaces(const Field& field, const SurfaceSet& set, const std::string& path);

} // namespace bask
