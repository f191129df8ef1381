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
};

struct IdentificationOptions {
    double environment_K = 298.15;       ///< T3
    double environmentDeviation_K = 0.0; ///< standard error of T3, included in those of the rates
    double environmentShare = 1.0;       ///< lambda3 / (lambda2 T3^4), see environmentShare()
    bool freeAmbient = false;            ///< whether lambda3 is fitted by itself, not tied to lambda2
    bool convection = false;             ///< whether h' is fitted; it is 0 otherwise
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
    int readings = 0;    ///< number of readings used in the fit
    int outliers = 0;    ///< number of readings left out
    int windows = 0;
    double window_s = 0.0;
    double residual_K = 0.0; ///< standard deviation of the readings about the fit
    /// Condition of the scaled problem; if it is large, the rates are hard to separate.
    double condition = 0.0;
    Message reason; ///< why the rates cannot be used; code None if they can

    bool usable() const { return reason == Message{}; }
    HeatRates rates() const { return {lambda1.value, lambda2.value, lambda3.value}; }
};

/// Fits the integral of the heat balance over windows [t0, t0 + w] that do not overlap,
///
///   T(t) = T0 + lambda1 int s F - lambda2 int T^4 + lambda3 (t - t0) - h' int (T - T3)       (from t0 to t)
///
/// with its own T0 in each window. The integral form needs no differentiated temperature: a difference
/// quotient of two readings dt apart has 1.4 / dt times their noise, while an integral averages noise out.
/// With free T0 the errors within a window are those of single readings, hence independent, and windows share
/// no data; effects that are missing in the balance cannot accumulate beyond one window. Standard errors are
/// the larger of two estimates: ordinary least squares (independent errors) and the scatter of the windows
/// (White's "sandwich", for any correlation within a window, such as that of rounding). Readings that differ
/// from the fit by more than six robust standard deviations and 0.1 K are left out, the worst first.
///
/// Not usable, with the reason, in these cases: too few readings, a source that is never in view, view factor
/// and temperatures that hardly vary, a rate with a standard error above a quarter of it, a negative rate.
IdentifiedRates identifyRates(const std::vector<HeatSample>& record, const IdentificationOptions& options);

} // namespace bask
