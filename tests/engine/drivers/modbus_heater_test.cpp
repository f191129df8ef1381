#include "engine/drivers/modbus_heater.h"

#include "engine/base/units.h"
#include "engine/drivers/modbus_thermometer.h"
#include "tests/engine/drivers/modbus_fixture.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

using test::shipped;

constexpr double kWarm_K = kZeroCelsius_K + 80.0;

class ModbusHeaterTest : public test::ModbusDriverTest {
protected:
    std::unique_ptr<ModbusHeater> made(const std::string& profile) {
        sim.addController(5, shipped(profile));
        return ModbusHeater::create(link, clock, {5, shipped(profile)}).value();
    }
    std::unique_ptr<ModbusHeater> heaterOf(const ModbusProfile& profile) {
        return ModbusHeater::create(link, clock, {5, profile}).value();
    }
    /// As a loop at 10 Hz that wants heat.
    void heat(ModbusHeater& heater, double s, double setPoint_K = kWarm_K) {
        for (double t = 0.0; t < s; t += 0.1) {
            m_newest = heater.keepHeating(setPoint_K, 0.5);
            run(heater, 0.1);
        }
    }

    bool heats() const { return sim.isOn(5) && sim.setPoint_K(5) > kWarm_K - 1.0; }

    Result<void> m_newest;
};

// Catches heat without a word, a set point off by a scale or unit, and a state told that is not the device's.
TEST_F(ModbusHeaterTest, HeatsTowardsTheSetPointWithEveryProfile) {
    for (const char* profile : {"eurotherm-2400", "watlow-ez-zone", "pixsys-drr245"}) {
        const auto heater = made(profile);
        EXPECT_FALSE(heater->keepHeating(kWarm_K, 0.5).ok()) << "nobody has answered";
        EXPECT_EQ(heater->heatState(), HeatState::Unknown);
        run(*heater, 2.0);
        EXPECT_EQ(heater->heatState(), HeatState::Off) << profile;
        ASSERT_TRUE(heater->read().ok()) << profile;
        EXPECT_NEAR(heater->read()->value_K, 296.15, 0.6) << profile;
        EXPECT_FALSE(heater->heating()) << profile;
        EXPECT_FALSE(heater->isManual());
        EXPECT_EQ(sim.writes(), 0) << "found off, nothing is written";

        heat(*heater, 3.0);
        EXPECT_TRUE(m_newest.ok()) << profile;
        EXPECT_TRUE(heater->heating());
        EXPECT_TRUE(sim.isOn(5)) << profile;
        EXPECT_NEAR(sim.setPoint_K(5), kWarm_K, 0.01) << profile;
        EXPECT_NEAR(heater->setPoint_K().value(), kWarm_K, 0.01) << profile;
        heat(*heater, 300.0);
        EXPECT_NEAR(heater->read()->value_K, kWarm_K, 1.0) << profile;
        EXPECT_LE(sim.writes(), 4) << "written where it differs, not again and again: " << profile;

        EXPECT_EQ(heater->heatState(), HeatState::On) << profile;
        EXPECT_TRUE(heater->heatOff().ok());
        EXPECT_EQ(heater->heatState(), HeatState::On) << "ordered is not confirmed: " << profile;
        run(*heater, 1.0);
        EXPECT_FALSE(heater->heating()) << profile;
        EXPECT_EQ(heater->heatState(), HeatState::Off) << profile;
        const double before_K = sim.plate_K(5);
        run(*heater, 60.0);
        EXPECT_LT(sim.plate_K(5), before_K - 5.0) << profile;
        sim = ModbusSimulator();
    }
}

// Catches a temperature that waited for an engine that was held up and is told as new.
TEST_F(ModbusHeaterTest, AReadingIsAsOldAsItsQuestion) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 2.0);
    const RegisterSpec plate = *shipped("pixsys-drr245").processValue;
    const double before_s = heater->read()->time_s;
    std::size_t seen = link.sent.size();
    for (bool isAsked = false; !isAsked;) {
        run(*heater, 0.005);
        for (; seen < link.sent.size(); ++seen)
            isAsked = isAsked || (link.sent[seen].address <= plate.address &&
                                  plate.address < link.sent[seen].address + link.sent[seen].count);
    }
    const double asked_s = clock.now_s();
    clock.advance(5.0);
    run(*heater, 0.005);
    for (int i = 0; i < 100 && heater->read()->time_s == before_s; ++i)
        run(*heater, 0.005);
    EXPECT_EQ(heater->read()->time_s, asked_s);
}

