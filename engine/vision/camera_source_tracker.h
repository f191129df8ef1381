#pragma once
// Measures the source's pose with a fixed camera that sees its markers.

#include "engine/base/clock.h"
#include "engine/devices/source_tracker.h"
#include "engine/vision/part_tracker.h"

namespace bask {

/// Converts a tracked source in C to a reading in R at `time_s`. Invalid if the source is not tracked, and if
/// the mirrored pose may be the true one: the robot would move on a guess.
PoseReading readingOf(const std::optional<TrackedPose>& pose, TrackState state, const Pose& X_RC,
                      double time_s, double latency_s);

/// Not thread-safe. The pose of the camera in R and its calibration are assumed exact.
class CameraSourceTracker final : public SourceTracker {
public:
    /// `clock` is the engine's clock, which the frames' time_s uses.
    CameraSourceTracker(Camera& camera, const Clock& clock, const MarkerLayout& layout,
                        const CameraModel& model, const Pose& X_RC);

    /// Processes the newest frame, if it is new. Tracking is best if this is called as often as the camera
    /// delivers frames. Errors: those of the camera; CameraSizeOther.
    Result<void> look();
    /// Looks at the newest frame, and extrapolates the pose to now.
    Result<PoseReading> read() override;

    /// Returns X_CS now.
    std::optional<TrackedPose> tracked() const { return m_tracker.at(m_clock.now_s()); }
    const TrackStep& lastStep() const { return m_step; }
    /// Returns the time from the exposure of the last frame to its known pose; 0 before the first.
    double latency_s() const { return m_latency_s; }

private:
    Camera& m_camera;
    const Clock& m_clock;
    CameraModel m_model;
    Pose m_X_RC;
    PartTracker m_tracker;
    TrackStep m_step;
    std::shared_ptr<const CameraFrame> m_frame; ///< the last frame that was processed
    double m_latency_s = 0.0;
};

} // namespace bask
