#pragma once
// What the studies draw with: the same from seed and index on every machine and thread.

#include "engine/control/rig_geometry.h"

#include <cstdint>
#include <random>

namespace bask {

using StudyRandom = std::mt19937_64;

/// Neighbouring seeds and indices give streams that have nothing to do with each other.
StudyRandom studyRandom(std::uint64_t seed, int index);
double uniform(StudyRandom& random, double least, double most);
/// A pose of the workspace that keeps the clearance, fixed coordinates as in `rest`. Throws
/// std::invalid_argument where there is none.
Vector6d drawAllowedPose(StudyRandom& random, const RigGeometry& geometry, const Vector6d& rest);

inline constexpr int kMaxDraws = 100000; ///< of a pose or a mounting, before the rig is called unfit

} // namespace bask
