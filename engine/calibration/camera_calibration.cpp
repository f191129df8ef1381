#include "engine/calibration/camera_calibration.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace bask {
namespace {

struct Corners {
    std::vector<cv::Point3f> board;
    std::vector<cv::Point2f> seen;
};

Corners cornersOf(const CalibrationView& view, const Board& board) {
    Corners corners;
    for (std::size_t k = 0; k < view.board.corners.size(); ++k) {
        const Eigen::Vector2d at = cornerOf(board, view.board.corners[k]), p = view.board.corners_px[k];
        corners.board.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F);
        corners.seen.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
    return corners;
}

struct Solution {
    double rms_px = 0.0;
    cv::Mat matrix, distortion, deviations, viewErrors;
    std::vector<cv::Mat> rotations;
};

Solution solve(const std::vector<Corners>& views, cv::Size size, int coefficients) {
    std::vector<std::vector<cv::Point3f>> board;
    std::vector<std::vector<cv::Point2f>> seen;
    for (const Corners& view : views) {
        board.push_back(view.board);
        seen.push_back(view.seen);
    }
    Solution s;
    cv::Mat ofPoses;
    std::vector<cv::Mat> translations;
    s.rms_px = cv::calibrateCamera(board, seen, size, s.matrix, s.distortion, s.rotations, translations,
                                   s.deviations, ofPoses, s.viewErrors,
                                   coefficients == 8 ? cv::CALIB_RATIONAL_MODEL : 0);
    return s;
}

// Sum of the squared distances between the corners seen and shown, with the pose that suits them best.
double squaredError(const Corners& view, const Solution& s) {
    cv::Mat rotation, translation;
    cv::solvePnP(view.board, view.seen, s.matrix, s.distortion, rotation, translation);
    std::vector<cv::Point2f> shown;
    cv::projectPoints(view.board, rotation, translation, s.matrix, s.distortion, shown);
    return std::pow(cv::norm(shown, view.seen), 2);
}

constexpr std::size_t kParts = kMinHeldOutViews; // of the views, each held out once

// Nothing for too few views, or when it is stopped. `fitted` hears of each part.
std::optional<double> heldOut(const std::vector<Corners>& views, cv::Size size, int coefficients,
                              const std::stop_token& stop, const std::function<void()>& fitted) {
    if (views.size() < kParts)
        return std::nullopt;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t part = 0; part < kParts; ++part) {
        if (stop.stop_requested())
            return std::nullopt;
        std::vector<Corners> kept, out;
        for (std::size_t k = 0; k < views.size(); ++k)
            (k % kParts == part ? out : kept).push_back(views[k]);
        const Solution s = solve(kept, size, coefficients);
        fitted();
        for (const Corners& view : out) {
            sum += squaredError(view, s);
            count += view.seen.size();
        }
    }
    return std::sqrt(sum / static_cast<double>(count));
}

// The boards' normals in the camera's frame.
std::vector<Eigen::Vector3d> normalsOf(const std::vector<cv::Mat>& rotations) {
    std::vector<Eigen::Vector3d> normals;
    for (const cv::Mat& rotation : rotations) {
        cv::Matx33d turn;
        cv::Rodrigues(rotation, turn);
        normals.emplace_back(turn(0, 2), turn(1, 2), turn(2, 2));
    }
    return normals;
}

double tiltOf(const std::vector<Eigen::Vector3d>& normals) {
    double min = 1.0; // cosine
    for (const Eigen::Vector3d& normal : normals)
        min = std::min(min, std::abs(normal.z()));
    return std::acos(min);
}

double turnOf(const std::vector<Eigen::Vector3d>& normals) {
    double max_rad = 0.0;
    for (const Eigen::Vector3d& a : normals)
        for (const Eigen::Vector3d& b : normals)
            max_rad = std::max(max_rad, std::atan2(a.cross(b).norm(), a.dot(b)));
    return max_rad;
}

CameraModel cameraOf(const Solution& s, int coefficients) {
    CameraModel camera;
    camera.fx = s.matrix.at<double>(0, 0);
    camera.fy = s.matrix.at<double>(1, 1);
    camera.cx = s.matrix.at<double>(0, 2);
    camera.cy = s.matrix.at<double>(1, 2);
    for (int k = 0; k < coefficients; ++k)
        camera.distortion.push_back(s.distortion.at<double>(k));
    for (int k = 0; k < 4 + coefficients; ++k)
        camera.deviations.push_back(s.deviations.at<double>(k));
    camera.rms_px = s.rms_px;
    return camera;
}

bool isPlausible(const CameraModel& camera) {
    const auto finite = [](double v) { return std::isfinite(v); };
    return camera.fx > 0.0 && camera.fy > 0.0 && finite(camera.fx + camera.fy + camera.cx + camera.cy) &&
           finite(*camera.rms_px) && std::ranges::all_of(camera.distortion, finite) &&
           std::ranges::all_of(camera.deviations, finite);
}

} // namespace

std::optional<double> CameraCalibration::heldOut_m(double distance_m) const {
    if (!heldOut_px)
        return std::nullopt;
    return *heldOut_px * distance_m / (0.5 * (camera.fx + camera.fy));
}

