#pragma once
// Where the source is, measured while it is moved.

#include "engine/base/pose.h"
#include "engine/base/result.h"

namespace bask {

/// One reading of a pose; one that was not seen is invalid, never a pose.
struct PoseReading {
    double time_s =
        0.0; ///< what the pose stands for, on the engine's clock: now where it is carried on to now
    Pose X_RS = Pose::Identity();
    bool valid = false;
    /// When the source was last seen, on the same clock: how old the reading is.
    double seen_s = 0.0;
    double latency_s = 0.0; ///< from the light of the newest frame to its pose known; 0: not told
    bool predicted = false; ///< the newest frame did not show it
    double position_m = 0.0, angle_rad = 0.0; ///< two standard deviations in the worst direction; 0: not told
};

/// Used on the engine thread only.
class SourceTracker {
public:
    virtual ~SourceTracker() = default;
    /// Newest reading, or an Error when the device does not answer.
    virtual Result<PoseReading> read() = 0;
};

} // namespace bask
