// `bask run --live` over three serial ports at once, against `bask simulate-rig`: real drivers, real ports,
// two processes.

#include "engine/session/session_file.h"
#include "tests/app/rig_processes.h"

namespace bask::test {
namespace {

using LiveRigTest = RigProcesses;

constexpr double kBand_K = 0.5;
constexpr double kTarget_degC = 40.0;

} // namespace

// Catches any link of the chain that is wrong or slow: the objects' true temperatures come to their targets
// and stay, the recording is whole, and the plate is off in the end.
TEST_F(LiveRigTest, settlesOverThreeLinks) {
    startBench();
    startEngine({QStringLiteral("--duration"), QStringLiteral("150")});
    waitUntilHeating();
    QElapsedTimer run;
    run.start();
    ASSERT_TRUE(waitFor([&] { return run.elapsed() > 145000; }, 160000));
    const BenchState state = this->state();
    ASSERT_EQ(state.objects_degC.size(), 3U);
    for (const double t_degC : state.objects_degC)
        EXPECT_NEAR(t_degC, kTarget_degC, kBand_K);
    EXPECT_TRUE(state.isHeating);

    const auto code = ended(60000);
    EXPECT_EQ(code, 0) << engine.readAll().toStdString();
    EXPECT_FALSE(this->state().isHeating);
    const auto record = readSession(session().toStdString());
    ASSERT_TRUE(record.ok());
    EXPECT_FALSE(record->simulated);
    EXPECT_EQ(record->outcome, "settled");
    const auto controlled = record->controlledSamples();
    EXPECT_GE(controlled.size(), 1200U) << "a sample each period, but for what a busy machine loses";
    for (std::size_t i = 1; i < controlled.size(); ++i)
        EXPECT_LT(controlled[i].time_s - controlled[i - 1].time_s, 1.0) << i;
}

// Catches heat that stays on, and a robot that goes on, without an engine.
TEST_F(LiveRigTest, aKilledEngineLeavesNoHeatAndNoMotion) {
    startBench();
    startEngine();
    waitUntilHeating();
    ::kill(static_cast<pid_t>(engine.processId()), SIGKILL);
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
    waitUntilHeating();
    ::kill(static_cast<pid_t>(engine.processId()), SIGSTOP);
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
    waitUntilHeating();
    QElapsedTimer run;
    run.start();
    ASSERT_TRUE(waitFor([&] { return run.elapsed() > 5000; }));
    ::kill(static_cast<pid_t>(engine.processId()), SIGINT);
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 4000));
    EXPECT_TRUE(ended(60000).has_value());
    EXPECT_GT(state().place_m.z(), 0.29) << "the top of its workspace";
    const auto record = readSession(session().toStdString());
    ASSERT_TRUE(record.ok());
    EXPECT_EQ(record->outcome, "stopped");
}

} // namespace bask::test
