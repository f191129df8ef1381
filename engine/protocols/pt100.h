#pragma once
// Platinum resistors of 100 ohm by IEC 60751: resistance and temperature.

#include <optional>

namespace bask {

/// Returns R(t) = 100 (1 + A t + B t^2 + C (t - 100) t^3), the last term below 0 degC only; A = 3.9083e-3, B
/// = -5.775e-7, C = -4.183e-12. The standard's range is -200..850 degC.
double pt100Ohm(double t_degC);

/// Returns the temperature of a resistance; empty outside of the standard's range.
std::optional<double> pt100Celsius(double ohm);

} // namespace bask