// Catches a controller in the other unit, which heats to 392 degC for 200 degC: Watlow's tells it.
TEST_F(ModbusHeaterTest, AControllerIsReadAndSetInTheUnitThatItTells) {
    const ModbusProfile& watlow = shipped("watlow-ez-zone");
    for (const RegisterUnit unit : {RegisterUnit::Celsius, RegisterUnit::Fahrenheit}) {
        sim = ModbusSimulator();
        sim.addController(5, inUnit(watlow, unit));
        const auto heater = heaterOf(watlow);
        run(*heater, 2.0);
        ASSERT_TRUE(heater->read());
        EXPECT_NEAR(heater->read()->value_K, 296.15, 0.1);
        heat(*heater, 3.0, kZeroCelsius_K + 200.0);
        EXPECT_TRUE(m_newest.ok());
        EXPECT_NEAR(sim.setPoint_K(5), kZeroCelsius_K + 200.0, 0.01);
        EXPECT_NEAR(heater->setPoint_K().value(), kZeroCelsius_K + 200.0, 0.01);
        EXPECT_TRUE(heater->heatOff().ok());
        run(*heater, 2.0);
        EXPECT_FALSE(heater->heating());
        EXPECT_LT(sim.setPoint_K(5), kZeroCelsius_K + 40.0);
    }
}

TEST_F(ModbusHeaterTest, AControllerInAnUnknownUnitIsNotHeated) {
    const auto heater = made("watlow-ez-zone");
    run(*heater, 2.0);
    heat(*heater, 3.0);
    ASSERT_TRUE(m_newest.ok());
    sim.setRegister(5, 3, 2490, 7);
    heat(*heater, 2.0);
    EXPECT_EQ(m_newest.error().code(), MessageCode::DeviceAnswersWrong);
    EXPECT_EQ(heater->read().error().code(), MessageCode::DeviceAnswersWrong);
    EXPECT_LT(sim.setPoint_K(5), kZeroCelsius_K + 40.0);
}

// Catches another controller of the same kind, at the same unit of another line, that is switched.
TEST_F(ModbusHeaterTest, AnotherControllerIsWrittenNothing) {
    ModbusProfile profile = shipped("pixsys-drr245");
    profile.identity = {3, 0, 2};
    ASSERT_EQ(modbusProfileFromJson(modbusProfileToJson(profile), "")->identity, profile.identity);
    sim.addController(5, profile);
    const auto be = [&](std::uint16_t number) {
        sim.setRegister(5, 3, 0, 0x00f5);
        sim.setRegister(5, 3, 1, number);
    };
    be(7);
    const auto heater = heaterOf(profile);
    heater->expect("00f5 0008");
    sim.setRegister(5, 3, 1016, 1); // somebody uses it
    run(*heater, 2.0);
    EXPECT_EQ(heater->status().link, LinkState::Opening);
    EXPECT_EQ(heater->read().error().message,
              (Message{MessageCode::DeviceExchanged, {"line", "00f5 0008", "00f5 0007"}}));
    heat(*heater, 1.0);
    EXPECT_EQ(m_newest.error().code(), MessageCode::DeviceExchanged);
    EXPECT_EQ(heater->heatOff().error().code(), MessageCode::DeviceExchanged);
    run(*heater, 2.0);
    EXPECT_EQ(sim.writes(), 0);
    EXPECT_TRUE(sim.isOn(5));
    EXPECT_EQ(heater->heatState(), HeatState::Unknown);
    be(8);
    run(*heater, 2.0);
    EXPECT_EQ(heater->status().link, LinkState::Live);
    EXPECT_EQ(heater->status().signature, "00f5 0008");
    EXPECT_FALSE(sim.isOn(5)) << "found on, it is switched off";
}

