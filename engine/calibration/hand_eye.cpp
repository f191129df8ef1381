#include "engine/calibration/hand_eye.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/corner_fit.h"
#include "engine/calibration/hand_eye_fit.h"
#include "engine/calibration/relative_pose.h"

#include <Eigen/Eigenvalues>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kMinTurn_deg = 3.0; // root mean square about an axis, between two poses
constexpr double kMax_px = 20.0;     // no robot is so wrong

std::vector<HandEyeSight> sightsOf(std::span<const HandEyeView> views, const MarkerLayout& layout,
                                   const CameraModel& camera) {
    std::vector<HandEyeSight> sights;
    for (std::size_t k = 0; k < views.size(); ++k) {
        const auto pose = partPose(views[k].frames, layout, Part::EndEffector, camera);
        if (!pose)
            continue;
        HandEyeSight sight{k, views[k].X_RE, pose->X_CP, {}};
        for (const SeenMarker& seen : pose->used) {
            const auto places = seen.marker.corners();
            for (std::size_t c = 0; c < 4; ++c)
                sight.corners.push_back({places[c], seen.corners_px[c], static_cast<double>(seen.frames)});
        }
        sights.push_back(sight);
    }
    return sights;
}

// What the motion tells: root mean square turns between poses about the axes, least to largest.
Eigen::Vector3d turns(std::span<const HandEyeSight> views) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    int pairs = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        for (std::size_t k = 0; k < i; ++k, ++pairs) {
            const Pose X = views[i].X_RE.inverse() * views[k].X_RE;
            const Eigen::Vector3d turn = displacementBetween(Pose::Identity(), X).tail<3>();
            scatter += turn * turn.transpose();
        }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter / std::max(pairs, 1));
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

std::optional<Error> motionError(std::span<const HandEyeSight> views) {
    const Eigen::Vector3d turned = turns(views);
    const auto tooLittle = [](double turn_rad) { return degFromRad(turn_rad) < kMinTurn_deg; };
    const std::string needed = formatNumber(kMinTurn_deg);
    if (tooLittle(turned[2]))
        return Error{MessageCode::HandEyeNoTurn, "", {formatNumber(degFromRad(turned[2]), 2), needed}};
    if (tooLittle(turned[1]))
        return Error{MessageCode::HandEyeOneAxis, "", {formatNumber(degFromRad(turned[1]), 2), needed}};
    return std::nullopt;
}

cv::Mat matOf(const Eigen::MatrixXd& m) {
    cv::Mat1d result(static_cast<int>(m.rows()), static_cast<int>(m.cols()));
    for (int i = 0; i < result.rows; ++i)
        for (int k = 0; k < result.cols; ++k)
            result(i, k) = m(i, k);
    return result;
}

std::optional<Pose> byOpenCv(std::span<const HandEyeSight> views, cv::HandEyeCalibrationMethod method) {
    std::vector<cv::Mat> R_ER, t_ER, R_CP, t_CP;
    for (const HandEyeSight& view : views) {
        const Pose X_ER = view.X_RE.inverse();
        R_ER.push_back(matOf(X_ER.linear()));
        t_ER.push_back(matOf(X_ER.translation()));
        R_CP.push_back(matOf(view.X_CP.linear()));
        t_CP.push_back(matOf(view.X_CP.translation()));
    }
    cv::Mat1d R, t;
    try {
        cv::calibrateHandEye(R_ER, t_ER, R_CP, t_CP, R, t, method);
    } catch (const cv::Exception&) { // poses that the method cannot take
        return std::nullopt;
    }
    Pose X_RC = Pose::Identity();
    for (int i = 0; i < 3; ++i) {
        X_RC.translation()[i] = t(i);
        for (int k = 0; k < 3; ++k)
            X_RC.linear()(i, k) = R(i, k);
    }
    const bool isPose =
        X_RC.matrix().allFinite() && (X_RC.linear().transpose() * X_RC.linear()).isIdentity(1e-3);
    return isPose ? std::optional(X_RC) : std::nullopt;
}

