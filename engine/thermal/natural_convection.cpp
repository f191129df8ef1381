#include "engine/thermal/natural_convection.h"

#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kGravity_m_s2 = 9.80665;
constexpr double kPressure_Pa = 101325.0;
constexpr double kGas_J_kgK = 287.05;
constexpr double kHeat_J_kgK = 1006.0;
constexpr double kFilmRise_K = 15.0; ///< half of what a usual object is above the room

/// Dry air by Sutherland's law.
struct AirProperties {
    double conductivity_W_mK;
    double kinematicViscosity_m2_s;
    double prandtl;

    explicit AirProperties(double T_K) {
        const double root3 = std::pow(T_K / 273.15, 1.5);
        const double viscosity_Pa_s = 1.716e-5 * root3 * (273.15 + 110.4) / (T_K + 110.4);
        conductivity_W_mK = 0.0241 * root3 * (273.15 + 194.0) / (T_K + 194.0);
        kinematicViscosity_m2_s = viscosity_Pa_s * kGas_J_kgK * T_K / kPressure_Pa;
        prandtl = viscosity_Pa_s * kHeat_J_kgK / conductivity_W_mK;
    }
};

} // namespace

NaturalConvection naturalConvection(double length_m, double air_K) {
    if (!(length_m > 0.0) || !(air_K > 0.0))
        throw std::invalid_argument("naturalConvection: length and temperature must be positive");
    const double film_K = air_K + kFilmRise_K;
    const AirProperties air(film_K);
    const double nu = air.kinematicViscosity_m2_s;
    const double perKelvin =
        kGravity_m_s2 * std::pow(length_m, 3) * air.prandtl / (film_K * nu * nu); // Ra of 1 K
    const double X = perKelvin * std::pow(1.0 + std::pow(0.322 / air.prandtl, 11.0 / 20.0), -20.0 / 11.0);
    const double perNusselt = air.conductivity_W_mK / length_m;
    return {0.766 * std::pow(X, kLaminarPower) * perNusselt, 0.15 * std::cbrt(X) * perNusselt};
}

} // namespace bask
