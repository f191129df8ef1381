// What answers at a port, without a word that is written.

#include "engine/drivers/modbus_scan.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/drivers/rtu_link.h"
#include "engine/protocols/modbus_frame.h"
#include "tests/engine/drivers/test_links.h"
#include "tests/support/scripted_modbus_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace bask::test {
namespace {

const ModbusProfile& scannedProfile(const std::string& name) {
    return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
}

class ModbusScanTest : public testing::Test {
protected:
    /// As the simulated units answer; an address that they have not is refused.
    std::optional<ModbusReply> answer(const ModbusRequest& request) {
        if (!units.contains(request.unit))
            return gatewayException
                       ? std::optional(ModbusReply(modbusException("line", 1, *gatewayException)))
                       : std::nullopt;
        std::vector<std::uint16_t> out;
        for (int i = 0; i < request.count; ++i) {
            try {
                out.push_back(sim.registerAt(request.unit, request.function, request.address + i));
            } catch (const std::out_of_range&) {
                return ModbusReply(modbusException("line", 1, 2));
            }
        }
        return ModbusReply(out);
    }
    void run(int first, int last) {
        ModbusScan scan(link, first, last);
        for (int i = 0; scan.work() && i < 100000; ++i)
            clock.advance(0.005);
        found = scan.found();
    }
    std::vector<std::string> fitsOf(int unit) const {
        std::vector<std::string> out;
        const auto it = std::ranges::find(found, unit, &FoundUnit::unit);
        if (it != found.end())
            for (const ProfileFit& fit : it->fits)
                out.push_back(fit.profile);
        return out;
    }

    ManualClock clock;
    ModbusSimulator sim;
    std::set<int> units;
    std::optional<int> gatewayException; ///< for a unit that is not there
    ScriptedModbusLink link{clock, [this](const ModbusRequest& request) { return answer(request); }};
    std::vector<FoundUnit> found;
};

} // namespace

// Catches a device that is not found, or taken for another, and a register that is written.
TEST_F(ModbusScanTest, FindsEachShippedProfileAmongSixteenUnits) {
    int unit = 1;
    for (const ModbusProfile& profile : shippedProfiles()) {
        ModbusSimulator fresh;
        sim = fresh;
        if (profile.channel)
            sim.addThermometer(unit, profile, 299.15);
        else
            sim.addController(unit, profile);
        if (profile.identity)
            for (int i = 0; i < profile.identity->count; ++i)
                sim.setRegister(unit, profile.identity->function, profile.identity->address + i, 7);
        units = {unit};
        link.open();
        run(1, 16);
        ASSERT_EQ(found.size(), 1U) << profile.name;
        EXPECT_EQ(found.front().unit, unit);
        const std::vector<std::string> fits = fitsOf(unit);
        EXPECT_NE(std::ranges::find(fits, profile.name), fits.end()) << profile.name;
        EXPECT_LE(fits.size(), 3U) << profile.name << ": " << testing::PrintToString(fits);
        unit = unit % 16 + 1;
    }
    EXPECT_TRUE(std::ranges::all_of(link.sent, &ModbusRequest::reads));
    EXPECT_TRUE(
        std::ranges::all_of(link.sent, [](const ModbusRequest& request) { return request.values.empty(); }));
}

TEST_F(ModbusScanTest, TellsAUnitThatNoProfileFits) {
    sim.addThermometer(5, scannedProfile("modmux-pm6rtd"), 299.15);
    sim.addThermometer(7, scannedProfile("modmux-pm6rtd"), 2000.0);    // beyond its registers: no temperature
    sim.addThermometer(9, scannedProfile("thermasgard-rtm1"), 299.15); // which is not connected
    units = {5, 7};
    link.open();
    run(1, 16);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(fitsOf(5).empty());
    EXPECT_EQ(found[1].unit, 7);
    EXPECT_TRUE(fitsOf(7).empty()) << testing::PrintToString(fitsOf(7));
}

// Promise: sixteen numbers without a unit take less than two replies' time each.
TEST_F(ModbusScanTest, EndsWhereNothingAnswers) {
    link.open();
    const double from_s = clock.now_s();
    run(1, 16);
    EXPECT_TRUE(found.empty());
    EXPECT_EQ(link.sent.size(), 16U);
    EXPECT_LE(clock.now_s() - from_s, 16 * 2 * ScriptedModbusLink::kSilent_s + 0.1);
}

// Catches a profile that is named although the unit says that it is another device, or its unit cannot be
// meant.
TEST_F(ModbusScanTest, AUnitsOwnTypeDecides) {
    sim.addThermometer(3, scannedProfile("labjack-t7-thermocouples"), 299.15);
    for (const int channel : {1, 3, 5, 7, 8, 9, 10, 11, 12, 13})
        sim.removeChannel(3, channel);
    sim.setTemperature(3, 2, 373.25);
    units = {3};
    link.open();
    run(1, 16);
    ASSERT_EQ(fitsOf(3), std::vector<std::string>{"labjack-t7-thermocouples"});
    const ProfileFit& fit = found.front().fits.front();
    EXPECT_TRUE(fit.isTypeTold);
    EXPECT_EQ(fit.signature, "125c 125d");
    ASSERT_EQ(fit.temperatures_K.size(), 14U);
    EXPECT_NEAR(fit.temperatures_K[2], 373.25, 1e-3);
    EXPECT_TRUE(std::isnan(fit.temperatures_K[1]));
    sim.setRegister(3, 3, 60000, 0x4080); // 4.0F
    run(3, 3);
    EXPECT_TRUE(fitsOf(3).empty());
}

