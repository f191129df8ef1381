// The alarm table and its delays, with observations made by hand.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/model/hand_warm.h"
#include "engine/runtime/alarm_causes.h"
#include "engine/runtime/latched_faults.h"
#include "engine/runtime/safety_monitor.h"
#include "tests/engine/runtime/loop_on_rig.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace bask {
namespace {

struct Monitor {
    explicit Monitor(Experiment from = twoDisks(40.0)) : experiment(std::move(from)), monitor(experiment) {
        seen.source_K = experiment.source.temperature_K;
        for (int i = 0; i < 2; ++i) {
            ObservedObject object;
            object.isKnown = true;
            object.measured_K = experiment.environment_K;
            seen.objects.push_back(object);
        }
    }
    SafetyChanges after(double seconds) {
        seen.now_s += seconds;
        seen.sinceTick_s = experiment.sampling.period_s;
        return monitor.watch(seen);
    }
    bool isActive(SafetyCondition condition) const {
        return std::ranges::any_of(monitor.active(),
                                   [&](const SafetyFinding& f) { return f.condition == condition; });
    }
    Experiment experiment;
    SafetyMonitor monitor;
    SafetyObservation seen;
};

/// When the sensors of two equally warm objects are told to seem swapped, s; infinite: never. The left one is
/// heated more from 240 s on, when they are swapped, and the right one no more; the heat is off for a moment.
double seemSwapped_s(ReadBy readBy, double unheated_s) {
    Experiment experiment = twoDisks(40.0);
    for (ObjectSpec& object : experiment.objects)
        object.readBy = readBy;
    Monitor m(experiment);
    m.seen.isSourceDark = false;
    for (ObservedObject& object : m.seen.objects)
        object.viewFactor = 1.0;
    const double whole_K_s = m.monitor.powers_K_s(m.seen).front();
    std::array<double, 2> T_K{experiment.environment_K, experiment.environment_K};
    for (double t = 1.0; t < 400.0; t += 1.0) {
        const bool isSwapped = t > 240.0;
        const double before_K_s = t < 90.0 ? 0.12 : 0.03;
        const std::array<double, 2> heat_K_s{isSwapped ? 0.3 : before_K_s, isSwapped ? 0.0 : before_K_s};
        for (std::size_t i = 0; i < 2; ++i) {
            T_K[i] += heat_K_s[i] - (T_K[i] - experiment.environment_K) / 300.0;
            m.seen.objects[i].viewFactor = heat_K_s[i] / whole_K_s;
        }
        for (std::size_t i = 0; i < 2; ++i)
            m.seen.objects[i].measured_K = T_K[isSwapped ? 1 - i : i];
        m.seen.asked_K = t == unheated_s ? std::nullopt : std::optional(experiment.source.temperature_K);
        m.after(1.0);
        if (m.monitor.swappedWith(0))
            return t;
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

// Catches a sentence whose priority in the lists is not that of its row.
TEST(SafetyMonitor, ItsPrioritiesAreThoseOfTheSentences) {
    for (const auto& [condition, code] :
         {std::pair(SafetyCondition::RobotLost, MessageCode::ReasonRobotLost),
          std::pair(SafetyCondition::RobotAlarm, MessageCode::RobotAlarm),
          std::pair(SafetyCondition::RobotPlaceUnsure, MessageCode::RobotPlaceUnsure),
          std::pair(SafetyCondition::RobotSlow, MessageCode::RobotSlow),
          std::pair(SafetyCondition::ObjectHot, MessageCode::SafetyObjectHot),
          std::pair(SafetyCondition::SourceHot, MessageCode::SafetySourceHot),
          std::pair(SafetyCondition::SourceLost, MessageCode::ReasonSourceLost),
          std::pair(SafetyCondition::SourceSilent, MessageCode::SafetySourceSilent),
          std::pair(SafetyCondition::SourceNotHeating, MessageCode::SafetySourceNotHeating),
          std::pair(SafetyCondition::SourceHeatsUnasked, MessageCode::SafetySourceHeatsUnasked),
          std::pair(SafetyCondition::SourceNotCooling, MessageCode::SafetySourceNotCooling),
          std::pair(SafetyCondition::SourceCold, MessageCode::SafetySourceCold),
          std::pair(SafetyCondition::SourceUnit, MessageCode::SafetySourceUnit),
          std::pair(SafetyCondition::NoWatchdog, MessageCode::SafetyNoWatchdog),
          std::pair(SafetyCondition::RobotSluggish, MessageCode::SafetyRobotSluggish),
          std::pair(SafetyCondition::SetPointOther, MessageCode::SafetySetPointOther),
          std::pair(SafetyCondition::NotWarming, MessageCode::SafetyNotWarming),
          std::pair(SafetyCondition::SensorOpen, MessageCode::SafetySensorOpen),
          std::pair(SafetyCondition::SensorShort, MessageCode::SafetySensorShort),
          std::pair(SafetyCondition::SensorInvalid, MessageCode::ReasonSensorInvalid),
          std::pair(SafetyCondition::SensorStale, MessageCode::ReasonSensorStale),
          std::pair(SafetyCondition::SensorJump, MessageCode::SafetySensorJump),
          std::pair(SafetyCondition::SensorFrozen, MessageCode::SafetySensorFrozen),
          std::pair(SafetyCondition::SourcePoseLost, MessageCode::ReasonSourcePoseLost),
          std::pair(SafetyCondition::ObjectWarm, MessageCode::SafetyObjectWarm),
          std::pair(SafetyCondition::HeatedOtherwise, MessageCode::SafetyHeatedOtherwise),
          std::pair(SafetyCondition::HeatedAtRest, MessageCode::SafetyHeatedAtRest),
          std::pair(SafetyCondition::SourceOver, MessageCode::SafetySourceOver),
          std::pair(SafetyCondition::ThermometerLost, MessageCode::DeviceSilent),
          std::pair(SafetyCondition::HeatNotOff, MessageCode::SafetyHeatNotOff),
          std::pair(SafetyCondition::HeatByHand, MessageCode::SafetyHeatByHand),
          std::pair(SafetyCondition::SensorsApart, MessageCode::SafetySensorsApart),
          std::pair(SafetyCondition::DiskLow, MessageCode::SafetyDiskLow),
          std::pair(SafetyCondition::TargetLeft, MessageCode::SafetyTargetLeft),
          std::pair(SafetyCondition::SensorQuiet, MessageCode::SafetySensorQuiet),
          std::pair(SafetyCondition::LoopLate, MessageCode::SafetyLoopLate)})
        EXPECT_EQ(alarmEntry(condition).priority, alarmPriority(code)) << messageName(code);
}

// Catches a camera that says of a sensor which jumps to and fro, each time, that it differs from it.
TEST(SafetyMonitor, ACameraTellsNothingOfASensorThatIsNotTrusted) {
    for (const bool isLost : {false, true}) {
        Monitor m;
        ObservedObject& object = m.seen.objects[0];
        const double room_K = m.experiment.environment_K;
        object.isLost = isLost;
        bool isTold = false;
        for (int i = 0; i < 20; ++i) {
            object.opinion = CameraOpinion{room_K + 40.0, m.seen.now_s, room_K + 10.0, 0.3, room_K, 2.0};
            m.after(1.0);
            isTold = isTold || m.isActive(SafetyCondition::CameraDisagrees);
        }
        EXPECT_EQ(isTold, !isLost);
    }
}

// Catches a controller in degC that is read as degF: a room of 25 degC is -3.9 degC then, and 200 degC 392.
TEST(SafetyMonitor, ASourceColderThanTheRoomIsNotHeated) {
    Monitor m;
    m.seen.isSourceSwitched = true;
    m.seen.source_K = m.experiment.environment_K - 4.0; // the room is not known better
    m.after(1.0);
    m.after(1.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceCold));
    m.seen.source_K = kelvinFromCelsius((celsiusFromKelvin(m.experiment.environment_K) - 32.0) / 1.8);
    m.after(1.0);
    m.after(1.0);
    EXPECT_TRUE(m.isActive(SafetyCondition::SourceCold));
    ASSERT_NE(m.monitor.forbidsReset(), nullptr);
    EXPECT_EQ(m.monitor.forbidsReset()->message.code, MessageCode::SafetySourceCold);
    m.seen.isManual = true; // typed by a person
    m.after(1.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceCold));
}

// Catches a controller in degF that is read as degC; and a hot source that cools through that number.
TEST(SafetyMonitor, ASourceInTheOtherUnitIsNotHeated) {
    Monitor m;
    m.seen.isSourceSwitched = true;
    const double room_degF = celsiusFromKelvin(m.experiment.environment_K) * 1.8 + 32.0;
    m.seen.source_K = kelvinFromCelsius(room_degF + 30.0);
    for (int i = 0; i < 600; ++i) { // it cools as a heavy plate does
        *m.seen.source_K -= (*m.seen.source_K - m.experiment.environment_K) / 1200.0;
        m.after(1.0);
        ASSERT_FALSE(m.isActive(SafetyCondition::SourceUnit)) << i;
    }
    Monitor cold;
    cold.seen.isSourceSwitched = true;
    cold.seen.source_K = kelvinFromCelsius(room_degF + 2.0);
    for (int i = 0; i < 125; ++i)
        cold.after(1.0);
    EXPECT_TRUE(cold.isActive(SafetyCondition::SourceUnit));
    cold.monitor.restart(); // a reset, while it still is so
    cold.after(1.0);
    cold.after(1.0);
    EXPECT_TRUE(cold.isActive(SafetyCondition::SourceUnit));

    Monitor heated;
    heated.seen.isSourceSwitched = true;
    heated.seen.asked_K = kelvinFromCelsius(200.0);
    heated.seen.readBack_K = kelvinFromCelsius(200.0);
    heated.after(1.0);
    heated.seen.readBack_K = kelvinFromCelsius(392.0);
    heated.after(1.0);
    const SafetyChanges changes = heated.after(1.0);
    ASSERT_EQ(changes.raised.size(), 1U);
    EXPECT_EQ(changes.raised[0].message, (Message{MessageCode::SafetySourceUnit, {"392", "200"}}));
}

// Catches a controller whose numbers are half degrees, and is heated twice as far as it says.
TEST(SafetyMonitor, ASourceThatReadsBackAMultipleIsNotHeated) {
    Monitor m;
    m.seen.isSourceSwitched = true;
    m.seen.asked_K = kelvinFromCelsius(200.0);
    m.seen.readBack_K = kelvinFromCelsius(100.0); // still the one before
    m.after(1.0);
    m.after(1.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceUnit));
    m.seen.readBack_K = kelvinFromCelsius(180.0); // its own limit
    for (int i = 0; i < 5; ++i)
        m.after(1.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceUnit));
    for (const double back_degC : {20.0, 100.0, 400.0}) {
        m.seen.readBack_K = kelvinFromCelsius(200.0);
        m.after(1.0);
        m.after(1.0);
        EXPECT_FALSE(m.isActive(SafetyCondition::SourceUnit));
        m.seen.readBack_K = kelvinFromCelsius(back_degC);
        m.after(1.0);
        const SafetyChanges changes = m.after(1.0);
        ASSERT_EQ(changes.raised.size(), 1U) << back_degC;
        EXPECT_EQ(changes.raised[0].message.code, MessageCode::SafetySourceScale);
        EXPECT_EQ(argTexts(changes.raised[0].message).at(2), formatNumber(back_degC / 200.0));
    }
}

