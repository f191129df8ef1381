#pragma once
// A camera by OpenCV, captured on a thread of its own: a device, a stream, a video file or a folder.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/frame_source.h"

#include <functional>
#include <string>

namespace bask {

/// Two pictures of a live camera are never the same: one that comes again counts as none. A capture that
/// hangs is left to itself and another one begun; at most kMaxHanging in the process, then it is waited for.
class VideoCamera final : public Camera {
public:
    static constexpr double kLost_s = 1.0;
    static constexpr double kOpening_s = 5.0; ///< so long CameraOpening is told when there is no answer
    static constexpr double kHanging_s = 3.0; ///< without an answer of the system
    static constexpr double kFarewell_s = 0.5;
    static constexpr int kMaxHanging = 8;

    using Opener =
        std::function<Result<std::unique_ptr<FrameSource>>(const std::function<bool()>& isStopped)>;

    /// `name` as of openFrameSource; opened on the capture thread. `clock`, which is asked by newest() only,
    /// must outlive the camera.
    VideoCamera(std::string name, const Clock& clock);
    /// With another way of opening, for tests.
    VideoCamera(std::string name, const Clock& clock, Opener opener);
    /// Waits for kFarewell_s at most.
    ~VideoCamera() override;
    VideoCamera(const VideoCamera&) = delete;
    VideoCamera& operator=(const VideoCamera&) = delete;

    Result<std::shared_ptr<const CameraFrame>> newest() override;

    static int hanging(); ///< captures left to themselves that have not come back

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
