// Faults of the thermometer and of the objects' temperatures, on a run over three serial ports.

#include "tests/app/live_faults.h"

#include <QFile>

namespace bask::test {
namespace {

struct Row {
    const char* fault;
    ToldAs as;
    std::optional<ToldAs> cause; ///< told besides
};

class LiveSensorFaults : public LiveFaults {
protected:
    /// Holds at once, the heat as it was; goes on when the fault is over and a person resumes.
    void holdsFor(const Row& row) {
        ASSERT_NO_FATAL_FAILURE(makeMove());
        const Reaction seen = raise(row.fault, row.as);
        EXPECT_EQ(live.last.state, RunState::Holding) << row.fault << ": " << reasons();
        EXPECT_LE(seen.moved_ms, std::max(kReaction_ms, row.as.within_ms)) << row.fault;
        EXPECT_TRUE(waitFor([&] { return state().isHeating; }, 2000)) << row.fault << ": the heat goes on";
        if (const auto& cause = row.cause) {
            ASSERT_TRUE(waitFor([&] { return live.alarm(cause->code) != nullptr; }, 3000))
                << row.fault << ": " << reasons();
            const std::string told = describe(live.alarm(cause->code)->message);
            EXPECT_NE(told.find(cause->words), std::string::npos) << told;
        }
        tell(std::string_view(row.fault) == "thermometer unplug" ? "thermometer plug" : "thermometer none");
        ASSERT_TRUE(waitFor([&] { return isWell(); }, 5000)) << row.fault << ": " << reasons();
        live.send(Resume{});
        ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Running; })) << describe(live.refusal);
    }
};

} // namespace

// Catches any way a thermometer fails that leaves the robot moving, the reading in use or the operator
// without the reason; and a loss that lasts and is only held.
TEST_F(LiveSensorFaults, holdTheRunAndThenEndIt) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(begin());
    const ToldAs stale{MessageCode::ReasonSensorStale, "nothing new"};
    const ToldAs open{MessageCode::ReasonSensorInvalid, "no plausible value"}; // 655 ohm
    const ToldAs silent{MessageCode::DeviceSilent, "has not answered"};
    const ToldAs noPort{MessageCode::LinkNotOpened, "no such port"};
    const ToldAs wrong{MessageCode::DeviceAnswersWrong, "another number of registers"};
    const ToldAs refused{MessageCode::DeviceException, "exception 4"};
    for (const Row& row :
         {Row{"thermometer silent", stale, silent}, Row{"thermometer unplug", stale, noPort},
          Row{"thermometer wrong-unit", stale, silent}, Row{"thermometer bad-crc", stale, silent},
          Row{"thermometer late-reply", stale, {}}, Row{"thermometer short-reply", stale, wrong},
          Row{"thermometer exception", stale, refused}, Row{"thermometer open", open, {}},
          Row{"thermometer short", {MessageCode::SafetySensorShort, "is shorted"}, {}},
          Row{"thermometer jumping", {MessageCode::SafetySensorJump, "jumped by"}, {}}})
        ASSERT_NO_FATAL_FAILURE(holdsFor(row));

    ASSERT_NO_FATAL_FAILURE(makeMove());
    raise("thermometer open", open);
    QElapsedTimer paused;
    paused.start();
    const double stood_m = state().place_m.z();
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 12000)) << reasons();
    EXPECT_GT(paused.elapsed(), 4000) << "held first";
    EXPECT_LT(paused.elapsed(), 1000 + 8000) << "the held limit of 8 s, and no more than 1 s";
    ASSERT_TRUE(reaches(RunState::Fault, 30000)) << reasons();
    EXPECT_GT(state().place_m.z(), std::max(stood_m, kAway_m)) << "taken away";
    expectRecorded("fault");
}

// While plate and objects warm. Catches a robot that goes nearer and nearer by readings that stay.
TEST_F(LiveSensorFaults, frozenReadingsHoldTheRun) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(beReady());
    live.send(Arm{recording(), true});
    live.send(Start{true});
    ASSERT_TRUE(comesInRun([&] { return state().plate_degC > 40.0; })) << reasons();
    const Reaction seen =
        raise("thermometer frozen", {MessageCode::SafetySensorFrozen, "exactly the same value", 90000.0});
    EXPECT_EQ(live.last.state, RunState::Holding) << reasons();
    EXPECT_LE(seen.moved_ms - seen.told_ms, kReaction_ms);
    tell("thermometer none");
    ASSERT_TRUE(waitFor(
        [&] { // it comes back elsewhere: a person who has looked says that it is right
            for (std::size_t i = 0; i < live.last.sensors.size(); ++i)
                if (live.last.sensors[i] == SensorTrust::Distrusted)
                    live.send(ConfirmSensor{i});
            return isWell();
        },
        7000))
        << reasons();
    live.send(Stop{});
    ASSERT_TRUE(reaches(RunState::Stopped, 30000)) << reasons();
    expectRecorded("stopped");
}