std::vector<HandEyePoses> starts(std::span<const HandEyeSight> views, Mounting mounting) {
    std::vector<HandEyePoses> result;
    if (mounting == Mounting::Known) {
        for (const HandEyeSight& view : views)
            result.push_back({view.X_RE * view.X_CP.inverse(), Pose::Identity()});
        return result;
    }
    for (const auto method : {cv::CALIB_HAND_EYE_TSAI, cv::CALIB_HAND_EYE_PARK, cv::CALIB_HAND_EYE_HORAUD,
                              cv::CALIB_HAND_EYE_ANDREFF, cv::CALIB_HAND_EYE_DANIILIDIS})
        if (const auto X_RC = byOpenCv(views, method))
            for (const HandEyeSight& view : views)
                result.push_back({*X_RC, view.X_RE.inverse() * *X_RC * view.X_CP});
    return result;
}

double rmsOf(const HandEyeSight& sight, const CameraModel& camera, const HandEyePoses& poses) {
    const Pose X_CP = poses.X_CP(sight.X_RE);
    double squares = 0.0;
    for (const SeenCorner& corner : sight.corners)
        squares += std::pow(missOf(corner, camera, X_CP), 2);
    return std::sqrt(squares / static_cast<double>(sight.corners.size()));
}

HandEyePoses bestStart(std::span<const HandEyePoses> starts, std::span<const HandEyeSight> sights,
                       const CameraModel& camera) {
    constexpr double kScale_px = 20.0; // wrong views count little
    const auto cost = [&](const HandEyePoses& poses) {
        double sum = 0.0;
        for (const HandEyeSight& sight : sights)
            sum += std::log1p(std::pow(rmsOf(sight, camera, poses) / kScale_px, 2));
        return sum;
    };
    return *std::ranges::min_element(starts, {}, cost);
}

// Those that miss by no more than 3 px or four times what the median one does.
std::vector<HandEyeSight> fitting(std::span<const HandEyeSight> sights, const CameraModel& camera,
                                  const HandEyePoses& poses) {
    constexpr double kMin_px = 3.0, kTimes = 4.0;
    std::vector<double> misses;
    for (const HandEyeSight& sight : sights)
        misses.push_back(rmsOf(sight, camera, poses));
    std::vector<double> sorted = misses;
    std::ranges::sort(sorted);
    const double max = std::max(kMin_px, kTimes * sorted[sorted.size() / 2]);
    std::vector<HandEyeSight> kept;
    for (std::size_t k = 0; k < sights.size(); ++k)
        if (misses[k] <= max)
            kept.push_back(sights[k]);
    return kept;
}

void tellViews(HandEye& result, std::span<const HandEyeSight> sights, std::span<const HandEyeSight> used,
               const CameraModel& camera) {
    const HandEyePoses poses{result.X_RC, result.X_EP};
    for (const HandEyeSight& sight : sights) {
        HandEyeResidual& residual = result.views[sight.view];
        residual.isUsed = std::ranges::find(used, sight.view, &HandEyeSight::view) != used.end();
        residual.rms_px = rmsOf(sight, camera, poses);
        residual.difference = differenceBetween(poses.X_CP(sight.X_RE), sight.X_CP);
        if (!residual.isUsed)
            result.remarks.push_back(
                {MessageCode::HandEyeViewLeftOut,
                 {std::to_string(sight.view + 1), formatNumber(1e3 * residual.difference.distance_m, 2),
                  formatNumber(degFromRad(residual.difference.angle_rad), 2)}});
    }
}

// Wrong views lose weight step by step, then are left out.
std::optional<HandEyeFit> robustFit(std::span<const HandEyeSight> sights, const CameraModel& camera,
                                    HandEyePoses poses, Mounting mounting, std::vector<HandEyeSight>& used) {
    std::optional<HandEyeFit> fit;
    for (const double scale_px : {50.0, 10.0, 2.0}) {
        fit = fitHandEye(sights, camera, poses, mounting == Mounting::Sought, scale_px);
        if (!fit)
            return std::nullopt;
        poses = fit->poses;
    }
    used = fitting(sights, camera, poses);
    fit = fitHandEye(used, camera, poses, mounting == Mounting::Sought);
    if (fit)
        allowForRobot(*fit, used, camera, mounting == Mounting::Sought);
    return fit;
}

