#include "engine/base/edge_units.h"

#include "engine/base/units.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bask {
namespace {

struct Suffixes {
    const char* readable;
    const char* si;
};

constexpr Suffixes suffixes(EdgeUnit unit) {
    switch (unit) {
    case EdgeUnit::LengthCm:
        return {"cm", "m"};
    case EdgeUnit::LengthMm:
        return {"mm", "m"};
    case EdgeUnit::SpeedCm:
        return {"cm_s", "m_s"};
    case EdgeUnit::AccelerationCm:
        return {"cm_s2", "m_s2"};
    case EdgeUnit::Angle:
        return {"deg", "rad"};
    case EdgeUnit::Temperature:
        break;
    }
    return {"degC", "K"};
}

double roughlyFromSi(double si, EdgeUnit unit) {
    switch (unit) {
    case EdgeUnit::LengthCm:
    case EdgeUnit::SpeedCm:
    case EdgeUnit::AccelerationCm:
        return si * 100.0;
    case EdgeUnit::LengthMm:
        return si * 1000.0;
    case EdgeUnit::Angle:
        return degFromRad(si);
    case EdgeUnit::Temperature:
        break;
    }
    return celsiusFromKelvin(si);
}

} // namespace

std::string readableKey(std::string_view name, EdgeUnit unit) {
    return std::string(name) + '_' + suffixes(unit).readable;
}

std::string siKey(std::string_view name, EdgeUnit unit) {
    return std::string(name) + '_' + suffixes(unit).si;
}

std::string_view readableUnit(EdgeUnit unit) {
    switch (unit) {
    case EdgeUnit::SpeedCm:
        return "cm/s";
    case EdgeUnit::AccelerationCm:
        return "cm/s2";
    default:
        return suffixes(unit).readable;
    }
}

// Dividing (not multiplying by 0.01) makes a typed "5" cm the same double as 0.05.
double toSi(double readable, EdgeUnit unit) {
    switch (unit) {
    case EdgeUnit::LengthCm:
    case EdgeUnit::SpeedCm:
    case EdgeUnit::AccelerationCm:
        return readable / 100.0;
    case EdgeUnit::LengthMm:
        return readable / 1000.0;
    case EdgeUnit::Angle:
        return radFromDeg(readable);
    case EdgeUnit::Temperature:
        break;
    }
    return kelvinFromCelsius(readable);
}

ReadableValue fromSi(double si, EdgeUnit unit) {
    const double guess = roughlyFromSi(si, unit);
    if (!std::isfinite(guess))
        return {guess, false};
    std::array<char, 40> text{};
    for (int digits = 6; digits <= 17; ++digits) {
        std::snprintf(text.data(), text.size(), "%.*g", digits, guess);
        const double value = std::strtod(text.data(), nullptr);
        if (toSi(value, unit) == si)
            return {value, true};
    }
    for (const double target : {-INFINITY, INFINITY}) {
        const double neighbour = std::nextafter(guess, target);
        if (toSi(neighbour, unit) == si)
            return {neighbour, true};
    }
    return {guess, false};
}

EdgeUnit coordinateUnit(int coordinate) {
    return coordinate < 3 ? EdgeUnit::LengthCm : EdgeUnit::Angle;
}

} // namespace bask
