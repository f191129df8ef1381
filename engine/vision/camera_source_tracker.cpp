#include "engine/vision/camera_source_tracker.h"

namespace bask {

PoseReading readingOf(const std::optional<TrackedPose>& pose, TrackState state, const Pose& X_RC,
                      double time_s, double latency_s) {
    PoseReading reading;
    reading.time_s = time_s;
    reading.latency_s = latency_s;
    if (!pose || pose->isAmbiguous)
        return reading;
    reading.valid = true;
    reading.X_RS = X_RC * pose->X_CP;
    reading.seen_s = pose->seen_s;
    reading.predicted = state == TrackState::Predicting;
    const PoseSpread spread = spreadOf(pose->covariance); // the same in R's axes
    reading.position_m = spread.position_m;
    reading.angle_rad = spread.angle_rad;
    return reading;
}

CameraSourceTracker::CameraSourceTracker(Camera& camera, const Clock& clock, const MarkerLayout& layout,
                                         const CameraModel& model, const Pose& X_RC)
    : m_camera(camera), m_clock(clock), m_model(model), m_X_RC(X_RC), m_tracker(layout, Part::Source, model) {
}

Result<void> CameraSourceTracker::look() {
    const auto newest = m_camera.newest();
    if (!newest)
        return newest.error();
    const auto& frame = *newest;
    if (const auto fits = checkSize(m_model, frame->picture.width, frame->picture.height); !fits)
        return fits;
    if (frame == m_frame)
        return {};
    m_step = m_tracker.step(*frame);
    m_frame = frame;
    m_latency_s = SteadyClock().now_s() - frame->caught_s;
    return {};
}

Result<PoseReading> CameraSourceTracker::read() {
    if (const auto looked = look(); !looked)
        return looked.error();
    const double now_s = m_clock.now_s();
    return readingOf(m_tracker.at(now_s), m_step.state, m_X_RC, now_s, m_latency_s);
}

} // namespace bask
