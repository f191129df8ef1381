#pragma once
// A run on a real rig's drivers in this process, over three serial ports, against a simulated rig in a
// process of its own: faults are raised there, and what is done is read there.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"
#include "engine/runtime/engine_worker.h"
#include "engine/runtime/lateness.h"
#include "tests/app/rig_processes.h"

#include <QDir>
#include <QFileInfo>
#include <QThread>

#include <algorithm>
#include <cstdio>

namespace bask::test {

/// In memory where there is such a place: a busy disk would hold the engine, or what it talks to, up.
inline QString folderInMemory() {
    return (QFileInfo(QStringLiteral("/dev/shm")).isWritable() ? QStringLiteral("/dev/shm")
                                                               : QDir::tempPath()) +
           QStringLiteral("/bask-XXXXXX");
}

/// The engine on its thread, with everything it told.
class LiveEngine : public QObject {
public:
    explicit LiveEngine(const std::string& alarmFile = {}) : m_worker(alarmFile) {
        m_worker.moveToThread(&m_thread);
        connect(&m_thread, &QThread::started, &m_worker, &EngineWorker::start);
        connect(&m_worker, &EngineWorker::published, this, [this](const Snapshot& snapshot) {
            last = snapshot;
            std::ranges::copy(snapshot.newSamples, std::back_inserter(samples));
            std::ranges::copy(snapshot.newEvents, std::back_inserter(events));
            if (snapshot.refusal.code != MessageCode::None)
                refusal = snapshot.refusal;
        });
        connect(&m_worker, &EngineWorker::stepped, this, [this](double late_s) { lateness.add(late_s); });
        m_thread.start();
    }
    ~LiveEngine() override {
        shutDown();
        m_thread.quit();
        m_thread.wait();
    }
    /// Goes on at once.
    void post(const Command& command) {
        QMetaObject::invokeMethod(&m_worker, [this, command] { m_worker.post(command); });
    }
    template <class Work>
    requires std::is_invocable_v<Work>
    void post(Work work) { QMetaObject::invokeMethod(&m_worker, std::move(work)); }
    /// On the engine's thread; waits for it.
    template <class Work> void ask(Work work) {
        QMetaObject::invokeMethod(&m_worker, std::move(work), Qt::BlockingQueuedConnection);
    }
    void shutDown() {
        QMetaObject::invokeMethod(&m_worker, &EngineWorker::shutdown, Qt::BlockingQueuedConnection);
    }
    /// `receiver`, which lives on a thread of its own, is told as well, and holds what it has not taken.
    void tellToo(QObject& receiver) {
        connect(&m_worker, &EngineWorker::published, &receiver,
                [](const Snapshot&, const std::shared_ptr<const int>&) {});
    }
    /// Waits until it is done; `refusal` is of this command then.
    void send(const Command& command) {
        QCoreApplication::processEvents();
        refusal = {};
        QMetaObject::invokeMethod(
            &m_worker, [this, command] { m_worker.post(command); }, Qt::BlockingQueuedConnection);
        QCoreApplication::processEvents();
    }
    const Alarm* alarm(MessageCode code) const {
        const auto it = std::ranges::find_if(
            last.alarms, [&](const Alarm& a) { return a.isActive && a.message.code == code; });
        return it == last.alarms.end() ? nullptr : &*it;
    }

    Snapshot last;
    Message refusal;
    std::vector<TraceSample> samples;
    std::vector<TraceEvent> events;
    Lateness lateness; ///< of the control steps

private:
    QThread m_thread;
    EngineWorker m_worker;
};

/// What a fault is to be told as, and how soon.
struct ToldAs {
    MessageCode code;
    const char* words; ///< in its sentence
    double within_ms = 1000.0;
};

/// What was done about a fault: ms from before it was raised.
struct Reaction {
    double told_ms = -1.0;
    double off_ms = -1.0;  ///< the bench's heat is off; -1: still on
    double moved_ms = 0.0; ///< the bench's robot moved last
    double moved_m = 0.0;  ///< and so far since the fault
    double rose_ms = -1.0; ///< it was seen to have risen by 2 mm
    std::string sentence;
};

class LiveFaults : public RigProcesses {
protected:
    explicit LiveFaults(bool keepsAlarms = false) : live(keepsAlarms ? files() + "/alarms.json" : "") {}

    static constexpr double kReaction_ms = 1000.0; ///< the most, of motion and of heat
    static constexpr double kNear_m = 0.17;        ///< to the plate; the retreat ends at 0.2