// Catches a controller of another kind that is switched by the registers of this one.
TEST_F(ModbusHeaterTest, AControllerOfAnotherTypeIsWrittenNothing) {
    ModbusProfile profile = shipped("pixsys-drr245");
    profile.deviceType = RegisterSpec{3, 1, RegisterType::Uint16};
    profile.deviceType->unit = RegisterUnit::None;
    profile.deviceTypes = {245.0};
    sim.addController(5, profile);
    sim.setRegister(5, 3, 1, 144);
    sim.setRegister(5, 3, 1016, 1);
    const auto heater = heaterOf(profile);
    run(*heater, 1.0);
    heat(*heater, 1.0);
    EXPECT_EQ(m_newest.error().code(), MessageCode::DeviceAnswersWrong);
    EXPECT_FALSE(heater->read().ok());
    EXPECT_EQ(sim.writes(), 0);
    sim.setRegister(5, 3, 1, 245);
    run(*heater, 2.0);
    EXPECT_TRUE(heater->read().ok());
    EXPECT_FALSE(sim.isOn(5)) << "found on, it is switched off";
}

// Promise: heat is off unless something keeps saying on.
TEST_F(ModbusHeaterTest, HeatGoesOffByItself) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    heat(*heater, 2.0);
    ASSERT_TRUE(sim.isOn(5));
    run(*heater, 0.4);
    EXPECT_TRUE(sim.isOn(5));
    run(*heater, 0.3);
    EXPECT_FALSE(sim.isOn(5)) << "0.5 s after the last word";
    run(*heater, 0.5);
    EXPECT_FALSE(heater->heating());
}

// Promise of start-up: a heater that is found on is switched off, and what it is set to is read.
TEST_F(ModbusHeaterTest, FoundOnItIsSwitchedOff) {
    const auto heater = made("pixsys-drr245");
    sim.setRegister(5, 3, 1001, 2000);
    sim.setRegister(5, 3, 1016, 1);
    run(*heater, 1.5);
    EXPECT_FALSE(sim.isOn(5));
    EXPECT_NEAR(heater->setPoint_K().value(), kZeroCelsius_K + 200.0, 1e-6);

    const auto other = made("eurotherm-2400");
    sim.setRegister(5, 3, 24, 150);
    run(*other, 1.5);
    EXPECT_NEAR(sim.setPoint_K(5), kZeroCelsius_K, 1e-9);
    EXPECT_FALSE(other->heating());
}

// Catches heat switched on before the set point and the watchdog are what they are to be.
TEST_F(ModbusHeaterTest, WatchdogAndSetPointAreSetBeforeHeatIsOn) {
    const auto heater = made("pixsys-drr245");
    sim.setRegister(5, 3, 1001, 3000); // of the last user
    run(*heater, 1.0);
    heat(*heater, 2.0);
    std::vector<int> written;
    for (const ModbusRequest& r : link.sent) {
        if (r.function == 6)
            written.push_back(r.address);
    }
    EXPECT_EQ(written, (std::vector<int>{1022, 1001, 1016}));
    EXPECT_EQ(sim.registerAt(5, 3, 1022), 30000);
}

// Promise: an engine that dies leaves the device's watchdog to switch off; a healthy one keeps it quiet.
TEST_F(ModbusHeaterTest, TheDevicesWatchdogIsFedByPollsOnly) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    heat(*heater, 60.0);
    EXPECT_TRUE(sim.isOn(5));
    clock.advance(31.0); // kill -9
    sim.transmit(clock.now_s());
    EXPECT_FALSE(sim.isOn(5));
}

// Catches a wish that survives a lost link: heat coming back on by itself, or off never being sent.
TEST_F(ModbusHeaterTest, AfterALostLinkItIsSwitchedOff) {
    const auto heater = made("eurotherm-2400");
    run(*heater, 1.0);
    heat(*heater, 3.0);
    link.unplug();
    heat(*heater, 2.0);
    EXPECT_FALSE(m_newest.ok());
    EXPECT_TRUE(heater->heating()) << "not yet seen to be off";
    EXPECT_EQ(heater->heatState(), HeatState::Unknown);
    EXPECT_FALSE(heater->setPoint_K().has_value());
    EXPECT_FALSE(heater->heatOff().ok());
    EXPECT_NEAR(sim.setPoint_K(5), kWarm_K, 0.01);
    link.isPlugged = true;
    const std::size_t sent = link.sent.size();
    run(*heater, 1.0);
    ASSERT_GT(link.sent.size(), sent);
    EXPECT_EQ(link.sent[sent].function, 6) << "off comes first";
    EXPECT_NEAR(sim.setPoint_K(5), kZeroCelsius_K, 1e-9);
    EXPECT_FALSE(heater->heating());
}