// Catches a robot whose retreat takes far longer than the experiment says, and nobody knows before the run.
TEST(SafetyMonitor, ARobotThatCannotFollowIsToldWithTheTimeOfARetreat) {
    Monitor m;
    m.seen.robotLag = RobotLag{"$120=10", 0.15, 1.1, 0.00274};
    m.seen.longestRetreat_m = 0.1;
    m.after(1.0);
    const SafetyChanges changes = m.after(1.0);
    ASSERT_EQ(changes.raised.size(), 1U);
    EXPECT_EQ(changes.raised[0].message,
              (Message{MessageCode::SafetyRobotSluggish, {"$120=10", "1.1", "0.15", "37"}}));
    EXPECT_EQ(m.monitor.forbidsResume(), nullptr) << "told only";
    m.seen.robotLag.reset();
    m.after(1.0);
    m.after(1.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::RobotSluggish));
}

// Catches one line of two devices that is two alarms of priority 1.
TEST(SafetyMonitor, ALineThatIsLostIsOneCause) {
    const SafetyFinding thermometer{SafetyCondition::ThermometerLost, 0, {MessageCode::LinkLost, {"line"}}};
    const std::vector<SafetyFinding> present{
        {SafetyCondition::SourceLost, 0, {MessageCode::LinkLost, {"line"}}}, thermometer};
    Experiment experiment = twoDisks(40.0);
    experiment.rig.emplace();
    experiment.rig->thermometer.emplace().port = "line";
    experiment.rig->source.emplace().port = "another";
    EXPECT_EQ(causeOf(thermometer, present, experiment), nullptr);
    experiment.rig->source->port = "line";
    const SafetyFinding* const cause = causeOf(thermometer, present, experiment);
    ASSERT_NE(cause, nullptr);
    EXPECT_EQ(cause->condition, SafetyCondition::SourceLost);
}

