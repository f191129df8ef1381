#pragma once
// Tracks a part from frame to frame by its markers: searches near its last place, or everywhere if it is
// lost, and filters its pose with covariance.

#include "engine/devices/camera.h"
#include "engine/vision/marker_search.h"
#include "engine/vision/pose_filter.h"

#include <optional>
#include <vector>

namespace bask {

/// A filtered pose of a part at one time.
struct TrackedPose {
    double time_s = 0.0; ///< time of the pose, on the engine's clock
    double seen_s = 0.0; ///< time of the last accepted frame
    Pose X_CP = Pose::Identity();
    Vector6d velocity = Vector6d::Zero(); ///< [v; w], C axes, m/s and rad/s
    /// Of X_CP, see pose_covariance.h; large enough to include the mirrored pose if that may be the true one.
    Matrix6d covariance = Matrix6d::Zero();
    bool isAmbiguous = false; ///< whether the mirrored pose explains the frames as well
};

enum class TrackState { Searching, Tracking, Predicting };

struct TrackStep {
    TrackState state = TrackState::Searching;
    std::vector<FoundMarker> found; ///< all markers of the dictionary in the searched part of the picture
    std::vector<int> left_out;      ///< ids of the part that did not fit, as a whole or in one corner
    bool searchedAll = false;       ///< whether the whole picture was searched
};

/// Not thread-safe.
///
/// Starts with the pose of one frame (partPose); if only one marker is visible, a second frame must agree. It
/// restarts if a frame does not fit the previous ones: at once with two or more markers that agree, with one
/// marker after kRejected frames.
class PartTracker {
public:
    /// The pose is predicted for this long without an accepted frame.
    static constexpr double kPredicted_s = 1.0;
    static constexpr int kRejected = 3;

    PartTracker(MarkerLayout layout, Part part, CameraModel camera);

    /// Processes one frame of the size of the camera's pictures. A frame older than the last one restarts the
    /// tracker.
    TrackStep step(const CameraFrame& frame);
    /// Returns the pose extrapolated to a time; empty while searching, or later than kPredicted_s after the
    /// last accepted frame.
    std::optional<TrackedPose> at(double time_s) const;
    void forget();

private:
    struct Seen {
        std::vector<int> ids;            ///< ids of the part, each once
        std::vector<SeenCorner> corners; ///< four of each marker
    };
    void look(const CameraFrame& frame, TrackStep& step);
    Seen seenOf(const std::vector<FoundMarker>& found) const;
    bool follow(double time_s, const Seen& seen, TrackStep& step);
    bool begin(double time_s, const Seen& seen, TrackStep& step);
    void weighMirrored(double time_s, const Seen& seen, FilterStep& taken);
    void seekMirrored(double time_s, const Seen& seen, const MotionState& predicted);
    void lose();

    MarkerLayout m_layout;
    Part m_part;
    CameraModel m_camera;
    std::optional<PoseFilter> m_filter;
    std::optional<PoseFilter> m_mirrored; ///< the other pose that one marker allows, tracked in parallel
    double m_evidence = 0.0;              ///< evidence against m_filter and for m_mirrored, in variances
    /// Whether it is undecided which of two poses is true, also if they have become equal.
    bool m_isOpen = false;
    bool m_confirmed = false;
    int m_rejected = 0; ///< number of rejected frames in a row
    double m_seen_s = 0.0, m_last_s = -1e300;
    SearchSchedule m_schedule;
};

} // namespace bask
