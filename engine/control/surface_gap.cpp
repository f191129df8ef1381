#include "engine/control/surface_gap.h"

#include "engine/control/feasibility.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

/// Nearest pose to `centre` with its angles, within workspace and clearance, at which the object settles at
/// its target: least squares with a pull so weak that it shifts the temperature only by about 0.1 mK.
std::optional<Vector6d> nearestOnSurface(const SteadySearch& search, int object, double target_K,
                                         const Vector6d& centre, const Vector6d& start) {
    constexpr double kPull_K_m = 1.0;
    constexpr double kFixed_K_rad = 1e5;
    SteadyAim aim{Eigen::RowVectorXd::Unit(search.geometry().objects(), object),
                  Eigen::VectorXd::Constant(1, target_K)};
    aim.pull << Eigen::Vector3d::Constant(kPull_K_m), Eigen::Vector3d::Constant(kFixed_K_rad);
    aim.towards = centre;
    const SteadyPose found = search.refine(aim, start, Shade::Rough);
    if (std::abs(found.T_K[object] - target_K) > kReachedWithin_K)
        return std::nullopt;
    return found.q;
}

} // namespace

std::optional<SurfaceGap> surfaceGap(const SteadySearch& search, const std::vector<double>& targets_K,
                                     const Vector6d& q) {
    constexpr int kRounds = 60;
    constexpr double kStill_m = 1e-4;
    const auto N = static_cast<int>(targets_K.size());
    if (std::ranges::none_of(search.geometry().freeCoordinates(), [](int c) { return c < 3; }))
        return std::nullopt;
    Vector6d centre = q;
    std::vector<Vector6d> points(targets_K.size(), q);
    for (int round = 0; round < kRounds && !search.stopped(); ++round) {
        Vector6d sum = Vector6d::Zero();
        for (int i = 0; i < N; ++i) {
            Vector6d& point = points[static_cast<std::size_t>(i)];
            const auto found =
                nearestOnSurface(search, i, targets_K[static_cast<std::size_t>(i)], centre, point);
            if (!found)
                return std::nullopt;
            point = *found;
            sum += point;
        }
        const Vector6d next = sum / N;
        const bool still = (next - centre).norm() < kStill_m;
        centre = next;
        if (still)
            break;
    }
    SurfaceGap out;
    for (const Vector6d& a : points) {
        out.points.emplace_back(a.head<3>());
        for (const Vector6d& b : points)
            out.distance_m = std::max(out.distance_m, (a - b).norm());
    }
    return out;
}

} // namespace bask
