#pragma once
// Heat rates of one object from a record of it, by linear least squares, with standard errors and a verdict.

#include "engine/base/message.h"
#include "engine/thermal/heat_balance.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace bask {

/// One row of a record.
struct HeatSample {
    double time_s = 0.0; ///< growing
    double temperature_K = 0.0;
    double viewFactor = 0.0;     ///< known also where the reading is not
    double sourceStrength = 1.0; ///< net source power over the one that lambda1 is to stand for
    bool valid = true;           ///< temperature_K is a fresh reading
};

struct IdentificationOptions {
    double environment_K = 298.15;         ///< T3
    double environmentDeviation_K = 0.0;   ///< standard error of T3, passed on into those of the rates
    double absorptanceOverEmittance = 1.0; ///< of the object: lambda3 = lambda2 T3^4 alpha2 / eps2
    bool freeAmbient = false;              ///< lambda3 is fitted, not tied to lambda2
    bool convection = false;               ///< h' is fitted; 0 otherwise
};

/// NaN where it was not asked for or could not be told.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
};

struct IdentifiedRates {
    Estimate lambda1;    ///< K/s, at source strength 1
    Estimate lambda2;    ///< 1/(K3 s)
    Estimate lambda3;    ///< K/s
    Estimate convection; ///< h' = h / (m c / A), 1/s
    int readings = 0;    ///< that the fit rests on
    int outliers = 0;    ///< left out
    int windows = 0;
    double window_s = 0.0;
    double residual_K = 0.0; ///< standard deviation of the readings about the fit
    double condition = 0.0;  ///< of the scaled problem; the larger, the less the rates are told apart
    Message reason;          ///< why the rates cannot be used; code None: they can

    bool usable() const { return reason == Message{}; }
    HeatRates rates() const { return {lambda1.value, lambda2.value, lambda3.value}; }
};

/// Fits the integral of the heat balance over windows [t0, t0 + w] that do not overlap,
///
///   T(t) = T0 + lambda1 int s F - lambda2 int T^4 + lambda3 (t - t0) - h' int (T - T3)       (from t0 to t)
///
/// with a T0 of its own in each window. The integral form needs no differentiated temperature: a difference
/// quotient of two readings dt apart has 1.4 / dt times their noise, while in an integral noise averages out.
/// With T0 free the errors within a window are those of single readings, hence independent, and windows share
/// nothing; what is not in the balance cannot pile up for longer than one. Standard errors are the greater of
/// two estimates: of ordinary least squares (independent errors) and by the scatter of the windows (White's
/// "sandwich", any correlation within a window, as rounding makes it). Readings off the fit by more than six
/// robust standard deviations and 0.1 K are left out, the worst first.
///
/// Not usable, with the reason: too few readings, a source never in view, view factor and temperatures that
/// hardly vary, a rate with a standard error over a quarter of it, a rate below zero.
IdentifiedRates identifyRates(const std::vector<HeatSample>& record, const IdentificationOptions& options);

} // namespace bask
