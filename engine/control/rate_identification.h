#pragma once
// Recursive least squares for lambda1 and lambda2 of one object during a run.

#include "engine/thermal/heat_balance.h"

#include <Eigen/Core>

#include <deque>

namespace bask {

/// Fits  T(t) - T(t-w) = lambda1 * integral(s F) - lambda2 * integral(T^4 - T0^4 + h'(T) (T - T_air) /
/// lambda2) with T0^4 = lambda3 / lambda2, both ratios to lambda2 those of the start, over a short window w:
/// the integral form of the heat balance, which needs no differentiated temperature. Old data are forgotten
/// exponentially, back to a wide prior about the start values, so that a long rest at a steady state neither
/// winds the estimate up nor freezes it. Estimates are the minimum within bounds, not clipped.
class RateIdentification {
public:
    static constexpr double kRange = 10.0;       ///< estimates stay within start / kRange .. start * kRange
    static constexpr double kForgetting = 0.998; ///< for each sample, or slower:
    static constexpr double kMemory = 0.5;       ///< in time constants of the object, at least
    static constexpr double kWindow_s = 6.0;     ///< window of the integral, or longer:
    static constexpr double kWindow = 0.01;      ///< in time constants of the object, at least
    static constexpr double kNoise_K = 0.05;     ///< of the difference of two readings
    static constexpr double kPrior = 1.0;        ///< standard deviation of lambda / start - 1

    explicit RateIdentification(const HeatRates& start);

    /// Adds a sample: measured temperature, view factor, source strength and what the neighbours add to the
    /// room's T^4 at time_s (ascending).
    /// Returns the error of the predicted change over the window, K, divided by the square root of 1 + the
    /// variance that the rates' uncertainty adds to the noise's: what is still guessed counts less. 0 without
    /// a change.
    double add(double time_s, double temperature_K, double F, double sourceStrength,
               double neighbours_K4 = 0.0);
    /// Returns the present estimate; the ratios of all losses to lambda2 are fixed.
    HeatRates rates() const;
    /// Returns the standard deviation of the steady view factor for temperature T_K, from the fit's
    /// covariance.
    double steadyViewFactorDeviation(double T_K) const;

private:
    struct Sample {
        double time_s;
        double temperature_K;
        double heating; ///< integral of s F since the start, s
        double cooling; ///< integral of the losses over lambda2 since the start, K4 s
    };
    /// Returns the losses over lambda2, K4.
    double cooling_K4(double T_K) const;
    double update(const Sample& from, const Sample& to, double forgetting);

    HeatRates m_start;
    double m_timeConstant_s; ///< at the environment's temperature, with the estimate of the start
    double m_lastF = 0.0;
    double m_lastCooling_K4 = 0.0;
    std::deque<Sample> m_samples;
    // In units of the start values, about them: minimise x'Ax/2 - b'x, x = lambda / start - 1.
    Eigen::Matrix2d m_information;
    Eigen::Vector2d m_vector = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_relative = Eigen::Vector2d::Ones(); ///< lambda / start
};

} // namespace bask
