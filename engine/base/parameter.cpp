#include "engine/base/parameter.h"

#include <cctype>

namespace bask {

std::string siUnit(const Unit& unit) {
    std::string plain = unit.words;
    if (unit.edge)
        switch (*unit.edge) {
        case EdgeUnit::Temperature:
            return "K";
        case EdgeUnit::LengthCm:
        case EdgeUnit::LengthMm:
            return "m";
        case EdgeUnit::SpeedCm:
            return "m/s";
        case EdgeUnit::AccelerationCm:
            return "m/s^2";
        case EdgeUnit::Angle:
            return "rad";
        }
    if (plain.empty())
        return "1";
    std::string out;
    for (const char c : plain) { // an exponent follows a letter
        if (c >= '0' && c <= '9' && !out.empty() && std::isalpha(static_cast<unsigned char>(out.back())))
            out += '^';
        out += c;
    }
    return out;
}

std::string keyOf(const ParameterFacts& facts) {
    std::string key = facts.name;
    if (*facts.unit.suffix != '\0')
        key += std::string("_") + facts.unit.suffix;
    return key;
}

double written(const ParameterFacts& facts, double si) {
    return facts.unit.edge ? fromSi(si, *facts.unit.edge).value : si;
}

double fromWritten(const ParameterFacts& facts, double value) {
    return facts.unit.edge ? toSi(value, *facts.unit.edge) : value;
}

} // namespace bask
