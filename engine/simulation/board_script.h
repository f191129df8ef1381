#pragma once
// How a patient person moves a calibration board in front of a camera: from one view with new information to
// the next, and still for a while at each.

#include "engine/base/pose.h"
#include "engine/calibration/board.h"
#include "engine/calibration/camera_model.h"

namespace bask {

inline constexpr int kBoardViews = 22;
inline constexpr double kBoardMoving_s = 0.7, kBoardStill_s = 0.8;

/// Returns the width of the light margin of a board's sheet around its pattern.
double boardMargin_m(const Board& board);

/// Returns X_CB of the view `number` (they repeat after kBoardViews); B is the pattern's upper left corner, x
/// right, y down. The sheet is inside the picture of any camera that can be calibrated.
Pose scriptedBoardPose(const Board& board, const CameraModel& camera, int number);

/// Returns the pose at this time after the start: the board moves to each view, then is still there.
Pose boardPoseAt(const Board& board, const CameraModel& camera, double time_s);
/// Returns the middle of the time at which the board is still at the view.
double stillTime_s(int number);

} // namespace bask
