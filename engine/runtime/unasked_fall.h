#pragma once
// How a source that heated though its heat is off cools.

#include "engine/model/safety_spec.h"

namespace bask {

/// How far such a source has fallen from its maximum.
struct UnaskedFall {
    /// One that has fallen by this cools: one that is stuck on has less noise.
    static constexpr double kCools_K = SafetySpec::kSourceGain_K;

    double fallen_K = 0.0;
    double needed_K = 0.0; ///< with this fall it no longer counts as heating, and Reset is possible
};

} // namespace bask
