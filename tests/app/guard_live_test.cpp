// The engine of `bask run --live` and of the window killed, stopped and hung at random moments of a run,
// while it heats, is held, and is late: the guard switches the plate off, and knows it within 3 s.

#include "tests/app/rig_processes.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>

#include <sys/ptrace.h>
#include <sys/wait.h>

namespace bask::test {
namespace {

/// The threads of that name in a process that runs on.
std::vector<pid_t> threadsNamed(const char* wanted, const QProcess& process) {
    std::vector<pid_t> out;
    const QDir tasks(QStringLiteral("/proc/%1/task").arg(process.processId()));
    for (const QString& each : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile name(tasks.filePath(each + QStringLiteral("/comm")));
        if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == wanted)
            out.push_back(each.toInt());
    }
    return out;
}

/// What the run does when its engine ends.
enum class Doing { Heats, Holds, IsLate };

class GuardLive : public RigProcesses {
protected:
    static constexpr double kOff_s = 3.0;
    static constexpr int kLatest_ms = 6000;                     ///< after the heat went on
    static constexpr int kHeld_ms = 1500;                       ///< from a sensor's loss to the hold
    static constexpr int kLate_ms = 75000, kLateFor_ms = 10000; ///< the objects are warm
    static constexpr const char* kNoWatchdog[] = {"eurotherm-2400", "watlow-ez-zone"};

    /// What ends or hangs the engine, in a run that has begun at a random time before.
    template <class Stop> void goesOffAfter(const char* name, int times, Stop stop) {
        double worst_s = 0.0, sum_s = 0.0;
        for (int i = 0; i < times; ++i) {
            const QByteArray heater = heaters[static_cast<std::size_t>(i) % heaters.size()];
            const Doing doing = rests && i % 20 == 0 ? Doing::IsLate
                                : i % 3 == 1         ? Doing::Holds
                                                     : Doing::Heats;
            SCOPED_TRACE(std::to_string(i) + ' ' + heater.toStdString());
            int later_ms = 0;
            bool isOn = false;
            for (int k = 0; k < 3 && !isOn; ++k) { // a busy machine's devices may end a run before
                ASSERT_NO_FATAL_FAILURE(beginRun(heater, doing));
                ASSERT_NO_FATAL_FAILURE(goOnFor(doing, later_ms));
                isOn = heats();
                if (!isOn) {
                    endProcess(engine);
                    endGuardsOf(QFileInfo(experiment()).path());
                }
            }
            ASSERT_TRUE(isOn) << name << " after " << later_ms;
            const qint64 stopped_ms = QDateTime::currentMSecsSinceEpoch();
            ASSERT_NO_FATAL_FAILURE(stop());
            std::optional<qint64> confirmed_ms;
            ASSERT_TRUE(waitFor([&] { return (confirmed_ms = confirmedOff_ms()).has_value(); }, 15000))
                << name << " after " << later_ms << " ms: " << log().toStdString();
            const double took_s = 1e-3 * static_cast<double>(*confirmed_ms - stopped_ms);
            EXPECT_LE(took_s, kOff_s) << name << " after " << later_ms << " ms: " << log().toStdString();
            EXPECT_FALSE(heats());
            worst_s = std::max(worst_s, took_s);
            sum_s += took_s;
            goOn();
            if (engine.state() != QProcess::NotRunning && !m_isWindow) {
                // Told, it faults, and watches the plate cool: a person need not wait for that.
                std::optional<int> code;
                for (int k = 0; k < 200 && !(code = ended(100)); ++k)
                    if (k % 10 == 9)
                        sendSignal(engine, SIGINT);
                EXPECT_EQ(code, 1) << engine.readAll().toStdString();
            }
            endProcess(engine);
        }
        std::printf("| %s, %d times%s: confirmed off within %.2f s (mean %.2f s)\n", name, times,
                    m_isWindow ? ", the window" : "", worst_s, sum_s / times);
        std::fflush(stdout);
    }
    /// At a cold rig.
    void beginRun(const QByteArray& heater, Doing doing) {
        bench.terminate();
        ASSERT_TRUE(bench.state() == QProcess::NotRunning || bench.waitForFinished(5000));
        makeHeater(heater);
        m_hasSwitch = heater.isEmpty();
        QFile::remove(logFile());
        ASSERT_NO_FATAL_FAILURE(startBench(doing == Doing::IsLate ? 2.0 : 10.0));
        begin();
        ASSERT_TRUE(waitFor([&] { return heats() || engine.state() == QProcess::NotRunning; }, 60000) &&
                    engine.state() != QProcess::NotRunning)
            << engine.readAll().toStdString();
    }
    /// Until the engine is to end.
    void goOnFor(Doing doing, int& later_ms) {
        const int min_ms = doing == Doing::IsLate ? kLate_ms : doing == Doing::Holds ? kHeld_ms : 0;
        const int max_ms = doing == Doing::IsLate ? kLate_ms + kLateFor_ms : kLatest_ms;
        later_ms = QRandomGenerator::global()->bounded(min_ms, max_ms);
        if (doing == Doing::Holds) {
            (void)waitFor([] { return false; }, later_ms - kHeld_ms);
            ASSERT_NO_FATAL_FAILURE(tell("thermometer open"));
            (void)waitFor([] { return false; }, kHeld_ms);
            const Eigen::Vector3d stands_m = state().place_m;
            (void)waitFor([] { return false; }, 200);
            EXPECT_EQ(state().place_m, stands_m) << "it is not held";
        } else {
            (void)waitFor([] { return false; }, later_ms);
        }
    }
    /// A controller without a register for on and off only shows it by its plate.
    bool heats() {
        const BenchState before = state();
        if (m_hasSwitch)
            return before.isHeating;
        (void)waitFor([] { return false; }, 150);
        return state().plate_degC > before.plate_degC + 0.02;
    }
    /// Of the command, or of a window on a display of its own.
    void begin() {
        if (!m_isWindow)
            return startEngine();
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("BASK_SETTINGS_DIR"), portOf("."));
        environment.insert(QStringLiteral("DISPLAY"), m_display);
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
        environment.insert(QStringLiteral("LP_NUM_THREADS"), QStringLiteral("1"));
        engine.setProcessEnvironment(environment);
        engine.setProcessChannelMode(QProcess::MergedChannels);
        engine.start(QStringLiteral(BASK_WINDOW), {experiment()});
    }
    /// False: no display can be made here.
    bool openDisplay() {
        m_server.start(QStringLiteral("Xvfb"),
                       {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                        QStringLiteral("0"), QStringLiteral("1600x1000x24")});
        QByteArray number;
        (void)waitFor([&] {
            m_server.waitForReadyRead(20);
            return (number += m_server.readAllStandardOutput()).endsWith('\n') ||
                   m_server.state() == QProcess::NotRunning;
        });
        m_display = QLatin1Char(':') + QString::fromLatin1(number.trimmed());
        return m_isWindow = !number.isEmpty();
    }
    ~GuardLive() override {
        goOn();
        endProcess(engine);
        endProcess(m_server);
    }
    /// What was stopped goes on.
    void goOn() {
        if (m_thread > 0) {
            EXPECT_EQ(::ptrace(PTRACE_DETACH, std::exchange(m_thread, 0), nullptr, nullptr), 0);
        }
        if (engine.state() != QProcess::NotRunning)
            sendSignal(engine, SIGCONT);
    }
    /// The engine's thread stands still, the others do not.
    void hang() {
        const std::vector<pid_t> threads = threadsNamed("engine", engine);
        ASSERT_EQ(threads.size(), 1U);
        m_thread = threads.front();
        ASSERT_EQ(::ptrace(PTRACE_SEIZE, m_thread, nullptr, nullptr), 0);
        ASSERT_EQ(::ptrace(PTRACE_INTERRUPT, m_thread, nullptr, nullptr), 0);
        ASSERT_EQ(::waitpid(m_thread, nullptr, __WALL), m_thread);
    }
    QString logFile() const { return portOf("guard.log"); }
    QByteArray log() const {
        QFile file(logFile());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// When the guard knew it, by its log, ms since 1970.
    std::optional<qint64> confirmedOff_ms() const {
        for (const QByteArray& line : log().split('\n'))
            if (line.contains("confirmed off"))
                return QDateTime::fromString(QString::fromLatin1(line.left(24)), Qt::ISODateWithMs)
                    .toMSecsSinceEpoch();
        return std::nullopt;
    }

    /// Of the runs in turn; empty: a hotplate.
    std::vector<QByteArray> heaters{{}};
    bool rests = false; ///< some of the runs have settled before; they are recorded

    void killed(int times) {
        goesOffAfter("killed", times, [this] {
            sendSignal(engine, SIGKILL);
            engine.waitForFinished();
        });
    }
    void stopped(int times) {
        goesOffAfter("stopped", times, [this] { sendSignal(engine, SIGSTOP); });
    }
    void hung(int times) {
        goesOffAfter("hung", times, [this] { hang(); });
    }

private:
    pid_t m_thread = 0;
    bool m_isWindow = false, m_hasSwitch = true;
    QProcess m_server;
    QString m_display;
};

} // namespace

