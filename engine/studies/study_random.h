#pragma once
// Random numbers of the studies: the same from seed and index on every machine and thread.

#include "engine/control/rig_geometry.h"

#include <cstdint>
#include <random>

namespace bask {

using StudyRandom = std::mt19937_64;

/// Neighbouring seeds and indices give independent streams.
StudyRandom studyRandom(std::uint64_t seed, int index);
double uniform(StudyRandom& random, double min, double max);
/// Returns a pose of the workspace with the clearance, with fixed coordinates as in `rest`. Throws
/// std::invalid_argument if there is none.
Vector6d drawAllowedPose(StudyRandom& random, const RigGeometry& geometry, const Vector6d& rest);

/// Attempts for a pose or a mounting, before the rig counts as unsuitable.
inline constexpr int kMaxDraws = 100000;

} // namespace bask
