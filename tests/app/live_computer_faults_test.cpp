// Faults of the computer, on a run over three serial ports: a full disk, a clock that is set, a window that
// hangs.

#include "engine/base/notice.h"
#include "tests/app/live_faults.h"

#include <atomic>
#include <chrono>
#include <ctime>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {
std::atomic<std::time_t> g_clockJump_s{0};
}

// In place of the system's for the whole program: the clock of the wall jumps, that of the machine does not.
extern "C" int clock_gettime(clockid_t id, timespec* time) noexcept {
    const auto code = static_cast<int>(::syscall(SYS_clock_gettime, id, time));
    if (id == CLOCK_REALTIME)
        time->tv_sec += g_clockJump_s;
    return code;
}

namespace bask::test {
namespace {

/// A file system of its own that is soon full.
class SmallDisk {
public:
    SmallDisk() : isThere(::mount("tmpfs", path().c_str(), "tmpfs", 0, "size=1m") == 0), reason(errno) {}
    ~SmallDisk() {
        if (isThere)
            ::umount2(path().c_str(), MNT_DETACH);
    }
    std::string path() const { return m_folder.path().toStdString(); }
    void fill() const {
        QFile file(filler());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        const QByteArray page(4096, 'x');
        while (file.write(page) == page.size())
            ;
    }
    void clear() const { ASSERT_TRUE(QFile::remove(filler())); }

private:
    QString filler() const { return m_folder.filePath(QStringLiteral("filler")); }
    QTemporaryDir m_folder;

public:
    const bool isThere;
    const int reason;
};

class LiveComputerFaults : public LiveFaults {
protected:
    double longestGap_s(std::size_t from) const {
        double gap_s = 0.0;
        for (std::size_t i = from + 1; i < live.samples.size(); ++i)
            gap_s = std::max(gap_s, live.samples[i].time_s - live.samples[i - 1].time_s);
        return gap_s;
    }
};

} // namespace

// Catches a run that goes on unrecorded, one that is begun where there is no room, an engine that the full
// disk takes along, and a recording that cannot be read any more.
TEST_F(LiveComputerFaults, aFullDiskEndsTheRunAndLeavesItsRecording) {
    const SmallDisk disk;
    if (!disk.isThere)
        GTEST_SKIP() << "no file system can be mounted here (" << std::strerror(disk.reason)
                     << "); try it under unshare -rm";
    startBench();
    Experiment small = read();
    load(small);
    ASSERT_NO_FATAL_FAILURE(beReady());
    live.send(Arm{disk.path() + "/run.bask"});
    EXPECT_TRUE(waitFor([&] { return live.refusal.code == MessageCode::SafetyDiskLow; }))
        << "1 MB is less than the 100 MB it wants";
    EXPECT_EQ(live.last.state, RunState::Ready);

    small.safety.minDisk_MB = 0.0;
    load(small);
    ASSERT_NO_FATAL_FAILURE(beReady());
    const std::string path = disk.path() + "/run.bask";
    live.send(Arm{path});
    ASSERT_TRUE(reaches(RunState::Armed)) << describe(live.refusal);
    live.send(Start{true});
    ASSERT_TRUE(waitFor([&] { return state().isHeating && live.last.runTime_s > 3.0; })) << reasons();
    ASSERT_NO_FATAL_FAILURE(makeMove());
    const double full_s = live.last.runTime_s;
    const Reaction seen = raise("disk full", [&] { disk.fill(); },
                                {MessageCode::ReasonRecorderFailed, "recording failed", 3000.0});
    EXPECT_TRUE(live.last.state == RunState::Stopping || live.last.state == RunState::Fault) << reasons();
    EXPECT_GE(seen.off_ms, 0.0);
    EXPECT_LE(seen.off_ms - seen.told_ms, 500.0);
    ASSERT_TRUE(reaches(RunState::Fault, 40000)) << reasons();
    EXPECT_GT(state().place_m.z(), kAway_m) << "taken away: the engine has kept control";
    const auto expectReadable = [&] {
        const auto record = readSession(path);
        ASSERT_TRUE(record) << describe(record.error());
        EXPECT_TRUE(record->interrupted());
        ASSERT_FALSE(record->samples.empty());
        EXPECT_GT(record->samples.back().time_s, full_s - 1.5) << "all but the last second";
    };
    expectReadable();
    disk.clear();
    expectReadable();
    ASSERT_NO_FATAL_FAILURE(begin()) << "elsewhere it goes on";
    live.send(Stop{});
    ASSERT_TRUE(reaches(RunState::Stopped, 40000)) << reasons();
}

// Catches an engine that tells time by the clock on the wall: readings that are old or of the future, a loop
// that waits for an hour, a watchdog that is not fed.
TEST_F(LiveComputerFaults, aClockThatIsSetChangesNothing) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(begin());
    for (const std::time_t jump_s : {3600, -3600}) {
        const std::size_t from = live.samples.size();
        const auto before = std::chrono::system_clock::now();
        g_clockJump_s = jump_s;
        EXPECT_GE(std::abs(std::chrono::duration<double>(std::chrono::system_clock::now() - before).count()),
                  3500.0)
            << "the test itself";
        ASSERT_NO_FATAL_FAILURE(makeMove());
        ASSERT_TRUE(waitFor([&] { return live.samples.size() > from + 60; }, 15000)) << reasons();
        EXPECT_LT(longestGap_s(from), 1.0);
        EXPECT_TRUE(std::ranges::none_of(live.last.alarms, [](const Alarm& a) {
            return a.isActive && !isNotice(a.message.code);
        })) << reasons();
        EXPECT_EQ(live.last.state, RunState::Running) << reasons();
        EXPECT_TRUE(state().isHeating);
    }
    g_clockJump_s = 0;
    live.send(Stop{});
    ASSERT_TRUE(reaches(RunState::Stopped, 40000)) << reasons();
    ASSERT_TRUE(isClosed());
    const auto record = readSession(lastRecording());
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_EQ(record->outcome, "stopped");
}

