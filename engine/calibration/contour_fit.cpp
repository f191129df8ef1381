#include "engine/calibration/contour_fit.h"

#include "engine/calibration/projection.h"

#include <Eigen/Cholesky>
#include <ceres/autodiff_cost_function.h>
#include <ceres/jet.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/rotation.h>
#include <ceres/solver.h>

#include <limits>

namespace bask {
namespace {

constexpr double kNearestContour_m = 1e-3; // in front of the camera

// Residual by the displacement of X_RC from where the fit starts.
struct ContourCost {
    Lens lens;
    Pose start;
    Eigen::Vector3d p_R;
    Eigen::Vector2d seen, normal;
    double scale;

    template <class T> bool operator()(const T* ofCamera, T* miss) const {
        Eigen::Matrix<T, 3, 1> shifted, turned;
        for (int i = 0; i < 3; ++i)
            shifted[i] = p_R[i] - ofCamera[i] - start.translation()[i];
        const T back[3] = {-ofCamera[3], -ofCamera[4], -ofCamera[5]};
        ceres::AngleAxisRotatePoint(back, shifted.data(), turned.data());
        const Eigen::Matrix<T, 3, 1> p_C = start.linear().transpose().cast<T>() * turned;
        if (p_C.z() < kNearestContour_m)
            return false;
        const Eigen::Matrix<T, 2, 1> shown = shownAt(lens, p_C);
        miss[0] = scale * (normal.x() * (shown.x() - seen.x()) + normal.y() * (shown.y() - seen.y()));
        return true;
    }
};

// A displacement costs: half its square by an information matrix.
struct PriorCost {
    Matrix6d root; // root^T root is the information

    template <class T> bool operator()(const T* ofCamera, T* cost) const {
        for (int i = 0; i < 6; ++i) {
            cost[i] = T(0.0);
            for (int k = 0; k < 6; ++k)
                cost[i] += root(i, k) * ofCamera[k];
        }
        return true;
    }
};

} // namespace

double contourMiss(const ContourPoint& point, const Pose& X_RE, const CameraModel& camera, const Pose& X_RC) {
    const Eigen::Vector3d p_C = X_RC.inverse() * (X_RE * point.p_E);
    return p_C.z() < kNearestContour_m ? std::numeric_limits<double>::quiet_NaN()
                                       : point.normal.dot(point.seen_px - shownAt(Lens(camera), p_C));
}

ContourJacobian contourJacobian(const ContourPoint& point, const CameraModel& camera, const Pose& X_CE) {
    using Jet = ceres::Jet<double, 3>;
    const Eigen::Vector3d arm = X_CE.linear() * point.p_E, p_C = arm + X_CE.translation();
    Eigen::Matrix<Jet, 3, 1> p;
    for (int i = 0; i < 3; ++i)
        p[i] = Jet(p_C[i], i);
    const Eigen::Matrix<Jet, 2, 1> shown = shownAt(Lens(camera), p);
    const Eigen::Vector3d byPoint = point.normal.x() * shown.x().v + point.normal.y() * shown.y().v;
    ContourJacobian out;
    out.miss_px = point.normal.dot(point.seen_px - Eigen::Vector2d(shown.x().a, shown.y().a));
    out.byPart.head<3>() = byPoint;
    out.byPart.tail<3>() = arm.cross(byPoint); // w x arm moves the point
    return out;
}

std::optional<Pose> fitContours(std::span<const ContourSight> sights, const CameraModel& camera,
                                const Pose& start, double robust, const std::optional<Matrix6d>& prior) {
    const Lens lens(camera);
    Vector6d displacement = Vector6d::Zero();
    ceres::Problem problem;
    for (const ContourSight& sight : sights)
        for (const ContourPoint& point : sight.points) {
            if (!std::isfinite(contourMiss(point, sight.X_RE, camera, start)))
                return std::nullopt;
            problem.AddResidualBlock(new ceres::AutoDiffCostFunction<ContourCost, 1, 6>(
                                         new ContourCost{lens, start, sight.X_RE * point.p_E, point.seen_px,
                                                         point.normal, 1.0 / point.deviation_px}),
                                     new ceres::CauchyLoss(robust), displacement.data());
        }
    if (prior)
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<PriorCost, 6, 6>(new PriorCost{Matrix6d(prior->llt().matrixU())}),
            nullptr, displacement.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 50;
    options.function_tolerance = 1e-10;
    options.parameter_tolerance = 1e-10;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    const bool isUsable =
        problem.NumResidualBlocks() > 0 && summary.IsSolutionUsable() && displacement.allFinite();
    return isUsable ? std::optional(displaced(start, displacement)) : std::nullopt;
}

} // namespace bask