// Catches a limit that chatters about its value, and one that a single wrong reading of the source trips.
TEST(SafetyMonitor, LimitsHaveDelaysAndHysteresis) {
    Monitor m;
    const double warning_K = m.experiment.safety.warning_K;
    m.seen.objects[0].measured_K = warning_K + 0.1;
    const SafetyChanges changes = m.after(1.0);
    ASSERT_EQ(changes.raised.size(), 1U);
    EXPECT_EQ(
        describe(changes.raised[0].message),
        "\"left\" is at 120.1 °C, above its warning limit of 120 °C. Let it cool: Stop or Retreat takes it "
        "away. Check its target and its limits.");
    m.seen.objects[0].measured_K = warning_K - 1.5;
    EXPECT_TRUE(m.after(1.0).ended.empty());
    m.seen.objects[0].measured_K = warning_K - 2.5;
    EXPECT_TRUE(m.after(0.5).ended.empty()); // off-delay
    EXPECT_EQ(m.after(1.0).ended.size(), 1U);

    m.seen.source_K = sourceTripLimit_K(m.experiment) + 100.0;
    EXPECT_TRUE(m.after(0.1).raised.empty());
    m.seen.source_K = m.experiment.source.temperature_K;
    EXPECT_TRUE(m.after(0.1).raised.empty());
    m.seen.source_K = sourceTripLimit_K(m.experiment) + 1.0;
    m.after(0.1);
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceHot));
    m.after(0.5);
    EXPECT_TRUE(m.isActive(SafetyCondition::SourceHot));
}

