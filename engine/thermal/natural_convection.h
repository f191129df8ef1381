#pragma once
// Natural convection over a heated horizontal plate in air.

namespace bask {

inline constexpr double kLaminarPower = 0.2; ///< of the temperature difference in laminar h

/// h = max(laminar d^(1/5), turbulent d^(1/3)), W/(m2 K), for a difference of d kelvin between plate and air.
struct NaturalConvection {
    double laminar = 0.0;   ///< W/(m2 K^(6/5))
    double turbulent = 0.0; ///< W/(m2 K^(4/3))
};

/// Returns h of the upper face of a horizontal plate that is warmer than the air around it, at 1013 hPa:
///
///     Nu = max(0.766 X^(1/5), 0.15 X^(1/3)),   X = Ra f(Pr),   f = (1 + (0.322 / Pr)^(11/20))^(-20/11),
///     Ra = g d L^3 / (T_film nu a),   Nu = h L / k,   L = area / perimeter.
///
/// Source: S. W. Churchill, Free convection around immersed bodies, Heat Exchanger Design Handbook (1983), as
/// in VDI Heat Atlas (2010), section F2. (The correlation of Churchill and Chu, 1975, is for vertical
/// plates.) The atlas changes from the first to the second law at X = 7e4 with a jump down; here the larger
/// one counts, which changes at 2e5, is up to 15 % higher in between, and grows without a jump. Range: X up
/// to 1e10, and so for plates of 3 mm to 1 m in L that are 1 to 150 K above air of -50 to 100 degrees C;
/// small plates lie below the X of the measurements behind the law (some 1e2), where errors of 30 % are
/// usual. Properties of air are taken 15 K above the room: h of the first law changes by less than 2 % up to
/// a film 75 K above it, that of the second falls by 12 %. A tilted plate, a plume from the source below, and
/// moving air are not in it; a plate colder than the air loses less than this. Throws std::invalid_argument
/// unless both arguments are positive.
NaturalConvection naturalConvection(double length_m, double air_K);

} // namespace bask
