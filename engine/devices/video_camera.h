#pragma once
// A camera with OpenCV, captured on its own thread: a device, a stream, a video file or a folder.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/frame_source.h"

#include <memory>
#include <string>

namespace bask {

class VideoCamera final : public Camera {
public:
    static constexpr double kHanging_s = BackgroundCapture<CaughtPicture>::kHanging_s;
    static constexpr int kMaxHanging = BackgroundCapture<CaughtPicture>::kMaxHanging;

    using Opener = CaptureOpener<CaughtPicture>;

    /// `name` as in openFrameSource; opened on the capture thread. `clock` is read only by newest() and must
    /// outlive the camera.
    VideoCamera(std::string name, const Clock& clock);
    /// Uses another function for opening, for tests.
    VideoCamera(std::string name, const Clock& clock, Opener opener);

    Result<std::shared_ptr<const CameraFrame>> newest() override;

    static int hanging(); ///< number of abandoned captures that have not returned

private:
    const Clock& m_clock;
    SteadyClock m_steady;
    BackgroundCapture<CaughtPicture> m_capture;
    std::shared_ptr<const CameraFrame> m_newest;
};

} // namespace bask
