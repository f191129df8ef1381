#pragma once
// The interface of a thermal camera: the newest frame, with its age.

#include "engine/base/left_out_pictures.h"
#include "engine/base/result.h"
#include "engine/thermography/frame_decoder.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace bask {

/// Immutable once it is published.
struct ThermalCameraFrame {
    double time_s = 0.0;      ///< when it was taken, on the engine's clock
    std::uint64_t number = 0; ///< increases with every frame of a camera
    ThermalFrame frame;
    /// When the camera's shutter was last seen to open before this frame, on the engine's clock; empty: that
    /// is not known.
    std::optional<double> shutter_s{};
};

/// Captures in the background; newest() may be called from any one thread and never waits.
class ThermalCamera {
public:
    virtual ~ThermalCamera() = default;
    /// Returns the newest frame, the same one again until there is a newer one, and while the camera's
    /// shutter is closed. Errors: those of Camera::newest.
    virtual Result<std::shared_ptr<const ThermalCameraFrame>> newest() = 0;
    virtual const ThermalProfile& profile() const = 0;
    /// Returns the frames so far that could not be used.
    virtual LeftOutPictures leftOut() const { return {}; }
};

} // namespace bask
