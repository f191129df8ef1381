// A run over three programs in Python: the shipped simulated devices, whose world is a folder of this test.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/drivers/program_files.h"
#include "engine/recording/session_file.h"
#include "tests/app/live_faults.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <csignal>

namespace bask::test {
namespace {

constexpr std::array kRoles{"robot", "thermometer", "heater"};

class LiveProgramsTest : public testing::Test {
protected:
    LiveProgramsTest() { write("velocity"); }
    ~LiveProgramsTest() override {
        engine.kill();
        engine.waitForFinished();
        for (const char* role : kRoles)
            if (const auto pid = pidOf(role))
                ::kill(pid, SIGKILL);
    }

    QString experiment() const { return m_folder.filePath(QStringLiteral("rig.json")); }
    QString session() const { return m_folder.filePath(QStringLiteral("run.bask")); }
    QString command(const char* role, const char* moves) const {
        return QStringLiteral("python3 \"%1\" --role %2 --world %3 --experiment %4 --moves %5")
            .arg(QStringLiteral(BASK_PROGRAM_DRIVERS "/simulated_devices.py"), QLatin1String(role),
                 m_folder.filePath(QStringLiteral("world")), experiment(), QLatin1String(moves));
    }
    void write(const char* moves) const {
        QFile source(QStringLiteral(BASK_PROGRAM_DRIVERS "/simulated_rig.json"));
        ASSERT_TRUE(source.open(QIODevice::ReadOnly));
        QJsonObject root = QJsonDocument::fromJson(source.readAll()).object();
        QJsonObject rig = root["rig"].toObject();
        for (const auto& [key, role] :
             {std::pair("robot", "robot"), {"thermometer", "thermometer"}, {"source", "heater"}}) {
            QJsonObject device = rig[QLatin1String(key)].toObject();
            EXPECT_TRUE(device["command"].toString().startsWith("python3 simulated_devices.py --role "));
            device["command"] = command(role, moves);
            rig[QLatin1String(key)] = device;
        }
        root["rig"] = rig;
        QFile file(experiment());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(root).toJson()) > 0);
    }
    /// What is truly so; null: nothing is told.
    QJsonValue world(const char* name) const {
        QFile file(m_folder.filePath(QStringLiteral("world/") + QLatin1String(name)));
        if (!file.open(QIODevice::ReadOnly))
            return {};
        return QJsonDocument::fromJson('[' + file.readAll() + ']').array().at(0);
    }
    pid_t pidOf(const char* role) const {
        const QByteArray own = m_folder.filePath(QStringLiteral("world")).toUtf8();
        for (const QString& entry : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs)) {
            QFile file(QStringLiteral("/proc/%1/cmdline").arg(entry));
            if (entry.toInt() <= 0 || !file.open(QIODevice::ReadOnly))
                continue;
            const QList<QByteArray> words = file.readAll().split('\0');
            if (words.contains(own) && words.contains(role) && words.at(0).contains("python3"))
                return entry.toInt();
        }
        return 0;
    }
    bool areGone() const {
        return std::ranges::none_of(kRoles, [this](const char* role) { return pidOf(role) != 0; });
    }
    void startBask(const QStringList& more) {
        engine.setProcessChannelMode(QProcess::MergedChannels);
        engine.start(QStringLiteral(BASK_PROGRAM),
                     QStringList{QStringLiteral("run"), QStringLiteral("--live"),
                                 QStringLiteral("--accept-limits"), experiment(),
                                 QStringLiteral("--overwrite"), QStringLiteral("-o"), session()} +
                         more);
        ASSERT_TRUE(engine.waitForStarted());
    }
    bool isHot() const { return world("plate").toDouble() > kelvinFromCelsius(150.0); }

    QTemporaryDir m_folder{folderInMemory()};
    QProcess engine;
};

} // namespace

