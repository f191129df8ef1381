// What answers at a port, without a word that is written.

#include "engine/drivers/modbus_scan.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/protocols/modbus_frame.h"
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
            return std::nullopt;
        std::vector<std::uint16_t> out;
        for (int i = 0; i < request.count; ++i) {
            try {
                out.push_back(sim.registerAt(request.unit, request.function, request.address + i));
            } catch (const std::out_of_range&) {
                return ModbusReply(Error(MessageCode::DeviceException, "", {"line", "1", "2"}));
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

// Catches a port that is searched for minutes where nothing is there.
TEST_F(ModbusScanTest, EndsWhereNothingAnswers) {
    link.open();
    const double from_s = clock.now_s();
    run(1, 16);
    EXPECT_TRUE(found.empty());
    EXPECT_EQ(link.sent.size(), 32U);
    EXPECT_LT(clock.now_s() - from_s, 32 * 2.5 * ScriptedModbusLink::kSilent_s);
}

} // namespace bask::test
