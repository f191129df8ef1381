#pragma once
// Where the source is, measured while it is moved.

#include "engine/base/pose.h"
#include "engine/base/result.h"

namespace bask {

/// One reading of a pose; one that was not seen is invalid, never a pose.
struct PoseReading {
    double time_s = 0.0; ///< when it was measured, on the engine's clock
    Pose X_RS = Pose::Identity();
    bool valid = false;
};

/// Used on the engine thread only.
class SourceTracker {
public:
    virtual ~SourceTracker() = default;
    /// Newest reading, or an Error when the device does not answer.
    virtual Result<PoseReading> read() = 0;
};

} // namespace bask
