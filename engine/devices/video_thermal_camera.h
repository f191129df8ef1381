#pragma once
// A thermal camera captured on its own thread: a device with 16 bits a pixel, or a recording.

#include "engine/base/clock.h"
#include "engine/devices/thermal_camera.h"
#include "engine/devices/thermal_frame_source.h"

#include <atomic>
#include <memory>
#include <string>

namespace bask {

/// Repeated frames of a live camera are those of its closed shutter, and are ignored; frames tell when it was
/// open again (ShutterWatch), until the camera is opened anew. Drivers and formats
/// were tried with recorded bytes and a device that a test plays, never with a camera.
class VideoThermalCamera final : public ThermalCamera {
public:
    using Opener = CaptureOpener<CaughtThermalFrame>;

    /// `name` as in openThermalFrames; opened on the capture thread. `clock` is read only by newest() and
    /// must outlive the camera.
    VideoThermalCamera(const std::string& name, const ThermalProfile& profile, const Clock& clock);
    /// Uses another function for opening, for tests.
    VideoThermalCamera(const std::string& name, ThermalProfile profile, const Clock& clock, Opener opener);

    Result<std::shared_ptr<const ThermalCameraFrame>> newest() override;
    const ThermalProfile& profile() const override { return m_profile; }
    LeftOutPictures leftOut() const override { return m_capture.leftOut(); }

private:
    using ShutterTime = std::shared_ptr<std::atomic<double>>; ///< on SteadyClock; NaN: not known
    static Opener watched(Opener opener, const ThermalProfile& profile, ShutterTime shutter_s);

    ThermalProfile m_profile;
    const Clock& m_clock;
    SteadyClock m_steady;
    ShutterTime m_shutter_s; ///< written by the capture's thread
    BackgroundCapture<CaughtThermalFrame> m_capture;
    std::shared_ptr<const ThermalCameraFrame> m_newest;
};

} // namespace bask