// Catches a less grave reaction that is done first, since it was found first.
TEST(SafetyMonitor, TheGravestComesFirst) {
    Monitor m;
    m.seen.objects[0].isLost = m.seen.objects[0].isInvalid = true;
    m.seen.objects[0].measured_K.reset();
    m.seen.objects[1].measured_K = m.experiment.safety.trip_K + 1.0;
    m.seen.isPlaceSure = false;
    const SafetyChanges changes = m.after(1.0);
    ASSERT_GE(changes.raised.size(), 3U);
    EXPECT_EQ(changes.raised[0].condition, SafetyCondition::RobotPlaceUnsure);
    EXPECT_EQ(changes.raised[1].condition, SafetyCondition::ObjectHot);
    ASSERT_NE(m.monitor.forbidsReset(), nullptr);
    EXPECT_EQ(m.monitor.forbidsReset()->condition, SafetyCondition::RobotPlaceUnsure);
}

// Catches one broken wire that is told as three faults, and a sensor said to be back when it only fails
// otherwise.
TEST(SafetyMonitor, OneSensorHasOneTrouble) {
    Monitor m;
    ObservedObject& object = m.seen.objects[0];
    object.isLost = object.isInvalid = true;
    object.measured_K.reset();
    object.fault = SensorFault::Open;
    EXPECT_EQ(m.after(1.0).raised.size(), 1U);
    object.isInvalid = false;
    object.fault = SensorFault::None;
    object.age_s = 9.0;
    const SafetyChanges changes = m.after(1.0);
    EXPECT_TRUE(changes.raised.empty());
    EXPECT_TRUE(changes.ended.empty());
    EXPECT_TRUE(m.isActive(SafetyCondition::SensorOpen));
}

// Catches a thermometer whose cable is off being told as sensors only; and before it was ever read.
TEST(SafetyMonitor, AThermometerThatDoesNotAnswerIsNamed) {
    Monitor m;
    m.seen.thermometerProblem = {MessageCode::DeviceSilent, {"/dev/ttyUSB1", "2"}};
    EXPECT_TRUE(m.after(1.0).raised.empty());
    for (ObservedObject& object : m.seen.objects) {
        object.isLost = true;
        object.age_s = 4.0;
        object.measured_K.reset();
    }
    EXPECT_EQ(m.after(1.0).raised.size(), 3U);
    EXPECT_TRUE(m.isActive(SafetyCondition::ThermometerLost));
    Monitor fresh;
    for (ObservedObject& object : fresh.seen.objects) {
        object = {};
        object.isLost = true;
        object.age_s = std::numeric_limits<double>::infinity();
    }
    EXPECT_TRUE(fresh.after(1.0).raised.empty());
}