// Catches an arm of six axes behind a program by which an experiment does not come to its end.
TEST_F(LiveProgramsTest, threeDisksSettle) {
    for (const char* moves : {"velocity", "steps"}) {
        write(moves);
        startBask({QStringLiteral("--allow-program"), QStringLiteral("--duration"), QStringLiteral("90")});
        ASSERT_TRUE(waitFor([&] { return engine.state() == QProcess::NotRunning; }, 240000));
        const QByteArray said = engine.readAll();
        EXPECT_EQ(engine.exitCode(), 0) << moves << ": " << said.toStdString();
        std::printf("%s", said.constData());
        for (const QJsonValue object : world("objects").toArray())
            EXPECT_LT(object.toDouble(), kelvinFromCelsius(45.0));
        const auto record = readSession(session().toStdString());
        ASSERT_TRUE(record) << describe(record.error());
        EXPECT_EQ(record->outcome, "settled");
        EXPECT_GT(world("robot").toArray().at(2).toDouble(), 0.19) << "it has taken them away";
        EXPECT_TRUE(areGone());
    }
}

// Catches an experiment from elsewhere that starts programs, and one that waits for ever for them.
TEST_F(LiveProgramsTest, areNotStartedBeforeTheyAreConfirmed) {
    qputenv("BASK_SETTINGS_DIR", m_folder.path().toUtf8());
    startBask({});
    ASSERT_TRUE(waitFor([&] { return engine.state() == QProcess::NotRunning; }, 30000));
    EXPECT_EQ(engine.exitCode(), 2);
    EXPECT_NE(engine.readAll().indexOf("was not confirmed on this computer"), -1);
    EXPECT_FALSE(QFile::exists(m_folder.filePath(QStringLiteral("world")))) << "nothing has run";
}

// Catches a program that babbles 1 MB/s and holds the control loop up, or is not told.
TEST_F(LiveProgramsTest, aBabblerDoesNotHoldTheLoopUp) {
    const QString script = m_folder.filePath(QStringLiteral("babbler.py"));
    QFile file(script);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("import json, sys, time\n"
               "json.loads(sys.stdin.readline())\n"
               "while True:\n"
               "    sys.stdout.write(10 * ('x' * 999 + '\\n'))\n"
               "    sys.stdout.flush()\n"
               "    time.sleep(0.01)\n");
    file.close();
    Experiment experiment = readExperiment(this->experiment().toStdString()).value();
    experiment.rig->thermometer->port = "python3 " + script.toStdString();
    const auto lateness = [&](bool isBabbling) {
        LiveEngine live;
        Experiment used = experiment;
        if (!isBabbling)
            used.rig->thermometer.reset();
        for (const std::string& command : {used.rig->robot->port, used.rig->source->port,
                                           used.rig->thermometer ? used.rig->thermometer->port : ""})
            if (!command.empty())
                live.send(ConfirmProgram{command, programFiles(command).value().hash, false});
        live.send(LoadExperiment{used});
        bool isTold = false;
        waitFor(
            [&] {
                isTold = isTold || live.alarm(MessageCode::ProgramStopped) != nullptr;
                return false;
            },
            10000);
        EXPECT_EQ(isTold, isBabbling);
        EXPECT_GT(live.lateness.count(), 80U);
        return live.lateness;
    };
    const Lateness alone = lateness(false), beside = lateness(true);
    std::printf("| late steps, alone: median %.1f ms, 99 %% %.1f ms, worst %.1f ms; beside a babbler: %.1f, "
                "%.1f, %.1f ms\n",
                1e3 * alone.quantile_s(0.5), 1e3 * alone.quantile_s(0.99), 1e3 * alone.worst_s(),
                1e3 * beside.quantile_s(0.5), 1e3 * beside.quantile_s(0.99), 1e3 * beside.worst_s());
    EXPECT_LT(beside.quantile_s(0.9), 0.02);
}

// Catches programs that go on, with their heat on, when Bask is killed.
TEST_F(LiveProgramsTest, endWithBask) {
    startBask({QStringLiteral("--allow-program"), QStringLiteral("--duration"), QStringLiteral("90")});
    ASSERT_TRUE(waitFor([&] { return isHot(); }, 60000)) << engine.readAll().toStdString();
    ASSERT_FALSE(areGone());
    engine.kill();
    ASSERT_TRUE(engine.waitForFinished());
    QElapsedTimer since;
    since.start();
    EXPECT_TRUE(waitFor([&] { return areGone(); }, 5000));
    EXPECT_LT(since.elapsed(), 1000 + 500) << "within its time to live";
}

