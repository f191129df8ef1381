#pragma once
// Where a part is, by all of its markers that are seen.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/pose_covariance.h"
#include "engine/calibration/seen_markers.h"

namespace bask {

/// Standard deviation of a corner's coordinate that is taken for granted where frames are too few to tell.
inline constexpr double kUsualCorner_px = 0.2;

struct PartPose {
    Pose X_CP = Pose::Identity();
    /// By the corners' scatter over the frames, and more where the mean corners miss by more than that
    /// allows (badly placed markers, a camera badly known). The camera's own uncertainty is not in it.
    Matrix6d covariance = Matrix6d::Zero();
    double corner_px = 0.0;       ///< standard deviation of a corner's coordinate in one frame
    double rms_px = 0.0;          ///< distances between mean corners seen and shown
    std::optional<Pose> mirrored; ///< another pose that the corners allow
    std::vector<SeenMarker> used;
    /// What to know about it: MarkerLeftOut, MarkerSideOther, MarkersMisfit, PoseAmbiguous.
    std::vector<Message> remarks;
};

/// From frames of a still camera and a still part, one or many; a frame without the part's markers counts
/// for nothing. Markers that do not fit the others (wrong id, corner, side or place) are left out. A single
/// marker's side cannot be checked: a wrong one scales the distance. `corner_px`: instead of the scatter.
/// Errors: those of seenMarkers; MarkersDisagree (no majority fits together).
Result<PartPose> partPose(std::span<const MarkerFrame> frames, const MarkerLayout& layout, Part part,
                          const CameraModel& camera, std::optional<double> corner_px = std::nullopt);

/// Whether the camera shows a marker of a part there well enough to be found: facing it by 75 degrees or
/// less, within the picture where its size is known.
bool showsMarker(const CameraModel& camera, const PlacedMarker& marker, const Pose& X_CP);

/// Covariance that partPose would have with the markers of the part that the camera shows at `X_CP` and
/// corners so sure. Nothing when it shows none.
std::optional<Matrix6d> predictedCovariance(const MarkerLayout& layout, Part part, const CameraModel& camera,
                                            const Pose& X_CP, int frames, double corner_px = kUsualCorner_px);

} // namespace bask
