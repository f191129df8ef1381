#pragma once
// Heat rates of one object, identified from its record by linear least squares, with standard errors and a
// verdict.

#include "engine/base/message.h"
#include "engine/thermal/heat_balance.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace bask {

/// One row of a record.
struct HeatSample {
    double time_s = 0.0; ///< in ascending order
    double temperature_K = 0.0;
    double viewFactor = 0.0;     ///< also valid if the reading is not
    double sourceStrength = 1.0; ///< net source power divided by the power for which lambda1 is given
    bool valid = true;           ///< temperature_K is a fresh reading
    /// Mean view factor since the row before; NaN: that of a straight line between the two.
    double meanViewFactor = std::numeric_limits<double>::quiet_NaN();
    double neighbours_K4 = 0.0; ///< by which neighbours raise the room's T^4, see Neighbours
};

struct IdentificationOptions {
    double environment_K = 298.15;       ///< T3
    double environmentDeviation_K = 0.0; ///< standard error of T3, included in those of the rates
    double environmentShare = 1.0;       ///< lambda3 / (lambda2 T3^4), see environmentShare()
    bool freeAmbient = false;            ///< whether lambda3 is fitted by itself, not tied to lambda2
    bool convection = false;             ///< whether a constant h' is fitted
    /// The air's known loss over lambda2, K4 and its powers, if h' is not fitted: h and the emittance are
    /// known, m c / A is not. Its air_K is ignored: the air has the temperature environment_K.
    AirLoss airPerLambda2{};
    bool isAirKnown = false; ///< whether airPerLambda2 is what the air takes; else nothing is known of it
};

/// A value with its standard error; NaN if it was not requested or could not be determined.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
};

struct IdentifiedRates {
    Estimate lambda1;    ///< K/s, at source strength 1
    Estimate lambda2;    ///< 1/(K3 s)
    Estimate lambda3;    ///< K/s
    Estimate convection; ///< h' = h / (m c / A), 1/s
    /// Median temperature of the record's second half, K, at which the next two are given.
    double workingTemperature_K = std::numeric_limits<double>::quiet_NaN();
    Estimate loss;      ///< of radiation and air together, less what the room gives, K/s
    Estimate lossSlope; ///< its derivative by the object's temperature, 1/s
    Message caveat;     ///< what the record does not tell; code None if nothing
    int readings = 0;   ///< number of readings used in the fit
    int outliers = 0;   ///< number of readings left out
    int windows = 0;
    double window_s = 0.0;
    double residual_K = 0.0; ///< standard deviation of the readings about the fit
    /// Condition of the scaled problem; if it is large, the rates are hard to separate.
    double condition = 0.0;
    Message reason; ///< why the rates cannot be used; code None if they can

    bool usable() const { return reason == Message{}; }
    AirLoss airPerLambda2{}; ///< as in the options; zero if h' was fitted
    HeatRates rates() const {
        return {lambda1.value, lambda2.value, lambda3.value, airPerLambda2.scaled(lambda2.value)};
    }
};

/// Fits the integral of the heat balance over two windows [t0, t0 + w] of the record, or more of ten minutes,
///
///   T(t) = T0 + lambda1 (int s F + d s (F(t) - F(t0))) - lambda2 int (T^4 - neighbours) + lambda3 (t - t0) -
///   h' int (T - T3),
///
/// with its own T0 in each window and one time d by which all readings come before or after the view factors.
/// The integral form needs no differentiated temperature: a difference quotient of two readings dt apart
/// has 1.4 / dt times their noise, while an integral averages noise out. Readings that differ from the fit by
/// more than six robust standard deviations and 0.1 K are left out, the worst first. Standard errors, and the
/// bias that is taken off, are those of fits to synthetic records (SyntheticRecords). Radiation and
/// convection differ only by the curvature of T^4: where a record cannot tell them apart, the caveat says so,
/// and the loss and its slope at the working temperature are what it does tell.
///
/// Not usable, with the reason, in these cases: too few readings, a source that is never in view, view factor
/// and temperatures that hardly vary, a rate with a standard error above a quarter of it, a negative rate.
IdentifiedRates identifyRates(const std::vector<HeatSample>& record, const IdentificationOptions& options);

} // namespace bask
