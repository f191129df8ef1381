// Faults of the robot, of the heat source and of the whole rig, on a run over three serial ports.

#include "tests/app/live_faults.h"

#include <fcntl.h>
#include <unistd.h>

namespace bask::test {
namespace {

struct SourceRow {
    const char* fault;
    ToldAs as;
    double off_ms; ///< after it was told
};

class LiveRigFaults : public LiveFaults {
protected:
    void takesAwayFor(const SourceRow& row) {
        ASSERT_NO_FATAL_FAILURE(begin()) << row.fault;
        const Reaction seen = raise(row.fault, row.as);
        EXPECT_TRUE(live.last.state == RunState::Stopping || live.last.state == RunState::Fault)
            << row.fault << ": " << reasons();
        EXPECT_GE(seen.rose_ms, 0.0) << row.fault << ": no retreat";
        EXPECT_LE(seen.rose_ms - seen.told_ms, kReaction_ms) << row.fault;
        QElapsedTimer since;
        since.start();
        EXPECT_TRUE(waitFor([&] { return !state().isHeating; }, static_cast<int>(row.off_ms) + 1000));
        if (seen.off_ms < 0.0) {
            EXPECT_LE(since.elapsed(), row.off_ms) << row.fault;
            std::printf("|   %s: off after %.1f s\n", row.fault, 1e-3 * static_cast<double>(since.elapsed()));
        }
        ASSERT_TRUE(reaches(RunState::Fault, 40000)) << reasons();
        EXPECT_GT(state().place_m.z(), kAway_m) << row.fault;
        expectRecorded("fault");
        tell("heater none");
    }
    /// Somebody else's program has switched the plate on and gone.
    void heatBehindTheEngine() {
        const int port = ::open(portOf("heater").toStdString().c_str(), O_RDWR | O_NOCTTY);
        ASSERT_GE(port, 0);
        constexpr std::string_view kLines = "OUT_SP_1 100\r\nSTART_1\r\n";
        ASSERT_EQ(::write(port, kLines.data(), kLines.size()), static_cast<ssize_t>(kLines.size()));
        ASSERT_TRUE(waitFor([&] { return state().isHeating; }, 2000));
        ::close(port);
    }
};

/// What a robot's fault takes to be over.
enum class Remedy { Plug, None, Home, Clear };

struct RobotRow {
    const char* fault;
    ToldAs as;
    Remedy remedy;
};

/// Occupies the next number, so that a terminal made anew gets another one.
struct SpareTerminal {
    ~SpareTerminal() { ::close(master); }
    int master = ::posix_openpt(O_RDWR | O_NOCTTY);
};

constexpr double kStep_m = 0.01; ///< the robot's greatest step and its way to stand, with room

} // namespace

// Catches any way a robot fails that leaves the heat on or steps coming, or that cannot be mended without a
// new start; and a port that is not found again under another number.
TEST_F(LiveRigFaults, ofTheRobotEndTheHeatAndAllSteps) {
    startBench();
    load(read());
    for (const RobotRow& row :
         {RobotRow{"robot unplug", {MessageCode::LinkLost, "was lost"}, Remedy::Plug},
          RobotRow{"robot silent", {MessageCode::RobotSlow, "The heat is off"}, Remedy::None},
          RobotRow{"robot alarm", {MessageCode::RobotAlarm, "alarm 1: "}, Remedy::Home},
          RobotRow{"robot restart", {MessageCode::RobotRestarted, "has restarted"}, Remedy::Home},
          RobotRow{"robot door", {MessageCode::RobotHeld, "held at its own panel (Door"}, Remedy::Clear},
          RobotRow{"robot lost-steps", {MessageCode::RobotElsewhere, "mm from where"}, Remedy::Home},
          RobotRow{"robot slow-ok", {MessageCode::RobotSlow, "The heat is off", 3000.0}, Remedy::Clear}}) {
        ASSERT_NO_FATAL_FAILURE(begin()) << row.fault;
        // The answer to a line comes 3 s late: the line in flight is then still carried out.
        const bool isLate = row.as.within_ms > kReaction_ms;
        const Reaction seen = raise(row.fault, row.as, isLate ? 3000 : 1200);
        EXPECT_EQ(live.last.state, RunState::Fault) << row.fault << ": " << reasons();
        EXPECT_GE(seen.off_ms, 0.0) << row.fault;
        EXPECT_LE(seen.off_ms, row.as.within_ms) << row.fault;
        EXPECT_LE(seen.moved_ms, isLate ? 4500.0 : kReaction_ms) << row.fault;
        EXPECT_LE(seen.moved_m, kStep_m) << row.fault << ": one step";
        expectRecorded("fault");
        live.send(Reset{});
        EXPECT_EQ(live.last.state, RunState::Fault) << row.fault << " is not over";
        const std::string number = QFile::symLinkTarget(portOf("robot")).toStdString();
        const SpareTerminal spare;
        tell(row.remedy == Remedy::Plug ? "robot plug" : "robot none");
        if (row.remedy == Remedy::Plug) {
            EXPECT_NE(QFile::symLinkTarget(portOf("robot")).toStdString(), number);
            EXPECT_TRUE(waitFor(
                [&] {
                    return live.last.robotAlarm.code == MessageCode::None &&
                           live.alarm(MessageCode::RobotOpening) == nullptr;
                },
                2000));
        } else if (row.remedy == Remedy::Home) {
            ASSERT_NO_FATAL_FAILURE(home()) << row.fault;
        } else if (row.remedy == Remedy::Clear) {
            ASSERT_TRUE(waitFor([&] {
                live.send(ClearRobotAlarm{});
                return live.last.robotAlarm.code == MessageCode::None;
            })) << row.fault;
        }
    }
}

// Catches a plate that is switched on and cold for good.
TEST_F(LiveRigFaults, aSourceThatDoesNotHeatEndsTheRun) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(beReady());
    tell("heater no-heat");
    ASSERT_NO_FATAL_FAILURE(begin());
    const Reaction cold =
        raise("heater no-heat", {MessageCode::SafetySourceNotHeating, "come no nearer", 11000.0});
    EXPECT_LE(cold.off_ms - cold.told_ms, 500.0);
    ASSERT_TRUE(reaches(RunState::Fault, 40000)) << reasons();
    expectRecorded("fault");
}

