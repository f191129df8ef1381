// The engine of `bask run --live` and of the window killed, stopped and hung at random moments of a run: the
// guard switches the plate off.

#include "tests/app/rig_processes.h"

#include <QDir>
#include <QRandomGenerator>

#include <sys/ptrace.h>
#include <sys/wait.h>

namespace bask::test {
namespace {

/// The engine's thread in a process that runs on. 0: there is none.
pid_t engineThread(const QProcess& process) {
    const QDir tasks(QStringLiteral("/proc/%1/task").arg(process.processId()));
    for (const QString& each : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile name(tasks.filePath(each + QStringLiteral("/comm")));
        if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == "engine")
            return each.toInt();
    }
    return 0;
}

class GuardLive : public RigProcesses {
protected:
    static constexpr double kOff_s = 3.0;

    /// What ends or hangs the engine, in a run that has begun at a random time before.
    template <class Stop> void goesOffAfter(const char* name, int times, Stop stop) {
        double worst_s = 0.0;
        for (int i = 0; i < times; ++i) {
            SCOPED_TRACE(i);
            if (bench.state() == QProcess::NotRunning)
                startBench();
            begin();
            ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
            const int later_ms = static_cast<int>(QRandomGenerator::global()->bounded(2000));
            (void)waitFor([] { return false; }, later_ms);
            ASSERT_TRUE(state().isHeating);
            QElapsedTimer since;
            since.start();
            ASSERT_NO_FATAL_FAILURE(stop());
            ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 10000)) << name << " after " << later_ms;
            const double took_s = 1e-3 * static_cast<double>(since.elapsed());
            EXPECT_LE(took_s, kOff_s) << name << " after " << later_ms << " ms";
            worst_s = std::max(worst_s, took_s);
            EXPECT_TRUE(waitFor([&] { return confirmed() == i + 1; }, 5000)) << log().toStdString();
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
        std::printf("| %s, %d times: off within %.2f s\n", name, times, worst_s);
        QFile::remove(logFile());
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
        m_thread = engineThread(engine);
        ASSERT_GT(m_thread, 0);
        ASSERT_EQ(::ptrace(PTRACE_SEIZE, m_thread, nullptr, nullptr), 0);
        ASSERT_EQ(::ptrace(PTRACE_INTERRUPT, m_thread, nullptr, nullptr), 0);
        ASSERT_EQ(::waitpid(m_thread, nullptr, __WALL), m_thread);
    }
    QString logFile() const { return portOf("guard.log"); }
    QByteArray log() const {
        QFile file(logFile());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    int confirmed() const { return static_cast<int>(log().count("confirmed off")); }

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
    bool m_isWindow = false;
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
TEST_F(GuardLive, theWindowAtAnyMoment) {
    if (!openDisplay())
        GTEST_SKIP() << "Xvfb is not installed";
    killed(1);
    hung(1);
}
/// Of each kind, spread over several processes where BASK_MOMENTS says so.
int moments() {
    const int asked = qEnvironmentVariableIntValue("BASK_MOMENTS");
    return asked > 0 ? asked : 100;
}

TEST_F(GuardLive, hundredMoments) {
    killed(moments());
    stopped(moments());
    hung(moments());
}
TEST_F(GuardLive, hundredMomentsOfTheWindow) {
    if (!openDisplay())
        GTEST_SKIP() << "Xvfb is not installed";
    killed(moments());
    stopped(moments());
    hung(moments());
}

} // namespace bask::test
