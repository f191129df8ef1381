#include "engine/base/typed_unit.h"
#include "engine/base/unit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

namespace bask {

// Catches 15 mm that are 15 cm, and factors upside down.
TEST(TypedUnit, ValuesOfOneDimensionAreConverted) {
    const auto expect = [](double value, const char* from, const char* to, double wanted) {
        const auto got = converted(value, from, to);
        ASSERT_TRUE(got.has_value()) << from << " in " << to;
        EXPECT_NEAR(*got, wanted, 1e-12 * std::abs(wanted)) << from << " in " << to;
    };
    expect(15.0, "mm", "cm", 1.5);
    expect(1.5, "cm", "mm", 15.0);
    expect(0.2, "m", "mm", 200.0);
    expect(2.0, "min", "s", 120.0);
    expect(1.0, "h", "min", 60.0);
    expect(180.0, "deg", "rad", std::numbers::pi);
    expect(std::numbers::pi, "rad", "\u00b0", 180.0);
    expect(1.0, "cm/s2", "mm/s\u00b2", 10.0);
    expect(1.0, "cm/s^2", "mm/s\u00b2", 10.0);
    expect(60.0, "1/min", "1/s", 1.0);
    expect(2.0, "K/s", "K/min", 120.0);
    expect(1.8, "\u00b0F", "K", 1.0);
    expect(3.0, "\u00b0C", "K", 3.0);
    expect(1.0, "kJ/(kg K)", "J/(kg K)", 1000.0);
    expect(1.0, "J/(s m2 K)", "W/(m\u00b2 K)", 1.0);
    expect(1.0, "W/m2 K", "W/(m\u00b2 K)", 1.0);
    expect(1.0, "kJ/kg.K", "J/(kg K)", 1000.0);
    expect(1.0, "W/m2\u00b7K", "W/(m\u00b2 K)", 1.0);
    expect(2.0, "m/s m", "1/s", 2.0);
    expect(1.0, "g/cm3", "kg/m\u00b3", 1000.0);
    expect(50.0, "%", "", 0.5);
    expect(0.5, "1", "%", 50.0);
    expect(1.0, "GB", "MB", 1000.0);
    expect(1.0, "px/cm", "px/mm", 0.1);
}

TEST(TypedUnit, WhatDoesNotAgreeIsRefused) {
    for (const auto& [from, to] :
         std::initializer_list<std::pair<const char*, const char*>>{{"mm", "K"},
                                                                    {"s", "cm"},
                                                                    {"mm", ""},
                                                                    {"", "mm"},
                                                                    {"", "\u00b0"},
                                                                    {"rad/s", "1/s"},
                                                                    {"Hz", "rad/s"},
                                                                    {"mm/s", "mm"},
                                                                    {"cm2", "cm"},
                                                                    {"x", "cm"},
                                                                    {"mm/", "cm"},
                                                                    {"c", "cm"},
                                                                    {"W/(m2 K", "W/(m2 K)"},
                                                                    {"mm)", "mm"},
                                                                    {"W/m2 K s", "W/(m2 K)"},
                                                                    {"MM", "mm"},
                                                                    {"m99", "m"}})
        EXPECT_FALSE(converted(1.0, from, to).has_value()) << from << " in " << to;
}

// Catches a unit of forms or files that nobody can type.
TEST(TypedUnit, EveryUnitOfParametersIsUnderstood) {
    for (const Unit& each : {unit::kNone,
                             unit::kShareInPercent,
                             unit::kSeconds,
                             unit::kPerSecond,
                             unit::kPerSecond2,
                             unit::kPerKelvin,
                             unit::kSeconds3PerKelvin3,
                             unit::kSecondsPerKelvin9,
                             unit::kKelvin,
                             unit::kKelvinPerSecond,
                             unit::kPerKelvin3Second,
                             unit::kMegabytes,
                             unit::kHertz,
                             unit::kPixels,
                             unit::kRadians,
                             unit::kRadiansPerSecond,
                             unit::kRadiansPerSecond2,
                             unit::kConvection,
                             unit::kSpecificHeat,
                             unit::kDensity,
                             unit::kCelsius,
                             unit::kCentimetres,
                             unit::kMillimetres,
                             unit::kCentimetresPerSecond,
                             unit::kCentimetresPerSecond2,
                             unit::kDegrees}) {
        const auto shown = converted(1.0, std::string(each.symbol) + "/1", each.symbol);
        ASSERT_TRUE(shown.has_value()) << each.symbol;
        EXPECT_DOUBLE_EQ(*shown, 1.0);
    }
}

TEST(TypedUnit, TemperaturesOnAScale) {
    for (const char* text : {"\u00b0C", "degC", "C", "\u2103", "\u00baC"})
        EXPECT_EQ(typedTemperatureUnit(text), TemperatureUnit::Celsius) << text;
    EXPECT_EQ(typedTemperatureUnit("K"), TemperatureUnit::Kelvin);
    EXPECT_EQ(typedTemperatureUnit("\u2109"), TemperatureUnit::Fahrenheit);
    EXPECT_EQ(typedTemperatureUnit("F"), TemperatureUnit::Fahrenheit);
    for (const char* text : {"", "mm", "\u00b0", "k"})
        EXPECT_FALSE(typedTemperatureUnit(text).has_value()) << text;
}

} // namespace bask
