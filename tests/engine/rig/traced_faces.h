#pragma once
// What a face reflects, by rays: an independent computation for tests. Disks only.

#include "engine/base/pose.h"
#include "engine/thermography/band_radiance.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace bask::test {

/// A disk in the xy-plane of its frame. What a side does not emit it reflects, diffusely.
struct TracedDisk {
    double radius_m = 0.0;
    Pose X_R = Pose::Identity();
    double emittance = 1.0;
    /// Temperature over the radius, K, of the side towards +z; and of the other one.
    std::function<double(double)> above_K, below_K;
    /// Whether it reflects only the room: the source.
    bool seesRoomOnly = false;
};

struct TracedScene {
    std::vector<TracedDisk> disks;
    double room_K = 298.15;
};

struct TracedRadiance {
    double mean = 0.0, standardError = 0.0;
};

/// Returns the mean of the band radiance that falls on one side of a disk.
TracedRadiance receivedBy(const TracedScene& scene, std::size_t disk, bool isAbove, const BandRadiance& band,
                          int rays, std::uint64_t seed);

} // namespace bask::test
