#pragma once
// Whether an object's temperature follows its heat, whatever its rates and losses are: by what it did before.

#include "engine/runtime/heat_fit.h"

#include <array>
#include <deque>
#include <optional>
#include <vector>

namespace bask {

/// What an object should have done and has not.
struct Unfollowed {
    double expected_K = 0.0; ///< at least, with its sign
    double gained_K = 0.0;
    double time_s = 0.0;       ///< since when
    bool isImpossible = false; ///< no rates explain what came
    double missing_K() const { return expected_K - gained_K; }
};

/// Learns from an object's readings by how much the estimate of its heating is wrong and how it loses heat,
/// as HeatFit keeps them: all that explain it. Where all of these ask for a change of one sign, and even the
/// smallest is enough, and less than kMinShare of that has come, the object does not follow its heat. Where
/// one explains what is seen there is no fault. The newest readings are judged, not learnt from: learnt from
/// is what is older than kJudged_s, and nothing that is the very same value for long.
class WarmingWatch {
public:
    static constexpr double kMinShare = 0.1;
    static constexpr double kLongest_s = 300.0; ///< looked back
    static constexpr double kJudged_s = 90.0;

    /// `min_K`: less that should have come is no matter.
    WarmingWatch(LossRange losses, double environment_K, double min_K);

    /// The power absorbed at a time, K/s, and a valid reading; empty: there is none. Times grow.
    void add(double time_s, std::optional<double> temperature_K, double power_K_s);
    void reset();
    /// Its sensor has been zeroed: it is as warm as the room.
    void restAt(double time_s, double temperature_K);

    /// The worst contradiction; looked for every few seconds.
    const std::optional<Unfollowed>& unfollowed() const { return m_unfollowed; }
    /// How long the readings have been the very same, s.
    double sameFor_s() const;
    /// The worst of at least min_K since the readings became the same.
    /// `isQuiet`: the sensor's noise is gone too, and energy and losses are taken as estimated.
    std::optional<Unfollowed> unfollowedWhileSame(double min_K, bool isQuiet) const;

private:
    static constexpr std::array<double, 7> kLags_s{0.0, 1.0, 2.0, 3.5, 5.0, 8.0, 15.0}; ///< of sensors
    /// Of the losses: from the linear law (0) through the fourth power (1) to free convection, always the
    /// same.
    static constexpr std::size_t kLaws = 6;
    /// One for each two neighbouring lags, between which that of the sensor may be, and each law.
    using Fits = std::vector<HeatFit>;
    static constexpr std::size_t kFits = (kLags_s.size() - 1) * kLaws;
    /// Integrals from the beginning up to a time; of a bin the means over its readings.
    struct Mark {
        double time_s = 0.0;
        double temperature_K = 0.0;
        std::array<double, kLags_s.size()> energy_K{}; ///< absorbed, as a sensor with such a lag sees it
        double linear_K_s = 0.0, radiated_K_s = 0.0;   ///< losses by the linear law and by the fourth power
        int count = 0;
    };
    void integrate(double dt_s, double power_K_s);
    /// `wrong`: share by which energy and losses may be others.
    HeatSpan span(const Mark& from, const Mark& to, std::size_t fit, double wrong) const;
    void learn(Fits& fits, std::size_t end) const;
    HeatFit::Change expected(const Fits& fits, const Mark& from, double wrong) const;
    std::optional<Unfollowed> worst(const Fits& fits, const Mark& from, double min_K, double wrong) const;
    std::optional<Unfollowed> impossible(const Mark& from) const;
    std::optional<Unfollowed> bent(const Fits& fits, const Mark& middle, double min_K) const;
    void judge();

    LossRange m_losses;
    double m_environment_K;
    std::optional<double> m_zeroed_s{}; ///< when the room's temperature was measured
    double m_min_K;
    double m_bin_s;
    Fits m_anything; ///< that knows the bounds only
    Fits m_fits;
    std::optional<Unfollowed> m_unfollowed{};
    std::deque<Mark> m_bins; ///< oldest first; the last one is being filled
    double m_binStart_s = 0.0;
    std::size_t m_learnt = 0;                         ///< bins up to here have been learnt from
    Mark m_now;                                       ///< count: readings so far
    Mark m_same;                                      ///< at the first of the readings that are the very same
    std::array<double, kLags_s.size()> m_power_K_s{}; ///< as lagging sensors see it
    double m_before_K = 0.0;                          ///< reading before the newest
    double m_noise_K = 0.0; ///< standard deviation of a reading, by second differences
};

} // namespace bask
