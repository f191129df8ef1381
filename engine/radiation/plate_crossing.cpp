#include "engine/radiation/plate_crossing.h"

#include "engine/radiation/outline_table.h"
#include "engine/radiation/plate.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kTouch = 1e-9; // of the plates' size: as much may one reach into the other by rounding

// Where a line of the plate's plane enters and leaves it: places along the line, in ascending order.
std::vector<double> passages(const SightOutline& outline, const Eigen::Vector2d& start,
                             const Eigen::Vector2d& along) {
    std::vector<double> places;
    if (outline.radius_m > 0.0) {
        const double middle = -start.dot(along);
        const double half2 = outline.radius_m * outline.radius_m - (start + middle * along).squaredNorm();
        if (half2 <= 0.0)
            return {};
        places = {middle - std::sqrt(half2), middle + std::sqrt(half2)};
    }
    for (const SightRing& ring : outline.rings)
        for (std::size_t i = 0; i < ring.corners.size(); ++i) {
            const Eigen::Vector2d a = ring.corners[i].at - start;
            const Eigen::Vector2d b = ring.corners[(i + 1) % ring.corners.size()].at - start;
            const double asideA = along.x() * a.y() - along.y() * a.x(),
                         asideB = along.x() * b.y() - along.y() * b.x();
            if ((asideA > 0.0) != (asideB > 0.0))
                places.push_back((a + asideA / (asideA - asideB) * (b - a)).dot(along));
        }
    std::ranges::sort(places);
    return places;
}

} // namespace

bool platesCross(const RadiatingContour& a, const Pose& X_A, const RadiatingContour& b, const Pose& X_B) {
    const Plate& plateA = a.impl().plate();
    const Plate& plateB = b.impl().plate();
    const Eigen::Vector3d nA = X_A.linear().col(2), nB = X_B.linear().col(2),
                          between = X_B.translation() - X_A.translation();
    const double reach = plateA.reach_m() + plateB.reach_m();
    if (between.norm() > reach || std::abs(nA.dot(between)) > plateB.reach_m() ||
        std::abs(nB.dot(between)) > plateA.reach_m())
        return false;
    Eigen::Vector3d along = nA.cross(nB);
    const double sine = along.norm();
    if (sine < kTouch)
        return false;
    along /= sine;
    // A point of both planes, near A's origin.
    const Eigen::Vector3d inA = along.cross(nA);
    const Eigen::Vector3d start = X_A.translation() + nB.dot(between) / nB.dot(inA) * inA;
    const auto places = [&](const Plate& plate, const Pose& X) {
        const Eigen::Vector3d p = X.inverse() * start, d = X.linear().transpose() * along;
        return passages(plate.outline(0.0).outline, p.head<2>(), d.head<2>());
    };
    const std::vector<double> placesA = places(plateA, X_A), placesB = places(plateB, X_B);
    for (std::size_t i = 0; i + 1 < placesA.size(); i += 2)
        for (std::size_t j = 0; j + 1 < placesB.size(); j += 2)
            if (std::min(placesA[i + 1], placesB[j + 1]) - std::max(placesA[i], placesB[j]) > kTouch * reach)
                return true;
    return false;
}

} // namespace bask
