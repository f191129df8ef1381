#pragma once
// Reads a camera's pictures one after another, from a device, a stream, a video file or a folder.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <functional>
#include <memory>
#include <string>

namespace bask {

struct CaughtPicture {
    GreyPicture picture;
    double caught_s = 0.0; ///< exposure time on SteadyClock
};

/// Use it on one thread, which it may block for as long as the system takes.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// Returns the next picture. Errors: CameraNotOpened with the reason; the source cannot be used after
    /// that.
    virtual Result<CaughtPicture> next() = 0;
    /// Returns the time between pictures of a recording; 0 for a live camera, where noise makes any two
    /// pictures different.
    virtual double period_s() const { return 0.0; }
    /// Returns whether it is better to wait for a next() that does not return, because it will continue where
    /// it stopped.
    virtual bool isWaitedFor() const { return false; }
};

/// Opens "0" (number of a camera), "/dev/video0", "rtsp://host/stream", a FIFO with a video in it; a video
/// file, at its own rate; a picture, or a folder of pictures in order of their names, ten per second. Files
/// and folders start again at their end. All pictures of a folder are read first, so that a bad one is
/// reported at once. For a FIFO it waits for a writer until `isStopped`. Errors: CameraNotOpened.
Result<std::unique_ptr<FrameSource>> openFrameSource(const std::string& name,
                                                     const std::function<bool()>& isStopped);

} // namespace bask