// The ends of a register, and a value that is nobody's fault code. Catches a temperature of 3276.7 or -3276.8
// degC that is controlled by.
TEST_F(LiveSensorFaults, endsOfTheRegistersAreNoTemperature) {
    QFile file(experiment());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll().replace(
        "\"generic-pt100-ohm\"",
        R"({"name": "tenths", "title": "tenths of a degree", "source": "made up", "channels": 3,
            "channel": {"function": 4, "address": 0, "type": "int16", "scale": 0.1, "unit": "degC"}})");
    file.close();
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(text) == text.size());
    file.close();
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(begin());
    const ToldAs invalid{MessageCode::ReasonSensorInvalid, "no plausible value"};
    ASSERT_NO_FATAL_FAILURE(holdsFor({"thermometer open", invalid, {}}));  // 0x7FFF
    ASSERT_NO_FATAL_FAILURE(holdsFor({"thermometer short", invalid, {}})); // 0x8000
    for (const TraceSample& sample : live.samples)
        for (const ObjectSample& object : sample.objects)
            if (object.valid) {
                EXPECT_LT(std::abs(object.measured_K - kelvinFromCelsius(40.0)), 40.0) << sample.time_s;
            }
    live.send(Stop{});
    ASSERT_TRUE(reaches(RunState::Stopped, 30000)) << reasons();
    expectRecorded("stopped");
}

// Catches a limit of the objects that is not watched over a link, or the two limits in another order.
TEST_F(LiveSensorFaults, aHotObjectIsHeldAndThenTakenAway) {
    constexpr double kWarning_degC = 65.0, kTrip_degC = 72.0, kRise_K_s = 2.0;
    startBench();
    Experiment hot = read();
    hot.safety.warning_K = kelvinFromCelsius(kWarning_degC);
    hot.safety.trip_K = kelvinFromCelsius(kTrip_degC);
    hot.safety.warming_K = 1000.0; // a rise that no heat explains would end the run first
    load(hot);
    ASSERT_NO_FATAL_FAILURE(begin());
    // Until the register passes the limit: 2 K/s on top of what the robot takes back.
    const ToldAs warm{MessageCode::SafetyObjectWarm, "above its warning limit of 65", 60000.0};
    raise("thermometer rising", warm, 500);
    EXPECT_EQ(live.last.state, RunState::Holding) << reasons();
    EXPECT_TRUE(waitFor([&] { return state().isHeating; }, 2000));
    const auto hottest_degC = [&] {
        double max_K = 0.0;
        for (const ObjectSample& object : live.last.latest.objects)
            max_K = std::max(max_K, object.valid ? object.measured_K : 0.0);
        return celsiusFromKelvin(max_K);
    };
    ASSERT_TRUE(waitFor([&] { return hottest_degC() > kTrip_degC - 1.0; }));
    const ToldAs tripped{MessageCode::SafetyObjectHot, "above its trip limit of 72", 5000.0};
    const Reaction away = raise(
        "trip limit", [] {}, tripped);
    EXPECT_GT(away.off_ms, 0.0);
    EXPECT_LE(away.off_ms - away.told_ms, 200.0);
    EXPECT_LE(away.rose_ms - away.told_ms, kReaction_ms);
    const std::string& told = away.sentence; // "circle" is at 72.4 °C
    const double at_degC = std::stod(told.substr(told.find(" is at ") + 7));
    EXPECT_LT(at_degC, kTrip_degC + 1e-3 * kReaction_ms * (kRise_K_s + 2.0));
    ASSERT_TRUE(reaches(RunState::Fault, 60000)) << reasons();
    EXPECT_GT(state().place_m.z(), kAway_m);
    live.send(Reset{});
    EXPECT_EQ(live.refusal.code, MessageCode::SafetyObjectHot) << "not before it has cooled";
    expectRecorded("fault");
}

// Catches a fast rise over a link that waits for a limit of temperature.
TEST_F(LiveSensorFaults, aRiseThatNoHeatExplainsEndsTheRun) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(begin());
    const ToldAs foreign{MessageCode::SafetyHeatedOtherwise, "something else heats it", 20000.0};
    const Reaction seen = raise("thermometer rising", foreign);
    EXPECT_GT(seen.off_ms, 0.0);
    EXPECT_LE(seen.off_ms - seen.told_ms, kReaction_ms);
    tell("thermometer none");
    ASSERT_TRUE(reaches(RunState::Fault, 60000)) << reasons();
    EXPECT_GT(state().place_m.z(), kAway_m) << "taken away";
    expectRecorded("fault");
}

} // namespace bask::test