namespace {

class LiveProgramFaults : public LiveProgramsTest {
protected:
    void begin() {
        const auto loaded = readExperiment(experiment().toStdString());
        ASSERT_TRUE(loaded) << describe(loaded.error());
        for (const char* role : kRoles) {
            const std::string own = command(role, "velocity").toStdString();
            live.send(ConfirmProgram{own, programFiles(own).value().hash, false});
        }
        live.send(LoadExperiment{*loaded});
        ASSERT_TRUE(waitFor(
            [&] {
                if (!live.last.isPlaceSure) // a program that has started again: a person has looked
                    live.send(ClearRobotAlarm{});
                if (live.last.state == RunState::Fault)
                    live.send(Reset{});
                return live.last.state == RunState::Ready;
            },
            20000))
            << describe(live.refusal);
        live.send(Arm{m_folder.filePath(QStringLiteral("%1.bask").arg(++m_runs)).toStdString()});
        ASSERT_TRUE(waitFor(
            [&] {
                if (live.last.state == RunState::Armed)
                    live.send(Start{true});
                return live.last.state == RunState::Running;
            },
            20000))
            << describe(live.refusal);
        ASSERT_TRUE(
            waitFor([&] { return isHot() && world("robot").toArray().at(2).toDouble() < 0.14; }, 60000));
    }
    /// ms from the signal to the alarm.
    double raise(const char* role, int signal, MessageCode code) {
        const pid_t pid = pidOf(role);
        EXPECT_GT(pid, 0) << role; // 0 would be this test's own group
        QElapsedTimer since;
        since.start();
        EXPECT_TRUE(pid > 0 && ::kill(pid, signal) == 0);
        EXPECT_TRUE(waitFor([&] { return live.alarm(code) != nullptr; }, 8000)) << role << ' ' << signal;
        const double told_ms = 1e-6 * static_cast<double>(since.nsecsElapsed());
        std::printf("| %-12s | %2d | %-16s | %5.0f ms |\n", role, signal, messageName(code), told_ms);
        return told_ms;
    }

    LiveEngine live;
    int m_runs = 0;
};

} // namespace

// Catches a robot's program that is killed or stopped, and heat that stays on then.
TEST_F(LiveProgramFaults, ofTheRobotEndTheHeat) {
    ASSERT_NO_FATAL_FAILURE(begin());
    EXPECT_LT(raise("robot", SIGKILL, MessageCode::ProgramEnded), 500.0);
    EXPECT_EQ(live.last.state, RunState::Fault);
    EXPECT_TRUE(waitFor([&] { return live.last.heat == HeatState::Off; }, 2000));
    EXPECT_TRUE(waitFor([&] { return live.alarm(MessageCode::ProgramEnded) == nullptr; }, 10000))
        << "it is back";
    live.send(EndRecording{});
    ASSERT_NO_FATAL_FAILURE(begin());
    EXPECT_LT(raise("robot", SIGSTOP, MessageCode::RobotSlow), 500.0 + 500.0);
    EXPECT_EQ(live.last.state, RunState::Fault);
    EXPECT_TRUE(waitFor([&] { return live.last.heat == HeatState::Off; }, 2000));
}

// Catches objects that stay before a plate which nobody controls any more.
TEST_F(LiveProgramFaults, ofTheHeaterTakeTheObjectsAway) {
    ASSERT_NO_FATAL_FAILURE(begin());
    EXPECT_LT(raise("heater", SIGKILL, MessageCode::ProgramEnded), 500.0);
    EXPECT_TRUE(waitFor([&] { return world("robot").toArray().at(2).toDouble() > 0.19; }, 20000));
    EXPECT_TRUE(waitFor([&] { return live.last.heat == HeatState::Off; }, 8000))
        << "it has started again: off comes first";
}

TEST_F(LiveProgramFaults, ofTheThermometerHoldTheRun) {
    ASSERT_NO_FATAL_FAILURE(begin());
    const pid_t pid = pidOf("thermometer");
    ASSERT_TRUE(pid > 0 && ::kill(pid, SIGSTOP) == 0);
    EXPECT_TRUE(waitFor([&] { return live.last.state == RunState::Holding; }, 2000));
    EXPECT_TRUE(waitFor([&] { return pidOf("thermometer") != pid; }, 8000))
        << "it is ended and started again";
    EXPECT_TRUE(waitFor(
        [&] {
            if (live.last.state == RunState::Holding)
                live.send(Resume{});
            return live.last.state == RunState::Running;
        },
        10000));
}

} // namespace bask::test
