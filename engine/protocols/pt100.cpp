#include "engine/protocols/pt100.h"

#include <cmath>

namespace bask {
namespace {

constexpr double kA = 3.9083e-3, kB = -5.775e-7, kC = -4.183e-12;
constexpr double kColdest_degC = -200.0, kHottest_degC = 850.0;
constexpr double kOhmAtZero = 100.0;

double slope(double t_degC) { // ohm/K, below 0 degC
    const double t2 = t_degC * t_degC;
    return kOhmAtZero * (kA + 2.0 * kB * t_degC + kC * (4.0 * t2 * t_degC - 300.0 * t2));
}

} // namespace

double pt100Ohm(double t_degC) {
    const double cold = t_degC < 0.0 ? kC * (t_degC - 100.0) * t_degC * t_degC * t_degC : 0.0;
    return kOhmAtZero * (1.0 + kA * t_degC + kB * t_degC * t_degC + cold);
}

std::optional<double> pt100Celsius(double ohm) {
    if (!(ohm >= pt100Ohm(kColdest_degC) && ohm <= pt100Ohm(kHottest_degC)))
        return std::nullopt;
    double t = (-kA + std::sqrt(kA * kA - 4.0 * kB * (1.0 - ohm / kOhmAtZero))) / (2.0 * kB);
    if (ohm < kOhmAtZero) {
        for (int i = 0; i < 6; ++i) // Newton; three reach the last digit
            t -= (pt100Ohm(t) - ohm) / slope(t);
    }
    return t;
}

} // namespace bask
