#pragma once
// The source's pose, measured while it is moved.

#include "engine/base/pose.h"
#include "engine/base/result.h"

namespace bask {

/// One reading of a pose; if the source was not seen, it is invalid and contains no pose.
struct PoseReading {
    double time_s = 0.0; ///< time of the pose, on the engine's clock; the present time if it is extrapolated
    Pose X_RS = Pose::Identity();
    bool valid = false;
    /// When the source was last seen, on the same clock: gives the age of the reading.
    double seen_s = 0.0;
    /// From the exposure of the newest frame to its known pose; 0: unknown.
    double latency_s = 0.0;
    bool predicted = false;                   ///< whether the newest frame did not show it
    double position_m = 0.0, angle_rad = 0.0; ///< two standard deviations in the worst direction; 0: unknown
};

/// Use it only on the engine thread.
class SourceTracker {
public:
    virtual ~SourceTracker() = default;
    /// Returns the newest reading, or an Error if the device does not answer.
    virtual Result<PoseReading> read() = 0;
};

} // namespace bask
