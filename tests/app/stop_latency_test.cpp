// From a verb or a fault to the bytes that switch the heat off at the far end of the wire, while disk,
// window, camera and processor are in trouble. The short form runs in CI, the long one by hand
// (docs/safety.md).

#include "tests/app/hogs.h"
#include "tests/app/live_faults.h"
#include "tests/support/hold_up_watch.h"
#include "tests/support/hung_disk.h"

#include <QProcessEnvironment>

#include <cmath>
#include <fcntl.h>

#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace bask::test {
namespace {

constexpr double kAllowed_ms = 100.0, kMost_ms = 250.0; ///< 99.9 % of them, each

/// What is wrong meanwhile.
struct Trouble {
    const char* name;
    unsigned calls = 0; ///< of HungDisk
    int hogs = 0;
};

constexpr Trouble kTroubles[] = {
    {"nothing"},
    {"fsync hangs", kSync},
    {"write hangs", kWrite},
    {"statvfs hangs", kSpace},
    {"open hangs", kOpen},
    {"dead network mount", kAll},
    {"disk full", kFull},
    {"two busy threads", 0, 2},
    {"dead mount, two busy threads", kAll, 2},
};

class StopLatency : public LiveFaults {
protected:
    StopLatency() : LiveFaults(true) {
        m_machine.begin();
        hungDisk().exempt = static_cast<int>(::syscall(SYS_gettid));
    }
    ~StopLatency() override { hungDisk().release(); }

    static double now_s() { return SteadyClock().now_s(); }
    void hang(unsigned calls) const { hungDisk().hang(calls, files()); }

    /// A run that is recorded, whose heat is on. A busy machine's devices may end one before.
    void beginRun() {
        ASSERT_TRUE(waitFor([&] {
            if (live.last.state != RunState::Armed) {
                beReady();
                live.send(Arm{recording()});
            }
            if (!reaches(RunState::Armed))
                return false;
            live.send(Start{true});
            return reaches(RunState::Running) && comesInRun([&] { return state().isHeating; });
        })) << reasons();
    }
    void heatByHand() {
        ASSERT_TRUE(waitFor([&] {
            if (!live.last.isPlaceSure)
                live.send(ClearRobotAlarm{});
            if (live.last.state == RunState::Fault)
                live.send(Reset{});
            else if (!live.last.heatSetPoint_K)
                live.send(SetHeat{kelvinFromCelsius(60.0)});
            return state().isHeating;
        })) << reasons();
    }
    /// From `since_s` to the bytes on the wire, once the heat is off at the far end, too: a pseudo-terminal
    /// of a busy machine brings them there when a worker of the kernel's finds time.
    void note(double since_s, const HungDisk& program = hungDisk()) {
        std::optional<double> off;
        ASSERT_TRUE(waitFor([&] { return (off = off_s()).has_value(); }, 40000)) << reasons();
        ASSERT_GT(program.written_s, 0.0) << "the test itself";
        delays_ms.push_back(1e3 * (program.written_s - since_s));
        arrivals_ms.push_back(1e3 * (*off - since_s));
    }
    /// The time from which on the next order to switch off counts.
    double begun_s(HungDisk& program = hungDisk()) const {
        program.watchFor(m_off);
        return now_s();
    }
    /// Instead of the hotplate: a controller with registers. Before the bench is started.
    void makeHeaterModbus() {
        QFile file(experiment());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        QByteArray text = file.readAll();
        file.close();
        text.replace("\"driver\": \"namur\"",
                     "\"driver\": \"modbus\", \"unit\": 2, \"profile\": \"pixsys-drr245\"");
        text.replace("\"data_bits\": 7", "\"data_bits\": 8").replace("\"even\"", "\"none\"");
        ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        m_off = "\x02\x06\x03\xf8"; // unit 2 writes register 1016, which holds "on" by then
    }
    void measure(const Command& verb) {
        const double from_s = begun_s();
        live.post(verb);
        ASSERT_NO_FATAL_FAILURE(note(from_s));
    }
    void runAndEnd(const Trouble& trouble, const Command& verb) {
        ASSERT_NO_FATAL_FAILURE(beginRun());
        const Hogs busy(trouble.hogs);
        hang(trouble.calls);
        if ((trouble.calls & (kSync | kWrite | kFull)) != 0) {
            ASSERT_TRUE(waitFor([&] { return hungDisk().held > 0; })) << trouble.name << ": the test itself";
        }
        ASSERT_NO_FATAL_FAILURE(measure(verb)) << trouble.name;
        hungDisk().release();
    }
    /// Tells them and judges them.
    void expectSoon(const char* what) {
        std::ranges::sort(delays_ms);
        const auto at = [&](double share) {
            const double n = static_cast<double>(delays_ms.size());
            return delays_ms.at(static_cast<std::size_t>(std::max(0.0, std::ceil(share * n) - 1.0)));
        };
        std::printf("| %s: off after %.1f ms (median), %.1f ms (99.9 %%), %.1f ms (most) of %zu\n", what,
                    at(0.5), at(0.999), delays_ms.back(), delays_ms.size());
        std::printf("|   at the far end: after %.1f ms (most)\n", *std::ranges::max_element(arrivals_ms));
        allArrivals_ms.insert(allArrivals_ms.end(), arrivals_ms.begin(), arrivals_ms.end());
        arrivals_ms.clear();
        const HoldUp machine = m_machine.seen();
        m_machine.begin();
        std::printf("|   a bare thread meanwhile: late by %.1f ms (most); taken by the host: %.0f %%\n",
                    1e3 * machine.late_s, 100.0 * machine.stolenShare);
        std::fflush(stdout);
        EXPECT_LE(at(0.999), kAllowed_ms) << what;
        EXPECT_LE(delays_ms.back(), kMost_ms) << what;
        EXPECT_GE(delays_ms.front(), 0.0) << "the test itself";
        all_ms.insert(all_ms.end(), delays_ms.begin(), delays_ms.end());
        delays_ms.clear();
    }

