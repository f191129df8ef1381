#pragma once
// Whether a sensor has stopped: the very same value for longer than its own noise lets it be.

namespace bask {

/// Learns a sensor's noise and step from its readings. One that rests within its step gives the same value
/// for minutes and is fine; of one whose noise is larger than its step that is told.
class QuietWatch {
public:
    static constexpr double kQuiet_s = 30.0;

    /// A valid reading. Times grow.
    void add(double time_s, double value_K);
    /// How long the readings have been the very same, s; 0: not for kQuiet_s, or its noise allows it.
    double quietFor_s() const;
    /// A person says that it is fine: from now on anew.
    void confirm();

private:
    double m_time_s = 0.0;
    double m_since_s = 0.0; ///< of the value
    int m_same = 0;         ///< readings of it
    int m_count = 0;        ///< from which the noise is known
    double m_step_K = 0.0;  ///< least change between two readings; 0: none yet
    double m_variance_K2 = 0.0;
    double m_last_K[2]{}; ///< newest first
};

} // namespace bask