// This thread is the window's. Catches a control loop, a recording or a safety reaction that waits for it.
TEST_F(LiveComputerFaults, aWindowThatHangsLeavesControlAndSafetyAlone) {
    constexpr double kHung_s = 4.0, kFaultAfter_s = 2.0;
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(begin());
    const std::size_t from = live.samples.size() - 1;
    const double hung_s = live.last.runTime_s;
    const SteadyClock clock;
    const double began_s = clock.now_s();
    bool isRaised = false;
    double fault_s = 0.0;
    while (clock.now_s() < began_s + kHung_s) {
        ::usleep(10000);
        if (isRaised || clock.now_s() < began_s + kFaultAfter_s)
            continue;
        isRaised = true;
        bench.write("thermometer short\n");
        ASSERT_TRUE(bench.waitForBytesWritten(1000));
        fault_s = hung_s + clock.now_s() - began_s;
    }
    EXPECT_LT(live.last.runTime_s, hung_s + 0.1) << "nothing has come meanwhile";
    ASSERT_TRUE(waitFor([&] { return live.last.runTime_s > hung_s + kHung_s; })) << reasons();
    EXPECT_EQ(live.last.state, RunState::Holding) << reasons();
    EXPECT_GE(live.samples.size() - from, static_cast<std::size_t>(0.9 * kHung_s / 0.1));
    EXPECT_LT(longestGap_s(from), 1.0);
    live.send(Stop{});
    ASSERT_TRUE(reaches(RunState::Stopped, 40000)) << reasons();
    ASSERT_TRUE(isClosed());
    const auto record = readSession(lastRecording());
    ASSERT_TRUE(record) << describe(record.error());
    const auto told = std::ranges::find_if(record->events, [](const TraceEvent& event) {
        return event.message.code == MessageCode::SafetySensorShort;
    });
    ASSERT_NE(told, record->events.end());
    EXPECT_LT(told->time_s - fault_s, 1.0);
    std::printf("| window hangs, sensor shorted: held after %.0f ms\n", 1e3 * (told->time_s - fault_s));
}

} // namespace bask::test