// Catches a source that is lost and heats on, or whose objects stay before it.
TEST_F(LiveRigFaults, ofTheSourceTakeTheObjectsAway) {
    startBench();
    Experiment patient = read();
    patient.safety.sourceHeating_s = 60.0; // or a plate without its set point may be told to be cold first
    load(patient);
    ASSERT_NO_FATAL_FAILURE(takesAwayFor(
        {"heater garbage", {MessageCode::DeviceAnswersWrong, "does not fit", 2500.0}, kReaction_ms}));
    tell("heater setpoint-zero"); // it forgets what it is told at the start
    ASSERT_NO_FATAL_FAILURE(takesAwayFor(
        {"heater setpoint-zero", {MessageCode::SafetySetPointOther, "reads back", 15000.0}, kReaction_ms}));
}

// One that is cut off or deaf ends its heat by its own watchdog of 20 s, fed up to 5 s before.
TEST_F(LiveRigFaults, aDeafSourceEndsItsHeatItself) {
    startBench();
    load(read());
    takesAwayFor({"heater silent", {MessageCode::DeviceSilent, "has not answered", 2500.0}, 21000.0});
}

TEST_F(LiveRigFaults, aSourceCutOffEndsItsHeatItself) {
    startBench();
    load(read());
    takesAwayFor({"heater unplug", {MessageCode::LinkNotOpened, "no such port"}, 21000.0});
}

// Catches heat with nobody asking, and a plate beyond its limit, that are only seen in a run.
TEST_F(LiveRigFaults, ofAPlateThatHeatsByItselfAreToldInIdle) {
    startBench();
    Experiment tripping = read();
    tripping.safety.sourceTrip_K = kelvinFromCelsius(230.0);
    load(tripping);
    ASSERT_NO_FATAL_FAILURE(beReady());
    const BenchState before = state();
    const Reaction alone = raise(
        "heater stuck-on", {MessageCode::SafetySourceHeatsUnasked, "although its heat is off", 5000.0}, 300);
    EXPECT_EQ(live.last.state, RunState::Fault) << reasons();
    EXPECT_EQ(alone.moved_m, 0.0);
    ASSERT_TRUE(waitFor([&] { return live.alarm(MessageCode::SafetySourceHot) != nullptr; }, 40000))
        << reasons();
    EXPECT_LT(state().plate_degC, 230.0 + 15.0) << "told within a second and two readings";
    EXPECT_EQ(state().place_m, before.place_m);
    live.send(Reset{});
    EXPECT_EQ(live.last.state, RunState::Fault);
}

