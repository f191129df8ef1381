#pragma once
// Temperature and its rate at the newest sample: polynomial least squares over a sliding window (paper,
// Appendix C), robust to one outlier.

#include <deque>
#include <optional>
#include <vector>

namespace bask {

/// Value and slope of the fitted polynomial at the newest sample's time.
struct RateEstimate {
    double temperature_K = 0.0;
    double rate_K_s = 0.0;
    /// Index in the window (0 is the oldest) of the sample that was left out as an outlier.
    std::optional<int> leftOut;
};

/// Standard deviation of the estimate divided by that of independent errors of the samples.
struct NoiseGain {
    double value = 0.0;
    double slope_1_s = 0.0;
};

/// Returns the gain at the last of the given times (ascending, more than `order`), by least squares: with the
/// design matrix A and a' = (1, t, t^2 ...) at the last time, value^2 = a' (A'A)^-1 a and slope^2 = a_t'
/// (A'A)^-1 a_t.
///
/// For n samples dt apart: order 1 has value^2 = (4n - 2) / (n (n + 1)), slope^2 = 12 / (dt^2 n (n^2 - 1));
/// order 3 has value^2 = 8 (2n - 1) (n^2 - n + 3) / (n (n + 1) (n + 2) (n + 3)) and slope^2 = 200 (6n^4 -
/// 27n^3 + 42n^2 - 30n + 11) / (dt^2 n (n^2 - 1) (n^2 - 4) (n^2 - 9)). The default, n = 10 and order 3 at 1
/// s, has 0.91 and 0.92 1/s: readings rounded to 0.1 K (0.029 K, with noise of 0.02 K 0.035 K) give a rate
/// with a standard deviation of 0.032 K/s. A window of 20 reduces the slope's gain to 0.35 1/s, order 2 to
/// 0.41 1/s.
NoiseGain noiseGain(const std::vector<double>& times_s, int order);

/// A sliding window of the last `window` samples at their true times. Time is centred and scaled before the
/// fit, since raw cubes of seconds are ill-conditioned after minutes. Not thread-safe.
///
/// One sample of the window may be wrong by any amount. The sample with the largest externally studentised
/// residual (its distance from the fit of all others, divided by the standard deviation of that distance,
/// from the scatter of the others or from the noise floor, whichever is larger) is left out if that is above
/// kOutlier. The floor accounts for the resolution of the readings: a series of equal readings has no scatter
/// at all. A window needs at least three samples more than the polynomial has coefficients; otherwise all
/// samples are kept. The start of a ramp is kept: the newest sample is accepted, until the next ones decide,
/// if it has not changed faster than kOnset_K_s. The first sample of a faster ramp is left out if it jumps by
/// about 0.6 K (window 10, order 3); the estimate is then late by that sample.
class RateEstimator {
public:
    static constexpr double kOutlier = 8.0;
    /// For comparison: painted aluminium of 1 mm in front of a source of 300 degC warms by 0.5 K/s.
    static constexpr double kOnset_K_s = 1.2;
    /// For readings in steps of 0.1 K with noise of 0.02 K.
    static constexpr double kNoiseFloor_K = 0.035;

    /// Requires window > order >= 1; throws std::invalid_argument otherwise.
    RateEstimator(int window, int order, double noiseFloor_K = kNoiseFloor_K);

    /// Adds a sample. Returns false and leaves the window unchanged if the value is not finite or the time
    /// does not increase.
    bool add(double time_s, double temperature_K);
    void reset() { m_samples.clear(); }

    int count() const { return static_cast<int>(m_samples.size()); }
    bool full() const { return count() == m_window; }
    int window() const { return m_window; }

    /// Returns the estimate; empty until the window is full.
    std::optional<RateEstimate> estimate() const;

private:
    struct Sample {
        double time_s;
        double temperature_K;
    };
    int m_window;
    int m_order;
    double m_noiseFloor_K;
    std::deque<Sample> m_samples;
};

} // namespace bask