    std::vector<double> delays_ms, arrivals_ms, all_ms, allArrivals_ms;

private:
    std::string m_off = "STOP_1";
    HoldUpWatch m_machine;
};

} // namespace

// Catches a STOP that waits for the recorder, the alarms' file or the room on the disk.
TEST_F(StopLatency, ofARunWhoseDiskHangs) {
    startBench();
    load(read());
    for (const Trouble& trouble : {kTroubles[1], kTroubles[2], kTroubles[5]})
        ASSERT_NO_FATAL_FAILURE(runAndEnd(trouble, EmergencyStop{}));
    expectSoon("STOP of a run");
}

// Catches a fault whose heat goes off after the recorder has been waited for, or not before the window
// answers: this thread is the window's, and hangs.
TEST_F(StopLatency, ofAFaultWhileWindowAndDiskHang) {
    startBench();
    load(read());
    ASSERT_NO_FATAL_FAILURE(beginRun());
    const double began_s = live.last.clock_s - live.last.runTime_s;
    hang(kAll);
    (void)begun_s();
    bench.write("robot alarm\n");
    ASSERT_TRUE(bench.waitForBytesWritten(1000));
    std::this_thread::sleep_for(std::chrono::seconds(3));
    ASSERT_TRUE(waitFor([&] { return live.last.state == RunState::Fault; }, 5000)) << reasons();
    hungDisk().release();
    const auto told = std::ranges::find(live.events, MessageCode::RobotAlarm,
                                        [](const TraceEvent& event) { return event.message.code; });
    ASSERT_NE(told, live.events.end());
    ASSERT_NO_FATAL_FAILURE(note(began_s + told->time_s));
    EXPECT_GT(delays_ms.front(), -2.0) << "the test itself";
    delays_ms.front() = std::max(0.0, delays_ms.front());
    expectSoon("a halt, from where it is found");
}

// Catches heat that waits for a camera to be closed, for an edit's files, and for the engine's end.
TEST_F(StopLatency, ofHeatByHandBehindACameraAnEditAndTheEnd) {
    const std::string fifo = files() + "/camera";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    startBench();
    const Experiment experiment = read();
    load(experiment);
    for (int i = 0; i < 3; ++i) {
        ASSERT_NO_FATAL_FAILURE(heatByHand());
        live.send(WatchCamera{true, {}});
        live.send(ChooseCamera{fifo});
        ASSERT_TRUE(waitFor([&] { return live.last.heat == HeatState::On; }));
        const double from_s = begun_s();
        live.post(ChooseCamera{});
        live.post(SetHeat{});
        ASSERT_NO_FATAL_FAILURE(note(from_s));
    }
    ASSERT_NO_FATAL_FAILURE(heatByHand());
    const std::uint64_t loadId = live.last.loadId;
    hang(kAll);
    ASSERT_NO_FATAL_FAILURE(measure(LoadExperiment{experiment}));
    ASSERT_TRUE(waitFor([&] { return live.last.loadId > loadId; }));
    hungDisk().release();
    ASSERT_NO_FATAL_FAILURE(beginRun());
    hang(kAll);
    const double from_s = begun_s();
    live.shutDown();
    EXPECT_LT(now_s() - from_s, 8.0) << "it does not wait for the disk for ever";
    ASSERT_NO_FATAL_FAILURE(note(from_s));
    expectSoon("camera, edit and end");
}

