// Profiles of Modbus devices as JSON, and those that come with Bask.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/register_values.h"
#include "tests/support/shipped_profile.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace bask {
namespace {

const char* const kThermometer = R"({"name": "x", "channel": {"address": 5}, "channels": 2})";

Error refusal(const std::string& text) {
    const auto profile = modbusProfileFromJson(text, "p.json");
    return profile ? Error() : profile.error();
}

std::string with(const std::string& channel, const std::string& rest = "") {
    return R"({"name": "x", "channel": {"address": 5)" + channel + R"(}, "channels": 2)" + rest + "}";
}

std::string controller(const std::string& rest) {
    return R"({"name": "c", "process_value": {"address": 1}, "set_point": {"address": 2})" + rest + "}";
}

using test::shipped;

RegisterValue channel(const std::string& name, int raw) {
    const ModbusProfile& p = shipped(name);
    return temperatureFromRegisters(p, p.channel.value(), std::vector{static_cast<std::uint16_t>(raw)});
}

// Catches defaults that differ from the header's.
TEST(ModbusProfile, DefaultsAreThoseOfTheStructure) {
    const auto profile = modbusProfileFromJson(kThermometer, "p.json");
    ASSERT_TRUE(profile.ok());
    ModbusProfile expected;
    expected.name = "x";
    expected.channel = RegisterSpec{};
    expected.channel->address = 5;
    expected.channels = 2;
    EXPECT_EQ(*profile, expected);
}

// Catches a document whose example is refused.
TEST(ModbusProfile, TheExampleOfTheDocumentIsRead) {
    std::ifstream file(BASK_TEST_DATA "/../../docs/modbus-profiles.md");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::size_t begin = text.find("```json") + 7, end = text.find("```", begin);
    const auto profile = modbusProfileFromJson(text.substr(begin, end - begin), "docs");
    ASSERT_TRUE(profile.ok()) << describe(profile.error());
    EXPECT_EQ(profile->channels, 4);
    EXPECT_EQ(profile->channel->faults.at(32767.0), "open");
}

// Catches a key that is written and not read back, or the other way round.
TEST(ModbusProfile, EverythingSurvivesARoundTrip) {
    ModbusProfile all;
    all.name = "n";
    all.title = "t \"quoted\" \xC2\xB0";
    all.source = "s";
    all.channel = RegisterSpec{4,   7,    RegisterType::Int32,       true,
                               0.1, -3.5, RegisterUnit::Milliampere, {{-32768.0, "open"}, {0.5, "short"}}};
    all.channels = 3;
    all.isOneByOne = true;
    all.deviceType = RegisterSpec{3, 60000, RegisterType::Float32};
    all.deviceType->unit = RegisterUnit::None;
    all.deviceTypes = {7.0, 8.0};
    all.channelStep = 4;
    all.status = {{4, 9, 1, 2, false, "other"}, {3, 10, 0, 1, true, "short"}};
    all.at4mA_degC = -50.0;
    all.at20mA_degC = 1.0 / 3.0;
    EXPECT_EQ(modbusProfileFromJson(modbusProfileToJson(all), "").value(), all);

    ModbusProfile control;
    control.name = "c";
    control.processValue =
        RegisterSpec{4, 1, RegisterType::Float32, true, 2.0, 1.0, RegisterUnit::Kelvin, {}};
    control.setPoint =
        RegisterSpec{4, 2, RegisterType::Uint32, false, 0.1, 0.0, RegisterUnit::Fahrenheit, {}};
    control.setPointWritten =
        RegisterSpec{3, 3, RegisterType::Int16, false, 0.1, 0.0, RegisterUnit::Celsius, {}};
    control.run = RegisterSpec{3, 4, RegisterType::Uint16, false, 1.0, 0.0, RegisterUnit::None, {}};
    control.runOn = 10.0;
    control.runOff = 62.0;
    control.setPointOff_degC = -10.0;
    control.watchdog = control.run;
    control.watchdogUnit_s = 0.1;
    control.sensorFault = RegisterSpec{4, 6, RegisterType::Uint16, false, 1.0, 0.0, RegisterUnit::None, {}};
    control.status = {{3, 8, 3, 1, true, "open"}};
    EXPECT_EQ(modbusProfileFromJson(modbusProfileToJson(control), "").value(), control);
}

// Catches a writer that throws for a rig whose profile is not chosen yet.
TEST(ModbusProfile, AnEmptyOneCanBeWritten) {
    EXPECT_EQ(refusal(modbusProfileToJson(ModbusProfile{})).code(), MessageCode::JsonMissingKey);
}

// Catches a misspelt key, a wrong type or nonsense being taken, and a refusal without its place.
TEST(ModbusProfile, RefusesWithThePlace) {
    struct Case {
        std::string text;
        MessageCode code;
        std::string where;
    };
    const std::vector<Case> cases{
        {"{", MessageCode::JsonSyntax, "p.json"},
        {"[]", MessageCode::JsonWrongType, "p.json"},
        {R"({"channel": {"address": 5}, "channels": 1})", MessageCode::JsonMissingKey, "p.json"},
        {R"({"name": "", "channel": {"address": 5}, "channels": 1})", MessageCode::NameEmpty, "p.json: name"},
        {R"({"name": "x"})", MessageCode::JsonMissingKey, "p.json"},
        {R"({"name": "x", "name": "y"})", MessageCode::JsonDuplicateKey, "p.json"},
        {R"({"name": )" + std::string(33, '[') + std::string(33, ']') + '}', MessageCode::JsonTooDeep,
         "p.json"},
        {with("", R"(, "chanels": 2)"), MessageCode::JsonUnknownKey, "p.json"},
        {with(R"(, "adress": 2)"), MessageCode::JsonUnknownKey, "p.json: channel"},
        {R"({"name": "x", "channel": {}, "channels": 1})", MessageCode::JsonMissingKey, "p.json: channel"},
        {R"({"name": "x\u200b", "channel": {"address": 5}, "channels": 1})", MessageCode::NameNotPlain,
         "p.json: name"},
        {R"({"name": "x", "title": "a\u001b[31m", "channel": {"address": 5}, "channels": 1})",
         MessageCode::NameNotPlain, "p.json: title"},
        {R"({"name": "x", "channel": {"address": 5}})", MessageCode::JsonMissingKey, "p.json"},
        {R"({"name": "x", "channel": {"address": "5"}, "channels": 1})", MessageCode::JsonWrongType,
         "p.json: channel.address"},
        {R"({"name": "x", "channel": {"address": 1.5}, "channels": 1})", MessageCode::JsonWrongType,
         "p.json: channel.address"},
        {R"({"name": "x", "channel": {"address": 65536}, "channels": 1})", MessageCode::ValueOutOfRange,
         "p.json: channel.address"},
        {R"({"name": "x", "channel": {"address": 65535, "type": "float32"}, "channels": 1})",
         MessageCode::ValueOutOfRange, "p.json: channel.address"},
        {R"({"name": "x", "channel": {"address": 2147483647, "type": "float32"}, "channels": 1})",
         MessageCode::ValueOutOfRange, "p.json: channel.address"},
        {with(R"(, "function": 5)"), MessageCode::ValueOutOfRange, "p.json: channel.function"},
        {with(R"(, "type": "int8")"), MessageCode::ValueUnknown, "p.json: channel.type"},
        {with(R"(, "unit": "volt")"), MessageCode::ValueUnknown, "p.json: channel.unit"},
        {with(R"(, "unit": "none")"), MessageCode::ValueUnknown, "p.json: channel.unit"},
        {with(R"(, "scale": 0)"), MessageCode::ValueUnknown, "p.json: channel.scale"},
        {with(R"(, "scale": 1e999)"), MessageCode::JsonSyntax, "p.json"},
        {with(R"(, "low_word_first": 1)"), MessageCode::JsonWrongType, "p.json: channel.low_word_first"},
        {with(R"(, "faults": {"1x": "open"})"), MessageCode::JsonWrongType, "p.json: channel.faults.1x"},
        {with(R"(, "faults": {"1": "broken"})"), MessageCode::ValueUnknown, "p.json: channel.faults.1"},
        {with(R"(, "type": "float32")"), MessageCode::ValueOutOfRange, "p.json: channel_step"},
        {R"({"name": "x", "channel": {"address": 5}, "channels": 0})", MessageCode::ValueOutOfRange,
         "p.json: channels"},
        {R"({"name": "x", "channel": {"address": 5}, "channels": 20, "channel_step": 10})",
         MessageCode::ValueOutOfRange, "p.json: channel_step"},
        {R"({"name": "x", "channel": {"address": 65530}, "channels": 10})", MessageCode::ValueOutOfRange,
         "p.json: channel_step"},
        {with("", R"(, "status": {})"), MessageCode::JsonWrongType, "p.json: status"},
        {with("", R"(, "status": [{"address": 1, "fault": "hot"}])"), MessageCode::ValueUnknown,
         "p.json: status[0].fault"},
        {with("", R"(, "status": [{"address": 1, "first_bit": 15}])"), MessageCode::ValueOutOfRange,
         "p.json: status[0].first_bit"},
        {with("", R"(, "at_20mA_degC": 0)"), MessageCode::ValueUnknown, "p.json: at_20mA_degC"},
        {with("", R"(, "run": {"address": 1})"), MessageCode::JsonUnknownKey, "p.json"},
        {R"({"name": "c", "process_value": {"address": 1}})", MessageCode::JsonMissingKey, "p.json"},
        {R"({"name": "c", "process_value": {"address": 1}, "set_point": {"address": 2, "function": 4}})",
         MessageCode::ValueOutOfRange, "p.json: set_point.function"},
        {controller(R"(, "run": {"address": 3, "unit": "degC"})"), MessageCode::ValueUnknown,
         "p.json: run.unit"},
        {R"({"name": "c", "process_value": {"address": 1, "unit": "mA"}, "set_point": {"address": 2}})",
         MessageCode::ValueUnknown, "p.json: process_value.unit"},
        {controller(R"(, "run_on": 0)"), MessageCode::ValueUnknown, "p.json: run_off"},
        {controller(R"(, "watchdog_unit_s": 0)"), MessageCode::ValueNotPositive, "p.json: watchdog_unit_s"},
        // "Off" that heats, is never seen, or cannot be written.
        {controller(R"(, "set_point_off_degC": 200)"), MessageCode::ValueOutOfRange,
         "p.json: set_point_off_degC"},
        {controller(R"(, "set_point_off_degC": 40.1)"), MessageCode::ValueOutOfRange,
         "p.json: set_point_off_degC"},
        {controller(R"(, "run": {"address": 3}, "set_point_off_degC": 200)"), MessageCode::ValueOutOfRange,
         "p.json: set_point_off_degC"},
        {R"({"name": "c", "process_value": {"address": 1}, "set_point_off_degC": -1,)"
         R"( "set_point": {"address": 2, "type": "uint16"}})",
         MessageCode::ValueOutOfRange, "p.json: set_point_off_degC"},
        {R"({"name": "c", "process_value": {"address": 1},)"
         R"( "set_point": {"address": 2, "faults": {"0": "open"}}})",
         MessageCode::ValueUnknown, "p.json: set_point_off_degC"},
        {controller(R"(, "run": {"address": 3, "type": "uint16"}, "run_off": -1)"),
         MessageCode::ValueOutOfRange, "p.json: run_off"},
        {controller(R"(, "run": {"address": 3}, "run_on": 1, "run_off": 0.5)"), MessageCode::ValueUnknown,
         "p.json: run_off"},
        {controller(R"(, "run": {"address": 3}, "run_on": 0.6)"), MessageCode::ValueUnknown,
         "p.json: run_on"},
    };
    for (const Case& c : cases) {
        const Error error = refusal(c.text);
        EXPECT_EQ(error.code(), c.code) << c.text << "\n" << describe(error);
        EXPECT_EQ(error.where, c.where) << c.text;
    }
}

// Catches a shipped profile that cannot be read, has no source, or is listed under two names.
TEST(ModbusProfile, TheTypeOfADeviceNeedsItsNumbers) {
    const std::string type = R"(, "device_type": {"address": 9, "type": "uint16"})";
    EXPECT_EQ(argTexts(refusal(with("", type)).message), std::vector<std::string>{"device_types"});
    EXPECT_EQ(refusal(with("", type + R"(, "device_types": [])")).where, "p.json: device_types");
    EXPECT_EQ(refusal(with("", type + R"(, "device_types": [7, -1])")).where, "p.json: device_types");
    EXPECT_EQ(refusal(with("", type + R"(, "device_types": [7.5])")).where, "p.json: device_types");
    EXPECT_EQ(refusal(with("", type + R"(, "device_types": ["7"])")).code(), MessageCode::JsonWrongType);
    EXPECT_EQ(refusal(with("", R"(, "device_types": [7])")).where, "p.json: device_types");
    EXPECT_EQ(
        refusal(with("", R"(, "device_type": {"address": 9, "unit": "degC"}, "device_types": [7])")).where,
        "p.json: device_type.unit");
    EXPECT_TRUE(modbusProfileFromJson(with("", type + R"(, "device_types": [7, 8])"), "").ok());
    EXPECT_TRUE(
        modbusProfileFromJson(controller(type + R"(, "device_types": [7], "set_point_off_degC": 0)"), ""));
}

// Catches channels beyond one request that are refused although each has its own, and the other way round.
TEST(ModbusProfile, ChannelsReadOneByOneMayBeFarApart) {
    const std::string far = R"(, "channel_step": 125)";
    EXPECT_EQ(refusal(with("", far)).where, "p.json: channel_step");
    EXPECT_TRUE(modbusProfileFromJson(with("", far + R"(, "one_by_one": true)"), "").ok());
    EXPECT_EQ(refusal(R"({"name": "x", "channel": {"address": 65500}, "channels": 2, "channel_step": 125,
                        "one_by_one": true})")
                  .where,
              "p.json: channel_step");
    EXPECT_EQ(refusal(with("", R"(, "one_by_one": 1)")).code(), MessageCode::JsonWrongType);
}

TEST(ShippedProfiles, AreSoundAndSorted) {
    std::vector<std::string> names;
    for (const ModbusProfile& p : shippedProfiles()) {
        names.push_back(p.name);
        EXPECT_FALSE(p.title.empty()) << p.name;
        EXPECT_FALSE(p.source.empty()) << p.name;
        EXPECT_EQ(modbusProfileFromJson(modbusProfileToJson(p), p.name).value(), p);
    }
    EXPECT_EQ(names, (std::vector<std::string>{
                         "adam-4015-0-100", "benshaw-remote-rtd", "eurotherm-2400", "generic-pt100-ohm",
                         "isma-sfar-1m-1ti1do", "labjack-t7-thermocouples", "modmux-pm6rtd", "pixsys-drr245",
                         "thermasgard-rtm1", "watlow-ez-zone", "waveshare-8ch-4-20ma"}));
}

// What the manuals say; catches an address, scale or fault number typed wrongly.
TEST(ShippedProfiles, ThermometersReadAsTheirManualsSay) {
    EXPECT_NEAR(channel("modmux-pm6rtd", 3451).value_K, kelvinFromCelsius(345.1), 1e-9);
    EXPECT_EQ(channel("modmux-pm6rtd", 32768).fault, "open");
    EXPECT_EQ(channel("modmux-pm6rtd", 65536 - 32767).fault, "open");
    EXPECT_EQ(shipped("modmux-pm6rtd").channels, 6);

    EXPECT_NEAR(channel("benshaw-remote-rtd", 200).value_K, kelvinFromCelsius(200.0), 1e-9);
    const ModbusProfile& benshaw = shipped("benshaw-remote-rtd");
    EXPECT_EQ(benshaw.channels, 8);
    EXPECT_EQ(benshaw.status.at(0), (StatusSpec{4, 8, 0, 1, true, "short"}));
    EXPECT_EQ(benshaw.status.at(1), (StatusSpec{4, 9, 0, 1, true, "open"}));

    const ModbusProfile& isma = shipped("isma-sfar-1m-1ti1do");
    EXPECT_EQ(isma.channel->address, 52); // 30053
    EXPECT_EQ(isma.channel->function, 4);
    EXPECT_EQ(isma.status.at(0), (StatusSpec{4, 50, 0, 1, false, "open"}));
    EXPECT_NEAR(channel("isma-sfar-1m-1ti1do", 235).value_K, kelvinFromCelsius(23.5), 1e-9);

    EXPECT_EQ(shipped("thermasgard-rtm1").channel->function, 4);
    EXPECT_EQ(shipped("thermasgard-rtm1").channel->address, 0);
    EXPECT_NEAR(channel("thermasgard-rtm1", 65536 - 350).value_K, kelvinFromCelsius(-35.0), 1e-9);

    EXPECT_NEAR(channel("waveshare-8ch-4-20ma", 12000).value_K, kelvinFromCelsius(50.0), 1e-9);
    EXPECT_EQ(channel("waveshare-8ch-4-20ma", 3500).fault, "other");
    EXPECT_EQ(channel("waveshare-8ch-4-20ma", 21500).fault, "other");

    EXPECT_NEAR(channel("generic-pt100-ohm", 13851).value_K, kelvinFromCelsius(100.0), 0.02);
    EXPECT_EQ(channel("generic-pt100-ohm", 65535).fault, "out_of_range");

    EXPECT_NEAR(channel("adam-4015-0-100", 39321).value_K, kelvinFromCelsius(60.0), 1e-3);
    EXPECT_EQ(channel("adam-4015-0-100", 65535).fault, "out_of_range");
    EXPECT_EQ(channel("adam-4015-0-100", 0).fault, "out_of_range");
}

// As above, for what heats: here a wrong number heats wrongly.
TEST(ShippedProfiles, ALabJackTellsKelvinInTwoRegisters) {
    const ModbusProfile& p = shipped("labjack-t7-thermocouples");
    const auto read = [&](std::uint16_t high, std::uint16_t low) {
        return temperatureFromRegisters(p, p.channel.value(), std::vector{high, low});
    };
    EXPECT_NEAR(read(0x4396, 0x0000).value_K, 300.0, 1e-9); // 300.0F is 0x43960000
    EXPECT_EQ(read(0xc61c, 0x3c00).fault, "open");          // -9999.0F
    EXPECT_EQ(read(0x7fc0, 0x0000).fault.empty(), false);
    EXPECT_EQ(p.channel->address + 13 * p.channelStep, 7026) << "AIN13_EF_READ_A";
}

TEST(ShippedProfiles, ControllersReadAndAreSetAsTheirManualsSay) {
    const ModbusProfile& eurotherm = shipped("eurotherm-2400");
    EXPECT_EQ(eurotherm.processValue->address, 1);
    EXPECT_EQ(eurotherm.setPoint->address, 5);
    EXPECT_EQ(eurotherm.setPointWritten->address, 24);
    EXPECT_EQ(eurotherm.sensorFault->address, 258);
    EXPECT_EQ(*registersFromTemperature(eurotherm, *eurotherm.setPointWritten, kelvinFromCelsius(80.4)),
              std::vector<std::uint16_t>{80});

    const ModbusProfile& watlow = shipped("watlow-ez-zone");
    EXPECT_EQ(watlow.processValue->address, 360);
    EXPECT_EQ(watlow.setPoint->address, 2160);
    EXPECT_EQ(*registersFromTemperature(watlow, *watlow.setPoint, kelvinFromCelsius((75.0 - 32.0) / 1.8)),
              (std::vector<std::uint16_t>{0x0000, 0x4296})); // 75.0, its manual's example

    const ModbusProfile& pixsys = shipped("pixsys-drr245");
    EXPECT_EQ(pixsys.processValue->address, 1000);
    EXPECT_EQ(pixsys.setPoint->address, 1001);
    EXPECT_EQ(pixsys.run->address, 1016);
    EXPECT_EQ(pixsys.runOn, 1.0);
    EXPECT_EQ(pixsys.runOff, 0.0);
    EXPECT_EQ(pixsys.watchdog->address, 1022);
    EXPECT_EQ(pixsys.watchdogUnit_s, 0.001);
    EXPECT_EQ(pixsys.status.at(0), (StatusSpec{3, 1014, 3, 1, true, "other"}));
    EXPECT_EQ(*registersFromTemperature(pixsys, *pixsys.setPoint, kelvinFromCelsius(80.4)),
              std::vector<std::uint16_t>{804});
}

} // namespace
} // namespace bask