double CameraCalibration::focalDeviation() const {
    return std::max(camera.deviations.at(0) / camera.fx, camera.deviations.at(1) / camera.fy);
}

std::optional<Message> CameraCalibration::reasonAgainst() const {
    constexpr double kMinTilt_deg = 10.0, kMinTurn_deg = 2.0, kMaxDeviation = 0.1, kMaxResidual = 0.003;
    if (const double tilt_deg = degFromRad(tilt_rad); tilt_deg < kMinTilt_deg)
        return Message{MessageCode::ViewsStraightOn, {formatNumber(tilt_deg, 2), formatNumber(kMinTilt_deg)}};
    if (const double turn_deg = degFromRad(turn_rad); turn_deg < kMinTurn_deg)
        return Message{MessageCode::ViewsParallel, {formatNumber(turn_deg, 2), formatNumber(kMinTurn_deg)}};
    if (focalDeviation() > kMaxDeviation)
        return Message{MessageCode::CalibrationUncertain,
                       {formatNumber(100.0 * focalDeviation(), 2), formatNumber(100.0 * kMaxDeviation)}};
    if (const double max_px = kMaxResidual * camera.width; *camera.rms_px > max_px)
        return Message{MessageCode::CalibrationContradicts,
                       {formatNumber(*camera.rms_px, 3), formatNumber(max_px, 2)}};
    return std::nullopt;
}

Result<CameraCalibration> calibrateCamera(const std::vector<CalibrationView>& views, const Board& board,
                                          int width, int height, int coefficients,
                                          const std::stop_token& stop,
                                          const std::function<void(int, int)>& progress) {
    if (views.size() < kMinCalibrationViews)
        return Error{MessageCode::ViewsTooFew,
                     "",
                     {std::to_string(views.size()), std::to_string(kMinCalibrationViews)}};
    std::vector<Corners> corners;
    for (const CalibrationView& view : views)
        corners.push_back(cornersOf(view, board));
    const cv::Size size(width, height);
    const int fits = views.size() < kParts ? 1 : 1 + static_cast<int>(kParts);
    int done = 0;
    const std::function<void()> fitted = [&] {
        if (progress)
            progress(++done, fits);
    };
    try {
        const Solution solution = solve(corners, size, coefficients);
        fitted();
        const std::vector<Eigen::Vector3d> normals = normalsOf(solution.rotations);
        CameraCalibration result{cameraOf(solution, coefficients),
                                 heldOut(corners, size, coefficients, stop, fitted), tiltOf(normals),
                                 turnOf(normals)};
        if (stop.stop_requested())
            return Error{MessageCode::CalibrationCancelled, ""};
        result.camera.width = width;
        result.camera.height = height;
        result.camera.board = boardText(board);
        for (std::size_t k = 0; k < views.size(); ++k)
            result.camera.views.push_back(
                {views[k].name, solution.viewErrors.at<double>(static_cast<int>(k))});
        if (isPlausible(result.camera))
            return result;
    } catch (const cv::Exception&) { // views that determine no camera
    }
    return Error{MessageCode::CalibrationFailed, ""};
}

std::vector<std::size_t> viewsStandingOut(const std::vector<ViewResidual>& views) {
    constexpr double kOften = 2.0;
    std::vector<std::size_t> out;
    if (views.size() < kMinHeldOutViews)
        return out;
    std::vector<double> residuals;
    for (const ViewResidual& view : views)
        residuals.push_back(view.rms_px);
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::ranges::nth_element(residuals, middle);
    for (std::size_t k = 0; k < views.size(); ++k)
        if (views[k].rms_px > kOften * *middle)
            out.push_back(k);
    return out;
}

Judgement judged(const CameraCalibration& calibration, double distance_m) {
    if (auto reason = calibration.reasonAgainst())
        return {Verdict::Redo, *reason};
    const std::optional<double> across_m = calibration.heldOut_m(distance_m);
    if (!across_m)
        return {Verdict::Redo,
                {MessageCode::CameraUnchecked,
                 {std::to_string(calibration.camera.views.size()), std::to_string(kMinHeldOutViews)}}};
    // Source and end-effector are seen by the same camera and share most of an error along the line of sight.
    const double along_m = calibration.focalError_m(distance_m), counted_m = 0.5 * along_m;
    const double worse_m = std::max(*across_m, counted_m);
    const Verdict verdict = worse_m <= 1e-3   ? Verdict::Good
                            : worse_m <= 3e-3 ? Verdict::Usable
                                              : Verdict::Redo;
    const bool isMisfit = *across_m > counted_m || !viewsStandingOut(calibration.camera.views).empty();
    const MessageCode code = verdict == Verdict::Good ? MessageCode::CameraGood
                             : isMisfit               ? MessageCode::CameraMisfits
                                                      : MessageCode::CameraFocalUncertain;
    return {
        verdict,
        {code,
         {formatNumber(1e3 * *across_m, 2), formatNumber(1e3 * along_m, 2), formatNumber(distance_m, 3)}}};
}

} // namespace bask
