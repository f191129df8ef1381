#pragma once
// A camera: the newest frame, with its age.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <cstdint>
#include <memory>

namespace bask {

/// Immutable once published.
struct CameraFrame {
    double time_s = 0.0;      ///< when its light was caught, on the engine's clock
    double caught_s = 0.0;    ///< the same on the computer's SteadyClock: pose time minus this is the latency
    std::uint64_t number = 0; ///< grows with every frame of a camera
    GreyPicture picture;
};

/// Captures by itself; newest() may be called from any one thread and never waits.
class Camera {
public:
    virtual ~Camera() = default;
    /// The newest frame, the same again while there is no newer one. Errors: CameraOpening before the first;
    /// CameraNotOpened when it cannot be had; CameraLost when none came for a second; both with the reason as
    /// far as the system told it, and it is sought again meanwhile.
    virtual Result<std::shared_ptr<const CameraFrame>> newest() = 0;
};

} // namespace bask