// Catches 25.0 degC that is offered as 250 degC first, and a device that answers zero for whatever it has
// not.
TEST_F(ModbusScanTest, TheMostProbableIsFirst) {
    sim.addThermometer(2, scannedProfile("benshaw-remote-rtd"), 297.15);
    sim.addThermometer(5, scannedProfile("benshaw-remote-rtd"), 273.15); // zeros
    sim.addThermometer(6, scannedProfile("thermasgard-rtm1"), 299.15);
    units = {2, 5, 6};
    link.open();
    run(1, 16);
    ASSERT_EQ(found.size(), 3U);
    ASSERT_FALSE(fitsOf(2).empty());
    EXPECT_EQ(fitsOf(2).front(), "benshaw-remote-rtd") << "24 degC, and not 2.4";
    EXPECT_TRUE(fitsOf(5).empty());
    EXPECT_EQ(fitsOf(6), std::vector<std::string>{"thermasgard-rtm1"});
}

// Catches an exception that is told, and not known by its number any more.
TEST(ModbusException, KeepsItsNumber) {
    EXPECT_EQ(exceptionOf(modbusException("line", 7, kNoGatewayPath)), 10);
    EXPECT_EQ(describe(modbusException("line", 7, 2)),
              "unit 7 on \"line\" refuses the request with exception 2. Check the profile set for it.");
    EXPECT_EQ(exceptionOf(Error(MessageCode::DeviceException, "", {"line", "1", "11"})), 11) << "as recorded";
    EXPECT_FALSE(exceptionOf(Error(MessageCode::DeviceSilent, "", {"line", "1", "11"})));
}

// Catches units that are not there, which a gateway says by an exception, and one device that is found 16
// times.
TEST_F(ModbusScanTest, AGatewayAndADeviceThatAnswersToAllNumbers) {
    sim.addThermometer(4, scannedProfile("modmux-pm6rtd"), 299.15);
    units = {4};
    gatewayException = kNoGatewayAnswer;
    link.open();
    run(1, 16);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().unit, 4);
    gatewayException.reset();
    for (const int unit : {1, 2, 3})
        sim.addThermometer(unit, scannedProfile("labjack-t7-thermocouples"), 299.15);
    sim.setRegister(3, 3, 60028, 1); // another one
    units = {1, 2, 3};
    run(1, 3);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].sameAs, 0);
    EXPECT_EQ(found[1].sameAs, 1);
    EXPECT_EQ(found[2].sameAs, 0);
}

// Catches progress that goes back, or an end that is not told.
TEST_F(ModbusScanTest, ProgressOnlyGrows) {
    sim.addController(2, scannedProfile("watlow-ez-zone"));
    units = {2};
    link.open();
    ModbusScan scan(link, 1, 4);
    double last = -1.0;
    while (scan.work()) {
        clock.advance(0.005);
        ASSERT_GE(scan.progress(), last);
        ASSERT_LT(scan.progress(), 1.0);
        last = scan.progress();
    }
    EXPECT_EQ(scan.progress(), 1.0);
    EXPECT_EQ(scan.found().front().fits.front().profile, "watlow-ez-zone");
    EXPECT_GT(last, 0.5);
}

// Catches a scan that never ends, or claims to be done, when the cable is pulled.
TEST_F(ModbusScanTest, AnUnpluggedPortEndsIt) {
    link.open();
    ModbusScan scan(link, 1, 16);
    ASSERT_TRUE(scan.work());
    link.unplug();
    int turns = 0;
    while (scan.work() && ++turns < 1000)
        clock.advance(0.005);
    EXPECT_LT(turns, 1000);
    EXPECT_LT(scan.progress(), 1.0);
}

// Promise: on the bytes of the line, nothing but reading.
TEST(ModbusScanBytes, OnlyReadAndEndInTime) {
    ManualClock clock;
    ModbusSimulator line;
    line.addThermometer(7, scannedProfile("modmux-pm6rtd"), 299.15);
    line.addController(16, scannedProfile("pixsys-drr245"));
    auto bytes = std::make_unique<DeviceLink>(line, clock);
    DeviceLink* wire = bytes.get();
    RtuLink link(std::move(bytes), {9600, 8, 'N', 1}, clock);
    link.open();
    ModbusScan scan(link, 1, 16);
    const double from_s = clock.now_s();
    std::string sent;
    while (scan.work()) {
        clock.advance(0.002);
        wire->work();
        sent += wire->takeSent();
    }
    EXPECT_LT(clock.now_s() - from_s, 16 * 2 * 0.3);
    ASSERT_EQ(scan.found().size(), 2U);
    EXPECT_EQ(scan.found()[0].unit, 7);
    EXPECT_EQ(scan.found()[0].fits.front().profile, "modmux-pm6rtd");
    EXPECT_EQ(scan.found()[1].unit, 16);
    EXPECT_EQ(scan.found()[1].fits.front().profile, "pixsys-drr245");
    EXPECT_EQ(line.writes(), 0);
    ASSERT_EQ(sent.size() % 8, 0U) << "a request to read has eight bytes";
    for (std::size_t at = 0; at < sent.size(); at += 8) {
        const int function = static_cast<unsigned char>(sent[at + 1]);
        EXPECT_TRUE(function == 3 || function == 4) << function;
    }
}

} // namespace bask::test
