#pragma once
// A camera: the newest frame, with its age.

#include "engine/base/result.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bask {

/// 8-bit picture, rows from the top, channels interleaved (1 grey, 3 BGR). Immutable once published.
struct CameraFrame {
    double time_s = 0.0;
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<std::uint8_t> pixels;
};

/// Captures on a thread of its own; newest() may be called from the engine thread and never waits.
class Camera {
public:
    virtual ~Camera() = default;
    /// Newest frame, or an Error when none came for a second.
    virtual Result<std::shared_ptr<const CameraFrame>> newest() = 0;
};

} // namespace bask
