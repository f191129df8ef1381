#pragma once
// Checks whether an object's temperature follows its heat, whatever its rates and losses are, by learning
// from its past.

#include "engine/runtime/heat_fit.h"
#include "engine/runtime/lagged_power.h"

#include <deque>
#include <optional>
#include <vector>

namespace bask {

/// A temperature change that should have happened and did not.
struct Unfollowed {
    double expected_K = 0.0; ///< minimum change, with its sign
    double gained_K = 0.0;
    double time_s = 0.0;       ///< time span
    bool isImpossible = false; ///< no rates explain the change
    double missing_K() const { return expected_K - gained_K; }
};

/// A rise that is faster than the heat explains.
struct ForeignHeat {
    double rate_K_s = 0.0;
    double explained_K_s = 0.0; ///< maximum of any rates, lags and losses
};

/// Learns from an object's readings how wrong the estimate of its heating is and how it loses heat. It keeps
/// all explanations, as HeatFit does. The object does not follow its heat if all explanations demand a change
/// of the same sign, even the smallest is large enough, and less than kMinShare of it has happened. There is
/// no fault if one explanation fits. The newest readings are judged but not learnt from: only what is older
/// than kJudged_s is learnt, and no value that stays exactly the same for long. One that stays nearly the
/// same without heat tells where the room is.
class WarmingWatch {
public:
    static constexpr double kMinShare = 0.1;
    static constexpr double kLongest_s = 300.0; ///< how far it looks back
    static constexpr double kJudged_s = 90.0;
    static constexpr double kRise_s = 30.0; ///< how far it looks back for a rise

    /// Expected changes smaller than `min_K` are ignored.
    WarmingWatch(LossRange losses, double environment_K, double min_K);

    /// Takes the absorbed power at a time, K/s, and a valid reading; empty if there is none. Times must
    /// increase. `uncertainty_K`: standard uncertainty of the reading that no mean makes smaller, as of a
    /// thermal camera; what may come from it is neither learnt nor told.
    void add(double time_s, std::optional<double> temperature_K, double power_K_s,
             double uncertainty_K = 0.0);
    void reset();
    /// Call when the sensor has been zeroed: the object is at the room's temperature.
    void restAt(double time_s, double temperature_K);

    /// The worst contradiction, updated every few seconds.
    const std::optional<Unfollowed>& unfollowed() const { return m_unfollowed; }
    /// The largest rise of the last kRise_s that no rates explain, updated every few seconds.
    const std::optional<ForeignHeat>& foreignHeat() const { return m_foreignHeat; }
    /// How far the change of `readings` over the last `time_s` is from what this object's heat explains by
    /// what was learnt, K, positive if they are too warm; empty if it is not known. An object's own readings
    /// are *this; those of another one tell whether the sensors are swapped.
    std::optional<double> unexplained_K(const WarmingWatch& readings, double time_s) const;
    /// How long the readings have been exactly the same, s.
    double sameFor_s() const;
    /// Returns the worst contradiction of at least min_K since the readings became the same.
    std::optional<Unfollowed> unfollowedWhileSame(double min_K) const;

private:
    /// Laws of the losses: from the linear law (0) through the fourth power (1) to free convection, in equal
    /// steps.
    static constexpr std::size_t kLaws = 6;
    /// One fit for each pair of neighbouring lags, between which the sensor's lag may be, and each law.
    using Fits = std::vector<HeatFit>;
    static constexpr std::size_t kFits = (LaggedPower::kLags_s.size() - 1) * kLaws;
    /// Integrals from the beginning up to a time; for a bin, the means over its readings.
    struct Mark {
        double time_s = 0.0;
        double temperature_K = 0.0;
        double uncertainty_K = 0.0;
        LaggedPower::Energies energy_K{};            ///< absorbed energy, as a sensor with this lag sees it
        double linear_K_s = 0.0, radiated_K_s = 0.0; ///< losses by the linear law and by the fourth power
        int count = 0;
    };
    void integrate(double dt_s, double power_K_s);
    /// `wrong` is the relative error of energy and losses.
    HeatSpan span(const Mark& from, const Mark& to, std::size_t fit, double wrong) const;
    /// Where the reading stays as it is without heat, the object, or a sensor that is off it, has found its
    /// balance with the room: changes are counted from there, and the room need not be known.
    void noteRest();
    /// By how much the room may be warmer or colder than the reference at a time.
    double roomUnknown_K(double time_s) const;
    /// By how much a change between two marks may be wrong.
    static double unsure_K(const Mark& from, const Mark& to);
    void learn(Fits& fits, std::size_t end) const;
    std::optional<Mark> at(double time_s) const; ///< between bins; empty before and after them
    HeatFit::Change expected(const Fits& fits, const Mark& from, double wrong) const;
    std::optional<Unfollowed> worst(const Fits& fits, const Mark& from, double min_K, double wrong) const;
    std::optional<Unfollowed> impossible(const Mark& from) const;
    std::optional<Unfollowed> bent(const Fits& fits, const Mark& middle, double min_K) const;
    void judge();
    void judgeRise();

    LossRange m_losses;
    double m_environment_K;
    std::optional<double> m_zeroed_s{}; ///< time when the room's temperature was measured
    bool m_isRest = false;              ///< it was told by a rest, from which changes are counted
    double m_restRate_K_s = 0.0;        ///< by which the temperature may still have changed there
    double m_min_K;
    double m_bin_s;
    Fits m_anything; ///< a fit that knows the bounds only
    Fits m_fits;
    std::optional<Unfollowed> m_unfollowed{};
    std::optional<ForeignHeat> m_foreignHeat{};
    double m_riseFrom_s = 0.0; ///< rises that began before are not judged
    std::deque<Mark> m_bins;   ///< oldest first; the last one is being filled
    double m_binStart_s = 0.0;
    std::size_t m_learnt = 0; ///< number of bins that have been learnt from
    Mark m_now;               ///< its count is the number of readings so far
    Mark m_same;              ///< at the first of the equal readings
    LaggedPower m_power;
    double m_read_s = 0.0;   ///< time of the newest reading
    double m_usual_s = 0.0;  ///< usual time between two readings
    double m_before_K = 0.0; ///< the reading before the newest one
    double m_noise_K = 0.0;  ///< standard deviation of a reading, from second differences
};

} // namespace bask