// Catches a rig that stops as a whole, or dies, unnoticed; a fault without what went over the links before;
// and one that goes on by itself when it is back.
TEST_F(LiveRigFaults, ofAllDevicesAtOnceEndTheRun) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(begin());
    const auto pid = static_cast<pid_t>(bench.processId());
    for (const Command& command : {Command(SendByHand{portOf("robot").toStdString(), "?"}),
                                   Command(FindUnits{ModbusSearchSpec{"/dev/elsewhere"}})}) {
        live.send(command);
        EXPECT_EQ(live.refusal.code, MessageCode::SessionAlreadyRunning) << "while a run is on";
    }
    const auto stopIt = [&] {
        m_isBenchStopped = true;
        ::kill(pid, SIGSTOP);
    };
    raise("SIGSTOP of all", stopIt, {MessageCode::RobotSlow, "The heat is off"});
    EXPECT_EQ(live.last.state, RunState::Fault) << reasons();
    EXPECT_NE(live.alarm(MessageCode::ReasonSensorStale), nullptr) << "seen first";
    ASSERT_TRUE(waitFor([&] { return live.last.devices.at(2).status.link == LinkState::Lost; }, 5000));
    expectRecorded("fault");
    expectTraffic();
    ::kill(pid, SIGCONT);
    m_isBenchStopped = false;
    QElapsedTimer back;
    back.start();
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 5000));
    EXPECT_LT(back.elapsed(), 2000) << "found again within 2 s, and told to stop";
    const Eigen::Vector3d stands_m = state().place_m;
    ASSERT_NO_FATAL_FAILURE(beReady());
    EXPECT_EQ(state().place_m, stands_m) << "a reset moves nothing";
    EXPECT_FALSE(state().isHeating);

    ASSERT_NO_FATAL_FAILURE(begin());
    const auto endIt = [&] { // and its names, as udev does: the terminals may be another test's next
        endProcess(bench);
        for (const char* role : {"robot", "thermometer", "heater"})
            QFile::remove(portOf(role));
    };
    raise("SIGKILL of all", endIt, {MessageCode::LinkLost, "was lost"});
    EXPECT_EQ(live.last.state, RunState::Fault) << reasons();
    expectRecorded("fault");
    startBench();
    back.start();
    EXPECT_TRUE(waitFor(
        [&] {
            return std::ranges::all_of(live.last.devices, [](const RigDeviceState& device) {
                return device.status.link == LinkState::Live;
            });
        },
        6000));
    std::printf("|   all devices are back after %.1f s\n", 1e-3 * static_cast<double>(back.elapsed()));
    EXPECT_EQ(live.last.state, RunState::Fault) << "until a person resets it";
}

// Catches devices that are taken for ready before they are there.
TEST_F(LiveRigFaults, atTheStartOfDevicesThatAreOff) {
    load(read());
    ASSERT_TRUE(waitFor([&] { return live.alarm(MessageCode::LinkNotOpened) != nullptr; })) << reasons();
    live.send(Reset{});
    EXPECT_EQ(live.refusal.code, MessageCode::LinkNotOpened);
    EXPECT_EQ(live.last.state, RunState::Fault);
    startBench();
    const BenchState before = state();
    ASSERT_NO_FATAL_FAILURE(beReady());
    EXPECT_EQ(state().place_m, before.place_m);
    EXPECT_FALSE(state().isHeating);
}

// Catches a rig that can be run, moved or heated before a person has looked, and a plate that heats on.
TEST_F(LiveRigFaults, atTheStartOfAHotPlateAndARobotInAlarm) {
    startBench();
    tell("robot alarm");
    ASSERT_NO_FATAL_FAILURE(heatBehindTheEngine());
    ASSERT_TRUE(waitFor([&] { return state().plate_degC > 60.0; }));
    QElapsedTimer found;
    found.start();
    load(read());
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 5000)) << reasons();
    std::printf("| a plate found heating is off after %lld ms\n", static_cast<long long>(found.elapsed()));
    EXPECT_LT(found.elapsed(), 1000);
    ASSERT_TRUE(waitFor([&] { return live.last.robotAlarm.code == MessageCode::RobotAlarm; })) << reasons();
    live.send(Reset{});
    EXPECT_EQ(live.refusal.code, MessageCode::RobotAlarm);
    for (const Command& command : {Command(Arm{}), Command(MoveTo{}), Command(SetHeat{350.0})}) {
        live.send(command);
        EXPECT_EQ(live.refusal.code, MessageCode::CommandNotNow) << command.index();
    }
    tell("robot none");
    ASSERT_NO_FATAL_FAILURE(home());
    const Eigen::Vector3d stands_m = state().place_m;
    ASSERT_NO_FATAL_FAILURE(beReady());
    EXPECT_EQ(state().place_m, stands_m);
    EXPECT_FALSE(state().isHeating);
}

} // namespace bask::test
