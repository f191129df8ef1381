#pragma once
// A camera with OpenCV, captured on its own thread: a device, a stream, a video file or a folder.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/frame_source.h"

#include <functional>
#include <string>

namespace bask {

/// Two pictures of a live camera are never equal, so a repeated picture is ignored. A capture that hangs is
/// abandoned and another one is started, at most kMaxHanging in the process; after that it waits.
class VideoCamera final : public Camera {
public:
    static constexpr double kLost_s = 1.0;
    static constexpr double kOpening_s = 5.0; ///< CameraOpening is returned for this long without an answer
    static constexpr double kHanging_s = 3.0; ///< longest time without an answer of the system
    static constexpr double kFarewell_s = 0.5;
    static constexpr int kMaxHanging = 8;

    using Opener =
        std::function<Result<std::unique_ptr<FrameSource>>(const std::function<bool()>& isStopped)>;

    /// `name` as in openFrameSource; opened on the capture thread. `clock` is read only by newest() and must
    /// outlive the camera.
    VideoCamera(std::string name, const Clock& clock);
    /// Uses another function for opening, for tests.
    VideoCamera(std::string name, const Clock& clock, Opener opener);
    /// Waits for at most kFarewell_s.
    ~VideoCamera() override;
    VideoCamera(const VideoCamera&) = delete;
    VideoCamera& operator=(const VideoCamera&) = delete;

    Result<std::shared_ptr<const CameraFrame>> newest() override;

    static int hanging(); ///< number of abandoned captures that have not returned

private:
    class Capture;

    void beginAgainWhenHanging(double now_s);
    Error absence(double now_s) const;

    std::string m_name;
    const Clock& m_clock;
    SteadyClock m_steady;
    Opener m_opener;
    double m_began_s;
    std::shared_ptr<Capture> m_capture;
    std::shared_ptr<const CameraFrame> m_newest;
};

} // namespace bask
