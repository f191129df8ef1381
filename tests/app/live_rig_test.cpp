// How `bask run --live` over three serial ports ends, against `bask simulate-rig`: real drivers, real ports,
// two processes. That it settles is in socat_rig_test.cpp.

#include "engine/recording/session_file.h"
#include "tests/app/rig_processes.h"
#include "tests/support/listening_sockets.h"

namespace bask::test {
namespace {

using LiveRigTest = RigProcesses;

} // namespace

// Catches a second bench that takes the links of the first away from under a run, and a refusal that outlives
// the first, even one that was killed.
TEST_F(LiveRigTest, aBenchIsAloneAtItsPorts) {
    startBench();
    const QString before = QFile::symLinkTarget(portOf("robot"));
    QProcess second;
    second.start(QStringLiteral(BASK_PROGRAM), {QStringLiteral("simulate-rig"), experiment()});
    ASSERT_TRUE(second.waitForFinished(20000));
    EXPECT_EQ(second.exitCode(), 2);
    EXPECT_TRUE(second.readAllStandardError().contains("another bask simulate-rig"));
    EXPECT_EQ(QFile::symLinkTarget(portOf("robot")), before);
    sendSignal(bench, SIGKILL);
    ASSERT_TRUE(bench.waitForFinished(5000));
    startBench();
}

// Catches heat that stays on, and a robot that goes on, without an engine.
TEST_F(LiveRigTest, aKilledEngineLeavesNoHeatAndNoMotion) {
    startBench();
    startEngine();
    ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
    sendSignal(engine, SIGKILL);
    QElapsedTimer dead;
    dead.start();
    ASSERT_TRUE(engine.waitForFinished(5000));
    ASSERT_TRUE(waitFor([&] { return dead.elapsed() > 1000; }));
    const Eigen::Vector3d stands_m = state().place_m;
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 40000));
    EXPECT_LT(dead.elapsed(), 25000) << "the plate's own watchdog of 20 s";
    EXPECT_EQ(state().place_m, stands_m);
    const auto record = readSession(session().toStdString());
    ASSERT_TRUE(record.ok());
    EXPECT_TRUE(record->interrupted());
}

// Catches an engine that hangs and keeps the plate hot.
TEST_F(LiveRigTest, aStoppedEngineLeavesNoHeatAndNoMotion) {
    startBench();
    startEngine();
    ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
    sendSignal(engine, SIGSTOP);
    QElapsedTimer dead;
    dead.start();
    ASSERT_TRUE(waitFor([&] { return dead.elapsed() > 1000; }));
    const Eigen::Vector3d stands_m = state().place_m;
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 40000));
    EXPECT_LT(dead.elapsed(), 25000);
    EXPECT_EQ(state().place_m, stands_m);
}

// Catches Ctrl+C that leaves the robot where it is over a hot plate.
TEST_F(LiveRigTest, anInterruptStopsAndRetreats) {
    startBench();
    startEngine();
    ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
    QElapsedTimer run;
    run.start();
    ASSERT_TRUE(waitFor([&] { return run.elapsed() > 5000; }));
    const std::string process = std::to_string(engine.processId());
    EXPECT_EQ(listeningSockets(process), "");
    sendSignal(engine, SIGINT);
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 4000));
    EXPECT_EQ(listeningSockets(process), "") << "nor in its retreat";
    EXPECT_TRUE(ended(60000).has_value());
    EXPECT_GT(state().place_m.z(), kAway_m) << "the top of its workspace";
    const auto record = readSession(session().toStdString());
    ASSERT_TRUE(record.ok());
    EXPECT_EQ(record->outcome, "stopped");
}

// Catches a program that is gone when the plate, which says that it is off, heats on.
TEST_F(LiveRigTest, aPlateThatSaysOffAndHeatsIsToldBeforeTheEnd) {
    startBench();
    startEngine();
    ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
    sendSignal(engine, SIGINT);
    ASSERT_TRUE(waitFor([&] { return state().place_m.z() > kAway_m; }, 60000));
    ASSERT_NO_FATAL_FAILURE(tell("heater stuck-on"));
    EXPECT_EQ(ended(60000), 1);
    EXPECT_TRUE(engine.readAll().contains("though its heat is off"));
}

} // namespace bask::test