// Catches sensors that disagree in a cold rig unnoticed, and objects at their targets taken for that.
TEST(SafetyMonitor, SensorsAreComparedOnlyInAColdRig) {
    Monitor m;
    *m.seen.objects[1].measured_K += 8.0;
    m.after(1.0);
    EXPECT_TRUE(m.after(11.0).raised.size() == 1U && m.isActive(SafetyCondition::SensorsApart));
    Monitor warm;
    *warm.seen.objects[1].measured_K += 8.0;
    warm.seen.asked_K = 473.15;
    warm.seen.isSourceDark = false;
    warm.after(1.0);
    warm.seen.asked_K.reset();
    warm.seen.isSourceDark = true;
    warm.after(1.0);
    EXPECT_TRUE(warm.after(600.0).raised.empty());
    warm.after(4000.0);
    EXPECT_EQ(warm.after(11.0).raised.size(), 1U);
}

// Catches jumps that an estimator takes, a channel that never comes back, and readings counted twice.
TEST(SensorChannels, AJumpIsNoReading) {
    SensorChannels channels(1, SamplingSpec{1.0, 5, 1}, {3.0, {2.0}});
    for (int t = 0; t < 10; ++t)
        channels.add({{static_cast<double>(t), 300.0, true}});
    channels.add({{10.0, 330.0, true}});
    EXPECT_TRUE(channels.lastInvalid(0));
    EXPECT_EQ(channels.measured_K(0), 300.0);
    EXPECT_EQ(channels.jump(0).inARow, 1);
    EXPECT_NEAR(channels.jump(0).rate_K_s, 30.0, 1e-9);
    EXPECT_EQ(channels.jump(0).began_s, 10.0);
    EXPECT_EQ(channels.jump(0).from_K, 300.0);
    EXPECT_EQ(channels.jump(0).to_K, 330.0);
    channels.add({{10.0, 330.0, true}}); // the same reading once more
    EXPECT_EQ(channels.jump(0).inARow, 1);
    channels.add({{11.0, 300.1, true}});
    EXPECT_EQ(channels.jump(0).inARow, 0);
    EXPECT_FALSE(channels.lastInvalid(0));
    for (int t = 12; t < 24; ++t)
        channels.add({{static_cast<double>(t), 320.0, true}});
    EXPECT_EQ(channels.measured_K(0), 320.0); // 20 K in 12 s: an object may have been changed
}

// Catches a plate that holds its temperature though it was switched off; and one that cools being blamed.
TEST(SafetyMonitor, ASourceThatIsOffMustCool) {
    Monitor m;
    m.seen.isSourceSwitched = true;
    m.seen.source_K = kelvinFromCelsius(300.0);
    for (int i = 0; i < 700; ++i) { // 1 K a minute, at the end of a heavy plate's cooling
        m.seen.source_K = *m.seen.source_K - 1.0 / 60.0;
        (void)m.after(1.0);
    }
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceNotCooling));
    double took_s = 0.0;
    for (; took_s < 1000.0 && !m.isActive(SafetyCondition::SourceNotCooling); took_s += 1.0) {
        m.seen.source_K = kelvinFromCelsius(288.0 + std::fmod(took_s, 3.0)); // a controller's ripple
        (void)m.after(1.0);
    }
    EXPECT_LT(took_s, 500.0);
    m.seen.asked_K = kelvinFromCelsius(300.0);
    (void)m.after(1.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceNotCooling));
}

// Catches a fast plate that is blamed for the moment its switching off takes; and one that heats on.
TEST(SafetyMonitor, ASourceSwitchedOffInFullHeatMayOvershoot) {
    for (const bool heatsOn : {false, true}) {
        Monitor m;
        m.seen.asked_K = kelvinFromCelsius(300.0);
        m.seen.source_K = kelvinFromCelsius(150.0);
        (void)m.after(1.0);
        m.seen.asked_K.reset();
        for (int i = 0; i < 40; ++i) {
            m.seen.source_K = *m.seen.source_K + (heatsOn || i < 7 ? 2.5 : -0.5);
            (void)m.after(0.1);
        }
        EXPECT_EQ(m.isActive(SafetyCondition::SourceHeatsUnasked), heatsOn);
    }
}

