#include "engine/studies/study_random.h"

#include <stdexcept>

namespace bask {

StudyRandom studyRandom(std::uint64_t seed, int index) {
    std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                        static_cast<std::uint32_t>(index)};
    return StudyRandom(words);
}

double uniform(StudyRandom& random, double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random);
}

Vector6d drawAllowedPose(StudyRandom& random, const RigGeometry& geometry, const Vector6d& rest) {
    for (int attempt = 0; attempt < kMaxDraws; ++attempt) {
        Vector6d q = rest;
        for (const int k : geometry.freeCoordinates())
            q[k] = uniform(random, geometry.limits().lower[k], geometry.limits().upper[k]);
        if (geometry.allowed(q))
            return q;
    }
    throw std::invalid_argument("study: no pose of the workspace keeps the clearance");
}

} // namespace bask
