#pragma once
// Whether an object's temperature follows its heat, whatever its rates and losses are: by what it did before.

#include <optional>
#include <vector>

namespace bask {

/// What an object should have done and has not.
struct Unfollowed {
    double expected_K = 0.0; ///< at least, with its sign
    double gained_K = 0.0;
    double time_s = 0.0; ///< since when
};

/// Compares an object with itself. Over an earlier stretch of some length its mean rate r and mean absorbed
/// power p' (K/s, believed: lambda1 F) are known, whatever it lost then. Since the stretch's end its
/// temperature should have changed by d, with
///
///     d d/dt = r + k (p - p') - l d / tau,
///
/// where k is by how much the belief is wrong, within [1/kBeliefFactor, kBeliefFactor], and l how many times
/// the losses by radiation it has, from none to those of moving air. Where all of these ask for a change of
/// one sign, and even the least is enough, and less than kLeastShare of that has come, the object does not
/// follow its heat. Where one explains what is seen there is no fault.
class WarmingWatch {
public:
    static constexpr double kBeliefFactor = 3.0;
    static constexpr double kLeastShare = 0.1;
    static constexpr double kLongest_s = 300.0; ///< looked back, or the time constant

    /// By radiation alone; `least_K`: less that should have come is no matter.
    WarmingWatch(double timeConstant_s, double least_K);

    /// A valid reading and the power absorbed at its time, K/s. Times grow.
    void add(double time_s, double temperature_K, double power_K_s);
    void reset();
    /// It has been at rest for long, absorbing this: known when sensors are zeroed at ambient.
    void restAt(double time_s, double temperature_K, double power_K_s);

    /// The worst contradiction; looked for every few seconds.
    const std::optional<Unfollowed>& unfollowed() const { return m_unfollowed; }
    /// How long the readings have been the very same, s.
    double sameFor_s() const;
    /// The worst of at least least_K since the readings became the same.
    std::optional<Unfollowed> unfollowedWhileSame(double least_K) const;

private:
    struct Bin { ///< means of its readings, and the energy absorbed up to its middle
        double time_s = 0.0;
        double temperature_K = 0.0;
        double energy_K = 0.0;
        int count = 0;
    };
    /// The worst by the stretches that end with the bins [first, last), since each of these or since `start`.
    std::optional<Unfollowed> worstSince(std::size_t first, std::size_t last, const Bin* start,
                                         double least_K) const;
    /// By other powers before and after the middle of the time since a bin, all of it at one temperature.
    std::optional<Unfollowed> unmovedBy(std::size_t first, double least_K) const;
    /// By the stretch that ends with a bin.
    std::optional<Unfollowed> unfollowedAfter(std::size_t end, const Bin& start, double least_K) const;

    /// Of all that may be, from `start` to now; since_K: by how much it was warmer then than over the
    /// stretch. 0: of either sign.
    double leastExpected_K(std::size_t end, const Bin& start, double rate_K_s, double power_K_s,
                           double since_K) const;

    double m_timeConstant_s;
    double m_least_K;
    double m_bin_s;
    std::optional<Unfollowed> m_unfollowed{};
    std::vector<Bin> m_bins; ///< oldest first; the last one is being filled
    double m_binStart_s = 0.0;
    double m_time_s = 0.0, m_temperature_K = 0.0, m_before_K = 0.0; ///< newest readings
    double m_power_K_s = 0.0, m_energy_K = 0.0;
    Bin m_same;             ///< the first reading of those that are the very same, with the energy then
    double m_noise_K = 0.0; ///< standard deviation of a reading, by second differences
    int m_count = 0;
};

} // namespace bask
