#pragma once
// Which sensor is on which object, by how both change while a thermal camera looks on.

#include "engine/runtime/second_opinion.h"

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace bask {

/// Two objects whose sensors seem to be exchanged.
struct ExchangedSensors {
    std::size_t one = 0, other = 0;
    double within_s = 0.0; ///< in which their readings changed as those of the other object
};

/// SecondOpinion compares temperatures, and so has to allow for all by which the camera may be wrong. That
/// hardly changes within seconds, so changes tell more: of the difference D between two sensors and C between
/// their objects in the camera, over a time in which C changes by dC, the sensors in their places demand D +
/// dC afterwards; sensors exchanged meanwhile -(D + dC); sensors exchanged before D - dC. Their sum is the
/// same in all three, which tells an exchange from one sensor that fails. The log of the ratio of the
/// likelihoods has to exceed kLogRatio. A sensor lags behind its object by an unknown time: what any lag
/// explains counts as explained.
class AssignmentWatch {
public:
    static constexpr double kLogRatio = 16.0; ///< odds of 1 to 9 million
    static constexpr double kOffset_K =
        0.5; ///< standard difference of two sensors' offsets, exchanged with them

    AssignmentWatch(std::size_t objects, double period_s);

    /// Takes what is seen at a time; empty for an object that the camera cannot read. Times must increase.
    void add(double now_s, const std::vector<std::optional<CameraOpinion>>& seen);
    /// Forgets all: the sensors may be handled.
    void reset();
    /// Returns the pair for which an exchange is likeliest, if it is likely for two readings in a row.
    const std::optional<ExchangedSensors>& exchanged() const { return m_exchanged; }

private:
    static constexpr std::array<double, 6> kLags_s{0.0, 1.0, 2.0, 3.5, 6.0, 10.0};
    using PerLag = std::array<double, kLags_s.size()>;
    struct Sample {
        double time_s = 0.0;
        double contact_K = 0.0;
        PerLag camera_K{};                          ///< as a sensor with this lag tells it
        double uncertainty_K = 0.0, excess_K = 0.0; ///< of the camera; above what the face reflects
    };
    struct Watch {
        std::deque<Sample> samples;
        PerLag camera_K{};
        double camera_s = 0.0, contact_s = 0.0;
        bool isBegun = false;
    };
    /// What an object's sensor and the camera told from one window to a later one.
    struct Change {
        double before_K = 0.0, after_K = 0.0;      ///< means of the sensor's readings
        double minSeen_K = 0.0, maxSeen_K = 0.0;   ///< change in the camera, for any lag
        double variance_K2 = 0.0;                  ///< of what may be wrong in it
        double minAfter_K = 0.0, maxAfter_K = 0.0; ///< of the camera itself afterwards, for any lag
        double uncertainty_K = 0.0;                ///< of these
    };
    void take(Watch& watch, double now_s, const CameraOpinion& seen) const;
    std::optional<Change> change(const Watch& watch, double end_s, double gap_s) const;
    static double logRatio(const Change& one, const Change& other);
    std::optional<ExchangedSensors> likeliest(double now_s) const;

    std::vector<Watch> m_objects;
    double m_period_s;
    std::optional<ExchangedSensors> m_before, m_exchanged;
};

} // namespace bask
