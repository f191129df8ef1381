#include "engine/calibration/corner_fit.h"

#include "engine/calibration/projection.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/rotation.h>
#include <ceres/solver.h>

#include <limits>

namespace bask {
namespace {

constexpr double kNearest_m = 1e-3; // in front of the camera

// Residual by the displacement of X_CP from where the fit starts.
struct CornerMiss {
    Lens lens;
    Eigen::Vector3d turned, shifted; // of the start: R p and t
    Eigen::Vector2d seen;
    double scale;

    CornerMiss(const Lens& l, const SeenCorner& corner, const Pose& start)
        : lens(l), turned(start.linear() * corner.p_PQ), shifted(start.translation()), seen(corner.seen_px),
          scale(std::sqrt(corner.weight)) {}

    template <class T> bool operator()(const T* displacement, T* miss) const {
        const T from[3] = {T(turned.x()), T(turned.y()), T(turned.z())};
        Eigen::Matrix<T, 3, 1> p;
        ceres::AngleAxisRotatePoint(displacement + 3, from, p.data());
        for (int i = 0; i < 3; ++i)
            p[i] += displacement[i] + shifted[i];
        if (p.z() < kNearest_m)
            return false;
        const Eigen::Matrix<T, 2, 1> shown = shownAt(lens, p);
        miss[0] = scale * (shown.x() - seen.x());
        miss[1] = scale * (shown.y() - seen.y());
        return true;
    }
};

using CornerCost = ceres::AutoDiffCostFunction<CornerMiss, 2, 6>;

bool allInFront(std::span<const SeenCorner> corners, const Pose& X_CP) {
    return std::ranges::all_of(corners,
                               [&](const SeenCorner& c) { return (X_CP * c.p_PQ).z() > kNearest_m; });
}

Vector6d solved(std::span<const SeenCorner> corners, const Lens& lens, const Pose& start,
                std::optional<double> robust_px) {
    Vector6d displacement = Vector6d::Zero();
    ceres::Problem problem;
    for (const SeenCorner& corner : corners)
        problem.AddResidualBlock(new CornerCost(new CornerMiss(lens, corner, start)),
                                 robust_px ? new ceres::CauchyLoss(*robust_px * std::sqrt(corner.weight))
                                           : nullptr,
                                 displacement.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 50;
    options.function_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return displacement;
}

} // namespace

double missOf(const SeenCorner& corner, const CameraModel& camera, const Pose& X_CP) {
    const Eigen::Vector3d p = X_CP * corner.p_PQ;
    return p.z() < kNearest_m ? std::numeric_limits<double>::infinity()
                              : (shownAt(Lens(camera), p) - corner.seen_px).norm();
}

CornerSums cornerSums(std::span<const SeenCorner> corners, const CameraModel& camera, const Pose& X_CP) {
    CornerSums sums;
    const Vector6d none = Vector6d::Zero();
    const double* const at[] = {none.data()};
    for (const SeenCorner& corner : corners) {
        const CornerCost cost(new CornerMiss(Lens(camera), corner, X_CP));
        Eigen::Vector2d miss;
        Eigen::Matrix<double, 2, 6, Eigen::RowMajor> J;
        double* jacobians[] = {J.data()};
        if (!cost.Evaluate(at, miss.data(), jacobians))
            continue;
        sums.information += J.transpose() * J;
        sums.gradient -= J.transpose() * miss;
        sums.squares_px2 += miss.squaredNorm();
    }
    return sums;
}

std::optional<CornerFit> fitCorners(std::span<const SeenCorner> corners, const CameraModel& camera,
                                    const Pose& start, std::optional<double> robust_px) {
    if (corners.size() < 3 || !start.matrix().allFinite() || !allInFront(corners, start))
        return std::nullopt;
    CornerFit fit;
    fit.X_CP = displaced(start, solved(corners, Lens(camera), start, robust_px));
    const CornerSums sums = cornerSums(corners, camera, fit.X_CP);
    fit.squares_px2 = sums.squares_px2;
    fit.information = sums.information;
    const bool isDetermined = Eigen::FullPivLU<Matrix6d>(fit.information).isInvertible();
    return isDetermined && std::isfinite(fit.squares_px2) ? std::optional(fit) : std::nullopt;
}

} // namespace bask