/// A program of its own, under a disk that hangs.
TEST_F(StopLatency, ofSignalsToTheProgram) {
    QFile shared(QString::fromStdString(files() + "/hung"));
    ASSERT_TRUE(shared.open(QIODevice::ReadWrite) && shared.resize(sizeof(HungDisk)));
    auto* const disk = reinterpret_cast<HungDisk*>(shared.map(0, sizeof(HungDisk)));
    ASSERT_NE(disk, nullptr);
    startBench();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LD_PRELOAD"), QStringLiteral(BASK_HUNG_DISK_LIBRARY));
    environment.insert(QStringLiteral("BASK_HUNG_DISK"), shared.fileName());
    engine.setProcessEnvironment(environment);
    for (const int number : {SIGINT, SIGTERM}) {
        startEngine();
        ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
        disk->hang(kAll, QFileInfo(session()).path().toStdString());
        ASSERT_TRUE(waitFor([&] { return disk->held > 0; })) << "the test itself";
        const double from_s = begun_s(*disk);
        sendSignal(engine, number);
        ASSERT_NO_FATAL_FAILURE(note(from_s, *disk));
        sendSignal(engine, number); // no retreat
        const auto code = ended(20000);
        const std::string output = engine.readAll().toStdString();
        ASSERT_TRUE(code) << "it waits for the disk: " << output;
        EXPECT_NE(output.find("not saved"), std::string::npos) << output;
        disk->release();
    }
    expectSoon("signals");
}

// Catches an off that a question under way holds up on a line of Modbus; it is to be at the device in time.
TEST_F(StopLatency, ofAModbusHeater) {
    ASSERT_NO_FATAL_FAILURE(makeHeaterModbus());
    startBench();
    load(read());
    for (const Trouble& trouble : {kTroubles[0], kTroubles[5]})
        for (int i = 0; i < 10; ++i) {
            hungDisk().release();
            ASSERT_NO_FATAL_FAILURE(heatByHand());
            hang(trouble.calls);
            ASSERT_NO_FATAL_FAILURE(measure(i % 2 == 0 ? Command(EmergencyStop{}) : Command(SetHeat{})));
        }
    hungDisk().release();
    EXPECT_LE(*std::ranges::max_element(arrivals_ms), kMost_ms) << "at the far end";
    expectSoon("a Modbus heater");
}

// Without its guard the port is Bask's own. Catches a heater that goes on after that was killed.
TEST_F(StopLatency, ofAModbusHeaterWhoseGuardIsKilled) {
    constexpr double kTakenBack_ms = 1500.0;
    ASSERT_NO_FATAL_FAILURE(makeHeaterModbus());
    startBench();
    load(read());
    for (int i = 0; i < 3; ++i) {
        ASSERT_NO_FATAL_FAILURE(heatByHand());
        const double from_s = begun_s();
        endGuardsOf(QFileInfo(experiment()).path());
        ASSERT_NO_FATAL_FAILURE(note(from_s));
    }
    std::printf("| guard killed: off at the far end after %.0f ms (most)\n",
                *std::ranges::max_element(arrivals_ms));
    EXPECT_LE(*std::ranges::max_element(arrivals_ms), kTakenBack_ms);
}

// Every verb with every trouble, a thousand times in all.
TEST_F(StopLatency, thousandTimes) {
    startBench();
    load(read());
    for (const Trouble& trouble : kTroubles) {
        for (int i = 0; i < 6; ++i)
            ASSERT_NO_FATAL_FAILURE(
                runAndEnd(trouble, i % 2 == 0 ? Command(EmergencyStop{}) : Command(SetHeat{})));
        const Hogs busy(trouble.hogs);
        for (int i = 0; i < 110; ++i) {
            hungDisk().release();
            ASSERT_NO_FATAL_FAILURE(heatByHand());
            hang(trouble.calls);
            ASSERT_NO_FATAL_FAILURE(measure(i % 2 == 0 ? Command(EmergencyStop{}) : Command(SetHeat{})));
        }
        hungDisk().release();
        expectSoon(trouble.name);
    }
    delays_ms = std::exchange(all_ms, {});
    arrivals_ms = std::exchange(allArrivals_ms, {});
    expectSoon("all of them");
}

} // namespace bask::test
