#pragma once
// When a live thermal camera's shutter was open again, from the times of its frames.

#include <algorithm>
#include <limits>
#include <optional>

namespace bask {

/// A camera that looks at its own shutter gives no new frame, or the same one again, for some tenths of a
/// second. A hold-up of the computer looks the same.
class ShutterWatch {
public:
    static constexpr double kShut_s = 0.3;
    static constexpr double kShutPeriods = 2.5; ///< of a camera that is slow

    explicit ShutterWatch(std::optional<double> frameRate_Hz)
        : m_shut_s(std::max(kShut_s, frameRate_Hz ? kShutPeriods / *frameRate_Hz : 0.0)) {}

    /// Takes the time of a frame that is new.
    void add(double time_s) {
        if (time_s - m_last_s >= m_shut_s)
            m_opened_s = time_s;
        m_last_s = time_s;
    }
    /// Returns the time of the first frame after the last event; empty before any.
    std::optional<double> opened_s() const { return m_opened_s; }

private:
    double m_shut_s;
    double m_last_s = std::numeric_limits<double>::infinity(); ///< of the last new frame
    std::optional<double> m_opened_s;
};

} // namespace bask