// Catches off taken for granted: the first writes are lost, or the device goes on.
TEST_F(ModbusHeaterTest, OffIsVerifiedAndRepeated) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    heat(*heater, 3.0);
    int lost = 0;
    before = [&](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.function == 6 && ++lost <= 5)
            return ModbusReply(std::vector<std::uint16_t>{}); // said to be done, and is not
        return std::nullopt;
    };
    EXPECT_TRUE(heater->heatOff().ok());
    run(*heater, 0.6);
    EXPECT_TRUE(heater->heating());
    run(*heater, 32.0);
    EXPECT_FALSE(sim.isOn(5));
    EXPECT_FALSE(heater->heating());
    EXPECT_EQ(lost, 6);
    EXPECT_TRUE(heater->heatOff().ok());
}

// Catches an order to switch off that is refused and told as taken, hammered, or begun anew with each call.
TEST_F(ModbusHeaterTest, AnOffThatIsRefusedIsToldAndNotHammered) {
    for (const char* profile : {"pixsys-drr245", "eurotherm-2400"}) {
        const auto heater = made(profile);
        run(*heater, 1.0);
        heat(*heater, 3.0);
        ASSERT_TRUE(sim.isOn(5));
        before = [](const ModbusRequest& r) -> std::optional<ModbusReply> {
            if (r.function == 6)
                return Error(MessageCode::DeviceException, "line", {"line", "5", "4"});
            return std::nullopt;
        };
        const int begun = sentBy(6);
        EXPECT_TRUE(heater->heatOff().ok());
        for (int i = 0; i < 1200; ++i) { // two minutes of an engine that asks while it heats
            run(*heater, 0.1);
            const auto off = heater->heatOff();
            EXPECT_TRUE(heater->heating());
            if (i >= 20) {
                ASSERT_FALSE(off.ok()) << profile << i;
                ASSERT_EQ(off.error().code(), MessageCode::DeviceException);
            }
        }
        EXPECT_LE(sentBy(6) - begun, 3 + 12) << profile;
        EXPECT_GE(sentBy(6) - begun, 3 + 10) << profile;
        before = nullptr;
        run(*heater, 11.0);
        EXPECT_FALSE(heater->heating()) << profile;
        EXPECT_TRUE(heater->heatOff().ok());
        sim = ModbusSimulator();
    }
}

// Promise: who stops the heat at the device keeps it stopped. Catches it switched on again over a person's or
// a protection's head.
TEST_F(ModbusHeaterTest, AStopAtItsOwnPanelIsNotUndone) {
    for (int i = 0; i < 20; ++i) {
        const auto heater = made("pixsys-drr245");
        run(*heater, 1.0);
        heat(*heater, 3.0);
        ASSERT_TRUE(m_newest.ok());
        run(*heater, 0.02 * i);
        sim.setRegister(5, 3, 1016, 0);
        for (double t = 0.0; t < 3.0; t += 0.1) { // a moving set point is no reason either
            m_newest = heater->keepHeating(kWarm_K + 2.0 * t, 0.5);
            run(*heater, 0.1);
            ASSERT_FALSE(sim.isOn(5)) << i;
        }
        ASSERT_FALSE(m_newest.ok());
        EXPECT_EQ(m_newest.error().code(), MessageCode::SafetySourceStopped);
        EXPECT_TRUE(heater->heatOff().ok());
        heat(*heater, 2.0);
        EXPECT_TRUE(m_newest.ok()) << "asked for anew";
        EXPECT_TRUE(sim.isOn(5));
        sim = ModbusSimulator();
    }
}

