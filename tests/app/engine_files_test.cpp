// Which files the engine's thread touches, by the kernel's own account: none in any state of a rig.

#include "engine/drivers/driver_catalogue.h"
#include "tests/app/live_faults.h"
#include "tests/support/file_call_watch.h"
#include "tests/support/joined_line.h"

#include <unistd.h>

namespace bask::test {
namespace {

class EngineFiles : public LiveFaults {
protected:
    EngineFiles() : LiveFaults(true) {}

    void expectNone(const char* when) {
        for (const std::string& call : m_watch.take())
            ADD_FAILURE() << when << ": " << call;
    }
    ~EngineFiles() override { endProcess(m_spare); }

    /// False: the kernel has no such filter.
    bool watch() {
        live.ask([this] { m_problem = m_watch.watchThisThread(); });
        return m_problem.empty();
    }
    /// A module that is not in use is tried, and let go.
    void tryDevice() {
        if (m_spare.state() == QProcess::NotRunning) {
            m_spare.start(QStringLiteral(BASK_PROGRAM),
                          {QStringLiteral("simulate-device"), QStringLiteral("thermometer"),
                           QStringLiteral("--driver"), QStringLiteral("modbus"), QStringLiteral("--link"),
                           portOf("spare")});
            ASSERT_TRUE(waitFor([&] { return QFile::exists(portOf("spare")); }));
        }
        TryDevice trial;
        ThermometerDeviceSpec& module = trial.rig.thermometer.emplace();
        module.port = portOf("spare").toStdString();
        module.serial = driverOf(module).serial;
        module.profile = *std::ranges::find(shippedProfiles(), "modmux-pm6rtd", &ModbusProfile::name);
        live.send(trial);
        ASSERT_EQ(live.refusal.code, MessageCode::None) << describe(live.refusal);
        ASSERT_TRUE(waitFor([&] {
            return live.last.tried && live.last.tried->state.status.link == LinkState::Live &&
                   !live.last.tried->temperatures_K.empty();
        }));
        live.send(TryDevice{});
        ASSERT_TRUE(waitFor([&] { return !live.last.tried; }));
    }
    void heat() {
        ASSERT_TRUE(waitFor([&] {
            if (!live.last.heatSetPoint_K)
                live.send(SetHeat{kelvinFromCelsius(60.0)});
            return state().isHeating;
        })) << describe(live.refusal);
    }
    void jog() {
        Jog up;
        up.twist[kZ] = 0.01;
        const Eigen::Vector3d from_m = state().place_m;
        live.send(up);
        ASSERT_EQ(live.refusal.code, MessageCode::None) << describe(live.refusal);
        ASSERT_TRUE(waitFor([&] { return (state().place_m - from_m).norm() > 1e-3; }));
        ASSERT_TRUE(waitFor([&] { return !live.last.isMoving; }));
    }

    FileCallWatch m_watch;
    std::string m_problem;
    QProcess m_spare;
};

} // namespace

// Promise: no file-system call on the engine's thread, which a disk or a dead mount could hold up. Catches
// each one, whoever makes it: a recording, alarms, room on the disk, a time zone, a library loaded late.
TEST_F(EngineFiles, areNone) {
    startBench();
    if (!watch())
        GTEST_SKIP() << "no calls can be watched here: " << m_problem;
    live.ask([] { (void)::access("/", F_OK); });
    ASSERT_EQ(m_watch.take(), std::vector<std::string>{"access /"}) << "the test itself";
    load(read());
    ASSERT_NO_FATAL_FAILURE(beReady());
    expectNone("loaded, faulted, reset");
    ASSERT_NO_FATAL_FAILURE(tryDevice());
    expectNone("a device tried");
    ASSERT_NO_FATAL_FAILURE(home());
    expectNone("homing");
    live.send(ListPorts{});
    ASSERT_TRUE(waitFor([&] { return !live.last.devices.empty(); }));
    ASSERT_NO_FATAL_FAILURE(heat());
    Vector6d goal = live.last.latest.coordinates;
    goal[kZ] += 0.01;
    live.send(MoveTo{goal});
    ASSERT_TRUE(waitFor([&] { return live.last.isMoving; }));
    live.send(WatchCamera{true, {}});
    live.send(ChooseCamera{"/nowhere"});
    live.send(ChooseCamera{});
    ASSERT_TRUE(waitFor([&] { return !live.last.isMoving; }));
    ASSERT_NO_FATAL_FAILURE(jog());
    expectNone("by hand");
    ASSERT_NO_FATAL_FAILURE(tryDevice());
    expectNone("a device tried while heat is on");
    live.send(SetHeat{});
    ASSERT_TRUE(waitFor([&] { return live.last.heat == HeatState::Off; }));
    expectNone("heat off by hand");
    ASSERT_NO_FATAL_FAILURE(begin());
    live.send(AddNote{"hello"});
    expectNone("armed, running");
    live.send(Hold{});
    ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Holding; }));
    live.send(Resume{});
    tell("thermometer short");
    ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Holding; })) << reasons();
    tell("thermometer none");
    ASSERT_TRUE(waitFor([&] { return isWell(); })) << reasons();
    live.send(AcknowledgeAll{});
    live.send(Resume{});
    expectNone("held");
    const double from_s = live.last.runTime_s;
    ASSERT_TRUE(comesInRun([&] { return live.last.runTime_s > from_s + 6.0; })) << "a look at the disk";
    live.send(Stop{});
    ASSERT_TRUE(reaches(RunState::Stopped, 40000)) << reasons();
    ASSERT_TRUE(waitFor([&] { return live.last.recordingPath.empty(); }));
    expectNone("settling, stopping, stopped");
    ASSERT_NO_FATAL_FAILURE(heat());
    tell("robot unplug");
    ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Fault; })) << reasons();
    tell("robot plug");
    ASSERT_TRUE(waitFor([&] { return live.last.devices.at(0).status.link == LinkState::Live; }));
    expectNone("a link lost and opened again");
    live.shutDown();
    expectNone("at the end");
}

