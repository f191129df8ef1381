// Registers as temperatures and as faults of sensors.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/protocols/pt100.h"
#include "engine/protocols/register_ranges.h"
#include "engine/protocols/register_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bask {
namespace {

RegisterSpec spec(RegisterType type, RegisterUnit unit, double scale = 1.0, double offset = 0.0) {
    RegisterSpec out;
    out.type = type;
    out.unit = unit;
    out.scale = scale;
    out.offset = offset;
    return out;
}

RegisterValue value(const RegisterSpec& s, std::vector<std::uint16_t> registers) {
    return temperatureFromRegisters(ModbusProfile{}, s, registers);
}

// IEC 60751's own table; catches a wrong coefficient or a missing term below zero.
TEST(Pt100, CheckPointsOfTheStandard) {
    EXPECT_NEAR(pt100Ohm(0.0), 100.0, 1e-12);
    EXPECT_NEAR(pt100Ohm(25.0), 109.7347, 5e-5);
    EXPECT_NEAR(pt100Ohm(60.0), 123.2419, 5e-5);
    EXPECT_NEAR(pt100Ohm(100.0), 138.5055, 5e-5);
    EXPECT_NEAR(pt100Ohm(200.0), 175.856, 5e-4);
    EXPECT_NEAR(pt100Ohm(-100.0), 60.26, 5e-3);
    EXPECT_NEAR(pt100Ohm(-200.0), 18.52, 5e-3);
    EXPECT_NEAR(pt100Ohm(850.0), 390.48, 5e-3);
}

// Catches an inverse that is off anywhere, and one that makes numbers of what no PT100 has.
TEST(Pt100, InverseOverTheWholeRange) {
    for (double t = -200.0; t <= 850.0; t += 0.5)
        ASSERT_NEAR(pt100Celsius(pt100Ohm(t)).value_or(1e9), t, 1e-9);
    EXPECT_FALSE(pt100Celsius(18.0));
    EXPECT_FALSE(pt100Celsius(391.0));
    EXPECT_FALSE(pt100Celsius(std::numeric_limits<double>::quiet_NaN()));
}

// Catches signs, word orders and scales mixed up.
TEST(RegisterValues, TypesAndWordOrders) {
    EXPECT_NEAR(value(spec(RegisterType::Int16, RegisterUnit::Celsius, 0.1), {0xFFCE}).value_K, 268.15, 1e-9);
    EXPECT_NEAR(value(spec(RegisterType::Uint16, RegisterUnit::Celsius, 0.01), {40000}).value_K, 673.15,
                1e-9);
    EXPECT_NEAR(value(spec(RegisterType::Int16, RegisterUnit::Kelvin, 0.1), {2981}).value_K, 298.1, 1e-9);
    RegisterSpec milli = spec(RegisterType::Int32, RegisterUnit::Celsius, 0.001);
    EXPECT_NEAR(value(milli, {0x0001, 0x86A0}).value_K, 373.15, 1e-9); // 100000
    EXPECT_NEAR(value(milli, {0xFFFF, 0xD8F0}).value_K, 263.15, 1e-9); // -10000
    milli.isLowWordFirst = true;
    EXPECT_NEAR(value(milli, {0x86A0, 0x0001}).value_K, 373.15, 1e-9);
    RegisterSpec real = spec(RegisterType::Float32, RegisterUnit::Fahrenheit);
    real.isLowWordFirst = true;
    EXPECT_NEAR(value(real, {0x0000, 0x4296}).value_K, kelvinFromCelsius((75.0 - 32.0) / 1.8),
                1e-9); // 75.0 degF
}

// Promise: what an open or shorted sensor looks like never becomes a temperature.
TEST(RegisterValues, EndsOfTypesAndImplausibleNumbersAreFaults) {
    const RegisterSpec tenths = spec(RegisterType::Int16, RegisterUnit::Celsius, 0.1);
    for (const int raw : {0x8000, 0x7FFF, 0x8001})
        EXPECT_EQ(value(tenths, {static_cast<std::uint16_t>(raw)}).fault, "out_of_range") << raw;
    EXPECT_EQ(value(spec(RegisterType::Uint16, RegisterUnit::Celsius, 0.001), {65535}).fault, "out_of_range");
    EXPECT_EQ(value(spec(RegisterType::Uint16, RegisterUnit::Celsius, 0.1), {32768}).fault, "out_of_range");
    EXPECT_EQ(value(spec(RegisterType::Int16, RegisterUnit::Celsius), {9999}).fault, "out_of_range");
    EXPECT_EQ(value(spec(RegisterType::Int32, RegisterUnit::Celsius, 0.001), {0x7FFF, 0xFFFF}).fault,
              "out_of_range");
    const RegisterSpec real = spec(RegisterType::Float32, RegisterUnit::Celsius);
    EXPECT_EQ(value(real, {0x7FC0, 0x0000}).fault, "out_of_range"); // NaN
    EXPECT_EQ(value(real, {0xFF80, 0x0000}).fault, "out_of_range"); // -infinity
    EXPECT_EQ(value(real, {0xC376, 0xDC29}).fault, "out_of_range"); // -246.86
    EXPECT_TRUE(value(tenths, {600}).fault.empty());
}

// Catches the profile's own numbers being ignored, or compared after scaling.
TEST(RegisterValues, FaultNumbersOfAProfile) {
    RegisterSpec s = spec(RegisterType::Int16, RegisterUnit::Celsius, 0.1);
    s.faults = {{9999.0, "open"}, {-9999.0, "short"}};
    EXPECT_EQ(value(s, {9999}).fault, "open");
    EXPECT_EQ(value(s, {static_cast<std::uint16_t>(-9999)}).fault, "short");
    EXPECT_NEAR(value(s, {999}).value_K, 373.05, 1e-9);
}

// NAMUR NE 43: valid 3.8..20.5 mA, a fault below 3.6 and above 21.
TEST(RegisterValues, CurrentsByNamur) {
    ModbusProfile profile;
    profile.at4mA_degC = -50.0;
    profile.at20mA_degC = 150.0;
    const RegisterSpec s = spec(RegisterType::Uint16, RegisterUnit::Milliampere, 0.001);
    const auto at = [&](int uA) {
        return temperatureFromRegisters(profile, s, std::vector{static_cast<std::uint16_t>(uA)});
    };
    EXPECT_NEAR(at(4000).value_K, 223.15, 1e-9);
    EXPECT_NEAR(at(12000).value_K, 323.15, 1e-9);
    EXPECT_NEAR(at(20000).value_K, 423.15, 1e-9);
    EXPECT_TRUE(at(3800).fault.empty());
    EXPECT_TRUE(at(20500).fault.empty());
    EXPECT_EQ(at(3700).fault, "out_of_range");
    EXPECT_EQ(at(20800).fault, "out_of_range");
    EXPECT_EQ(at(3500).fault, "other");
    EXPECT_EQ(at(21500).fault, "other");
    EXPECT_EQ(at(0).fault, "open");
}

// Catches a broken wire read as a hot sensor, and a shorted one as a cold one.
TEST(RegisterValues, OhmsThatNoPt100Has) {
    const RegisterSpec s = spec(RegisterType::Uint16, RegisterUnit::Ohm, 0.01);
    EXPECT_NEAR(value(s, {12324}).value_K, 333.15, 0.01);
    EXPECT_EQ(value(s, {0}).fault, "short");
    EXPECT_EQ(value(s, {50000}).fault, "open");
}

// Catches a set point that is written in other words than it is read.
TEST(RegisterValues, RoundTripOfEveryTypeAndUnit) {
    ModbusProfile profile;
    for (const RegisterType type : {RegisterType::Int16, RegisterType::Uint16, RegisterType::Int32,
                                    RegisterType::Uint32, RegisterType::Float32}) {
        for (const RegisterUnit unit : {RegisterUnit::Celsius, RegisterUnit::Fahrenheit, RegisterUnit::Kelvin,
                                        RegisterUnit::Ohm, RegisterUnit::Milliampere}) {
            for (const bool low : {false, true}) {
                RegisterSpec s = spec(type, unit, 0.02, 0.0);
                s.isLowWordFirst = low;
                const auto registers = registersFromTemperature(profile, s, 333.15);
                ASSERT_TRUE(registers.ok());
                EXPECT_EQ(static_cast<int>(registers->size()), registerCount(type));
                const RegisterValue back = temperatureFromRegisters(profile, s, *registers);
                EXPECT_TRUE(back.fault.empty());
                EXPECT_NEAR(back.value_K, 333.15, unit == RegisterUnit::Milliampere ? 0.07 : 0.03);
            }
        }
    }
}

// Catches a set point that wraps around into another one.
TEST(RegisterValues, WhatTheTypeCannotHoldIsRefused) {
    const RegisterSpec s = spec(RegisterType::Uint16, RegisterUnit::None, 1.0);
    EXPECT_EQ(registersFromQuantity(s, 65536.0).error().code(), MessageCode::ValueOutOfRange);
    EXPECT_EQ(registersFromQuantity(s, -1.0).error().code(), MessageCode::ValueOutOfRange);
    EXPECT_FALSE(registersFromQuantity(s, std::numeric_limits<double>::quiet_NaN()).ok());
    EXPECT_EQ(*registersFromQuantity(s, 65535.0), std::vector<std::uint16_t>{65535});
}

// Catches a bit taken for another channel's, and the two senses mixed up.
TEST(RegisterValues, StatusBits) {
    StatusSpec status;
    status.firstBit = 2;
    status.bitStep = 2;
    EXPECT_TRUE(isAtFault(status, 1, 0b10000));
    EXPECT_FALSE(isAtFault(status, 0, 0b10000));
    status.isFaultWhenSet = false;
    EXPECT_FALSE(isAtFault(status, 1, 0b10000));
    EXPECT_TRUE(isAtFault(status, 0, 0b10000));
}

// Catches a gap read (the device may have no register there) and neighbours read apart.
TEST(RegisterRanges, NeighboursAreReadTogether) {
    const auto joined = joinedRanges({{4, 8, 1}, {4, 0, 8}, {4, 9, 1}, {3, 10, 1}, {4, 12, 2}, {4, 4, 2}});
    EXPECT_EQ(joined, (std::vector<RegisterRange>{{3, 10, 1}, {4, 0, 10}, {4, 12, 2}}));
    EXPECT_EQ(joinedRanges({{3, 0, 100}, {3, 100, 100}}).size(), 2u);
}

// Catches values kept under the wrong address or function.
TEST(RegisterRanges, ImageKeepsFunctionsApart) {
    RegisterImage image;
    image.store({3, 10, 2}, {1, 2});
    image.store({4, 10, 2}, {3, 4});
    EXPECT_EQ(image.registers({3, 11, 1}), std::vector<std::uint16_t>{2});
    EXPECT_EQ(image.registers({4, 10, 2}), (std::vector<std::uint16_t>{3, 4}));
    EXPECT_THROW(image.registers({4, 12, 1}), std::out_of_range);
    EXPECT_THROW(image.store({3, 0, 2}, {1}), std::invalid_argument);
}

} // namespace
} // namespace bask
