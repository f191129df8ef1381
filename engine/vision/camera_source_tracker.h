#pragma once
// The source's pose by a camera that stands still and sees its markers.

#include "engine/base/clock.h"
#include "engine/devices/source_tracker.h"
#include "engine/vision/part_tracker.h"

namespace bask {

/// A source followed in C, as a reading in R at `time_s`; invalid where it is not followed, and where the
/// mirrored pose may be the true one: the robot would be led by a guess.
PoseReading readingOf(const std::optional<TrackedPose>& pose, TrackState state, const Pose& X_RC,
                      double time_s, double latency_s);

/// One thread. The pose of the camera in R and its calibration are taken as exact.
class CameraSourceTracker final : public SourceTracker {
public:
    /// `clock`: the engine's, on which the frames' time_s is.
    CameraSourceTracker(Camera& camera, const Clock& clock, const MarkerLayout& layout,
                        const CameraModel& model, const Pose& X_RC);

    /// The newest frame, if there is one that was not looked at. The pose is followed best when this is
    /// called as often as the camera has frames. Errors: those of the camera; CameraSizeOther.
    Result<void> look();
    /// Looks, and carries the pose on to now.
    Result<PoseReading> read() override;

    /// X_CS now.
    std::optional<TrackedPose> tracked() const { return m_tracker.at(m_clock.now_s()); }
    const TrackStep& lastStep() const { return m_step; }
    /// From the light of the last frame that was looked at to its pose known; 0 before the first.
    double latency_s() const { return m_latency_s; }

private:
    Camera& m_camera;
    const Clock& m_clock;
    CameraModel m_model;
    Pose m_X_RC;
    PartTracker m_tracker;
    TrackStep m_step;
    std::shared_ptr<const CameraFrame> m_frame; ///< looked at last
    double m_latency_s = 0.0;
};

} // namespace bask
