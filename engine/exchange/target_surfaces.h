#pragma once
// The poses of the end-effector at which an object has a given view factor: surfaces over three of its
// coordinates.

#include "engine/base/share_done.h"
#include "engine/control/robot_limits.h"
#include "engine/exchange/isosurface.h"
#include "engine/radiation/interaction_matrix.h"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>

namespace bask {

/// The coordinates over which surfaces are drawn; the other three of the end-effector are fixed.
/// OwnTranslation: each object's surface is over the positions of its own centre, as in the paper.
enum class PoseSubset { Translation, OwnTranslation, Rotation };

inline constexpr double kSurfaceStep_m = 0.01;
inline constexpr double kSurfaceStep_rad = 0.08726646259971647; ///< 5 degrees

/// Returns the grid of a subset: for positions the robot's workspace, for angles -90 to 90 degrees,
/// independent of the robot's range. The step is the requested one or slightly less, so that both ends are on
/// the grid; a range narrower than a step gets one step to each side. Throws std::invalid_argument for a step
/// that is not positive; targetFields refuses too many samples.
std::vector<FieldAxis> surfaceAxes(PoseSubset subset, const RobotLimits& limits, double step);

/// The geometry that determines the fields of targets: no temperature, no material.
struct TargetGeometry {
    RadiatingSource source;
    Pose X_RS = Pose::Identity();
    std::vector<MountedContour> objects;
    Screens screens = {};
    std::vector<FieldAxis> axes;       ///< three of the end-effector's coordinates in R; see surfaceAxes
    Vector6d fixed = Vector6d::Zero(); ///< values of the others
    /// Whether the axes are positions of each object's own centre, not of the end-effector: the mounting's
    /// translation is then not included, but its rotation is. For positions only.
    bool ofOwnCentres = false;
    /// From the source's plane, or from the highest point of any shield over it. Poses that are a grid step
    /// too near for it are left out, and so are the surfaces there.
    double clearance_m = 0.0;
    double tolerance = 1e-6; ///< of F; between samples the error of a surface is larger
    /// The object whose field is wanted, the others only shade it; empty: the fields of all.
    std::optional<std::size_t> only = {};
};

/// Returns the view factors of every object over the grid, one field for each, with the rough shade of the
/// other objects and of the screens (see roughShadedViewFactor). They are valid until the geometry changes:
/// another target only needs other surfaces. Errors: those of sampleField. Throws std::invalid_argument for
/// ofOwnCentres over an angle.
Result<std::vector<std::shared_ptr<const Field>>>
targetFields(const TargetGeometry& geometry, const std::stop_token& stop = {}, const ShareDone& done = {});

/// Returns the surface {q : F_i(q) = F*_i} of each object, in the end-effector's coordinates. A surface is
/// empty if the object has that view factor nowhere on the grid. Returns nothing if stopped. Throws
/// std::invalid_argument unless there is one view factor for each field, and as isosurfaces does.
std::optional<std::vector<Isosurface>> targetSurfaces(std::span<const std::shared_ptr<const Field>> fields,
                                                      std::span<const double> viewFactors,
                                                      const std::stop_token& stop = {});

/// Returns the offset of an object's own centre from the end-effector (R, m) at the fixed angles.
Eigen::Vector3d centreOffset(const Pose& X_EO, const Vector6d& fixed);

/// Surfaces of all objects, with the fixed coordinates.
struct SurfaceFrame {
    Vector6d fixed = Vector6d::Zero();
    std::vector<Isosurface> surfaces; ///< one for each object
};

/// Returns the surfaces for each of several values of one fixed coordinate: a fourth variable as a sequence.
/// Errors: those of targetFields. Throws as targetSurfaces does, and for a coordinate that is an axis.
Result<std::vector<SurfaceFrame>> targetSweep(const TargetGeometry& geometry, Coordinate coordinate,
                                              std::span<const double> values,
                                              std::span<const double> viewFactors,
                                              const std::stop_token& stop = {});

} // namespace bask
