// What a rig may not be: heat that nothing switches off, a device without a driver, values out of range.

#include "engine/model/rig_spec.h"

#include "engine/base/message_code.h"
#include "engine/drivers/driver_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace bask {
namespace {

const ModbusProfile& profileOf(const std::string& name) {
    return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
}

RigSpec rigWith(const ModbusProfile& profile) {
    RigSpec rig;
    rig.source.emplace().driver = "modbus";
    rig.source->port = "/dev/ttyPLATE";
    rig.source->profile = profile;
    return rig;
}

Error refusal(const RigSpec& rig) {
    const auto fit = checkRig(rig, 0, {});
    return fit ? Error(MessageCode::None, "") : fit.error();
}

/// A device of each driver that is valid, each with its range's limits.
template <class Spec> void expectRanges(std::optional<Spec> RigSpec::*place, const char* path, RigSpec rig) {
    const auto name = [&](const ParameterFacts& facts) { return std::string(path) + '.' + keyOf(facts); };
    const RigSpec valid = rig;
    ASSERT_EQ(refusal(valid).code(), MessageCode::None) << path << ": " << describe(refusal(valid));
    for (const auto& parameter : driverOf(*(rig.*place)).parameters) {
        if (!parameter.applies(*(rig.*place)))
            continue;
        for (const double outside : {parameter.facts->range.min - 1.0, parameter.facts->range.max + 1.0}) {
            rig = valid;
            parameter.set(*(rig.*place), fromWritten(*parameter.facts, outside));
            EXPECT_EQ(refusal(rig).where, name(*parameter.facts)) << outside;
        }
    }
    for (const Parameter<SerialSettings>& parameter : serialParameters())
        for (const double outside : {parameter.range.min - 1.0, parameter.range.max + 1.0}) {
            rig = valid;
            parameter.set((rig.*place)->serial, outside);
            std::string where(path);
            where.append(".serial.").append(keyOf(parameter));
            EXPECT_EQ(refusal(rig).where, where) << outside;
        }
}

template <class Spec> RigSpec rigWithDevice(std::optional<Spec> RigSpec::*place, const char* driver) {
    RigSpec rig;
    Spec& spec = (rig.*place).emplace();
    spec.driver = driver;
    spec.port = spec.driver == "modbus_tcp" ? "host-x" : "/dev/ttyX";
    return rig;
}

} // namespace

// Catches a parameter of a driver, or a setting of its line, that nobody checks.
TEST(RigSpec, EveryParameterIsRefusedOutsideItsRange) {
    for (const RobotDriver& driver : robotDrivers())
        expectRanges(&RigSpec::robot, "robot", rigWithDevice(&RigSpec::robot, driver.key));
    for (const ThermometerDriver& driver : thermometerDrivers()) {
        RigSpec rig = rigWithDevice(&RigSpec::thermometer, driver.key);
        if (driver.isModbus)
            rig.thermometer->profile = profileOf("modmux-pm6rtd");
        expectRanges(&RigSpec::thermometer, "thermometer", rig);
    }
    for (const HeatSourceDriver& driver : heatSourceDrivers()) {
        RigSpec rig = rigWithDevice(&RigSpec::source, driver.key);
        if (driver.isModbus)
            rig.source->profile = profileOf("pixsys-drr245");
        if (driver.link != DriverLink::None)
            expectRanges(&RigSpec::source, "source", rig);
    }
}

// Catches a driver that is not there and silently becomes another.
// Catches: a name that commands a terminal or looks like another one, and one whose bytes are counted.
TEST(RigSpec, ANameIsPlainAndMeasuredInCharacters) {
    RigSpec rig = rigWith(profileOf("pixsys-drr245"));
    ASSERT_EQ(refusal(rig).code(), MessageCode::None) << describe(refusal(rig));
    rig.name.clear();
    for (int k = 0; k < 1000; ++k)
        rig.name += "\u52a0";
    EXPECT_EQ(refusal(rig).code(), MessageCode::None);
    rig.name += "a";
    EXPECT_EQ(refusal(rig).code(), MessageCode::ValueOutOfRange);
    for (const char* name : {"a\x1b[31m", "a\u202eb", "a\u200b"}) {
        rig.name = name;
        EXPECT_EQ(refusal(rig).code(), MessageCode::NameNotPlain) << name;
        EXPECT_EQ(refusal(rig).where, "name") << name;
    }
}

TEST(RigSpec, AnUnknownDriverIsRefusedWithTheKnownOnes) {
    RigSpec robot = rigWithDevice(&RigSpec::robot, "scara");
    EXPECT_EQ(refusal(robot).code(), MessageCode::ValueUnknown);
    EXPECT_EQ(refusal(robot).where, "robot.driver");
    EXPECT_EQ(refusal(robot).message.args, (std::vector<MessageArg>{"scara", "grbl, dobot, program"}));
    EXPECT_EQ(refusal(rigWithDevice(&RigSpec::thermometer, "")).where, "thermometer.driver");
    EXPECT_EQ(refusal(rigWithDevice(&RigSpec::source, "grbl")).where, "source.driver");
}

