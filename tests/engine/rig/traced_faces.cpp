#include "tests/engine/rig/traced_faces.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

namespace bask::test {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random) {
    return std::uniform_real_distribution<double>()(random);
}

struct Hit {
    std::size_t disk;
    bool isAbove;
    double radius_m;
    Eigen::Vector3d p;
};

std::optional<Hit> firstHit(const TracedScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& d) {
    constexpr double kSelf_m = 1e-9;
    std::optional<Hit> hit;
    double nearest_m = 1e9;
    for (std::size_t k = 0; k < scene.disks.size(); ++k) {
        const TracedDisk& disk = scene.disks[k];
        const Eigen::Vector3d n = disk.X_R.linear().col(2);
        const double along = n.dot(d);
        if (along == 0.0)
            continue;
        const double t_m = n.dot(disk.X_R.translation() - from) / along;
        if (t_m < kSelf_m || t_m >= nearest_m)
            continue;
        const Eigen::Vector3d p = from + t_m * d;
        const double r_m = (p - disk.X_R.translation()).norm();
        if (r_m > disk.radius_m)
            continue;
        nearest_m = t_m;
        hit = Hit{k, along < 0.0, r_m, p};
    }
    return hit;
}

/// A direction by the cosine about the normal of a side.
Eigen::Vector3d diffuse(const TracedDisk& disk, bool isAbove, Random& random) {
    const double sine = std::sqrt(uniform(random)), angle = 2.0 * std::numbers::pi * uniform(random);
    const Eigen::Vector3d d(sine * std::cos(angle), sine * std::sin(angle), std::sqrt(1.0 - sine * sine));
    return disk.X_R.linear() * (isAbove ? d : Eigen::Vector3d(d.x(), d.y(), -d.z()));
}

double radianceAlong(const TracedScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& d,
                     const BandRadiance& band, Random& random, int depth) {
    const double room = band.radiance(scene.room_K);
    const auto hit = firstHit(scene, from, d);
    if (!hit || depth > 12)
        return room;
    const TracedDisk& disk = scene.disks[hit->disk];
    const auto& T_K = hit->isAbove ? disk.above_K : disk.below_K;
    const double own = disk.emittance * band.radiance(T_K(hit->radius_m));
    if (disk.emittance >= 1.0)
        return own;
    if (disk.seesRoomOnly)
        return own + (1.0 - disk.emittance) * room;
    return own + (1.0 - disk.emittance) * radianceAlong(scene, hit->p, diffuse(disk, hit->isAbove, random),
                                                        band, random, depth + 1);
}

} // namespace

TracedRadiance receivedBy(const TracedScene& scene, std::size_t disk, bool isAbove, const BandRadiance& band,
                          int rays, std::uint64_t seed) {
    Random random(seed);
    const TracedDisk& from = scene.disks[disk];
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < rays; ++k) {
        const double r_m = from.radius_m * std::sqrt(uniform(random));
        const double angle = 2.0 * std::numbers::pi * uniform(random);
        const Eigen::Vector3d p =
            from.X_R * Eigen::Vector3d(r_m * std::cos(angle), r_m * std::sin(angle), 0.0);
        const double L = radianceAlong(scene, p, diffuse(from, isAbove, random), band, random, 0);
        sum += L;
        squares += L * L;
    }
    const double mean = sum / rays;
    return {mean, std::sqrt(std::max(squares / rays - mean * mean, 0.0) / rays)};
}

} // namespace bask::test
