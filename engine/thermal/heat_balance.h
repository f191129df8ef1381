#pragma once
// Lumped heat balance of a thin object in front of a hot source: dT/dt = lambda1 F - lambda2 T^4 + lambda3.

#include "engine/base/result.h"

#include <string>

namespace bask {

/// The material of an object; the lumped mass is thickness x area.
struct Material {
    std::string name;
    double emittance = 0.9;   ///< eps2, (0, 1]
    double absorptance = 0.9; ///< alpha2, (0, 1]
    double specificHeat_J_kgK = 900.0;
    double density_kg_m3 = 2700.0;
    double thickness_m = 0.001;
    double infill = 1.0; ///< fraction of the volume that is solid, (0, 1]

    /// Returns m c / A, J/(m2 K).
    double arealHeatCapacity_J_m2K() const {
        return specificHeat_J_kgK * density_kg_m3 * thickness_m * infill;
    }
    bool operator==(const Material&) const = default;
};

/// Radiosity of the source: gray with reflection (J = sigma eps1 (T1^4 - T3^4)) or the paper's J1 = E1 (J =
/// sigma (eps1 T1^4 - T3^4)), which neglects the reflection.
enum class SourceModel { Gray, Paper };

/// Returns the net power J (W/m2) that a black surface seeing only the source absorbs, minus that of one
/// seeing only the environment. Not positive if the source cannot heat.
double netSourcePower_W_m2(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                           double environment_K);

/// What an object exchanges radiation with.
struct Surroundings {
    SourceModel model = SourceModel::Gray;
    double netSourcePower_W_m2 = 0.0; ///< J, see netSourcePower_W_m2()
    double environment_K = 298.15;    ///< T3

    bool operator==(const Surroundings&) const = default;
};

/// Returns the surroundings of a source at a temperature.
Surroundings surroundingsOf(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                            double environment_K);

/// lambda1 (K/s), lambda2 (1/(K3 s)), lambda3 (K/s) of an object.
struct HeatRates {
    double lambda1 = 0.0;
    double lambda2 = 0.0;
    double lambda3 = 0.0;

    /// Returns dT/dt (K/s) at view factor F and temperature T (K).
    double rate_K_s(double F, double T_K) const;
    /// Returns the temperature (K) at which the rate at F is zero.
    double steadyTemperature_K(double F) const;
    /// Returns the view factor whose steady temperature is T; it may lie outside [0, 1].
    double steadyViewFactor(double T_K) const;
    /// Returns 1 / (4 lambda2 T^3), s.
    double timeConstant_s(double T_K) const;

    bool operator==(const HeatRates&) const = default;
};

/// Returns lambda3 / (lambda2 T3^4). With a gray source it is 1 by Kirchhoff's law: the room radiates at the
/// wavelengths at which the object emits, so no object settles above the room without a source; alpha2 is for
/// the source's radiation only. The paper's model takes alpha2 for both: alpha2 / eps2.
double environmentShare(SourceModel model, const Material& material);

/// Returns the rates of a material in its surroundings.
HeatRates heatRates(const Material& material, const Surroundings& surroundings);

} // namespace bask
