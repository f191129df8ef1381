#pragma once
// What a run was worth in numbers: of each object and of the robot, every one by its written definition.

#include "engine/recording/session_file.h"

#include <array>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace bask {

/// Of one object, judged on the plant's true temperature T where there is one, else on the estimate, from the
/// last change of its target (or Start) until Stop. The step is the target minus T at the first sample then.
/// An empty number is not known or not defined.
struct ObjectMetrics {
    double target_K = 0.0; ///< the last one; NaN without a sample
    double from_s = 0.0;   ///< run time at which that target was set
    bool isTrue = false;   ///< T is the plant's own temperature
    std::optional<double> step_K;
    std::optional<double> final_K; ///< T at the last sample
    /// From from_s until T stays within +-band of the target up to the last sample; empty when it is outside
    /// there.
    std::optional<double> settling_s;
    std::optional<double> settledFrom_s; ///< run time from which on it stays within the band; empty as that
    /// Between T's first crossings of 10 % and of 90 % of the step, linear between samples; empty when it
    /// gets not so far, or when the step is less than twice the band.
    std::optional<double> rise_s;
    /// How far T went beyond the target in the step's direction, K, 0 when it did not; empty for such small
    /// steps.
    std::optional<double> overshoot_K;
    /// Mean of T minus target over the last kSteadyWindow_s, or since it settled where that is less; empty
    /// when not settled. And the standard deviation of T there, empty with fewer than two samples.
    std::optional<double> steadyError_K;
    std::optional<double> steadyDeviation_K;
    double pathLength_m = 0.0; ///< of the object's centre in R, over all samples until Stop

    /// Overshoot as a share of the step's size.
    std::optional<double> overshootShare() const;
};

/// Of the run, from Start until Stop. A sample's command counts until the next sample.
struct RunMetrics {
    double band_K = kSettledBand_K;
    double duration_s = 0.0;
    std::size_t samples = 0;
    std::vector<ObjectMetrics> objects; ///< in the experiment's order
    double pathLength_m = 0.0;          ///< of the end-effector's origin
    double turned_rad = 0.0;            ///< sum of the angles that it was turned by between samples
    double heldBack_s = 0.0;            ///< some limit held the command back
    /// Held back by that limit, by Limit; workspace: any of its bounds. Files of the first versions name
    /// none.
    std::array<double, 6> atLimit_s{};
    double atVelocityLimit_s = 0.0; ///< speed, rotation or both
    TraceSample last;               ///< until Stop; without objects: there is none
};

inline constexpr double kSteadyWindow_s = 60.0;

/// Counts them from a run's samples, one by one in their order; keeps no more of a day than of some minutes.
class RunMetricsCount {
public:
    explicit RunMetricsCount(const SessionRecord& facts, double band_K = kSettledBand_K);
    ~RunMetricsCount();
    RunMetricsCount(const RunMetricsCount&) = delete;
    RunMetricsCount& operator=(const RunMetricsCount&) = delete;

    void add(const TraceSample& sample); ///< after Stop: is left out
    RunMetrics metrics() const;          ///< of the samples so far

private:
    struct ObjectCount;
    void addMotion(const TraceSample& sample);

    double m_until_s;
    std::deque<std::pair<double, double>> m_holds_s; ///< from, until; those over are left out
    RunMetrics m_metrics;
    std::vector<ObjectCount> m_objects;
};

RunMetrics runMetrics(const SessionRecord& session, double band_K = kSettledBand_K);

} // namespace bask
