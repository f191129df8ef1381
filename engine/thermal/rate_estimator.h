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
    std::optional<int> leftOut; ///< sample of the window, 0 the oldest, that was taken for an outlier
};

/// Standard deviation of the estimate over that of independent errors of the samples.
struct NoiseGain {
    double value = 0.0;
    double slope_1_s = 0.0;
};

/// Gain at the last of the given times (growing, more than `order`), by least squares: with the design matrix
/// A and a' = (1, t, t^2 ...) at the last time, value^2 = a' (A'A)^-1 a and slope^2 = a_t' (A'A)^-1 a_t.
///
/// For n samples dt apart: order 1 has value^2 = (4n - 2) / (n (n + 1)), slope^2 = 12 / (dt^2 n (n^2 - 1));
/// order 3 has value^2 = 8 (2n - 1) (n^2 - n + 3) / (n (n + 1) (n + 2) (n + 3)) and slope^2 =
/// 200 (6n^4 - 27n^3 + 42n^2 - 30n + 11) / (dt^2 n (n^2 - 1) (n^2 - 4) (n^2 - 9)). The default, n = 10 and
/// order 3 at 1 s: 0.91 and 0.92 1/s, so that readings rounded to 0.1 K (0.029 K, with noise of 0.02 K
/// 0.035 K) give a rate good to 0.032 K/s. A window of 20 brings that to 0.35 1/s, order 2 to 0.41 1/s.
NoiseGain noiseGain(const std::vector<double>& times_s, int order);

/// Sliding window of the last `window` samples at their true times. Time is centred and scaled before the
/// fit, since raw cubes of seconds are ill-conditioned after minutes. Not thread-safe.
///
/// One sample of the window may be wrong by any amount: the one with the largest externally studentised
/// residual (its distance from the fit of all others, over the standard deviation of that distance, with the
/// scatter of the others but no less than the noise floor) is left out if that is over kOutlier. The floor
/// knows the readings' steps: a long row of equal readings has no scatter at all. Windows with fewer than
/// three samples more than the polynomial has coefficients cannot tell, and keep all. A ramp that begins is
/// kept: the newest sample is believed, until the next ones tell, when it has not changed faster than
/// kOnset_K_s. Of a faster ramp the first sample is left out when it jumps by about 0.6 K (window 10, order
/// 3), which makes the estimate late by that sample.
class RateEstimator {
public:
    static constexpr double kOutlier = 8.0;
    /// Painted aluminium of 1 mm before a source of 300 degC warms by 0.5 K/s.
    static constexpr double kOnset_K_s = 1.2;
    /// Readings in steps of 0.1 K with noise of 0.02 K.
    static constexpr double kNoiseFloor_K = 0.035;

    /// window > order >= 1; throws std::invalid_argument otherwise.
    RateEstimator(int window, int order, double noiseFloor_K = kNoiseFloor_K);

    /// Adds a sample; returns false and leaves the window as it was when the value is not finite or the time
    /// does not grow.
    bool add(double time_s, double temperature_K);
    void reset() { m_samples.clear(); }

    int count() const { return static_cast<int>(m_samples.size()); }
    bool full() const { return count() == m_window; }
    int window() const { return m_window; }

    /// Empty until the window is full.
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
