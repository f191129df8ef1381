// The heat while no run is on, and orders to switch it off that are not obeyed.

#include "engine/base/message_code.h"
#include "engine/runtime/fault_script.h"
#include "tests/engine/runtime/loop_on_rig.h"

namespace bask {
namespace {

constexpr double kSetPoint_K = kelvinFromCelsius(100.0);

Experiment quickDisks() {
    Experiment experiment = twoDisks(40.0);
    experiment.sampling = {0.1, 30, 2};
    return experiment;
}

bool isAlarm(const ServoLoop& loop, MessageCode code) {
    return std::ranges::any_of(loop.alarmConditions(),
                               [&](const AlarmCondition& c) { return c.message.code == code; });
}

/// Takes orders and does not obey the one to switch off, as a controller whose refusals come later.
struct DeafSource final : HeatSource {
    explicit DeafSource(HeatSource& from) : inner(from) {}
    Result<Reading> read() override { return inner.read(); }
    Result<void> keepHeating(double setPoint_K, double validFor_s) override {
        return inner.keepHeating(setPoint_K, validFor_s);
    }
    Result<void> heatOff() override {
        if (++orders > 3)
            return Error(MessageCode::DeviceException, {}, {"plate", "1", "2"});
        return {};
    }
    bool heating() const override { return isDeaf || inner.heating(); }
    HeatState heatState() const override { return isDeaf ? HeatState::Unknown : inner.heatState(); }
    HeatSource& inner;
    bool isDeaf = false;
    int orders = 0;
};

} // namespace

// Catches heat by hand that goes on, or comes on again, while the objects are taken away from it.
TEST(HeatByHand, ATripSwitchesItOffForTheWholeRetreat) {
    for (const SimulatedFault fault : {SimulatedFault::ObjectHot, SimulatedFault::SourceOverheats}) {
        for (const bool isArmed : {false, true}) {
            LoopOnRig rig(quickDisks());
            rig.periods(40);
            ASSERT_TRUE(rig.loop.setHeat(kSetPoint_K));
            rig.periods(5);
            ASSERT_TRUE(rig.rig.heatSource().heating());
            if (isArmed) {
                ASSERT_TRUE(rig.loop.arm());
            }
            setFault(rig.rig, fault, 1, true);
            for (int i = 0; i < 2000 && rig.loop.state() != RunState::Stopping; ++i)
                rig.periods(1);
            ASSERT_EQ(rig.loop.state(), RunState::Stopping) << simulatedFaultName(fault);
            while (rig.loop.state() == RunState::Stopping) {
                EXPECT_FALSE(rig.rig.heatSource().heating());
                rig.periods(1);
            }
            EXPECT_EQ(rig.loop.state(), RunState::Fault);
            EXPECT_FALSE(rig.loop.heatSetPoint_K());
        }
    }
}

// Catches a plate that is heated for ever while nobody sees how hot the objects are.
TEST(HeatByHand, EndsWhenASensorIsLostForLong) {
    LoopOnRig rig(quickDisks());
    rig.periods(40);
    ASSERT_TRUE(rig.loop.setHeat(kSetPoint_K));
    setFault(rig.rig, SimulatedFault::SensorOpen, 0, true);
    rig.periods(100);
    EXPECT_TRUE(rig.rig.heatSource().heating()) << "a moment to put the plug back in";
    rig.periods(100);
    EXPECT_FALSE(rig.rig.heatSource().heating());
    EXPECT_EQ(rig.loop.state(), RunState::Fault);
    ASSERT_TRUE(rig.loop.reset());
    rig.periods(2);
    const auto refused = rig.loop.setHeat(kSetPoint_K);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ReasonSensorInvalid);
}

// Catches heat that goes on over a sensor that gives the same value for ever.
TEST(HeatByHand, EndsWhenASensorIsFrozen) {
    Experiment experiment = quickDisks();
    experiment.start[kZ] = 0.03;
    experiment.source.temperature_K = kelvinFromCelsius(300.0);
    LoopOnRig rig(experiment);
    rig.periods(40);
    ASSERT_TRUE(rig.loop.zeroSensors());
    ASSERT_TRUE(rig.loop.setHeat(experiment.source.temperature_K));
    rig.periods(20);
    setFault(rig.rig, SimulatedFault::SensorFrozen, 0, true);
    for (int i = 0; i < 3000 && !isAlarm(rig.loop, MessageCode::SafetySensorFrozen); ++i)
        rig.periods(1);
    ASSERT_TRUE(isAlarm(rig.loop, MessageCode::SafetySensorFrozen));
    const auto refused = rig.loop.setHeat(experiment.source.temperature_K);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::SafetySensorFrozen);
    rig.periods(200);
    EXPECT_FALSE(rig.rig.heatSource().heating());
    EXPECT_EQ(rig.loop.state(), RunState::Fault);
}

// Catches an Off that is swallowed by a state.
TEST(HeatByHand, OffIsOffInEveryState) {
    LoopOnRig rig(quickDisks());
    rig.periods(40);
    ASSERT_TRUE(rig.loop.setHeat(kSetPoint_K));
    ASSERT_TRUE(rig.loop.arm());
    rig.periods(2);
    ASSERT_TRUE(rig.rig.heatSource().heating());
    ASSERT_TRUE(rig.loop.setHeat(std::nullopt));
    EXPECT_FALSE(rig.rig.heatSource().heating());
    rig.periods(2);
    EXPECT_FALSE(rig.rig.heatSource().heating());
    ASSERT_TRUE(rig.loop.start(true));
    rig.periods(20);
    ASSERT_TRUE(rig.loop.setHeat(std::nullopt));
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_FALSE(rig.rig.heatSource().heating());
}

// Catches an order that is refused only after it was given, told to nobody and never given again.
TEST(HeatByHand, AnOrderThatIsRefusedLaterIsRepeatedAndTold) {
    LoopWithSource<DeafSource> rig(quickDisks());
    rig.periods(40);
    ASSERT_TRUE(rig.loop.setHeat(kSetPoint_K));
    rig.periods(2);
    rig.source.isDeaf = true;
    rig.source.orders = 0;
    ASSERT_TRUE(rig.loop.setHeat(std::nullopt));
    rig.periods(10);
    EXPECT_GT(rig.source.orders, 5);
    EXPECT_TRUE(isAlarm(rig.loop, MessageCode::SafetyHeatNotOff));
    rig.source.isDeaf = false;
    rig.source.orders = -100;
    rig.periods(3);
    EXPECT_FALSE(isAlarm(rig.loop, MessageCode::SafetyHeatNotOff)) << "over once it is off";
}

} // namespace bask
