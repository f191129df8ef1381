// Edits of an experiment on a real rig.

#include "engine/base/units.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "tests/engine/runtime/rig_on_ports.h"
#include "tests/support/held_calls.h"

#include <sys/ioctl.h>
#include <sys/syscall.h>

namespace bask {
namespace {

using KeptRigTest = test::RigOnPorts;

} // namespace

// Catches a port that is opened anew by an edit: an Arduino behind it resets, says zero and is believed.
TEST_F(KeptRigTest, AnEditLeavesEveryPortAlone) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    ASSERT_NO_FATAL_FAILURE(moveAside());
    experiment.objects[0].name = "plate";
    experiment.source.emittance = 0.5;
    experiment.robot.upper[kX] += 0.01;
    ASSERT_NO_FATAL_FAILURE(load());
    EXPECT_NEAR(engine->last.latest.coordinates[kX], experiment.start[kX] + 0.01, 2e-4) << "told at once";
    ASSERT_TRUE(sees([&] { return engine->last.state == RunState::Ready; })) << reasons();
    EXPECT_EQ(opened(), (std::array{1, 1, 1}));
    EXPECT_NEAR(engine->last.latest.coordinates[kX], experiment.start[kX] + 0.01, 2e-4);
    EXPECT_TRUE(engine->last.isPlaceSure);
    Vector6d back = experiment.start;
    engine->send(MoveTo{back});
    EXPECT_TRUE(sees([&] { return grbl.positions().at(0) < 0.1; })) << "the new loop's robot moves";
}

// Catches a port that is opened anew by a name, or by how often a thermometer is asked.
TEST_F(KeptRigTest, NamesAndThePeriodLeaveEveryPortAlone) {
    const ModbusProfile& profile =
        *std::ranges::find(shippedProfiles(), "waveshare-8ch-4-20ma", &ModbusProfile::name);
    ModbusSimulator module;
    module.addThermometer(5, profile, kelvinFromCelsius(25.0));
    devices[1].become(module);
    ThermometerDeviceSpec& thermometer = *experiment.rig->thermometer;
    thermometer.driver = "modbus";
    thermometer.serial = driverOf(thermometer).serial;
    thermometer.unit = 5;
    thermometer.profile = profile;
    ASSERT_NO_FATAL_FAILURE(beginWell());
    experiment.rig->name = "bench 2";
    experiment.sampling.period_s = 0.4;
    ASSERT_NO_FATAL_FAILURE(load());
    ASSERT_TRUE(sees([&] { return engine->last.state == RunState::Ready; })) << reasons();
    ASSERT_NO_FATAL_FAILURE(waitForSamples(0.8));
    EXPECT_EQ(opened(), (std::array{1, 1, 1}));
    EXPECT_TRUE(engine->last.latest.objects.at(0).valid);
}

// Catches an edit of the thermometer that resets the robot's controller.
TEST_F(KeptRigTest, ADeviceThatIsChangedIsTheOnlyOneThatIsOpenedAnew) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    ASSERT_NO_FATAL_FAILURE(moveAside());
    experiment.rig->thermometer->channels = {1};
    ASSERT_NO_FATAL_FAILURE(load());
    EXPECT_EQ(engine->last.state, RunState::Fault) << "a person looks at a rig that is another one";
    ASSERT_TRUE(sees([&] { return devices[1].times() == 2 && areLive(); }));
    EXPECT_EQ(opened(), (std::array{1, 2, 1}));
    ASSERT_NO_FATAL_FAILURE(waitForSamples(0.5));
    EXPECT_NEAR(engine->last.latest.coordinates[kX], experiment.start[kX] + 0.01, 2e-4);
}

