// The catalogue of drivers against what walks it: files, forms, the rig.

#include "engine/drivers/driver_catalogue.h"

#include "engine/base/named_values.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <set>

namespace bask {
namespace {

constexpr std::array kRoles{DeviceRole::Robot, DeviceRole::Thermometer, DeviceRole::HeatSource};

/// What a driver brings along that no other has.
struct OwnSettings {
    double emittance = 0.95;
    int average = 4;
};

constexpr Parameter<OwnSettings> kOwn[]{
    {{"emittance", unit::kNone, {0.0, 1.0, true}}, &OwnSettings::emittance},
    {{"average", unit::kSeconds, {1.0, 100.0}}, &OwnSettings::average},
};

template <class Driver> void expectWhole(const std::vector<Driver>& drivers) {
    std::set<std::string> keys;
    for (const Driver& driver : drivers) {
        EXPECT_TRUE(keys.insert(driver.key).second) << driver.key;
        EXPECT_GT(std::strlen(driver.name), 0U) << driver.key;
        EXPECT_NE(driver.make, nullptr) << driver.key;
        std::set<std::string> parameters;
        for (const auto& parameter : driver.parameters) {
            EXPECT_TRUE(parameters.insert(keyOf(*parameter.facts)).second) << driver.key;
            EXPECT_GT(std::strlen(parameter.facts->label), 0U) << driver.key << ", for its form";
            EXPECT_LT(parameter.facts->range.min, parameter.facts->range.max) << driver.key;
        }
    }
}

} // namespace

// Catches an entry with a forgotten field, or two that files cannot tell apart.
TEST(DriverCatalogue, EveryEntryIsWhole) {
    expectWhole(robotDrivers());
    expectWhole(thermometerDrivers());
    expectWhole(heatSourceDrivers());
    for (const DeviceRole role : kRoles)
        EXPECT_FALSE(driversOf(role).empty());
    EXPECT_TRUE(driversOf(DeviceRole::Camera).empty());
}

// Catches a usual device whose driver is not there.
TEST(DriverCatalogue, TheUsualDevicesHaveADriver) {
    EXPECT_STREQ(driverOf(RobotDeviceSpec()).key, "grbl");
    EXPECT_STREQ(driverOf(ThermometerDeviceSpec()).key, "modbus");
    EXPECT_STREQ(driverOf(HeatSourceDeviceSpec()).key, "by_hand");
}

// Catches an unknown driver that silently becomes another one.
TEST(DriverCatalogue, AnUnknownKeyIsAnError) {
    RobotDeviceSpec robot;
    ThermometerDeviceSpec thermometer;
    HeatSourceDeviceSpec source;
    robot.driver = "stream"; // of another role
    thermometer.driver = "Stream";
    source.driver = "";
    EXPECT_THROW(driverOf(robot), std::invalid_argument);
    EXPECT_THROW(driverOf(thermometer), std::invalid_argument);
    EXPECT_THROW(driverOf(source), std::invalid_argument);
}

// Catches values of a driver's own that do not come back as they were set, or have no default.
TEST(DriverCatalogue, ADriversOwnValuesComeBack) {
    const ParameterTable<OwnSettings> table = kOwn;
    const auto parameters = ownParameters<ThermometerDeviceSpec>(table, SetupStep::Use);
    ThermometerDeviceSpec spec;
    EXPECT_EQ(parameters.at(0).get(spec), 0.95);
    EXPECT_EQ(parameters.at(1).get(spec), 4.0);
    EXPECT_EQ(settingsFrom(table, spec.own).average, 4);
    parameters.at(0).set(spec, 0.5);
    parameters.at(1).set(spec, 7.0);
    EXPECT_EQ(spec.own, (NamedValues{{"emittance", 0.5}, {"average_s", 7.0}}));
    EXPECT_EQ(parameters.at(1).get(spec), 7.0);
    EXPECT_EQ(settingsFrom(table, spec.own).emittance, 0.5);
    EXPECT_EQ(settingsFrom(table, spec.own).average, 7);
    EXPECT_NE(spec, ThermometerDeviceSpec()) << "another device";
}

} // namespace bask