// Catches a reset that forgets a plate which heats on, and an alarm that stays when the plate cools or rests
// cool.
TEST(SafetyMonitor, ASourceThatHeatsUnaskedIsNoneOnlyOnceItDoesNot) {
    for (const double then_K_s : {-0.3, 0.0}) {
        Monitor m;
        m.seen.source_K = then_K_s < 0.0 ? kelvinFromCelsius(150.0) : m.experiment.environment_K;
        for (int i = 0; i < 15; ++i) {
            m.seen.source_K = *m.seen.source_K + 1.0;
            (void)m.after(1.0);
        }
        ASSERT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked));
        for (int i = 0; i < 15; ++i) {
            m.monitor.restart();
            m.seen.source_K = *m.seen.source_K + 0.2;
            (void)m.after(1.0);
            EXPECT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked)) << i;
        }
        double for_s = 0.0;
        for (; for_s < 200.0 && m.isActive(SafetyCondition::SourceHeatsUnasked); for_s += 1.0) {
            m.seen.source_K = *m.seen.source_K + then_K_s;
            (void)m.after(1.0);
        }
        EXPECT_LE(for_s, then_K_s < 0.0 ? 34.0 : 130.0); // half of 18 K
        EXPECT_GE(for_s, then_K_s < 0.0 ? 28.0 : 100.0);
    }
}

// Catches a plate that is stuck on at a set point of its own, and taken for one that is off since it rests.
TEST(SafetyMonitor, ASourceThatHeatsUnaskedAndRestsHotHeatsOn) {
    Monitor m;
    const auto during = [&](int seconds, const auto& temperature_K) {
        for (int i = 0; i < seconds; ++i) {
            m.seen.source_K = temperature_K(static_cast<double>(i));
            (void)m.after(1.0);
            if (m.isActive(SafetyCondition::SourceHeatsUnasked))
                m.monitor.restart(); // somebody who presses Reset all the time
        }
    };
    const double hot_K = m.experiment.environment_K + 125.0;
    during(22, [&](double t) { return hot_K - 10.5 * std::max(0.0, 1.0 - t / 20.0); });
    ASSERT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked));
    during(600, [&](double) { return hot_K - 1.0; }); // by now less than the limit over where it began
    ASSERT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked));
    during(600, [&](double t) { return hot_K - 2.5 + 2.0 * std::sin(0.1 * t); }); // a thermostat's
    ASSERT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked));
    ASSERT_NE(m.monitor.forbidsReset(), nullptr);
    EXPECT_EQ(m.monitor.forbidsReset()->message.code, MessageCode::SafetySourceHeatsUnasked);

    during(20, [&](double t) { return hot_K - 1.0 - 0.3 * t; }); // switched off at its mains
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceHeatsUnasked));
    EXPECT_EQ(m.monitor.forbidsReset(), nullptr);
}

// Catches a plate that a person heats, and one that overshoots and cools after STOP, taken for stuck ones.
TEST(SafetyMonitor, AHeatedSourceThatCoolsOrIsHeatedByHandHeatsNotUnasked) {
    Monitor m;
    const double room_K = m.experiment.environment_K;
    double source_K = room_K;
    const auto second = [&](double change_K) {
        m.seen.source_K = source_K += change_K;
        (void)m.after(1.0);
        ASSERT_FALSE(m.isActive(SafetyCondition::SourceHeatsUnasked)) << source_K - room_K;
    };
    m.seen.asked_K = room_K + 275.0;
    for (int i = 0; i < 275; ++i)
        ASSERT_NO_FATAL_FAILURE(second(1.0));
    m.seen.asked_K.reset();
    for (int i = 0; i < 8; ++i)
        ASSERT_NO_FATAL_FAILURE(second(1.0)); // what its inertia holds
    for (int i = 0; i < 1500; ++i)
        ASSERT_NO_FATAL_FAILURE(second((room_K - source_K) / 300.0));
    ASSERT_LT(source_K, room_K + 5.0);

    m.seen.isManual = true;
    for (int i = 0; i < 200; ++i)
        ASSERT_NO_FATAL_FAILURE(second(1.0));
    for (int i = 0; i < 200; ++i)
        ASSERT_NO_FATAL_FAILURE(second(0.0));
}

// Catches a source that is taken to heat no more because nobody hears it, and one that another experiment on
// the same rig forgets.
TEST(SafetyMonitor, ASourceThatHeatsUnaskedIsNotForgotten) {
    Monitor m;
    const auto warm = [](Monitor& monitor, int seconds, double rate_K_s) {
        for (int i = 0; i < seconds; ++i) {
            monitor.seen.source_K = monitor.seen.source_K.value_or(kelvinFromCelsius(165.0)) + rate_K_s;
            (void)monitor.after(1.0);
        }
    };
    m.seen.source_K = kelvinFromCelsius(150.0);
    warm(m, 15, 1.0);
    ASSERT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked));
    m.seen.source_K.reset();
    (void)m.after(5.0);
    EXPECT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked)) << "nothing was read";
    m.seen.sourceProblem = {MessageCode::ReasonSourceLost, {}};
    (void)m.after(5.0);
    EXPECT_TRUE(m.isActive(SafetyCondition::SourceHeatsUnasked)) << "its link is lost";
    m.seen.sourceProblem = {};
    EXPECT_GT(m.monitor.unaskedWarming_K(), 10.0);

    Monitor next;
    next.monitor.useHistory(false, m.monitor.unaskedWarming_K());
    next.monitor.restart();
    warm(next, 3, 0.2);
    EXPECT_TRUE(next.isActive(SafetyCondition::SourceHeatsUnasked));
    warm(next, 30, -0.3);
    EXPECT_FALSE(next.isActive(SafetyCondition::SourceHeatsUnasked)) << "it has cooled";
    EXPECT_EQ(next.monitor.unaskedWarming_K(), 0.0);
}