// Catches a set point that was lowered at the device and is raised again.
TEST_F(ModbusHeaterTest, ASetPointLoweredAtItsOwnPanelIsNotRaised) {
    const auto heater = made("eurotherm-2400");
    run(*heater, 1.0);
    heat(*heater, 3.0);
    sim.setRegister(5, 3, 24, 40);
    heat(*heater, 3.0);
    ASSERT_FALSE(m_newest.ok());
    EXPECT_EQ(m_newest.error().message, (Message{MessageCode::SafetySetPointOther, {"80", "40"}}));
    EXPECT_NEAR(sim.setPoint_K(5), kZeroCelsius_K, 1e-9);
    EXPECT_FALSE(heater->heating());
}

// Catches a memory that is worn out by a set point that moves, and one that lags behind or never arrives.
TEST_F(ModbusHeaterTest, ARampIsWrittenInSteps) {
    for (const char* profile : {"pixsys-drr245", "eurotherm-2400"}) {
        const auto heater = made(profile);
        run(*heater, 1.0);
        heat(*heater, 3.0);
        const int begun = sentBy(6);
        double worst_K = 0.0, last_K = 0.0;
        for (int i = 1; i <= 5000; ++i) { // 100 K in 500 s
            last_K = kWarm_K + 0.02 * i + 0.0013;
            m_newest = heater->keepHeating(last_K, 0.5);
            ASSERT_TRUE(m_newest.ok()) << profile << i << describe(m_newest.error());
            run(*heater, 0.1);
            worst_K = std::max(worst_K, std::abs(sim.setPoint_K(5) - last_K));
        }
        EXPECT_LE(sentBy(6) - begun, 101) << profile;
        EXPECT_LT(worst_K, 1.7) << profile;
        heat(*heater, 6.0, last_K);
        EXPECT_NEAR(sim.setPoint_K(5), last_K, 0.51) << profile;
        heat(*heater, 1.0, last_K - 20.0);
        EXPECT_NEAR(sim.setPoint_K(5), last_K - 20.0, 0.51) << "at once: " << profile;
        sim = ModbusSimulator();
    }
}

// Catches off believed by one register while the controller heats towards another, and off written again and
// again because of that.
TEST_F(ModbusHeaterTest, AControllerDrivenByItsOwnSetPointIsNotOff) {
    const auto heater = made("eurotherm-2400");
    std::uint16_t working = 200; // its second set point, or the top of its ramp
    before = [&](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.function != 3 || r.address > 5 || r.address + r.count <= 5)
            return std::nullopt;
        std::vector<std::uint16_t> values;
        for (int i = 0; i < r.count; ++i)
            values.push_back(r.address + i == 5 ? working : sim.registerAt(5, 3, r.address + i));
        return ModbusReply(values);
    };
    run(*heater, 1.0);
    EXPECT_TRUE(heater->heating());
    heat(*heater, 3.0);
    EXPECT_TRUE(m_newest.ok());
    EXPECT_EQ(sim.registerAt(5, 3, 24), 80);
    EXPECT_NEAR(heater->setPoint_K().value(), kZeroCelsius_K + 200.0, 1e-9) << "as it heats";
    (void)heater->heatOff();
    const int begun = sentBy(6);
    run(*heater, 4.0);
    EXPECT_EQ(sentBy(6) - begun, 1);
    EXPECT_TRUE(heater->heating());
    EXPECT_EQ(heater->heatOff().error().message, (Message{MessageCode::SafetySetPointOther, {"0", "200"}}));
    working = 30;
    run(*heater, 1.0);
    EXPECT_FALSE(heater->heating());
    EXPECT_TRUE(heater->heatOff().ok());
}

