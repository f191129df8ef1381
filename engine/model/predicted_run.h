#pragma once
// A run as it is predicted before Start.

#include "engine/base/pose.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace bask {

/// One moment of a predicted run.
struct PredictedSample {
    double time_s = 0.0;                     ///< since Start
    Vector6d coordinates = Vector6d::Zero(); ///< end-effector in R, m and rad
    std::vector<double> temperatures_K;      ///< of each object, in the experiment's order
    /// of runs whose sensors' noise is another; empty: not computed
    std::vector<double> lowest_K{}, highest_K{};
};

/// How a predicted run ends.
enum class PredictedEnd : std::uint8_t {
    Settled,
    Limit, ///< not settled by the latest end of a run
    Cut,   ///< the computation was stopped: how it goes on is not known
    Fault  ///< a fault or an alarm ends it
};

struct PredictedRun {
    static constexpr std::size_t kMaxSamples = 500;
    static constexpr int kDraws = 4; ///< runs with other noise of the sensors, which make the band

    std::vector<PredictedSample>
        samples;                      ///< in time order, with the first and the last; empty: no prediction
    std::optional<double> settling_s; ///< when all objects have settled; empty: they do not, or not known
    PredictedEnd end = PredictedEnd::Settled;

    double end_s() const { return samples.empty() ? 0.0 : samples.back().time_s; }
    bool hasBand() const { return !samples.empty() && !samples.front().lowest_K.empty(); }
};

} // namespace bask
