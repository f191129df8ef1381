#pragma once
// Reads a camera's pictures one after another, from a device, a stream, a video file or a folder.

#include "engine/devices/background_capture.h"
#include "engine/shape/marker.h"

#include <functional>
#include <memory>
#include <string>

namespace bask {

struct CaughtPicture {
    GreyPicture picture;
    double caught_s = 0.0; ///< exposure time on SteadyClock
};

bool isSamePicture(const CaughtPicture& a, const CaughtPicture& b);

using FrameSource = CaptureSource<CaughtPicture>;

/// Returns whether a name is the number of a camera, "0" to "999".
bool isCameraNumber(const std::string& name);
/// Returns the device of a camera's number; any other name is returned.
std::string cameraDevice(const std::string& name);

/// Opens "0" (number of a camera), "/dev/video0", "rtsp://host/stream", a FIFO with a video in it; a video
/// file, at its own rate; a picture, or a folder of pictures in order of their names, ten per second. Files
/// and folders start again at their end. All pictures of a folder are read first, so that a bad one is
/// reported at once. For a FIFO it waits for a writer until `isStopped`. Errors: CameraNotOpened.
Result<std::unique_ptr<FrameSource>> openFrameSource(const std::string& name,
                                                     const std::function<bool()>& isStopped);

} // namespace bask