// Catches a dead thermometer on the same line that takes the heater's time.
TEST_F(ModbusHeaterTest, ADeadNeighbourDoesNotHoldItUp) {
    const auto thermometer =
        ModbusThermometer::create(link, clock, {7, shipped("thermasgard-rtm1"), {0}}).value();
    const auto heater = made("pixsys-drr245");
    const auto both = [&](double s) {
        int live = 0, turns = 0;
        for (double t = 0.0; t < s; t += 0.005) {
            clock.advance(0.005);
            sim.transmit(clock.now_s());
            thermometer->work(); // is asked first, as in a rig
            heater->work();
            live += heater->status().link == LinkState::Live ? 1 : 0;
            ++turns;
        }
        return static_cast<double>(live) / turns;
    };
    both(2.0);
    const auto heatFor = [&](double s) {
        double share = 0.0;
        for (double t = 0.0; t < s; t += 0.1) {
            (void)heater->keepHeating(kWarm_K, 0.5);
            share += both(0.1) * 0.1 / s;
        }
        return share;
    };
    const auto begun = static_cast<std::ptrdiff_t>(link.sent.size());
    EXPECT_GT(heatFor(60.0), 0.99);
    EXPECT_GT(std::count_if(link.sent.begin() + begun, link.sent.end(),
                            [](const ModbusRequest& r) { return r.unit == 5; }),
              120)
        << "questions of the heater in a minute";
    double worst_s = 0.0;
    for (int i = 0; i < 20; ++i) {
        heatFor(4.0 + 0.073 * i);
        ASSERT_TRUE(sim.isOn(5));
        (void)heater->heatOff();
        const double off_s = clock.now_s();
        while (sim.isOn(5) && clock.now_s() < off_s + 60.0)
            both(0.005);
        worst_s = std::max(worst_s, clock.now_s() - off_s);
    }
    EXPECT_LT(worst_s, 0.8);
    RecordProperty("off_after_ms", static_cast<int>(1000.0 * worst_s));
    sim.addThermometer(7, shipped("thermasgard-rtm1"), 293.15);
    both(2.0);
    EXPECT_EQ(thermometer->status().link, LinkState::Live) << "back within two seconds";
}

// Catches off that waits for a reading: here none comes any more, and the first off is lost too.
TEST_F(ModbusHeaterTest, OffDoesNotWaitForWhatCannotBeRead) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    heat(*heater, 3.0);
    int offs = 0;
    before = [&](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.function == 6 && ++offs > 1)
            return std::nullopt;
        return Error(MessageCode::DeviceException, "", {"line", "5", "4"});
    };
    EXPECT_TRUE(sim.isOn(5));
    const std::size_t sent = link.sent.size();
    (void)heater->heatOff();
    run(*heater, 1.0);
    EXPECT_FALSE(sim.isOn(5));
    EXPECT_TRUE(heater->heating()) << "not seen to be off";
    EXPECT_LT(link.sent.size() - sent, 12u) << "and not hammered";
    before = nullptr;
    run(*heater, 1.0);
    EXPECT_FALSE(heater->heating());
}

// Catches a set point that the device limits: written for ever, or taken for what was asked.
TEST_F(ModbusHeaterTest, ASetPointThatIsNotTakenIsToldAndNotWornOut) {
    const auto heater = made("eurotherm-2400");
    run(*heater, 1.0);
    before = [&](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.function != 6 || r.values.at(0) <= 60)
            return std::nullopt;
        sim.setRegister(5, 3, 24, 60);
        return ModbusReply(std::vector<std::uint16_t>{});
    };
    heat(*heater, 5.0);
    ASSERT_FALSE(m_newest.ok());
    EXPECT_EQ(m_newest.error().code(), MessageCode::SafetySetPointOther);
    EXPECT_EQ(argTexts(m_newest.error().message), (std::vector<std::string>{"80", "60"}));
    EXPECT_NEAR(heater->setPoint_K().value(), kZeroCelsius_K + 60.0, 1e-9);
    EXPECT_EQ(sentBy(6), 3);
    heat(*heater, 2.0, kZeroCelsius_K + 50.0);
    EXPECT_TRUE(m_newest.ok()) << "another wish is tried";
    EXPECT_NEAR(sim.setPoint_K(5), kZeroCelsius_K + 50.0, 1e-9);
}

// Catches a refusal in words of the device being lost.
TEST_F(ModbusHeaterTest, ARefusedWriteIsTold) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    before = [](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.address == 1022 && r.function == 6)
            return Error(MessageCode::DeviceException, "line", {"line", "5", "3"});
        return std::nullopt;
    };
    heat(*heater, 5.0);
    ASSERT_FALSE(m_newest.ok());
    EXPECT_EQ(m_newest.error().code(), MessageCode::DeviceException);
    EXPECT_FALSE(sim.isOn(5)) << "without its watchdog it does not heat";
}

