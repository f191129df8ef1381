#pragma once
// Where a camera's pictures come from: a device, a stream, a video file or a folder, read one after another.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <functional>
#include <memory>
#include <string>

namespace bask {

struct CaughtPicture {
    GreyPicture picture;
    double caught_s = 0.0; ///< on SteadyClock
};

/// Used on one thread, which it may hold up for as long as the system likes.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// The next picture. Errors: CameraNotOpened with the reason; the source is of no use then.
    virtual Result<CaughtPicture> next() = 0;
    /// Time between the pictures of what is played; 0: live, where two are never the same for their noise.
    virtual double period_s() const { return 0.0; }
    /// Whether a next() that does not return is best waited for: it goes on where it stopped.
    virtual bool isWaitedFor() const { return false; }
};

/// "0" (number of a camera), "/dev/video0", "rtsp://host/stream", a FIFO with a video in it; a video file, at
/// its own rate, a picture or a folder of pictures in order of their names, ten a second: these begin again
/// at their end. A folder's pictures are all looked at first, so that a bad one is told at once. Waits for
/// somebody to write into a FIFO until `isStopped`. Errors: CameraNotOpened.
Result<std::unique_ptr<FrameSource>> openFrameSource(const std::string& name,
                                                     const std::function<bool()>& isStopped);

} // namespace bask
