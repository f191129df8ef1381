#pragma once
// A camera's intrinsics from views of a board, and how well they hold in views that they were not made from.

#include "engine/calibration/board_finder.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/verdict.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

struct CalibrationView {
    std::string name;
    BoardView board;
};

struct CameraCalibration {
    CameraModel camera;
    /// Root mean square over the corners of each view, by a camera that was made without it (of five such,
    /// each without a fifth of the views); the board's pose is the view's own. Nothing below five views.
    std::optional<double> heldOut_px;
    double tilt_rad = 0.0; ///< largest angle between a view's board and the picture
    double turn_rad = 0.0; ///< largest angle between the boards of two views

    /// The same as a length across the line of sight, so far from the camera.
    std::optional<double> heldOut_m(double distance_m) const;
    /// Standard deviation of the focal lengths, the larger of the two, relative.
    double focalDeviation() const;
    /// What two of them are as a length along the line of sight, so far from the camera.
    double focalError_m(double distance_m) const { return 2.0 * focalDeviation() * distance_m; }
    /// Why the camera should not be used: ViewsStraightOn (boards tilted by less than 10 degrees
    /// against the picture tell no focal length, however small its deviation looks), ViewsParallel (nor do
    /// boards turned by less than 2 degrees against one another, such as copies of one picture: Zhang, A
    /// flexible new technique for camera calibration, 2000, section 4), CalibrationUncertain (focal length to
    /// 10 %), CalibrationContradicts (residuals above 0.3 % of the picture's width).
    std::optional<Message> reasonAgainst() const;
};

inline constexpr std::size_t kMinCalibrationViews = 3;
inline constexpr std::size_t kMinHeldOutViews = 5;

/// By cv::calibrateCamera, all parameters free; `coefficients` is 5 (k1 k2 p1 p2 k3) or 8. All views have the
/// size width x height. Residuals are distances between corners. `progress` hears after each fit how many of
/// how many are done; `stop` is asked between them. Errors: ViewsTooFew, CalibrationFailed (views that no
/// camera explains), CalibrationCancelled.
Result<CameraCalibration> calibrateCamera(const std::vector<CalibrationView>& views, const Board& board,
                                          int width, int height, int coefficients,
                                          const std::stop_token& stop = {},
                                          const std::function<void(int, int)>& progress = {});

/// Views that had better be left out: residuals above twice the median. None below five views.
std::vector<std::size_t> viewsStandingOut(const std::vector<ViewResidual>& views);

/// How far off the camera shows things so far away: across the line of sight as held-out views have it, and
/// along it by two standard deviations of the focal length. Good: 1 mm across and 2 mm along; Usable: 3 and
/// 6 mm; Redo: worse, what reasonAgainst says, or too few views to hold some out. Reasons: CameraGood;
/// CameraMisfits (across, or views stand out) or CameraFocalUncertain (along); CameraUnchecked; those of
/// reasonAgainst.
Judgement judged(const CameraCalibration& calibration, double distance_m);

} // namespace bask
