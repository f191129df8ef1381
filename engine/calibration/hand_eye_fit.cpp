#include "engine/calibration/hand_eye_fit.h"

#include "engine/calibration/part_pose.h"
#include "engine/calibration/projection.h"
#include "engine/calibration/rigid_fit.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/rotation.h>
#include <ceres/solver.h>

#include <cmath>

namespace bask {
namespace {

template <class T> using Vector3 = Eigen::Matrix<T, 3, 1>;

// Residual by the displacements of X_RC and X_EP from where the fit starts.
struct SightMiss {
    Lens lens;
    Pose X_RE;
    HandEyePoses start;
    Eigen::Vector3d turned; // R_EP p
    Eigen::Vector2d seen;
    double scale;

    SightMiss(const Lens& l, const HandEyeSight& sight, const SeenCorner& corner, const HandEyePoses& from)
        : lens(l), X_RE(sight.X_RE), start(from), turned(from.X_EP.linear() * corner.p_PQ),
          seen(corner.seen_px), scale(std::sqrt(corner.weight)) {}

    template <class T> bool operator()(const T* ofCamera, const T* ofMounting, T* miss) const {
        const Vector3<T> from = turned.cast<T>();
        Vector3<T> p_E, p_shifted, p_turned;
        ceres::AngleAxisRotatePoint(ofMounting + 3, from.data(), p_E.data());
        for (int i = 0; i < 3; ++i)
            p_E[i] += ofMounting[i] + start.X_EP.translation()[i];
        const Vector3<T> p_R = X_RE.linear().cast<T>() * p_E + X_RE.translation().cast<T>();
        for (int i = 0; i < 3; ++i)
            p_shifted[i] = p_R[i] - ofCamera[i] - start.X_RC.translation()[i];
        const T back[3] = {-ofCamera[3], -ofCamera[4], -ofCamera[5]};
        ceres::AngleAxisRotatePoint(back, p_shifted.data(), p_turned.data());
        const Vector3<T> p_C = start.X_RC.linear().transpose().cast<T>() * p_turned;
        if (p_C.z() < 1e-3)
            return false;
        const Eigen::Matrix<T, 2, 1> shown = shownAt(lens, p_C);
        miss[0] = scale * (shown.x() - seen.x());
        miss[1] = scale * (shown.y() - seen.y());
        return true;
    }
};

using SightCost = ceres::AutoDiffCostFunction<SightMiss, 2, 6, 6>;

HandEyePoses displacedBy(const HandEyePoses& start, const Vector6d& ofCamera, const Vector6d& ofMounting) {
    return {displaced(start.X_RC, ofCamera), displaced(start.X_EP, ofMounting)};
}

HandEyePoses solved(std::span<const HandEyeSight> sights, const Lens& lens, const HandEyePoses& start,
                    bool isMountingSought, std::optional<double> robust_px) {
    Vector6d ofCamera = Vector6d::Zero(), ofMounting = Vector6d::Zero();
    ceres::Problem problem;
    for (const HandEyeSight& sight : sights)
        for (const SeenCorner& corner : sight.corners)
            problem.AddResidualBlock(new SightCost(new SightMiss(lens, sight, corner, start)),
                                     robust_px ? new ceres::CauchyLoss(*robust_px * std::sqrt(corner.weight))
                                               : nullptr,
                                     ofCamera.data(), ofMounting.data());
    if (!isMountingSought)
        problem.SetParameterBlockConstant(ofMounting.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return displacedBy(start, ofCamera, ofMounting);
}

// Each view by itself: where its corners ask the markers to go from where the robot and the poses put them.
struct OwnPlaces {
    std::vector<RigidSight> sights;                 ///< noise by a variance of 1
    Eigen::MatrixXd information;                    ///< by the unknowns
    double squares_px2 = 0.0, ownSquares_px2 = 0.0; ///< now, and when each view goes there
    double corners = 0.0, weights = 0.0;            ///< their number, and the sum of their weights
};

OwnPlaces ownPlaces(std::span<const HandEyeSight> sights, const CameraModel& camera,
                    const HandEyePoses& poses, int unknowns) {
    OwnPlaces places;
    places.information.setZero(unknowns, unknowns);
    for (const HandEyeSight& sight : sights) {
        const CornerSums sums = cornerSums(sight.corners, camera, poses.X_CP(sight.X_RE));
        RigidSight own;
        own.noise = sums.information.inverse();
        own.moved = own.noise * sums.gradient;
        own.byUnknowns = byHandEye(poses, sight.X_RE).leftCols(unknowns);
        places.information += own.byUnknowns.transpose() * sums.information * own.byUnknowns;
        places.squares_px2 += sums.squares_px2;
        places.ownSquares_px2 += sums.squares_px2 - sums.gradient.dot(own.moved);
        places.corners += static_cast<double>(sight.corners.size());
        for (const SeenCorner& corner : sight.corners)
            places.weights += corner.weight;
        places.sights.push_back(own);
    }
    return places;
}

// Of a corner's coordinate, by how far a view's corners are from any pose.
double varianceOf(const OwnPlaces& places) {
    constexpr double kEnough = 20.0; // degrees of freedom
    const double freedom = 2.0 * places.corners - 6.0 * static_cast<double>(places.sights.size());
    return freedom < kEnough ? std::max(kUsualCorner_px * kUsualCorner_px, places.ownSquares_px2 / freedom)
                             : places.ownSquares_px2 / freedom;
}

} // namespace

Eigen::Matrix<double, 6, 12> byHandEye(const HandEyePoses& poses, const Pose& X_RE) {
    const BetweenJacobian J = betweenJacobian(poses.X_RC, X_RE * poses.X_EP);
    Eigen::Matrix<double, 6, 12> by;
    by.leftCols<6>() = J.byA;
    by.middleCols<3>(6) = J.byB.leftCols<3>() * X_RE.linear();
    by.rightCols<3>() = J.byB.rightCols<3>() * X_RE.linear();
    return by;
}

std::optional<HandEyeFit> fitHandEye(std::span<const HandEyeSight> sights, const CameraModel& camera,
                                     const HandEyePoses& start, bool isMountingSought,
                                     std::optional<double> robust_px) {
    const auto isInFront = [&](const HandEyeSight& sight) {
        return std::ranges::all_of(sight.corners, [&](const SeenCorner& corner) {
            return std::isfinite(missOf(corner, camera, start.X_CP(sight.X_RE)));
        });
    };
    if (!std::ranges::all_of(sights, isInFront))
        return std::nullopt;
    HandEyeFit fit;
    fit.poses = solved(sights, Lens(camera), start, isMountingSought, robust_px);
    const int unknowns = isMountingSought ? 12 : 6;
    const OwnPlaces places = ownPlaces(sights, camera, fit.poses, unknowns);
    fit.rms_px = std::sqrt(places.squares_px2 / places.weights);
    if (!std::isfinite(fit.rms_px) || !Eigen::FullPivLU<Eigen::MatrixXd>(places.information).isInvertible())
        return std::nullopt;
    fit.covariance.topLeftCorner(unknowns, unknowns) = varianceOf(places) * places.information.inverse();
    return fit;
}

void allowForRobot(HandEyeFit& fit, std::span<const HandEyeSight> sights, const CameraModel& camera,
                   bool isMountingSought) {
    constexpr int kSteps = 3;
    const int unknowns = isMountingSought ? 12 : 6;
    OwnPlaces places = ownPlaces(sights, camera, fit.poses, unknowns);
    const double variance = varianceOf(places), freedom = 6.0 * static_cast<double>(sights.size()) - unknowns;
    if (freedom <= 0.0 || places.squares_px2 - places.ownSquares_px2 <= variance * freedom)
        return;
    for (int step = 0; step < kSteps; ++step) {
        for (RigidSight& sight : places.sights)
            sight.noise *= variance;
        const RigidFit moved = fitRigid(places.sights);
        Vector6d ofMounting = Vector6d::Zero();
        if (isMountingSought)
            ofMounting = moved.unknowns.tail<6>();
        fit.poses = displacedBy(fit.poses, moved.unknowns.head<6>(), ofMounting);
        fit.covariance.topLeftCorner(unknowns, unknowns) = moved.covariance;
        fit.robot_m = moved.position_m;
        fit.robot_rad = moved.angle_rad;
        places = ownPlaces(sights, camera, fit.poses, unknowns);
    }
    fit.rms_px = std::sqrt(places.squares_px2 / places.weights);
}

} // namespace bask
