#include "engine/control/surface_gap.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

/// Nearest point to `centre` on one object's target surface: the tangent plane's nearest point, again and
/// again. Empty when that does not settle.
std::optional<Vector6d> nearestOnSurface(const SteadySearch& search, int object, double target_K,
                                         const Vector6d& centre, const Vector6d& start) {
    constexpr int kSteps = 100;
    constexpr double kOnSurface_K = 1e-4;
    constexpr double kStill_m = 1e-6;
    constexpr double kFarthest_m = 1.0;
    Vector6d q = start;
    for (int step = 0; step < kSteps; ++step) {
        const SteadySearch::Gradient here = search.at(q);
        Vector6d slope = Vector6d::Zero();
        for (const int c : search.geometry().freeCoordinates())
            if (c < 3)
                slope[c] = here.dT(object, c);
        const double square = slope.squaredNorm();
        if (square < 1e-6)
            return std::nullopt;
        const double missing_K = target_K - here.T_K[object];
        const Vector6d next = centre + (missing_K + slope.dot(q - centre)) / square * slope;
        const double moved_m = (next - q).norm();
        if (std::abs(missing_K) < kOnSurface_K && moved_m < kStill_m)
            return q;
        if ((next - centre).norm() > kFarthest_m)
            return std::nullopt;
        constexpr double kLongest_m = 0.02; // a tangent plane is not trusted farther
        q += std::min(1.0, kLongest_m / std::max(moved_m, 1e-12)) * (next - q);
    }
    return std::nullopt;
}

} // namespace

std::optional<SurfaceGap> surfaceGap(const SteadySearch& search, const std::vector<double>& targets_K,
                                     const Vector6d& q) {
    constexpr int kRounds = 200;
    constexpr double kStill_m = 1e-5;
    const auto N = static_cast<int>(targets_K.size());
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