    /// The bench's, as far as the engine is concerned.
    Experiment read() const {
        Experiment out = readExperiment(experiment().toStdString()).value();
        out.safety.stalePeriods = 5.0; // a busy machine is no fault
        out.safety.pauseLimit_s = 8.0;
        out.safety.frozen_s = 5.0;
        out.safety.sourceHeating_s = 10.0;
        return out;
    }
    void load(const Experiment& loaded) {
        m_targets_K = {loaded.objects.front().target_K - 4.0, loaded.objects.front().target_K + 4.0};
        live.send(LoadExperiment{loaded});
        if (!m_isLoaded) { // an edit that leaves the devices as they are asks for no reset
            ASSERT_EQ(live.last.state, RunState::Fault) << "until a person resets it";
        }
        m_isLoaded = true;
    }
    /// A fault is not waited out: nothing ends it but a person.
    bool reaches(RunState state, int limit_ms = 20000) {
        (void)waitFor([&] { return live.last.state == state || live.last.state == RunState::Fault; },
                      limit_ms);
        return live.last.state == state;
    }
    template <class Condition> bool comesInRun(Condition condition) {
        return waitFor([&] {
                   resumeIfWell();
                   return live.last.state == RunState::Fault || condition();
               }) &&
               live.last.state != RunState::Fault;
    }
    /// As often as a busy machine's devices are late.
    void beReady() {
        ASSERT_TRUE(waitFor([&] {
            if (!live.last.isPlaceSure) // as a person would who has looked
                live.send(ClearRobotAlarm{});
            if (live.last.state == RunState::Fault)
                live.send(Reset{});
            return live.last.state == RunState::Ready || live.last.state == RunState::Stopped;
        })) << reasons();
    }
    void home() {
        ASSERT_TRUE(waitFor([&] { // a robot that has just been found tells its state first
            live.refusal = {};
            live.send(HomeRobot{});
            return live.refusal.code == MessageCode::None;
        })) << describe(live.refusal);
        ASSERT_TRUE(waitFor([&] { return live.last.isPlaceSure; }));
    }
    /// A new run, up to a robot that moves before a hot plate.
    void begin() {
        ASSERT_NO_FATAL_FAILURE(beReady());
        live.send(Arm{recording(), true});
        ASSERT_TRUE(reaches(RunState::Armed)) << describe(live.refusal);
        ASSERT_TRUE(waitFor([&] { // a busy machine's readings may not be fresh at once
            if (live.last.state == RunState::Armed)
                live.send(Start{true});
            return live.last.state == RunState::Running;
        })) << describe(live.refusal);
        ASSERT_TRUE(comesInRun([&] { return state().isHeating && state().place_m.z() < kNear_m; }))
            << reasons();
        ASSERT_NO_FATAL_FAILURE(makeMove());
    }
    /// Other targets: the robot is on its way to them.
    void makeMove() {
        std::swap(m_targets_K[0], m_targets_K[1]);
        live.send(SetTargets{std::vector<double>(live.last.targets_K.size(), m_targets_K[0])});
        const Eigen::Vector3d from_m = state().place_m;
        ASSERT_TRUE(comesInRun([&] {
            return live.last.state == RunState::Running && (state().place_m - from_m).norm() > 1e-3;
        })) << reasons();
    }
    /// A run is held where the machine is too busy.
    void resumeIfWell() {
        if (live.last.state == RunState::Holding && isWell())
            live.send(Resume{});
    }
    bool isWell() const {
        return std::ranges::none_of(live.last.alarms,
                                    [](const Alarm& a) { return a.isActive && a.priority == 1; }) &&
               std::ranges::all_of(live.last.latest.objects, &ObjectSample::valid);
    }
    std::string recording() {
        return m_recordings.filePath(QStringLiteral("%1.bask").arg(++m_runs)).toStdString();
    }
    /// Where recordings are, and the alarms where they are kept.
    std::string files() const { return m_recordings.path().toStdString(); }
    std::string lastRecording() const {
        return m_recordings.filePath(QStringLiteral("%1.bask").arg(m_runs)).toStdString();
    }
    std::string reasons() const {
        std::string out = runStateName(live.last.state);
        for (const Message& reason : live.last.reasons)
            out += " | " + describe(reason);
        return out;
    }