// Catches a plate's broken sensor read as its temperature, wherever the device tells it.
TEST_F(ModbusHeaterTest, ABrokenSensorIsInvalid) {
    for (const auto& [profile, fault] : {std::pair("eurotherm-2400", SensorFault::Open),
                                         std::pair("watlow-ez-zone", SensorFault::OutOfRange),
                                         std::pair("pixsys-drr245", SensorFault::Other)}) {
        const auto heater = made(profile);
        run(*heater, 1.0);
        EXPECT_TRUE(heater->read()->valid) << profile;
        ASSERT_TRUE(sim.setFault("open").ok());
        run(*heater, 1.0);
        EXPECT_FALSE(heater->read()->valid) << profile;
        EXPECT_EQ(heater->read()->fault, fault) << profile;
        ASSERT_TRUE(sim.setFault("none").ok());
        sim = ModbusSimulator();
    }
}

// Catches a lost "on" repeated after heat is wanted no more.
TEST_F(ModbusHeaterTest, AnOnThatWasLostIsNotRepeatedAfterOff) {
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    before = [&](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.function == 6 && r.address == 1016) {
            EXPECT_TRUE(sim.setFault("silent").ok());
        }
        return std::nullopt;
    };
    heat(*heater, 1.5);
    before = nullptr;
    ASSERT_TRUE(sim.setFault("none").ok());
    run(*heater, 5.0);
    EXPECT_FALSE(sim.isOn(5));
    EXPECT_EQ(link.sent.back().function, 3);
    for (std::size_t i = link.sent.size() - 10; i < link.sent.size(); ++i)
        EXPECT_EQ(link.sent[i].function, 3) << "nothing more to write";
}

// Catches an "off" that nobody has answered and that is taken for done, since on was never read back.
TEST_F(ModbusHeaterTest, AnOffWithoutAnAnswerIsSaidAgainAndIsNotOff) {
    for (const char* profile : {"pixsys-drr245", "eurotherm-2400"}) {
        SCOPED_TRACE(profile);
        const auto heater = made(profile);
        run(*heater, 1.0);
        for (double t = 0.0; t < 2.0 && !heats(); t += 0.005) {
            (void)heater->keepHeating(kWarm_K, 0.5);
            run(*heater, 0.005);
        }
        ASSERT_TRUE(heats());
        ASSERT_TRUE(sim.setFault("silent").ok()); // before it is read back
        (void)heater->heatOff();
        for (double t = 0.0; t < 10.0; t += 0.1) {
            run(*heater, 0.1);
            ASSERT_TRUE(heater->heating()) << t;
            ASSERT_NE(heater->heatState(), HeatState::Off) << t;
        }
        ASSERT_TRUE(sim.setFault("none").ok());
        run(*heater, 3.0);
        EXPECT_FALSE(heats());
        EXPECT_FALSE(heater->heating());
        sim = ModbusSimulator();
    }
}

// Catches wishes and settings that no register can hold.
TEST_F(ModbusHeaterTest, RefusesWhatItCannotDo) {
    const ModbusProfile& pixsys = shipped("pixsys-drr245");
    const auto refusal = [&](const ModbusHeaterSettings& s) {
        return ModbusHeater::create(link, clock, s).error();
    };
    EXPECT_EQ(refusal({1, shipped("modmux-pm6rtd")}).code(), MessageCode::JsonMissingKey);
    EXPECT_EQ(refusal({0, pixsys}).where, "unit");
    EXPECT_EQ(refusal({1, pixsys, 0.25, 1.0, 70.0}).where, "watchdog"); // 16 bits of milliseconds
    EXPECT_EQ(refusal({1, pixsys, 0.25, 1.0, 0.3}).where, "watchdog");  // shorter than the polls
    EXPECT_TRUE(heaterOf(pixsys)->hasWatchdog());
    EXPECT_FALSE(heaterOf(shipped("watlow-ez-zone"))->hasWatchdog());
    const auto heater = made("pixsys-drr245");
    run(*heater, 1.0);
    EXPECT_EQ(heater->keepHeating(5000.0, 0.5).error().code(), MessageCode::ValueOutOfRange);
    EXPECT_EQ(heater->keepHeating(kWarm_K, 0.0).error().code(), MessageCode::ValueNotPositive);
    run(*heater, 1.0);
    EXPECT_EQ(sim.writes(), 0);
}

} // namespace
} // namespace bask
