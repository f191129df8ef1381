#include "engine/session/mounting_check.h"

#include "engine/base/message_code.h"

#include <algorithm>

namespace bask {
namespace {

using Outline = std::vector<Eigen::Vector2d>;
using Rings = std::vector<Outline>;

constexpr int kOutlinePoints = 120;
constexpr double kFlatTriangle = 0.1; ///< height over longest side, below which three places are a line

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool edgesMeet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
               const Eigen::Vector2d& d) {
    return cross(b - a, c - a) * cross(b - a, d - a) <= 0.0 &&
           cross(d - c, a - c) * cross(d - c, b - c) <= 0.0;
}

bool edgesMeet(const Outline& one, const Outline& other) {
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t k = 0; k < other.size(); ++k)
            if (edgesMeet(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()]))
                return true;
    return false;
}

// Inside the outline and in no hole.
bool covers(const Rings& face, const Eigen::Vector2d& p) {
    return std::ranges::count_if(face, [&](const Outline& ring) { return encloses(ring, p); }) % 2 == 1;
}

bool overlap(const Rings& one, const Rings& other) {
    if (covers(other, one.front().front()) || covers(one, other.front().front()))
        return true;
    return std::ranges::any_of(one, [&](const Outline& ring) {
        return std::ranges::any_of(other, [&](const Outline& its) { return edgesMeet(ring, its); });
    });
}

bool inLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return (b - a).cross(c - a).norm() < kFlatTriangle * longest * longest;
}

} // namespace

std::vector<std::vector<Eigen::Vector2d>> mountedRings(const ObjectSpec& object, int points) {
    const Pose X_EO = poseFromCoordinates(object.mounting);
    Rings rings = shapeRings(object.shape, points);
    for (Outline& ring : rings)
        for (Eigen::Vector2d& p : ring)
            p = (X_EO * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
    return rings;
}

std::vector<MountingRemark> mountingRemarks(const Experiment& experiment) {
    const std::vector<ObjectSpec>& objects = experiment.objects;
    const double most_m = experiment.robot.maxMountingRadius_m;
    const int count = static_cast<int>(objects.size());
    std::vector<Rings> outlines;
    std::vector<Eigen::Vector3d> places;
    for (const ObjectSpec& object : objects) {
        outlines.push_back(mountedRings(object, kOutlinePoints));
        places.push_back(object.mounting.head<3>());
    }
    const auto name = [&](int i) { return objects[static_cast<std::size_t>(i)].name; };
    const auto at = [](const auto& list, int i) -> const auto& {
        return list[static_cast<std::size_t>(i)];
    };
    std::vector<MountingRemark> out;
    for (int i = 0; i < count; ++i) {
        double radius_m = 0.0;
        for (const Eigen::Vector2d& p : at(outlines, i).front())
            radius_m = std::max(radius_m, p.norm());
        if (most_m > 0.0 && radius_m > most_m)
            out.push_back({{MessageCode::MountingFar,
                            {name(i), formatNumber(100.0 * radius_m, 3), formatNumber(100.0 * most_m, 3)}},
                           {i}});
        for (int k = i + 1; k < count; ++k) {
            if (overlap(at(outlines, i), at(outlines, k)))
                out.push_back({{MessageCode::MountingOverlap, {name(i), name(k)}}, {i, k}});
            for (int l = k + 1; l < count; ++l)
                if (inLine(at(places, i), at(places, k), at(places, l)))
                    out.push_back({{MessageCode::MountingInLine, {name(i), name(k), name(l)}}, {i, k, l}});
        }
    }
    return out;
}

} // namespace bask
