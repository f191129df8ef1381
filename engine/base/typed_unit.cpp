#include "engine/base/typed_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>

namespace bask {
namespace {

enum class Dimension { Metre, Kilogram, Second, Kelvin, Radian, Pixel, Byte };
using enum Dimension;
constexpr std::size_t kDimensions = 7;

/// A unit: a factor times a product of powers of SI units.
struct UnitSize {
    double si = 1.0;
    std::array<int, kDimensions> powers{};

    void multiply(const UnitSize& other, int power) {
        si *= std::pow(other.si, power);
        for (std::size_t i = 0; i < powers.size(); ++i)
            powers[i] += power * other.powers[i];
    }
};

constexpr UnitSize sized(double si, Dimension dimension, int power = 1) {
    UnitSize out{si, {}};
    out.powers[static_cast<std::size_t>(dimension)] = power;
    return out;
}

constexpr UnitSize energy(double si, int perSecond) {
    UnitSize out{si, {}};
    out.powers[static_cast<std::size_t>(Kilogram)] = 1;
    out.powers[static_cast<std::size_t>(Metre)] = 2;
    out.powers[static_cast<std::size_t>(Second)] = -2 - perSecond;
    return out;
}

struct NamedUnit {
    std::string_view name;
    UnitSize size;
};

constexpr std::array kUnits{
    NamedUnit{"m", sized(1.0, Metre)},
    NamedUnit{"cm", sized(0.01, Metre)},
    NamedUnit{"mm", sized(0.001, Metre)},
    NamedUnit{"kg", sized(1.0, Kilogram)},
    NamedUnit{"g", sized(0.001, Kilogram)},
    NamedUnit{"s", sized(1.0, Second)},
    NamedUnit{"ms", sized(0.001, Second)},
    NamedUnit{"min", sized(60.0, Second)},
    NamedUnit{"h", sized(3600.0, Second)},
    NamedUnit{"Hz", sized(1.0, Second, -1)},
    NamedUnit{"K", sized(1.0, Kelvin)},
    NamedUnit{"\u00b0C", sized(1.0, Kelvin)},
    NamedUnit{"degC", sized(1.0, Kelvin)},
    NamedUnit{"\u00b0F", sized(1.0 / 1.8, Kelvin)},
    NamedUnit{"degF", sized(1.0 / 1.8, Kelvin)},
    NamedUnit{"rad", sized(1.0, Radian)},
    NamedUnit{"\u00b0", sized(radFromDeg(1.0), Radian)},
    NamedUnit{"deg", sized(radFromDeg(1.0), Radian)},
    NamedUnit{"J", energy(1.0, 0)},
    NamedUnit{"kJ", energy(1000.0, 0)},
    NamedUnit{"W", energy(1.0, 1)},
    NamedUnit{"kW", energy(1000.0, 1)},
    NamedUnit{"px", sized(1.0, Pixel)},
    NamedUnit{"B", sized(1.0, Byte)},
    NamedUnit{"MB", sized(1e6, Byte)},
    NamedUnit{"GB", sized(1e9, Byte)},
    NamedUnit{"%", UnitSize{0.01, {}}},
    NamedUnit{"1", UnitSize{}},
};

/// With digits for superscripts, and with plain spaces.
std::string plainSpelling(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kSpellings{{
        {"\u00b2", "2"},
        {"\u00b3", "3"},
        {"\u2074", "4"},
        {"\u2076", "6"},
        {"\u2079", "9"},
        {"^", ""},
        {"\u00b7", " "},
        {".", " "},
        {"\u00a0", " "},
        {"\u202f", " "},
        {"\u2103", "\u00b0C"},
        {"\u2109", "\u00b0F"},
        {"\u00ba", "\u00b0"}, // the ordinal on keyboards without a degree
    }};
    std::string out(text);
    for (const auto& [from, to] : kSpellings)
        for (std::size_t at = out.find(from); at != std::string::npos; at = out.find(from, at + to.size()))
            out.replace(at, from.size(), to);
    return out;
}

/// What a factor after a quotient is, as the "K" of "W/m2 K".
enum class AfterSlash { Above, Below };

/// Reads products, quotients and brackets, each factor with a power.
class UnitReader {
public:
    UnitReader(std::string_view text, AfterSlash after) : m_rest(text), m_after(after) {}

    std::optional<UnitSize> all() {
        auto out = product();
        return m_rest.empty() ? out : std::nullopt;
    }

private:
    std::optional<UnitSize> product() {
        UnitSize out;
        bool isBelow = false;
        for (skipSpaces(); !m_rest.empty() && m_rest.front() != ')'; skipSpaces()) {
            const bool divides = takes('/');
            skipSpaces();
            const auto each = factor();
            if (!each)
                return std::nullopt;
            isBelow = divides || (isBelow && m_after == AfterSlash::Below);
            out.multiply(*each, isBelow ? -1 : 1);
        }
        return out;
    }

    std::optional<UnitSize> factor() {
        std::optional<UnitSize> base;
        if (takes('(')) {
            base = product();
            if (!takes(')'))
                return std::nullopt;
        } else {
            base = named();
        }
        if (!base)
            return std::nullopt;
        UnitSize out;
        out.multiply(*base, power());
        return out;
    }

    std::optional<UnitSize> named() {
        const std::size_t size =
            startsWith('1') ? 1 : std::min(m_rest.find_first_of(" /()0123456789"), m_rest.size());
        const auto unit = std::ranges::find(kUnits, m_rest.substr(0, size), &NamedUnit::name);
        if (unit == kUnits.end())
            return std::nullopt;
        m_rest.remove_prefix(size);
        return unit->size;
    }

    /// One digit: no power has two digits.
    int power() {
        if (m_rest.empty() || m_rest.front() < '0' || m_rest.front() > '9')
            return 1;
        const int out = m_rest.front() - '0';
        m_rest.remove_prefix(1);
        return out;
    }

    bool startsWith(char c) const { return !m_rest.empty() && m_rest.front() == c; }

    bool takes(char c) {
        const bool isThere = startsWith(c);
        m_rest.remove_prefix(isThere ? 1 : 0);
        return isThere;
    }

    void skipSpaces() {
        while (takes(' ')) {
        }
    }

    std::string_view m_rest;
    AfterSlash m_after;
};

std::optional<UnitSize> unitSize(std::string_view text, AfterSlash after = AfterSlash::Above) {
    const std::string plain = plainSpelling(text);
    return UnitReader(plain, after).all();
}

} // namespace

std::optional<double> converted(double value, std::string_view from, std::string_view to) {
    if (from == to)
        return value;
    auto given = unitSize(from);
    const auto wanted = unitSize(to);
    if (given && wanted && given->powers != wanted->powers)
        given = unitSize(from, AfterSlash::Below);
    if (!given || !wanted || given->powers != wanted->powers)
        return std::nullopt;
    return value * given->si / wanted->si;
}

std::optional<TemperatureUnit> typedTemperatureUnit(std::string_view text) {
    const std::string plain = plainSpelling(text);
    const auto isOneOf = [&plain](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, plain) != names.end();
    };
    if (isOneOf({"\u00b0C", "degC", "C"}))
        return TemperatureUnit::Celsius;
    if (isOneOf({"\u00b0F", "degF", "F"}))
        return TemperatureUnit::Fahrenheit;
    return plain == "K" ? std::optional(TemperatureUnit::Kelvin) : std::nullopt;
}

} // namespace bask
