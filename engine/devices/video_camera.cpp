#include "engine/devices/video_camera.h"

#include <utility>

namespace bask {

VideoCamera::VideoCamera(std::string name, const Clock& clock)
    : VideoCamera(name, clock, [name](const std::function<bool()>& isStopped) {
          return openFrameSource(name, isStopped);
      }) {}

VideoCamera::VideoCamera(std::string name, const Clock& clock, Opener opener)
    : m_clock(clock), m_capture(std::move(name), std::move(opener)) {}

int VideoCamera::hanging() {
    return hangingCaptures();
}

Result<std::shared_ptr<const CameraFrame>> VideoCamera::newest() {
    const auto taken = m_capture.newest();
    if (!taken)
        return taken.error();
    const NumberedPicture<CaughtPicture>& newest = **taken;
    if (!m_newest || m_newest->number != newest.number) {
        const double age_s = m_steady.now_s() - newest.caught.caught_s;
        m_newest = std::make_shared<CameraFrame>(CameraFrame{m_clock.now_s() - age_s, newest.caught.caught_s,
                                                             newest.number, newest.caught.picture});
    }
    return m_newest;
}

} // namespace bask
