#pragma once
// The numbers behind a trace plot, column by column in SI, and what each plotted quantity takes from them.

#include "engine/session/trace.h"

#include <utility>
#include <vector>

namespace bask {

/// What a trace plot shows against time.
enum class Quantity {
    Temperature, ///< measured, with target and tolerance band
    Error,       ///< measured minus target
    ViewFactor,
    Rate,     ///< dT/dt
    Speed,    ///< commanded, in percent of the limit; two series: translation and rotation
    Strength, ///< the controller's estimate of lambda1, K/s
};

/// Limits that make 100 % of the command speed.
struct SpeedLimits {
    double translation_m_s = 0.02;
    double rotation_rad_s = 0.1;
};

/// Samples of one run in the order of time.
class TraceColumns {
public:
    /// Starts again with this number of objects; more in a sample are left out, missing ones are NaN.
    void reset(std::size_t objects);

    /// Adds samples that are later than the last one. Returns the index of the first row added.
    std::size_t append(const std::vector<TraceSample>& samples);

    std::size_t rows() const { return m_time_s.size(); }
    std::size_t objects() const { return m_objects; }
    double time_s(std::size_t row) const { return m_time_s[row]; }
    double lastTime_s() const { return m_time_s.empty() ? 0.0 : m_time_s.back(); }

    static std::size_t seriesCount(Quantity quantity, std::size_t objects);
    /// Value in SI (K, K/s, 1); NaN where it is unknown or the reading was invalid. Speed in m/s and rad/s.
    double value(Quantity quantity, std::size_t series, std::size_t row) const;

    /// Row nearest in time; rows() when there is none.
    std::size_t nearestRow(double time_s) const;
    /// First row not before the time.
    std::size_t lowerRow(double time_s) const;

    /// Times at which an object's target changed, with the new target (K).
    const std::vector<std::pair<double, double>>& targetSteps(std::size_t object) const {
        return m_targets[object];
    }

private:
    struct ObjectColumns {
        std::vector<double> measured_K, error_K, viewFactor, rate_K_s, lambda1;
    };

    std::size_t m_objects = 0;
    std::vector<double> m_time_s, m_translation_m_s, m_rotation_rad_s;
    std::vector<ObjectColumns> m_columns;
    std::vector<std::vector<std::pair<double, double>>> m_targets;
};

} // namespace bask
