#pragma once
// The pose of a thermal camera in the robot's base, from the silhouettes of the objects that the robot holds.

#include "engine/base/share_done.h"
#include "engine/calibration/pose_covariance.h"
#include "engine/calibration/verdict.h"
#include "engine/thermography/silhouette_outline.h"
#include "engine/thermography/silhouette_search.h"
#include "engine/thermography/thermal_picture.h"

#include <span>
#include <vector>

namespace bask {

/// A picture, and where the end-effector was when it was taken. The robot stood still.
struct SilhouetteView {
    ThermalPicture picture;
    Pose X_RE = Pose::Identity();
};

struct SilhouetteOptions {
    StartUncertainty start;     ///< how far the start pose may be off
    double blur_px = 0.6;       ///< standard deviation of the lens's spot to begin with; it is fitted, too
    double minContrast_K = 1.0; ///< of an object against what is behind it, at 300 K
    std::size_t minViews = 3;   ///< pictures in which outlines are found
};

struct SilhouettePose {
    Pose X_RC = Pose::Identity();
    /// By the displacement of X_RC (pose_covariance.h): by the scatter of the edges about the outlines, by
    /// their correlation along them, by the robot's own errors where these show, and by 0.01 px that all
    /// edges may be off outwards. It does not include errors of the lens's model, of the outlines and of the
    /// objects' mountings, which all pictures have in common.
    Matrix6d covariance = Matrix6d::Zero();
    double rms_px = 0.0;                  ///< distances of the edges from the outlines
    double blur_px = 0.0;                 ///< standard deviation of the lens's spot, fitted
    std::vector<std::vector<int>> points; ///< pieces of outline used: of each view, of each object
    /// How many independent pieces these are worth, by the correlation of neighbours.
    double effectivePoints = 0.0;
    double foundShare = 0.0; ///< of the outlines that nothing hides: where the edge was found
    /// Standard deviations of the robot's own errors for each axis, at E; 0 where they do not show.
    double robot_m = 0.0, robot_rad = 0.0;
    PoseSpread atObjects;  ///< error of an object's place by that of X_RC, 2 sigma, at the worst one
    double across_m = 0.0; ///< the same across the line of sight
    std::vector<Message>
        remarks; ///< SilhouetteViewLeftOut, SilhouettePosesFew, -InLine, SilhouetteDepthAlike
};

/// Finds X_RC from a rough one. Errors: SilhouetteViewsFew; CameraSizeOther and ThermalPictureConstant (with
/// "picture N" as place); SilhouetteOutside (no outline in any picture at the start pose);
/// SilhouetteNoContrast; SilhouetteContradicts (less than half of the visible outlines are found, or they are
/// off by more than a pixel); SilhouetteAmbiguous (a second pose within twice the start's uncertainty fits
/// as well). Throws std::invalid_argument for a camera without size or focal lengths, a scene without
/// objects, poses that are not finite, and options out of range. It takes some seconds; `done` is told its
/// share.
Result<SilhouettePose> silhouettePose(const CameraModel& camera, std::span<const SilhouetteView> views,
                                      const SilhouetteScene& scene, const Pose& start,
                                      const SilhouetteOptions& options = {}, const ShareDone& done = {});

/// Judges the pose by its error at the objects, as relative poses are judged. Reasons: SilhouetteGood,
/// SilhouetteUncertain.
Judgement judged(const SilhouettePose& pose);

} // namespace bask
