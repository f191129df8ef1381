#pragma once
// The interface of a camera: the newest frame, with its age.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <cstdint>
#include <memory>

namespace bask {

/// Immutable once it is published.
struct CameraFrame {
    double time_s = 0.0; ///< exposure time, on the engine's clock
    /// The same on the computer's SteadyClock: the time of the pose minus this is the latency.
    double caught_s = 0.0;
    std::uint64_t number = 0; ///< increases with every frame of a camera
    GreyPicture picture;
};

/// Captures in the background; newest() may be called from any one thread and never waits.
class Camera {
public:
    virtual ~Camera() = default;
    /// Returns the newest frame, the same one again until there is a newer one. Errors: CameraOpening before
    /// the first frame; CameraNotOpened if the camera cannot be opened; CameraLost if no frame came for a
    /// second. The last two contain the reason given by the system; the camera is opened again in the
    /// background.
    virtual Result<std::shared_ptr<const CameraFrame>> newest() = 0;
};

} // namespace bask
