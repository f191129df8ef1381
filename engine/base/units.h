#pragma once
// Conversions between SI, used everywhere inside, and the units of screens and files at the edge.

#ifndef Q_MOC_RUN // moc 6.4 cannot parse this header
#include <numbers>
#endif

namespace bask {

inline constexpr double kStefanBoltzmann = 5.670374419e-8; ///< W/(m2 K4), CODATA 2018
inline constexpr double kZeroCelsius_K = 273.15;
inline constexpr double kMmPerM = 1000.0;

constexpr double kelvinFromCelsius(double t_degC) {
    return t_degC + kZeroCelsius_K;
}
constexpr double celsiusFromKelvin(double t_K) {
    return t_K - kZeroCelsius_K;
}
constexpr double radFromDeg(double a_deg) {
    return a_deg * std::numbers::pi / 180.0;
}
constexpr double degFromRad(double a_rad) {
    return a_rad * 180.0 / std::numbers::pi;
}

/// The unit in which a temperature is shown and typed. Differences are scaled without the offset.
enum class TemperatureUnit { Celsius, Kelvin, Fahrenheit };

constexpr double displayTemperature(double t_K, TemperatureUnit unit) {
    switch (unit) {
    case TemperatureUnit::Kelvin:
        return t_K;
    case TemperatureUnit::Fahrenheit:
        return celsiusFromKelvin(t_K) * 1.8 + 32.0;
    case TemperatureUnit::Celsius:
        break;
    }
    return celsiusFromKelvin(t_K);
}

constexpr double kelvinFromDisplay(double t, TemperatureUnit unit) {
    switch (unit) {
    case TemperatureUnit::Kelvin:
        return t;
    case TemperatureUnit::Fahrenheit:
        return kelvinFromCelsius((t - 32.0) / 1.8);
    case TemperatureUnit::Celsius:
        break;
    }
    return kelvinFromCelsius(t);
}

constexpr double displayDifference(double d_K, TemperatureUnit unit) {
    return unit == TemperatureUnit::Fahrenheit ? d_K * 1.8 : d_K;
}

/// "°C", "K" or "°F" in UTF-8.
constexpr const char* temperatureSymbol(TemperatureUnit unit) {
    switch (unit) {
    case TemperatureUnit::Kelvin:
        return "K";
    case TemperatureUnit::Fahrenheit:
        return "\u00b0F";
    case TemperatureUnit::Celsius:
        break;
    }
    return "\u00b0C";
}

/// Symbol of a temperature difference: "K" for Celsius and kelvin, "°F" for Fahrenheit.
constexpr const char* differenceSymbol(TemperatureUnit unit) {
    return unit == TemperatureUnit::Fahrenheit ? "\u00b0F" : "K";
}

} // namespace bask
