#pragma once
// Where the end-effector may be for an object to have a view factor: surfaces over three of its coordinates.

#include "engine/control/robot_limits.h"
#include "engine/exchange/isosurface.h"
#include "engine/radiation/interaction_matrix.h"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>

namespace bask {

/// What surfaces are drawn over; the other three of the end-effector's coordinates are held. OwnTranslation:
/// each object's over the positions of its own centre, as the paper has them.
enum class PoseSubset { Translation, OwnTranslation, Rotation };

inline constexpr double kSurfaceStep_m = 0.01;
inline constexpr double kSurfaceStep_rad = 0.08726646259971647; ///< 5 degrees

/// Grid of a subset: of positions the robot's workspace, of angles -90 to 90 degrees, whatever the robot can
/// turn. The step is the one asked for or a little less, so that both ends are on the grid; a range narrower
/// than a step gets one step to each side. Throws std::invalid_argument on a step that is not positive;
/// too many samples are refused by targetFields.
std::vector<FieldAxis> surfaceAxes(PoseSubset subset, const RobotLimits& limits, double step);

/// The geometry that fields of targets depend on: no temperature, no material.
struct TargetGeometry {
    RadiatingContour source;
    Pose X_RS = Pose::Identity();
    std::vector<MountedContour> objects;
    std::vector<FieldAxis> axes;      ///< three of the end-effector's coordinates in R; see surfaceAxes
    Vector6d held = Vector6d::Zero(); ///< the others
    /// Over the positions of each object's own centre, those where the axes' end-effector carries it: the
    /// mounting's translation is left out of the coordinates, its rotation is not. Of positions only.
    bool ofOwnCentres = false;
    /// Poses that are a grid step too near for this clearance are left out, and so are the surfaces there.
    double clearance_m = 0.0;
    double tolerance = 1e-6; ///< of F; between samples a surface is off by more than that
};

/// View factors of every object over the grid, one field an object. They stay valid until the geometry
/// changes: another target only needs other surfaces. Errors: those of sampleField. Throws
/// std::invalid_argument on ofOwnCentres over an angle.
Result<std::vector<std::shared_ptr<const Field>>> targetFields(const TargetGeometry& geometry,
                                                               const std::stop_token& stop = {});

/// The surface {q : F_i(q) = F*_i} of each object, in the end-effector's coordinates. Empty where the object
/// has that view factor nowhere on the grid. Nothing when stopped. Throws std::invalid_argument on another
/// number of view factors than fields, and as isosurfaces does.
std::optional<std::vector<Isosurface>> targetSurfaces(std::span<const std::shared_ptr<const Field>> fields,
                                                      std::span<const double> viewFactors,
                                                      const std::stop_token& stop = {});

/// How far an object's own centre is from the end-effector (R, m) at the held angles.
Eigen::Vector3d centreOffset(const Pose& X_EO, const Vector6d& held);

/// Surfaces of all objects, with what was held.
struct SurfaceFrame {
    Vector6d held = Vector6d::Zero();
    std::vector<Isosurface> surfaces; ///< one an object
};

/// The surfaces for each of several values of one held coordinate: a fourth variable as a sequence. Errors:
/// those of targetFields. Throws as targetSurfaces does, and on a coordinate that is an axis.
Result<std::vector<SurfaceFrame>> targetSweep(const TargetGeometry& geometry, Coordinate coordinate,
                                              std::span<const double> values,
                                              std::span<const double> viewFactors,
                                              const std::stop_token& stop = {});

} // namespace bask
