// Which files the engine's thread touches, by the kernel's own account: none in any state of a rig.

#include "tests/app/live_faults.h"
#include "tests/support/file_call_watch.h"

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
    /// False: the kernel has no such filter.
    bool watch() {
        live.ask([this] { m_problem = m_watch.watchThisThread(); });
        return m_problem.empty();
    }

    FileCallWatch m_watch;
    std::string m_problem;
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
    live.send(ListPorts{});
    ASSERT_TRUE(waitFor([&] { return !live.last.devices.empty(); }));
    live.send(SetHeat{kelvinFromCelsius(60.0)});
    ASSERT_TRUE(waitFor([&] { return state().isHeating; }));
    Vector6d goal = live.last.latest.coordinates;
    goal[kZ] += 0.01;
    live.send(MoveTo{goal});
    ASSERT_TRUE(waitFor([&] { return live.last.isMoving; }));
    live.send(WatchCamera{true, {}});
    live.send(ChooseCamera{"/nowhere"});
    live.send(ChooseCamera{});
    ASSERT_TRUE(waitFor([&] { return !live.last.isMoving; }));
    live.send(SetHeat{});
    ASSERT_TRUE(waitFor([&] { return live.last.heat == HeatState::Off; }));
    expectNone("by hand");
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
    live.send(SetHeat{kelvinFromCelsius(60.0)});
    ASSERT_TRUE(waitFor([&] { return state().isHeating; }));
    tell("robot unplug");
    ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Fault; })) << reasons();
    tell("robot plug");
    ASSERT_TRUE(waitFor([&] { return live.last.devices.at(0).status.link == LinkState::Live; }));
    expectNone("a link lost and opened again");
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
