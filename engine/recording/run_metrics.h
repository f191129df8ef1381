#pragma once
// Results of a run as numbers, for each object and for the robot, each with its definition.

#include "engine/recording/session_file.h"

#include <array>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace bask {

/// Results of one object, from the last change of its target (or Start) until Stop, by a temperature T. The
/// step is the target minus T at the first sample of this time. Samples without T are left out. An empty
/// number is unknown or undefined.
struct ObjectMetrics {
    double target_K = 0.0; ///< the last one; NaN without a sample
    double from_s = 0.0;   ///< run time at which that target was set
    std::optional<double> step_K;
    std::optional<double> final_K; ///< T at the last sample
    /// Time from from_s until T stays within +-band of the target up to the last sample; empty if it is
    /// outside there.
    std::optional<double> settling_s;
    /// Run time from which it stays within the band; empty in the same case.
    std::optional<double> settledFrom_s;
    /// Time between T's first crossings of 10 % and 90 % of the step, linear between samples; empty if it
    /// does not reach them, or if the step is less than twice the band.
    std::optional<double> rise_s;
    /// How far T went beyond the target in the step's direction, K, 0 if it did not; empty for such small
    /// steps.
    std::optional<double> overshoot_K;
    /// Mean of T minus target over the last kSteadyWindow_s, or since it settled if that is shorter; empty if
    /// it is not settled. The second value is the standard deviation of T there, empty with fewer than two
    /// samples.
    std::optional<double> steadyError_K;
    std::optional<double> steadyDeviation_K;
    std::size_t steadySamples = 0; ///< in that mean
    double pathLength_m = 0.0;     ///< of the object's centre in R, over all samples until Stop

    // Standard uncertainties: of a sensor by engine/thermal/contact_uncertainty.h, else what the thermal
    // camera told; empty where they are not known, and of the true temperature.
    std::optional<double> readingUncertainty_K; ///< of final_K, and of the reading that made overshoot_K
    std::optional<double> steadyUncertainty_K;
    /// Of settling_s: of the time between readings, and by how far readings wrong by their standard
    /// uncertainty move the moment at which T comes into the band for good. Infinite if it were not in the
    /// band then: that it has settled is not sure. Empty where it was in the band from the beginning.
    std::optional<double> settlingUncertainty_s;
    /// Of rise_s: by how far errors of the readings at the beginning and at both crossings move these.
    std::optional<double> riseUncertainty_s;

    /// Returns the overshoot as a fraction of the step's size.
    std::optional<double> overshootShare() const;
};

/// Results of the run, from Start until Stop. A sample's command counts until the next sample.
struct RunMetrics {
    double band_K = kSettledBand_K;
    double period_s = 1.0;     ///< of sampling
    double resolution_K = 0.0; ///< of a reading: its steps or its noise, the larger one; 0: not known
    double duration_s = 0.0;   ///< until Stop, or the last sample if there was none; 0 without a sample
    std::size_t samples = 0;
    std::vector<ObjectMetrics> objects; ///< in the experiment's order, by what their thermometers read
    /// The same by the plant's own temperatures; empty where the recording has none.
    std::vector<ObjectMetrics> trueObjects;
    double pathLength_m = 0.0; ///< of the end-effector's origin
    double turned_rad = 0.0;   ///< sum of the angles between samples
    double clamped_s = 0.0;    ///< time during which a limit restricted the command
    /// The same for each Limit; workspace counts any of its bounds. Files of the first versions do not
    /// contain this.
    std::array<double, 6> atLimit_s{};
    double atVelocityLimit_s = 0.0; ///< speed, rotation or both
    /// Samples until Stop; without objects if there is none. The controller's estimates of the first are
    /// those that it told first.
    TraceSample first, last;
};

inline constexpr double kSteadyWindow_s = 60.0;

/// Computes them from a run's samples, one by one in order; memory is limited even for a day.
class RunMetricsCount {
public:
    explicit RunMetricsCount(const SessionRecord& facts, double band_K = kSettledBand_K);
    ~RunMetricsCount();
    RunMetricsCount(const RunMetricsCount&) = delete;
    RunMetricsCount& operator=(const RunMetricsCount&) = delete;

    void add(const TraceSample& sample); ///< ignored after Stop
    RunMetrics metrics() const;          ///< of the samples so far

private:
    struct ObjectCount;
    void addMotion(double time_s, const Pose& X_RE);
    void addUncertainties(std::size_t i, ObjectMetrics& out) const;

    double m_until_s;
    std::deque<std::pair<double, double>> m_pauses_s; ///< start and end of each pause; past ones are removed
    RunMetrics m_metrics;
    std::vector<double> m_offsets_K; ///< of the zeroing; empty: not known
    int m_window = 1;                ///< readings of the zeroing
    double m_stale_s = 0.0;          ///< readings further apart have a gap between them
    std::vector<ObjectCount> m_objects;
    Pose m_pose = Pose::Identity(); ///< of the end-effector at the last sample
    bool m_hasTruth = false;
};

RunMetrics runMetrics(const SessionRecord& session, double band_K = kSettledBand_K);

} // namespace bask