// What frames have in common does not show in the residuals of one view: of X_RC, by the markers' lasting
// errors.
Matrix6d lastingOf(const HandEyeSight& sight, const MarkerLayout& layout, const CameraModel& camera) {
    const auto ofMarkers =
        predictedCovariance(layout, Part::EndEffector, camera, sight.X_CP, 1, kLastingCorner_px);
    if (!ofMarkers)
        return Matrix6d::Zero();
    Matrix6d turned = Matrix6d::Zero();
    turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = sight.X_RE.linear();
    const Matrix6d of_X_EC = covarianceBetween(sight.X_CP, *ofMarkers, Pose::Identity(), Matrix6d::Zero());
    return turned * of_X_EC * turned.transpose();
}

} // namespace

PoseDifference differenceBetween(const Pose& a, const Pose& b) {
    const Vector6d d = displacementBetween(a, b);
    return {d.head<3>().norm(), d.tail<3>().norm()};
}

Result<HandEye> calibrateHandEye(std::span<const HandEyeView> views, const MarkerLayout& layout,
                                 const CameraModel& camera, Mounting mounting) {
    const std::vector<HandEyeSight> sights = sightsOf(views, layout, camera);
    const std::size_t min = mounting == Mounting::Known ? 1 : 3;
    if (sights.empty() && !views.empty())
        return partPose(views.front().frames, layout, Part::EndEffector, camera).error();
    if (sights.size() < min)
        return Error{MessageCode::HandEyeViewsFew, "", {std::to_string(sights.size()), std::to_string(min)}};
    if (mounting == Mounting::Sought)
        if (auto error = motionError(sights))
            return *error;
    const std::vector<HandEyePoses> all = starts(sights, mounting);
    std::vector<HandEyeSight> used;
    const auto fit = all.empty() ? std::nullopt
                                 : robustFit(sights, camera, bestStart(all, sights, camera), mounting, used);
    if (!fit || fit->rms_px > kMax_px || 2 * used.size() <= sights.size())
        return Error{MessageCode::HandEyeContradicts, ""};
    if (mounting == Mounting::Sought)
        if (auto error = motionError(used))
            return *error;
    HandEye result;
    result.X_RC = fit->poses.X_RC;
    result.X_EP = fit->poses.X_EP;
    result.covariance = fit->covariance;
    if (used.size() == 1)
        result.covariance.topLeftCorner<6, 6>() += lastingOf(used.front(), layout, camera);
    result.rms_px = fit->rms_px;
    result.robot_m = fit->robot_m;
    result.robot_rad = fit->robot_rad;
    result.views.resize(views.size());
    tellViews(result, sights, used, camera);
    return result;
}

Result<HandEyeCheck> checkHandEye(const HandEye& handEye, const HandEyeView& view, const MarkerLayout& layout,
                                  const CameraModel& camera) {
    const auto seen = partPose(view.frames, layout, Part::EndEffector, camera);
    if (!seen)
        return seen.error();
    const HandEyePoses poses{handEye.X_RC, handEye.X_EP};
    const auto J = byHandEye(poses, view.X_RE);
    Vector6d ofRobot;
    ofRobot << Eigen::Vector3d::Constant(handEye.robot_m), Eigen::Vector3d::Constant(handEye.robot_rad);
    Matrix6d expected = J * handEye.covariance * J.transpose() + seen->covariance;
    expected.diagonal() += ofRobot.cwiseAbs2();
    return HandEyeCheck{differenceBetween(poses.X_CP(view.X_RE), seen->X_CP), spreadOf(expected)};
}

PoseSpread spreadAt(const HandEye& place, const Eigen::Vector3d& p_R, const MarkerLayout& layout,
                    const CameraModel& camera, const Pose& X_RE) {
    const Matrix6d carried = carriedBy(p_R - place.X_RC.translation());
    const Pose X_CE = place.X_RC.inverse() * X_RE;
    Matrix6d lasting = Matrix6d::Zero(); // one view's is in its covariance
    if (place.views.size() > 1)
        lasting = predictedCovariance(layout, Part::EndEffector, camera, X_CE, 1, kLastingCorner_px)
                      .value_or(Matrix6d::Zero());
    Matrix6d turn = Matrix6d::Zero(); // C axes into R's
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = place.X_RC.linear();
    return spreadOf(carried * place.covariance.topLeftCorner<6, 6>() * carried.transpose() +
                    turn * lasting * turn.transpose());
}

} // namespace bask
