#pragma once
// Detects a stopped sensor: exactly the same value for longer than its own noise allows.

#include <deque>
#include <optional>
#include <vector>

namespace bask {

/// Learns a sensor's noise and resolution step from its readings. A sensor whose noise is smaller than its
/// step can give the same value for minutes and is fine; only one with larger noise is reported, once there
/// are more equal readings than noise gives with a probability of kFalse, and kTimesUsual times as many as
/// ever before, since some devices repeat their readings.
class QuietWatch {
public:
    static constexpr double kFalse = 1e-9;
    static constexpr int kTimesUsual = 3;

    /// Takes a valid reading. Times must increase.
    void add(double time_s, double value_K);
    /// Returns how long the readings have been exactly the same, s; 0 if the noise allows it.
    double quietFor_s() const;
    /// A person confirms that the sensor is fine: starts again.
    void confirm();

private:
    /// Returns after how many equal readings it is quiet; empty if its noise is too small to tell.
    std::optional<int> enough() const;

    double m_time_s = 0.0;
    double m_since_s = 0.0;             ///< when the current value was first read
    int m_same = 0;                     ///< number of readings of it
    int m_longest = 1;                  ///< largest number of equal readings before
    int m_count = 0;                    ///< number of readings used for the noise
    double m_step_K = 0.0;              ///< smallest change between two readings; 0 if there was none yet
    std::deque<double> m_seconds_K;     ///< newest second differences
    std::vector<double> m_newSeconds_K; ///< those since the current value was first read
    double m_last_K[2]{};               ///< newest first
};

} // namespace bask
