#pragma once
// A camera's intrinsics from views of a board, and how accurate they are in views that were not used.

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
    /// Root mean square over the corners of each view, by a camera calibrated without that view (five
    /// calibrations, each without a fifth of the views); the board's pose is fitted to the view. Empty below
    /// five views.
    std::optional<double> heldOut_px;
    double tilt_rad = 0.0; ///< largest angle between a view's board and the picture
    double turn_rad = 0.0; ///< largest angle between the boards of two views

    /// Returns the held-out error as a length across the line of sight at this distance.
    std::optional<double> heldOut_m(double distance_m) const;
    /// Returns the relative standard deviation of the focal lengths, the larger of the two.
    double focalDeviation() const;
    /// Returns two of these deviations as a length along the line of sight at this distance.
    double focalError_m(double distance_m) const { return 2.0 * focalDeviation() * distance_m; }
    /// Returns why the camera should not be used; empty if it can. ViewsStraightOn: boards tilted by less
    /// than 10 degrees against the picture do not determine a focal length, even if its deviation looks
    /// small. ViewsParallel: nor do boards turned by less than 2 degrees against one another, such as copies
    /// of one picture (Zhang, A flexible new technique for camera calibration, 2000, section 4).
    /// CalibrationUncertain: focal length not known to 10 %. CalibrationContradicts: residuals above 0.3 % of
    /// the picture's width.
    std::optional<Message> reasonAgainst() const;
};

inline constexpr std::size_t kMinCalibrationViews = 3;
inline constexpr std::size_t kMinHeldOutViews = 5;

/// Calibrates with cv::calibrateCamera, all parameters free; `coefficients` is 5 (k1 k2 p1 p2 k3) or 8. All
/// views have the size width x height. Residuals are distances between corners. `progress` receives the
/// number of finished fits and their total after each fit; `stop` is checked between them. Errors:
/// ViewsTooFew, CalibrationFailed (no camera explains the views), CalibrationCancelled.
Result<CameraCalibration> calibrateCamera(const std::vector<CalibrationView>& views, const Board& board,
                                          int width, int height, int coefficients,
                                          const std::stop_token& stop = {},
                                          const std::function<void(int, int)>& progress = {});

/// Returns the views that should be left out: residuals above twice the median. None below five views.
std::vector<std::size_t> viewsStandingOut(const std::vector<ViewResidual>& views);

/// Judges the position errors of the camera at this distance: across the line of sight from held-out views,
/// and along it from two standard deviations of the focal length. Good: 1 mm across and 2 mm along; Usable: 3
/// and 6 mm; Redo: worse, or reasonAgainst, or too few views for held-out ones. Reasons: CameraGood;
/// CameraMisfits (across, or some views stand out); CameraFocalUncertain (along); CameraUnchecked; those of
/// reasonAgainst.
Judgement judged(const CameraCalibration& calibration, double distance_m);

} // namespace bask