// Catches a plate that may be hot, forgotten with the rig that was left.
TEST_F(KeptRigTest, HeatThatIsNotKnownToBeOffIsToldOverTheSimulatedRig) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    engine->send(SetHeat{kelvinFromCelsius(100.0)});
    ASSERT_TRUE(sees([&] { return engine->last.heat == HeatState::On; })) << reasons();
    servers[2].reset(); // its cable is off
    ASSERT_TRUE(sees([&] { return engine->last.state == RunState::Fault; }));
    experiment.rig.reset();
    ASSERT_NO_FATAL_FAILURE(load());
    ASSERT_TRUE(sees([&] { return engine->last.simulated && engine->last.state == RunState::Ready; }));
    const auto left = std::ranges::find_if(engine->last.alarms, [](const Alarm& alarm) {
        return alarm.message.code == MessageCode::HeatLeftUnknown;
    });
    ASSERT_NE(left, engine->last.alarms.end());
    EXPECT_TRUE(left->isActive && left->isLive);
    EXPECT_EQ(argTexts(left->message), std::vector<std::string>{port(2)});
    engine->send(AcknowledgeAlarm{left->id});
    EXPECT_TRUE(sees([&] {
        return std::ranges::none_of(engine->last.alarms, [](const Alarm& alarm) {
            return alarm.message.code == MessageCode::HeatLeftUnknown;
        });
    }));
}

// Catches an edit that ends a latched STOP.
TEST_F(KeptRigTest, WhatIsLatchedStaysSoOverAnEdit) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    engine->send(EmergencyStop{});
    ASSERT_TRUE(sees([&] { return engine->last.state == RunState::Fault; }));
    experiment.objects[0].name = "plate";
    ASSERT_NO_FATAL_FAILURE(load());
    EXPECT_EQ(engine->last.state, RunState::Fault);
    ASSERT_FALSE(engine->last.reasons.empty());
    EXPECT_EQ(engine->last.reasons.front().code, MessageCode::ReasonEmergencyStop);
    EXPECT_TRUE(std::ranges::any_of(engine->last.alarms, [](const Alarm& alarm) {
        return alarm.isActive && alarm.message.code == MessageCode::ReasonEmergencyStop;
    }));
}

// Catches heat by hand that goes on under an experiment that nobody has heated.
TEST_F(KeptRigTest, HeatByHandEndsWithAnEdit) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    engine->send(SetHeat{kelvinFromCelsius(100.0)});
    ASSERT_TRUE(sees([&] { return plate.isOn(); })) << describe(engine->refusal);
    experiment.objects[0].name = "plate";
    ASSERT_NO_FATAL_FAILURE(load());
    EXPECT_TRUE(sees([&] { return !plate.isOn() && !engine->last.heatOn; }));
    EXPECT_FALSE(engine->last.heatSetPoint_K);
    EXPECT_EQ(opened(), (std::array{1, 1, 1}));
}

// Catches heat that cannot be switched off while a port that was tried hangs at its closing: here by what a
// port is asked last, how much of it is unsent.
TEST_F(KeptRigTest, ATriedPortThatHangsHoldsNothingUp) {
    test::HeldCalls closing;
    std::string problem;
    engine->ask([&] { problem = closing.begin({SYS_ioctl, 1, TIOCOUTQ}); });
    if (!problem.empty())
        GTEST_SKIP() << "no calls can be held here: " << problem;
    StreamSimulator other{{}};
    RigSpec alone;
    alone.thermometer = experiment.rig->thermometer;
    alone.thermometer->port = folder.filePath("tried").toStdString();
    const auto server = PtyServer::create(other, alone.thermometer->port).value();
    ASSERT_NO_FATAL_FAILURE(beginWell());
    engine->send(TryDevice{alone});
    ASSERT_TRUE(sees([&] {
        server->work(clock.now_s());
        return engine->last.tried && engine->last.tried->state.status.link == LinkState::Live;
    }));
    engine->send(SetHeat{kelvinFromCelsius(60.0)});
    ASSERT_TRUE(sees([&] { return plate.isOn(); })) << describe(engine->refusal);
    closing.hold();
    engine->send(TryDevice{});
    ASSERT_TRUE(sees([&] { return closing.held() > 0; }));
    engine->send(SetHeat{});
    EXPECT_TRUE(sees([&] { return !plate.isOn(); }, 1000)) << "before its guard does it";
    EXPECT_TRUE(sees([&] { return !engine->last.tried; }, 1000));
    closing.release();
}

} // namespace bask
