#pragma once
// The units of parameters: how each is spelled in a file's keys, in a sentence and on a screen.

#include "engine/base/edge_units.h"
#include "engine/base/units.h"

#include <optional>
#include <string>

namespace bask {

/// Whether a value in kelvins is one that a reader in another scale is shown otherwise.
enum class Kelvins { None, Difference, Rate };

/// The unit of a parameter. Inside the program every value is in SI, or in this unit if SI has none.
struct Unit {
    const char* suffix = "";        ///< of a key in files: "K_s"
    const char* words = "";         ///< in a sentence of ASCII characters: "K/s"
    const char* symbol = "";        ///< on a screen, UTF-8: "K/s"
    double symbolPerSi = 1.0;       ///< value on a screen divided by the value in SI
    std::optional<EdgeUnit> edge{}; ///< if set, files accept two spellings: the readable unit and SI
    Kelvins kelvins = Kelvins::None;
};

namespace unit {

inline constexpr Unit kNone{};
inline constexpr Unit kShareInPercent{"", "", "%", 100.0};
inline constexpr Unit kSeconds{"s", "s", "s"};
inline constexpr Unit kPerSecond{"1_s", "1/s", "1/s"};
inline constexpr Unit kPerSecond2{"1_s2", "1/s2", "1/s\u00b2"};
inline constexpr Unit kPerKelvin{"1_K", "1/K", "1/K"};
inline constexpr Unit kSeconds3PerKelvin3{"s3_K3", "s3/K3", "s\u00b3/K\u00b3"};
inline constexpr Unit kSecondsPerKelvin9{"s_K9", "s/K9", "s/K\u2079"};
inline constexpr Unit kKelvin{"K", "K", "K", 1.0, {}, Kelvins::Difference};
inline constexpr Unit kKelvinPerSecond{"K_s", "K/s", "K/s", 1.0, {}, Kelvins::Rate};
inline constexpr Unit kPerKelvin3Second{"1_K3s", "1/(K3 s)", "1/(K\u00b3 s)"};
inline constexpr Unit kMegabytes{"MB", "MB", "MB"};
inline constexpr Unit kHertz{"Hz", "Hz", "Hz"};
inline constexpr Unit kGrey{"grey", "", ""};
inline constexpr Unit kPixels{"px", "px", "px"};
inline constexpr Unit kRadians{"rad", "rad", "\u00b0", degFromRad(1.0)};
inline constexpr Unit kRadiansPerSecond{"rad_s", "rad/s", "\u00b0/s", degFromRad(1.0)};
inline constexpr Unit kRadiansPerSecond2{"rad_s2", "rad/s2", "\u00b0/s\u00b2", degFromRad(1.0)};
inline constexpr Unit kConvection{"W_m2K", "W/(m2 K)", "W/(m\u00b2 K)"};
inline constexpr Unit kSpecificHeat{"J_kgK", "J/(kg K)", "J/(kg K)"};
inline constexpr Unit kDensity{"kg_m3", "kg/m3", "kg/m\u00b3"};
inline constexpr Unit kCelsius{"degC", "degC", "\u00b0C", 1.0, EdgeUnit::Temperature};
inline constexpr Unit kCentimetres{"cm", "cm", "mm", kMmPerM, EdgeUnit::LengthCm};
inline constexpr Unit kMillimetres{"mm", "mm", "mm", kMmPerM, EdgeUnit::LengthMm};
inline constexpr Unit kCentimetresPerSecond{"cm_s", "cm/s", "mm/s", kMmPerM, EdgeUnit::SpeedCm};
inline constexpr Unit kCentimetresPerSecond2{"cm_s2", "cm/s2", "mm/s\u00b2", kMmPerM,
                                             EdgeUnit::AccelerationCm};
inline constexpr Unit kDegrees{"deg", "deg", "\u00b0", degFromRad(1.0), EdgeUnit::Angle};

} // namespace unit

/// Returns the SI unit of the value as NeXus spells it: "m", "kg/m^3"; "1" for a number without a unit.
std::string siUnit(const Unit& unit);

} // namespace bask
