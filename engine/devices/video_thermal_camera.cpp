#include "engine/devices/video_thermal_camera.h"

#include "engine/devices/shutter_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Frames of a source, with a look at when they came.
class WatchedFrames final : public ThermalFrameSource {
public:
    WatchedFrames(std::unique_ptr<ThermalFrameSource> source, std::optional<double> frameRate_Hz,
                  std::shared_ptr<std::atomic<double>> shutter_s)
        : m_source(std::move(source)), m_watch(frameRate_Hz), m_shutter_s(std::move(shutter_s)) {}

    Result<CaughtThermalFrame> next() override {
        auto caught = m_source->next();
        const bool isLive = m_source->period_s() == 0.0;
        if (!caught || !isLive || (m_before && isSamePicture(*caught, *m_before)))
            return caught;
        m_watch.add(caught->caught_s);
        *m_shutter_s = m_watch.opened_s().value_or(kNaN);
        m_before = *caught;
        return caught;
    }
    double period_s() const override { return m_source->period_s(); }
    bool isWaitedFor() const override { return m_source->isWaitedFor(); }

private:
    std::unique_ptr<ThermalFrameSource> m_source;
    ShutterWatch m_watch;
    std::shared_ptr<std::atomic<double>> m_shutter_s;
    std::optional<CaughtThermalFrame> m_before;
};

} // namespace

VideoThermalCamera::VideoThermalCamera(const std::string& name, const ThermalProfile& profile,
                                       const Clock& clock)
    : VideoThermalCamera(name, profile, clock, [name, profile](const std::function<bool()>&) {
          return openThermalFrames(name, profile);
      }) {}

VideoThermalCamera::VideoThermalCamera(const std::string& name, ThermalProfile profile, const Clock& clock,
                                       Opener opener)
    : m_profile(std::move(profile)), m_clock(clock), m_shutter_s(std::make_shared<std::atomic<double>>(kNaN)),
      m_capture(name, watched(std::move(opener), m_profile, m_shutter_s)) {}

VideoThermalCamera::Opener VideoThermalCamera::watched(Opener opener, const ThermalProfile& profile,
                                                       ShutterTime shutter_s) {
    return [opener = std::move(opener), rate_Hz = profile.frameRate_Hz,
            shutter_s = std::move(shutter_s)](const std::function<bool()>& isStopped) {
        auto source = opener(isStopped);
        *shutter_s = kNaN;
        if (source)
            source = std::unique_ptr<ThermalFrameSource>(
                std::make_unique<WatchedFrames>(std::move(*source), rate_Hz, shutter_s));
        return source;
    };
}

Result<std::shared_ptr<const ThermalCameraFrame>> VideoThermalCamera::newest() {
    const auto taken = m_capture.newest();
    if (!taken)
        return taken.error();
    const NumberedPicture<CaughtThermalFrame>& newest = **taken;
    if (!m_newest || m_newest->number != newest.number) {
        const double age_s = m_steady.now_s() - newest.caught.caught_s;
        ThermalCameraFrame frame{m_clock.now_s() - age_s, newest.number, newest.caught.frame};
        if (const double shutter_s = *m_shutter_s; std::isfinite(shutter_s))
            frame.shutter_s = std::min(frame.time_s, frame.time_s + shutter_s - newest.caught.caught_s);
        m_newest = std::make_shared<ThermalCameraFrame>(std::move(frame));
    }
    return m_newest;
}

} // namespace bask
