#pragma once
// Detects a stopped sensor: exactly the same value for longer than its own noise allows.

namespace bask {

/// Learns a sensor's noise and resolution step from its readings. A sensor whose noise is smaller than its
/// step can give the same value for minutes and is fine; only one with larger noise is reported.
class QuietWatch {
public:
    static constexpr double kQuiet_s = 30.0;

    /// Takes a valid reading. Times must increase.
    void add(double time_s, double value_K);
    /// Returns how long the readings have been exactly the same, s; 0 if it is less than kQuiet_s or the
    /// noise allows it.
    double quietFor_s() const;
    /// A person confirms that the sensor is fine: starts again.
    void confirm();

private:
    double m_time_s = 0.0;
    double m_since_s = 0.0; ///< when the current value was first read
    int m_same = 0;         ///< number of readings of it
    int m_count = 0;        ///< number of readings used for the noise
    double m_step_K = 0.0;  ///< smallest change between two readings; 0 if there was none yet
    double m_variance_K2 = 0.0;
    double m_last_K[2]{}; ///< newest first
};

} // namespace bask
