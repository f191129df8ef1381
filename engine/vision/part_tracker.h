#pragma once
// A part followed from frame to frame by its markers: searched near its last place, everywhere when lost;
// its pose filtered with covariance.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"
#include "engine/calibration/pose_covariance.h"
#include "engine/devices/camera.h"

#include <optional>
#include <vector>

namespace bask {

/// A part's pose at one moment, by the filter.
struct TrackedPose {
    double time_s = 0.0; ///< what it stands for, on the engine's clock
    double seen_s = 0.0; ///< last frame that was believed
    Pose X_CP = Pose::Identity();
    Vector6d velocity = Vector6d::Zero();   ///< [v; w], C axes, m/s and rad/s
    Matrix6d covariance = Matrix6d::Zero(); ///< of X_CP, pose_covariance.h
    bool isAmbiguous = false;               ///< the mirrored pose explains the frames as well
};

enum class TrackState { Searching, Tracking, Predicting };

struct TrackStep {
    TrackState state = TrackState::Searching;
    std::vector<FoundMarker> found; ///< all of the dictionary in the searched part of the picture
    std::vector<int> left_out;      ///< ids of the part that did not fit
    bool searchedAll = false;       ///< the whole picture was searched
};

/// One thread.
class PartTracker {
public:
    /// Prediction without a believed frame is told for so long.
    static constexpr double kPredicted_s = 1.0;

    PartTracker(MarkerLayout layout, Part part, CameraModel camera);

    /// One frame, newer than the last.
    TrackStep step(const CameraFrame& frame);
    /// Carried on to a moment; nothing while searching, or later than kPredicted_s after the last believed
    /// frame.
    std::optional<TrackedPose> at(double time_s) const;
    void forget();
};

} // namespace bask