// Catches a driver, or a parameter of one, that the document does not tell.
TEST(RigSpec, TheDocumentHasEveryDriver) {
    std::ifstream file(BASK_DOCS "/experiment-format.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto expectDriver = [&](const std::string& role, const auto& driver) {
        const std::size_t at = text.find("\n| `" + role + ".driver`");
        ASSERT_NE(at, std::string::npos) << role;
        const std::string row = text.substr(at + 1, text.find('\n', at + 1) - at);
        EXPECT_NE(row.find("`\"" + std::string(driver.key) + "\"`"), std::string::npos) << role << driver.key;
        for (const auto& parameter : driver.parameters) {
            const std::string key = keyOf(*parameter.facts);
            EXPECT_TRUE(text.find(std::string("`").append(role).append(".").append(key).append("`")) !=
                            std::string::npos ||
                        text.find("`." + key + '`') != std::string::npos)
                << role << '.' << key;
        }
    };
    for (const RobotDriver& driver : robotDrivers())
        expectDriver("robot", driver);
    for (const ThermometerDriver& driver : thermometerDrivers())
        expectDriver("thermometer", driver);
    for (const HeatSourceDriver& driver : heatSourceDrivers())
        expectDriver("source", driver);
}

// Catches a path or a sentence that is only told when the device is opened, in words about a host.
TEST(RigSpec, AnAddressOfModbusTcpMustBeOne) {
    RigSpec rig = rigWith(profileOf("pixsys-drr245"));
    rig.source->driver = "modbus_tcp";
    for (const char* address : {"192.168.1.20", "logger:1502", "[::1]:502", "fe80::1%eth0"}) {
        rig.source->port = address;
        EXPECT_EQ(refusal(rig).code(), MessageCode::None) << address;
    }
    for (const char* address : {"/dev/ttyUSB0", "logger:0", "logger:502:503x", "a b", "http://a", "[::1"}) {
        rig.source->port = address;
        EXPECT_EQ(refusal(rig).where, "source.port") << address;
        EXPECT_EQ(refusal(rig).code(), MessageCode::ValueUnknown) << address;
    }
    rig.source->port.clear();
    EXPECT_EQ(refusal(rig).code(), MessageCode::JsonMissingKey);
    rig.source->port = "logger";
    rig.source->profile = profileOf("eurotherm-2400");
    EXPECT_EQ(refusal(rig).code(), MessageCode::SourceUnwatched) << "a network has no guard either";
}

// Catches two connections to one device, and a gateway with two units that is refused.
TEST(RigSpec, TwoUnitsMayShareAnAddress) {
    RigSpec rig = rigWith(profileOf("pixsys-drr245"));
    rig.source->driver = "modbus_tcp";
    rig.source->port = "gateway";
    rig.source->unit = 2;
    ThermometerDeviceSpec& thermometer = rig.thermometer.emplace();
    thermometer.driver = "modbus_tcp";
    thermometer.port = "gateway";
    thermometer.profile = profileOf("modmux-pm6rtd");
    thermometer.serial = {19200, 8, 'E', 1}; // of no matter there
    EXPECT_EQ(refusal(rig).code(), MessageCode::None) << describe(refusal(rig));
    EXPECT_TRUE(hasOneLine(rig));
    thermometer.unit = 2;
    EXPECT_EQ(refusal(rig).code(), MessageCode::PortTwice);
    thermometer.unit = 1;
    thermometer.port = "gateway:502"; // the same one
    EXPECT_EQ(refusal(rig).code(), MessageCode::PortTwice);
    thermometer.port = "gateway:503";
    EXPECT_EQ(refusal(rig).code(), MessageCode::None);
}

// Promise: an engine that dies leaves no heat on, unless somebody has said that it may.
TEST(RigSpec, ASourceWithoutWatchdogMustBeAllowed) {
    for (const char* name : {"eurotherm-2400", "watlow-ez-zone"}) {
        RigSpec rig = rigWith(profileOf(name));
        EXPECT_EQ(refusal(rig).code(), MessageCode::SourceUnwatched) << name;
        EXPECT_EQ(refusal(rig).where, "source.profile");
        EXPECT_NE(describe(refusal(rig)).find("\"unattended_heat\": true"), std::string::npos);
        rig.source->mayHeatUnattended = true;
        EXPECT_EQ(refusal(rig).code(), MessageCode::None) << name;
    }
    EXPECT_EQ(refusal(rigWith(profileOf("pixsys-drr245"))).code(), MessageCode::None);
    RigSpec isManual;
    isManual.source.emplace();
    EXPECT_EQ(refusal(isManual).code(), MessageCode::None) << "a person is there";
}

// Catches a time that the register cannot hold, found only when the session begins; or one rounded to none.
TEST(RigSpec, TheWatchdogsTimeMustFitItsRegister) {
    RigSpec rig = rigWith(profileOf("pixsys-drr245")); // milliseconds in 16 bits
    rig.source->watchdog_s = 65.5;
    EXPECT_EQ(refusal(rig).code(), MessageCode::None);
    for (const double time_s : {66.0, 1500.0}) {
        rig.source->watchdog_s = time_s;
        EXPECT_EQ(refusal(rig).code(), MessageCode::ValueOutOfRange);
        EXPECT_EQ(refusal(rig).where, "source.watchdog_s");
    }
    rig.source->profile.watchdogUnit_s = 60.0;
    rig.source->watchdog_s = 120.0;
    EXPECT_EQ(refusal(rig).code(), MessageCode::None);
    for (const double time_s : {20.0, 30.0, 90.0}) {
        rig.source->watchdog_s = time_s;
        EXPECT_EQ(refusal(rig).code(), MessageCode::ValueOutOfRange) << time_s;
    }
}

} // namespace bask
