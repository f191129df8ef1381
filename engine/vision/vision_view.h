#pragma once
// What the window is shown of a live camera: the picture and what was found in it. Values, never the camera.

#include "engine/base/message.h"
#include "engine/calibration/board_finder.h"
#include "engine/calibration/marker_pose.h"
#include "engine/vision/part_tracker.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

struct ViewedMarker {
    FoundMarker marker;
    std::optional<Part> part; ///< that the experiment says it sits on; empty: not listed
    /// By itself; empty without a calibrated camera or a known side.
    std::optional<MarkerPoses> poses;
    double side_m = 0.0; ///< as the experiment has it; 0: not listed
};

/// One look at the newest picture.
struct VisionView {
    std::string cameraName;
    std::shared_ptr<const CameraFrame> frame; ///< null before the first
    Message problem;                          ///< CameraLost and its like; code None: the camera answers
    double rate_Hz = 0.0;                     ///< pictures looked at a second
    double latency_s = 0.0;                   ///< from the light caught to the poses known
    std::vector<ViewedMarker> markers;
    /// What was looked for: findBoard's answer; empty: no board is looked for.
    std::optional<Result<BoardView>> board;
    std::optional<Board> boardSeen;     ///< what the picture shows, where it tells
    std::optional<TrackState> tracking; ///< of the source; empty: not tracked
    std::optional<TrackedPose> source;  ///< X_CS as tracked
};

} // namespace bask
