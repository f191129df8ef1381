#include "engine/devices/video_thermal_camera.h"

#include <utility>

namespace bask {

VideoThermalCamera::VideoThermalCamera(const std::string& name, const ThermalProfile& profile,
                                       const Clock& clock)
    : VideoThermalCamera(name, profile, clock, [name, profile](const std::function<bool()>&) {
          return openThermalFrames(name, profile);
      }) {}

VideoThermalCamera::VideoThermalCamera(const std::string& name, ThermalProfile profile, const Clock& clock,
                                       Opener opener)
    : m_profile(std::move(profile)), m_clock(clock), m_capture(name, std::move(opener)) {}

Result<std::shared_ptr<const ThermalCameraFrame>> VideoThermalCamera::newest() {
    const auto taken = m_capture.newest();
    if (!taken)
        return taken.error();
    const NumberedPicture<CaughtThermalFrame>& newest = **taken;
    if (!m_newest || m_newest->number != newest.number) {
        const double age_s = m_steady.now_s() - newest.caught.caught_s;
        m_newest = std::make_shared<ThermalCameraFrame>(
            ThermalCameraFrame{m_clock.now_s() - age_s, newest.number, newest.caught.frame});
    }
    return m_newest;
}

} // namespace bask
