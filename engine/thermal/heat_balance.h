#pragma once
// Lumped heat balance of a thin object in front of a hot source:
//     dT/dt = lambda1 F - lambda2 T^4 + lambda3 - h'(T) (T - T_air).

#include "engine/base/result.h"

#include <map>
#include <optional>
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
    double infill = 1.0;  ///< fraction of the volume that is solid, (0, 1]
    std::string source{}; ///< where the values are from, in words; empty: not told
    std::string date{};   ///< when they were found, "2026-11-23"; empty: not told
    /// Standard uncertainties in SI, by the name of the value in materialParameters(); a value that is not
    /// here has an unknown one.
    std::map<std::string, double> uncertainties{};

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

/// What is known of the air around the objects, which has the room's temperature T3. At most one of the two
/// is set; with neither, convection is unknown and not counted.
struct Air {
    std::optional<double> convection_W_m2K{}; ///< h of one face, given
    bool isNatural = false;                   ///< h by the correlation of naturalConvection()

    bool isKnown() const { return convection_W_m2K || isNatural; }
    bool operator==(const Air&) const = default;
};

/// What an object exchanges heat with.
struct Surroundings {
    SourceModel model = SourceModel::Gray;
    double netSourcePower_W_m2 = 0.0; ///< J, see netSourcePower_W_m2()
    double environment_K = 298.15;    ///< T3
    Air air{};

    bool operator==(const Surroundings&) const = default;
};

/// Returns the surroundings of a source at a temperature, with unknown air.
Surroundings surroundingsOf(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                            double environment_K);

/// What the air takes from an object, h'(T) (T - T_air) with h' = h / (m c / A). Natural convection goes with
/// a power of the difference d = |T - T_air|: h' = constant + max(laminar d^(1/5), turbulent d^(1/3)).
struct AirLoss {
    double constant_1_s = 0.0;
    double laminar = 0.0;   ///< 1/(s K^(1/5))
    double turbulent = 0.0; ///< 1/(s K^(1/3))
    double air_K = 0.0;

    bool isZero() const { return constant_1_s == 0.0 && laminar == 0.0 && turbulent == 0.0; }
    double coefficient_1_s(double T_K) const; ///< h'
    /// Returns the rate (K/s) at which the air cools the object; negative if it warms it.
    double rate_K_s(double T_K) const;
    /// Returns the derivative of rate_K_s() by T, 1/s.
    double slope_1_s(double T_K) const;
    /// Returns the loss of an object whose m c / A is smaller by this factor.
    AirLoss scaled(double factor) const;

    bool operator==(const AirLoss&) const = default;
};

/// lambda1 (K/s), lambda2 (1/(K3 s)), lambda3 (K/s) of an object, and what the air takes. Whoever needs a
/// rate, a steady state or a slope asks here, so that no part of the program leaves out a term.
struct HeatRates {
    double lambda1 = 0.0;
    double lambda2 = 0.0;
    double lambda3 = 0.0;
    AirLoss air{};

    /// Returns dT/dt (K/s) at view factor F and temperature T (K).
    double rate_K_s(double F, double T_K) const;
    /// Returns the change of T (K) in dt_s at constant F, by one linearly implicit midpoint step: stable for
    /// any dt_s.
    double step_K(double F, double T_K, double dt_s) const;
    /// Returns the temperature (K) at which the rate at F is zero. With air, to 1e-9 K.
    double steadyTemperature_K(double F) const;
    /// Returns the view factor whose steady temperature is T; it may lie outside [0, 1].
    double steadyViewFactor(double T_K) const;
    /// Returns the derivative of the losses by T, 4 lambda2 T^3 and that of the air's, 1/s.
    double lossSlope_1_s(double T_K) const;
    /// Returns 1 / lossSlope_1_s(), s.
    double timeConstant_s(double T_K) const;
    /// Returns rates with other heating, and with all losses (and what the room gives) in the same proportion
    /// to one another: h and the emittance are known better than m c / A.
    HeatRates scaled(double heating, double losses) const;
    /// Returns the fourth power of the temperature at which radiation alone lets the object rest in the room,
    /// K4.
    double rest_K4() const { return lambda3 / lambda2; }
    /// Returns the rates in a room whose temperature's fourth power is higher by this, K4: see Neighbours.
    HeatRates inWarmerRoom(double gain_K4) const;
    /// Returns the rates of radiation alone.
    HeatRates withoutAir() const { return {lambda1, lambda2, lambda3}; }

    bool operator==(const HeatRates&) const = default;
};

/// Returns lambda3 / (lambda2 T3^4). With a gray source it is 1 by Kirchhoff's law: the room radiates at the
/// wavelengths at which the object emits, so no object settles above the room without a source; alpha2 is for
/// the source's radiation only. The paper's model takes alpha2 for both: alpha2 / eps2.
double environmentShare(SourceModel model, const Material& material);

/// Returns the rates of a plate of this material in its surroundings. length_m, area over perimeter, is only
/// used for natural convection. Throws std::invalid_argument if that has no positive length.
HeatRates heatRates(const Material& material, const Surroundings& surroundings, double length_m = 0.0);

} // namespace bask