// Catches an object that touches the source and is taken for a loose contact.
TEST(SafetyMonitor, AJumpThatStaysOverTheTripLimitIsAHotObject) {
    Monitor m;
    m.seen.objects[1].measured_K.reset();
    m.seen.objects[1].isInvalid = true;
    m.seen.objects[1].jump = {m.experiment.safety.jumps, 40.0, 0.0, m.experiment.safety.trip_K + 5.0};
    (void)m.after(0.1);
    EXPECT_TRUE(m.isActive(SafetyCondition::ObjectHot));
    m.seen.objects[1].jump.min_K = m.experiment.safety.warning_K - 20.0; // one of them was cold
    (void)m.after(0.1);
    (void)m.after(2.0);
    EXPECT_FALSE(m.isActive(SafetyCondition::ObjectHot));
}

// Catches two swapped sensors that are told as two loose contacts, and two that jump elsewhere as swapped.
TEST(SafetyMonitor, TwoThatJumpToEachOthersReadingsAreSwapped) {
    Monitor m;
    m.seen.asked_K = kelvinFromCelsius(200.0);
    const int jumps = m.experiment.safety.jumps;
    for (ObservedObject& object : m.seen.objects) {
        object.measured_K.reset();
        object.isInvalid = true;
    }
    m.seen.objects[0].jump = {jumps, 12.0, 3.0, 312.4, 1.0, 300.2, 312.5};
    m.seen.objects[1].jump = {jumps, 12.0, 3.0, 300.1, 1.0, 312.2, 300.6};
    const SafetyChanges changes = m.after(1.0);
    ASSERT_EQ(changes.raised.size(), 1U);
    EXPECT_EQ(changes.raised[0].message.code, MessageCode::SafetySensorsSwapped);
    EXPECT_EQ(changes.raised[0].message.args.at(0).text(), "left");
    EXPECT_EQ(changes.raised[0].message.args.at(1).text(), "right");
    EXPECT_EQ(m.monitor.swappedWith(0), 1U);
    EXPECT_EQ(m.monitor.swappedWith(1), 0U);
    enum class Other { Elsewhere, Later, WithoutHeat }; // without heat somebody may exchange them
    for (const Other how : {Other::Elsewhere, Other::Later, Other::WithoutHeat}) {
        Monitor other;
        other.seen.objects = m.seen.objects;
        if (how != Other::WithoutHeat)
            other.seen.asked_K = m.seen.asked_K;
        other.seen.objects[1].jump.to_K += how == Other::Elsewhere ? 4.0 : 0.0;
        other.seen.objects[1].jump.began_s += how == Other::Later ? 5.0 : 0.0;
        EXPECT_EQ(other.after(1.0).raised.size(), 2U);
        EXPECT_TRUE(other.isActive(SafetyCondition::SensorJump));
        EXPECT_FALSE(other.monitor.swappedWith(0));
    }
}

// Catches sensors that are called swapped by what lasts for a moment, and where there are none.
TEST(SafetyMonitor, SensorsSeemSwappedOnlyForSomeTime) {
    const double told_s = seemSwapped_s(ReadBy::Contact, 0.0);
    ASSERT_LT(told_s, 350.0);
    EXPECT_NEAR(seemSwapped_s(ReadBy::Contact, told_s - 5.0), told_s + 6.0, 1.5);
    EXPECT_GT(seemSwapped_s(ReadBy::Camera, 0.0), 1000.0);
}

