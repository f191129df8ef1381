#include "engine/vision/camera_source_tracker.h"

#include "engine/base/message_code.h"

namespace bask {

CameraSourceTracker::CameraSourceTracker(Camera& camera, const Clock& clock, const MarkerLayout& layout,
                                         const CameraModel& model, const Pose& X_RC)
    : m_camera(camera), m_clock(clock), m_model(model), m_X_RC(X_RC), m_tracker(layout, Part::Source, model) {
}

Result<void> CameraSourceTracker::look() {
    const auto newest = m_camera.newest();
    if (!newest)
        return newest.error();
    const auto& frame = *newest;
    if (m_model.width != 0 &&
        (frame->picture.width != m_model.width || frame->picture.height != m_model.height)) {
        const auto text = [](int width, int height) {
            return std::to_string(width) + " x " + std::to_string(height);
        };
        return Error{
            MessageCode::CameraSizeOther,
            "",
            {text(m_model.width, m_model.height), text(frame->picture.width, frame->picture.height)}};
    }
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
    PoseReading reading;
    reading.time_s = m_clock.now_s();
    reading.latency_s = m_latency_s;
    const auto pose = m_tracker.at(reading.time_s);
    if (!pose)
        return reading;
    reading.valid = true;
    reading.X_RS = m_X_RC * pose->X_CP;
    reading.seen_s = pose->seen_s;
    reading.predicted = m_step.state == TrackState::Predicting;
    const PoseSpread spread = spreadOf(pose->covariance); // the same in R's axes
    reading.position_m = spread.position_m;
    reading.angle_rad = spread.angle_rad;
    return reading;
}

} // namespace bask
