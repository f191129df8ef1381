#pragma once
// Temperature and its rate at the newest sample: polynomial least squares over a sliding window (paper,
// Appendix C).

#include <deque>
#include <optional>

namespace bask {

/// Value and slope of the fitted polynomial at the newest sample's time.
struct RateEstimate {
    double temperature_K = 0.0;
    double rate_K_s = 0.0;
};

/// Sliding window of the last `window` samples at their true times. Time is centred and scaled before the
/// fit, since raw cubes of seconds are ill-conditioned after minutes. Not thread-safe.
class RateEstimator {
public:
    /// window > order >= 1; throws std::invalid_argument otherwise.
    RateEstimator(int window, int order);

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
    std::deque<Sample> m_samples;
};

} // namespace bask