// Catches what runs away and is told to be over because its readings are missing.
TEST(SafetyMonitor, WhatRunsAwayIsNotOverWhileReadingsAreMissing) {
    Monitor m;
    const double set_K = kelvinFromCelsius(150.0);
    m.seen.asked_K = m.seen.source_K = set_K;
    m.seen.isSourceDark = false;
    const auto bothActive = [&] {
        return m.isActive(SafetyCondition::HeatedOtherwise) && m.isActive(SafetyCondition::SourceOver);
    };
    for (int t = 0; t < 60 && !bothActive(); ++t) {
        m.seen.source_K = *m.seen.source_K + 1.0;
        *m.seen.objects[0].measured_K += t < 20 ? 0.0 : 1.7;
        m.after(1.0);
    }
    ASSERT_TRUE(bothActive());
    const double object_K = *m.seen.objects[0].measured_K;
    m.seen.source_K.reset();
    m.seen.objects[0].measured_K.reset();
    for (int t = 0; t < 5; ++t)
        m.after(1.0);
    EXPECT_TRUE(bothActive());
    m.seen.source_K = set_K;
    m.seen.objects[0].measured_K = object_K;
    for (int t = 0; t < 60; ++t) { // neither warms any more
        *m.seen.objects[0].measured_K -= 0.01;
        m.after(1.0);
    }
    EXPECT_FALSE(m.isActive(SafetyCondition::HeatedOtherwise));
    EXPECT_FALSE(m.isActive(SafetyCondition::SourceOver));
}

// Catches a hand that is told to heat an object, and what heats it beyond any hand without a word.
TEST(SafetyMonitor, AHandIsNotToldToHeat) {
    for (const double to_K : {310.0, 340.0}) {
        Monitor m;
        bool isTold = false;
        for (int t = 0; t < 120; ++t) {
            *m.seen.objects[0].measured_K +=
                t < 20 ? 0.0 : std::min(0.7, 0.1 * (to_K - *m.seen.objects[0].measured_K));
            m.after(1.0);
            isTold = isTold || m.isActive(SafetyCondition::HeatedAtRest);
            EXPECT_FALSE(m.isActive(SafetyCondition::HeatedOtherwise));
        }
        EXPECT_EQ(isTold, to_K > kByHand_K);
    }
}

// Catches an object that leaves its target in a run without a word; and one that is told where nothing moves
// it to that target: in a hold, before a source that is still cold, after another target.
TEST(SafetyMonitor, AnObjectThatGoesAwayFromItsTargetIsTold) {
    enum class Case { Told, NotControlled, ColdSource, OtherTargets };
    for (const Case when : {Case::Told, Case::NotControlled, Case::ColdSource, Case::OtherTargets}) {
        Monitor m;
        m.seen.isSourceDark = false;
        m.seen.isControlled = when != Case::NotControlled;
        m.seen.asked_K = kelvinFromCelsius(200.0);
        m.seen.source_K = *m.seen.asked_K - (when == Case::ColdSource ? 50.0 : 1.0);
        ObservedObject& object = m.seen.objects[0];
        object.target_K = kelvinFromCelsius(40.0);
        object.measured_K = kelvinFromCelsius(40.0);
        bool isTold = false;
        for (int t = 0; t < 150; ++t) {
            *object.measured_K -= 0.05; // as it would in the room's air
            if (when == Case::OtherTargets && t % 50 == 49)
                object.target_K += 0.5;
            m.after(1.0);
            isTold = isTold || m.isActive(SafetyCondition::TargetLeft);
        }
        EXPECT_EQ(isTold, when == Case::Told) << static_cast<int>(when);
    }
}

// Catches a fault that is latched a second time, and an acknowledgement that is lost, because what is known
// of the same fault is told in other words.
TEST(SafetyMonitor, AFaultInOtherWordsIsTheSameAlarm) {
    using enum MessageCode;
    const Monitor m;
    LatchedFaults faults(m.experiment, m.monitor);
    const auto isNew = [&](SafetyCondition condition, MessageCode code) {
        return faults.add(latchedFault({condition, 1, {code, {"right"}}}, m.experiment));
    };
    EXPECT_TRUE(isNew(SafetyCondition::NotWarming, SafetyNotWarming));
    for (const MessageCode code : {SafetyNotFollowing, SafetyNotFollowingPair, SafetyBeyondHeat})
        EXPECT_FALSE(isNew(SafetyCondition::NotWarming, code)) << messageName(code);
    EXPECT_TRUE(isNew(SafetyCondition::SensorsSwapped, SafetySensorsSeemSwapped));
    EXPECT_FALSE(isNew(SafetyCondition::SensorsSwapped, SafetySensorsSwapped));
    EXPECT_EQ(faults.all().size(), 2U);
}

} // namespace bask