constexpr double kRest_K = 273.15 + 60.0; ///< nearer to the plate than where a retreat ends

// The same where objects rest, and of a retreat by its verb: by hand, and out of a fault.
TEST_F(EngineFiles, areNoneAtRestAndInRetreats) {
    startBench(2.0);
    if (!watch())
        GTEST_SKIP() << "no calls can be watched here: " << m_problem;
    Experiment quick = read();
    quick.controller.estimatedRateErrorFactor = 1.0;
    quick.controller.levelServo.timeConstant_s = 4.0;
    quick.controller.levelServo.integralTime_s = 20.0;
    load(quick);
    for (int tries = 0; tries < 3 && live.last.state != RunState::Settled; ++tries) {
        ASSERT_NO_FATAL_FAILURE(begin()); // a run may have ended by a bench that was held up
        expectNone("running");
        live.send(SetTargets{std::vector<double>(live.last.targets_K.size(), kRest_K)});
        ASSERT_TRUE(waitFor(
            [&] {
                resumeIfWell();
                return live.last.state == RunState::Settled || live.last.state == RunState::Fault;
            },
            90000));
    }
    ASSERT_EQ(live.last.state, RunState::Settled) << reasons();
    std::printf("| settled %.0f s after its start\n", live.last.runTime_s);
    const double from_s = live.last.runTime_s;
    ASSERT_TRUE(waitFor([&] { return live.last.runTime_s > from_s + 1.0; }));
    expectNone("settled");
    live.send(EmergencyStop{});
    ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Fault && live.last.canRetreat; }));
    const double z_m = state().place_m.z();
    live.send(Retreat{});
    ASSERT_TRUE(reaches(RunState::Stopping)) << describe(live.refusal);
    ASSERT_TRUE(reaches(RunState::Fault, 40000)) << reasons();
    EXPECT_GT(state().place_m.z(), z_m);
    ASSERT_TRUE(isClosed());
    expectNone("a retreat out of a fault");
    ASSERT_NO_FATAL_FAILURE(beReady());
    ASSERT_NO_FATAL_FAILURE(heat());
    live.send(Retreat{});
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; })) << describe(live.refusal);
    ASSERT_TRUE(waitFor([&] { return live.last.state != RunState::Stopping; }, 40000));
    expectNone("a retreat by hand");
}

// The same of a heater and a thermometer on one line, which go through the guard: also when that is killed.
TEST_F(EngineFiles, areNoneOnASharedLine) {
    makeHeater("pixsys-drr245");
    startBench();
    const JoinedLine line(portOf("line").toStdString(),
                          {portOf("thermometer").toStdString(), portOf("heater").toStdString()});
    ASSERT_TRUE(line.isThere());
    if (!watch())
        GTEST_SKIP() << "no calls can be watched here: " << m_problem;
    Experiment shared = read();
    shared.rig->thermometer->port = shared.rig->source->port = portOf("line").toStdString();
    shared.rig->thermometer->serial = shared.rig->source->serial;
    load(shared);
    ASSERT_NO_FATAL_FAILURE(beReady());
    ASSERT_NO_FATAL_FAILURE(heat());
    expectNone("by hand");
    live.send(SetHeat{});
    ASSERT_TRUE(waitFor([&] { return live.last.heat == HeatState::Off; }));
    live.send(Arm{recording(), true});
    ASSERT_TRUE(reaches(RunState::Armed)) << describe(live.refusal);
    ASSERT_TRUE(waitFor([&] { // its targets are judged first
        if (live.last.state == RunState::Armed)
            live.send(Start{});
        return live.last.state == RunState::Running;
    })) << describe(live.refusal);
    ASSERT_TRUE(comesInRun([&] { return state().isHeating; }));
    expectNone("running");
    endGuardsOf(QFileInfo(experiment()).path());
    ASSERT_TRUE(waitFor([&] { return live.alarm(MessageCode::HeaterGuardLost) != nullptr; }, 5000));
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 5000)) << reasons();
    ASSERT_TRUE(reaches(RunState::Fault, 40000)) << reasons();
    ASSERT_NO_FATAL_FAILURE(beReady());
    expectNone("a guard that is lost, and a new one");
    live.shutDown();
    expectNone("at the end");
}

// Catches a file that the engine's thread reads when it begins: here the devices that were met.
TEST(EngineStart, readsNoFile) {
    QTemporaryDir folder;
    const std::string devices = folder.filePath(QStringLiteral("devices.json")).toStdString();
    ASSERT_TRUE(writeDeviceMemory({{"robot grbl /dev/ttyUSB0", {"usb-one", ""}}}, devices));
    EngineWorker worker(folder.filePath(QStringLiteral("alarms.json")).toStdString(), devices);
    FileCallWatch watch;
    std::string problem;
    QThread thread;
    worker.moveToThread(&thread);
    thread.start();
    QMetaObject::invokeMethod(
        &worker,
        [&] {
            problem = watch.watchThisThread();
            worker.start();
        },
        Qt::BlockingQueuedConnection);
    const std::vector<std::string> calls = watch.take();
    QMetaObject::invokeMethod(&worker, &EngineWorker::shutdown, Qt::BlockingQueuedConnection);
    thread.quit();
    thread.wait();
    if (!problem.empty())
        GTEST_SKIP() << "no calls can be watched here: " << problem;
    EXPECT_EQ(calls, std::vector<std::string>());
}

} // namespace bask::test