TEST_F(GuardLive, killedAtAnyMoment) {
    killed(2);
}
TEST_F(GuardLive, stoppedAtAnyMoment) {
    stopped(1);
}
TEST_F(GuardLive, hungAtAnyMoment) {
    hung(1);
}
// Catches a heater that only the guard can switch off: it has no watchdog, and no register for on and off.
TEST_F(GuardLive, ofAControllerWithoutAWatchdog) {
    heaters = {kNoWatchdog[0]};
    killed(1);
    heaters = {kNoWatchdog[1]};
    hung(1);
}
TEST_F(GuardLive, theWindowAtAnyMoment) {
    if (!openDisplay())
        GTEST_SKIP() << "Xvfb is not installed";
    killed(1);
    stopped(1);
    hung(1);
}
/// Of each kind, spread over several processes where BASK_MOMENTS says so.
int moments() {
    const int asked = qEnvironmentVariableIntValue("BASK_MOMENTS");
    return asked > 0 ? asked : 100;
}

TEST_F(GuardLive, hundredMoments) {
    heaters = {{}, kNoWatchdog[0], {}, kNoWatchdog[1]};
    rests = true;
    killed(moments());
    stopped(moments());
    hung(moments());
}
TEST_F(GuardLive, hundredMomentsOfTheWindow) {
    if (!openDisplay())
        GTEST_SKIP() << "Xvfb is not installed";
    heaters = {{}, kNoWatchdog[0], {}, kNoWatchdog[1]};
    killed(moments());
    stopped(moments());
    hung(moments());
}

} // namespace bask::test
