#pragma once
// How a patient person holds a calibration board before a camera: from one view that tells something new to
// the next, still for a while at each.

#include "engine/base/pose.h"
#include "engine/calibration/board.h"
#include "engine/calibration/camera_model.h"

namespace bask {

inline constexpr int kHeldViews = 22;
inline constexpr double kBoardMoving_s = 0.7, kBoardStill_s = 0.8;

/// Light rim of a board's sheet round its pattern.
double boardMargin_m(const Board& board);

/// X_CB of the view `number` (of kHeldViews, again and again); B is the pattern's upper left corner, x right,
/// y down. The sheet lies within the picture of any camera that can be calibrated.
Pose heldBoardPose(const Board& board, const CameraModel& camera, int number);

/// Where it is so long after it was taken up: it moves to each view, then is still there.
Pose boardPoseAt(const Board& board, const CameraModel& camera, double time_s);
/// When it is still at the view, in the middle of that time.
double stillTime_s(int number);

} // namespace bask
