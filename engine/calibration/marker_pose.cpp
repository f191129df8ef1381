#include "engine/calibration/marker_pose.h"

#include <opencv2/calib3d.hpp>

#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kCorner_px = 0.2; // standard deviation of a corner's coordinate that is taken for granted
constexpr double kSameAngle_rad = 0.01; // solutions that refining brings so near are one

double squaredError(const MarkerPose& pose) {
    return 4.0 * pose.rms_px * pose.rms_px;
}

bool isAmbiguous(const MarkerPose& best, const MarkerPose& second) {
    // Eight coordinates less six of the pose leave two from which the corners' variance is told.
    const double variance = std::max(kCorner_px * kCorner_px, 0.5 * squaredError(best));
    return std::abs(squaredError(second) - squaredError(best)) < 9.0 * variance;
}

double angleBetween(const MarkerPose& a, const MarkerPose& b) {
    return Eigen::AngleAxisd(a.X_CM().linear().transpose() * b.X_CM().linear()).angle();
}

} // namespace

Pose MarkerPose::X_CM() const {
    return poseFromRotationVector({translation_m[0], translation_m[1], translation_m[2]},
                                  {rotation_rad[0], rotation_rad[1], rotation_rad[2]});
}

std::optional<MarkerPoses> markerPoses(const std::array<Eigen::Vector2d, 4>& corners_px, double side_m,
                                       const CameraModel& camera) {
    const double h = 0.5 * side_m;
    const std::vector<cv::Point3d> square{{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
    std::vector<cv::Point2d> seen;
    for (const Eigen::Vector2d& p : corners_px)
        seen.emplace_back(p.x(), p.y());
    const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    const auto judged = [&](const cv::Mat1d& r, const cv::Mat1d& t) {
        std::vector<cv::Point2d> shown;
        cv::projectPoints(square, r, t, matrix, camera.distortion, shown);
        return MarkerPose{{r(0), r(1), r(2)}, {t(0), t(1), t(2)}, cv::norm(shown, seen) / 2.0};
    };
    std::vector<MarkerPose> raw, refined;
    try {
        std::vector<cv::Mat> rotations, translations;
        cv::solvePnPGeneric(square, seen, matrix, camera.distortion, rotations, translations, false,
                            cv::SOLVEPNP_IPPE_SQUARE);
        for (std::size_t k = 0; k < rotations.size(); ++k) { // the better one first
            cv::Mat1d r = rotations[k], t = translations[k];
            raw.push_back(judged(r, t));
            cv::solvePnPRefineLM(square, seen, matrix, camera.distortion, r, t);
            refined.push_back(judged(r, t));
        }
    } catch (const cv::Exception&) { // corners in a line
    }
    if (refined.empty())
        return std::nullopt;
    MarkerPoses result{refined.front(), std::nullopt, false};
    if (refined.size() > 1) {
        const bool isOne = angleBetween(refined[0], refined[1]) < kSameAngle_rad;
        result.second = isOne ? raw[1] : refined[1];
        result.isAmbiguous = !isOne && isAmbiguous(result.best, *result.second);
        if (result.second->rms_px < result.best.rms_px)
            std::swap(result.best, *result.second);
    }
    const auto isUsable = [](const MarkerPose& pose) {
        return pose.translation_m[2] > 0.0 && std::isfinite(pose.rms_px);
    };
    if (result.second && !isUsable(*result.second))
        result.second.reset();
    return isUsable(result.best) ? std::optional(result) : std::nullopt;
}

} // namespace bask
