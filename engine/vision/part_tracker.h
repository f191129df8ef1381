#pragma once
// A part followed from frame to frame by its markers: searched near its last place, everywhere when lost;
// its pose filtered with covariance.

#include "engine/devices/camera.h"
#include "engine/vision/marker_search.h"
#include "engine/vision/pose_filter.h"

#include <optional>
#include <vector>

namespace bask {

/// A part's pose at one moment, by the filter.
struct TrackedPose {
    double time_s = 0.0; ///< what it stands for, on the engine's clock
    double seen_s = 0.0; ///< last frame that was believed
    Pose X_CP = Pose::Identity();
    Vector6d velocity = Vector6d::Zero(); ///< [v; w], C axes, m/s and rad/s
    /// Of X_CP, pose_covariance.h; as wide as to reach the mirrored pose where that may be the true one.
    Matrix6d covariance = Matrix6d::Zero();
    bool isAmbiguous = false; ///< the mirrored pose explains the frames as well
};

enum class TrackState { Searching, Tracking, Predicting };

struct TrackStep {
    TrackState state = TrackState::Searching;
    std::vector<FoundMarker> found; ///< all of the dictionary in the searched part of the picture
    std::vector<int> left_out;      ///< ids of the part that did not fit, as a whole or by a corner
    bool searchedAll = false;       ///< the whole picture was searched
};

/// One thread.
///
/// Begins with the pose of one frame (partPose), once a second frame agrees where one marker only is seen. So
/// it begins anew where a frame does not fit what was before: at once by two markers or more that agree, by
/// one after kRejected frames.
class PartTracker {
public:
    /// Prediction without a believed frame is told for so long.
    static constexpr double kPredicted_s = 1.0;
    static constexpr int kRejected = 3;

    PartTracker(MarkerLayout layout, Part part, CameraModel camera);

    /// One frame, newer than the last (an older one: begins anew), as large as the camera's pictures.
    TrackStep step(const CameraFrame& frame);
    /// Carried on to a moment; nothing while searching, or later than kPredicted_s after the last believed
    /// frame.
    std::optional<TrackedPose> at(double time_s) const;
    void forget();

private:
    struct Seen {
        std::vector<int> ids;            ///< of the part, each once
        std::vector<SeenCorner> corners; ///< four of each
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
    std::optional<PoseFilter> m_mirrored; ///< the other pose that one marker allows, followed beside it
    double m_evidence = 0.0;              ///< against m_filter and for m_mirrored, in variances
    bool m_isOpen = false;                ///< which of two poses was never decided, also when they have met
    bool m_confirmed = false;
    int m_rejected = 0; ///< frames one after the other
    double m_seen_s = 0.0, m_last_s = -1e300;
    SearchSchedule m_schedule;
};

} // namespace bask
