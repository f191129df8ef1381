#pragma once
// Reads a thermal camera's frames one after another, from the camera or from a recording.

#include "engine/devices/background_capture.h"
#include "engine/thermography/camera_profile.h"
#include "engine/thermography/frame_decoder.h"

namespace bask {

struct CaughtThermalFrame {
    ThermalFrame frame;
    double caught_s = 0.0; ///< exposure time on SteadyClock
};
bool isSamePicture(const CaughtThermalFrame& a, const CaughtThermalFrame& b);

using ThermalFrameSource = CaptureSource<CaughtThermalFrame>;

/// Opens "0" (number of a camera) or "/dev/video0", whose frames have to be those of the profile, byte for
/// byte; a file of one frame or several; or a folder of frames, which are played at their times and begin
/// again at their end. A single frame that cannot be used is an error of next(), and the next one follows. A
/// frame is read at once, so that a wrong profile is told when it is opened. Errors: CameraNotOpened.
Result<std::unique_ptr<ThermalFrameSource>> openThermalFrames(const std::string& name,
                                                              const ThermalProfile& profile);

} // namespace bask
