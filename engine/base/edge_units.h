#pragma once
// Units in which people write an experiment: each key has a readable spelling (cm, deg, degC) and an SI one.

#include <array>
#include <string>
#include <string_view>

namespace bask {

/// How a quantity may be written: `name` + "_" + readable suffix, or `name` + "_" + SI suffix.
enum class EdgeUnit { Temperature, LengthCm, LengthMm, SpeedCm, AccelerationCm, Angle };

/// Key as people write it ("target_degC").
std::string readableKey(std::string_view name, EdgeUnit unit);
/// Key in SI ("target_K").
std::string siKey(std::string_view name, EdgeUnit unit);
/// Readable suffix as it stands in a sentence ("degC").
std::string_view readableUnit(EdgeUnit unit);

double toSi(double readable, EdgeUnit unit);
/// A readable value and whether toSi of it gives back exactly the same double.
struct ReadableValue {
    double value = 0.0;
    bool exact = false;
};
/// Returns the nearest readable value; prefers few digits (40, not 40.00000000000006).
ReadableValue fromSi(double si, EdgeUnit unit);

/// Returns the readable unit of a pose coordinate: cm for the first three, deg for the others.
EdgeUnit coordinateUnit(int coordinate);

} // namespace bask
