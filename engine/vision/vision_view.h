#pragma once
// What the window shows of a live camera: the picture and what was found in it. Contains values, never the
// camera.

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
    std::optional<Part> part; ///< the part that carries it in the experiment; empty: not listed
    /// Its poses from this marker alone; empty without a calibrated camera or a known side.
    std::optional<MarkerPoses> poses;
    double side_m = 0.0; ///< as listed in the experiment; 0: not listed
};

/// The result for one picture.
struct VisionView {
    std::string cameraName;
    std::shared_ptr<const CameraFrame> frame; ///< null before the first
    Message problem;                          ///< such as CameraLost; code None if the camera answers
    double rate_Hz = 0.0;                     ///< processed pictures per second
    double latency_s = 0.0;                   ///< from the exposure to the known poses
    std::vector<ViewedMarker> markers;
    /// The result of findBoard; empty if no board is searched.
    std::optional<Result<BoardView>> board;
    std::optional<Board> boardSeen;     ///< the board that the picture shows, if it can be determined
    std::optional<TrackState> tracking; ///< of the source; empty: not tracked
    std::optional<TrackedPose> source;  ///< X_CS as tracked
};

} // namespace bask