    /// Raises it and looks at the bench until it is told and then `after_ms` longer.
    template <class Raise>
    Reaction raise(const char* name, Raise raiseIt, const ToldAs& as, int after_ms = 1200) {
        Reaction out;
        const BenchState before = state();
        Eigen::Vector3d place_m = before.place_m;
        double lowest_m = before.place_m.z();
        const double run_s = live.last.runTime_s;
        QElapsedTimer since;
        since.start();
        const auto now_ms = [&] { return 1e-6 * static_cast<double>(since.nsecsElapsed()); };
        raiseIt();
        const double latest_ms = as.within_ms + 5000.0;
        while (now_ms() < (out.told_ms < 0.0 ? latest_ms : out.told_ms + after_ms)) {
            QCoreApplication::processEvents();
            if (const Alarm* alarm = live.alarm(as.code); alarm && out.told_ms < 0.0) {
                out.told_ms = now_ms();
                out.sentence = describe(alarm->message);
            }
            if (bench.state() != QProcess::Running || m_isBenchStopped) {
                QThread::msleep(2);
                continue;
            }
            const BenchState now = state();
            if (now.objects_degC.empty())
                continue;
            if (now.place_m != place_m)
                out.moved_ms = now_ms();
            place_m = now.place_m;
            out.moved_m = (place_m - before.place_m).norm();
            lowest_m = std::min(lowest_m, place_m.z());
            if (out.rose_ms < 0.0 && place_m.z() > lowest_m + 2e-3)
                out.rose_ms = now_ms();
            if (out.off_ms < 0.0 && !now.isHeating)
                out.off_ms = now_ms();
        }
        EXPECT_GE(out.told_ms, 0.0) << name << ": " << reasons();
        EXPECT_LE(out.told_ms, as.within_ms) << name;
        EXPECT_NE(out.sentence.find(as.words), std::string::npos) << name << ": " << out.sentence;
        std::printf("| %-28s | %-16s | %6.0f | %6.0f | %6.0f | %5.1f |\n", name, messageName(as.code),
                    out.told_ms, out.moved_ms, out.off_ms, 1e3 * out.moved_m);
        std::fflush(stdout);
        m_expected.push_back({as, name, run_s});
        return out;
    }
    Reaction raise(const char* fault, const ToldAs& as, int after_ms = 1200) {
        return raise(
            fault, [&] { tell(fault); }, as, after_ms);
    }
    /// The recording of the run that has ended; after a fault it would go on until all is cold.
    bool isClosed() {
        if (live.last.state == RunState::Fault)
            live.send(EndRecording{});
        return waitFor([&] { return live.last.recordingPath.empty(); });
    }
    /// The recording of the run has all that was told since the last look at one, in time.
    void expectRecorded(const std::string& outcome) {
        ASSERT_TRUE(isClosed());
        const auto record = readSession(lastRecording());
        ASSERT_TRUE(record) << describe(record.error());
        EXPECT_EQ(record->outcome, outcome);
        for (const auto& [as, name, run_s] : std::exchange(m_expected, {})) {
            const bool isThere = std::ranges::any_of(
                record->events, [&, from_s = run_s, code = as.code,
                                 by_s = run_s + 1e-3 * as.within_ms + 0.5](const TraceEvent& e) {
                    // An alarm is recorded as it was raised: a port is lost before it cannot be opened again.
                    const bool isThis = e.message.code == code || (code == MessageCode::LinkNotOpened &&
                                                                   e.message.code == MessageCode::LinkLost);
                    return isThis && e.time_s > from_s - 0.2 && e.time_s < by_s;
                });
            EXPECT_TRUE(isThere) << name << " is not in the record";
        }
    }

    /// What went over the three links is in the record, from before the run on.
    void expectTraffic() {
        const auto store = SessionStore::open(lastRecording());
        ASSERT_TRUE(store) << describe(store.error());
        std::vector<double> row;
        const auto take = [&](SessionStore::Row columns) {
            for (const SqlValue& value : columns)
                row.push_back(numberOf(value));
        };
        const auto read = (*store)->select("SELECT min(time_s) < 0, max(time_s) > 0, "
                                           "count(DISTINCT link), count(DISTINCT kind) >= 3 FROM traffic",
                                           take);
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(row, (std::vector{1.0, 1.0, 3.0, 1.0})) << "opened, sent, received";
    }

    bool m_isBenchStopped = false;

private:
    QTemporaryDir m_recordings{folderInMemory()};

protected:
    bool m_isLoaded = false;
    LiveEngine live;

private:
    struct Expected {
        ToldAs as;
        std::string name;
        double run_s; ///< when it was raised
    };
    std::array<double, 2> m_targets_K{};
    int m_runs = 0;
    std::vector<Expected> m_expected;
};

} // namespace bask::test
