#pragma once
// The pose of a part from all of its visible markers.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/pose_covariance.h"
#include "engine/calibration/seen_markers.h"

namespace bask {

/// Assumed standard deviation of a corner's coordinate if there are too few frames to estimate it.
inline constexpr double kUsualCorner_px = 0.2;

struct PartPose {
    Pose X_CP = Pose::Identity();
    /// From the scatter of the corners over the frames; larger if the mean corners miss by more than the
    /// scatter allows (wrong marker positions, an inaccurate camera). Does not include the camera's own
    /// uncertainty.
    Matrix6d covariance = Matrix6d::Zero();
    double corner_px = 0.0;       ///< standard deviation of a corner's coordinate in one frame
    double rms_px = 0.0;          ///< distances between mean corners seen and shown
    std::optional<Pose> mirrored; ///< another pose that the corners allow
    std::vector<SeenMarker> used;
    /// Notes about the pose: MarkerLeftOut, MarkerSideOther, MarkersMisfit, PoseAmbiguous.
    std::vector<Message> remarks;
};

/// Returns the pose from one or more frames of a fixed camera and a fixed part. A frame without the part's
/// markers is ignored. Markers that do not fit the others (wrong id, corner, side or position) are left out.
/// A single marker's side cannot be checked: a wrong side scales the distance. `corner_px` replaces the
/// estimated scatter. Errors: those of seenMarkers; MarkersDisagree (no majority fits together).
Result<PartPose> partPose(std::span<const MarkerFrame> frames, const MarkerLayout& layout, Part part,
                          const CameraModel& camera, std::optional<double> corner_px = std::nullopt);

/// Returns whether the camera would show a marker well enough to be found: facing it within 75 degrees, and
/// inside the picture if its size is known.
bool showsMarker(const CameraModel& camera, const PlacedMarker& marker, const Pose& X_CP);

/// Returns the covariance that partPose would have with the part's markers that the camera shows at `X_CP`
/// and this corner accuracy. Empty if it shows none.
std::optional<Matrix6d> predictedCovariance(const MarkerLayout& layout, Part part, const CameraModel& camera,
                                            const Pose& X_CP, int frames, double corner_px = kUsualCorner_px);

} // namespace bask
