#pragma once
// A simulated rig behind three serial ports and an engine that runs an experiment on it, each a process of
// its own.

#include "engine/base/pose.h"
#include "engine/experiment/experiment_file.h"
#include "engine/protocols/modbus_profile.h"
#include "tests/support/guard_processes.h"
#include "tests/support/wait_for.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QThread>

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <vector>

namespace bask::test {

/// What is truly so at the simulated rig.
struct BenchState {
    double plate_degC = 0.0;
    bool isHeating = false;
    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
    std::vector<double> objects_degC;
};

class RigProcesses : public testing::Test {
protected:
    static constexpr double kAway_m = 0.19; ///< the retreat ends at 0.2

    RigProcesses() {
        QFile source(QStringLiteral(BASK_TEST_DATA "/rig/three-thin-disks.json"));
        EXPECT_TRUE(source.open(QIODevice::ReadOnly));
        m_rig = source.readAll().replace("PORTS", m_folder.path().toUtf8());
        writeExperiment(m_rig);
    }
    ~RigProcesses() override {
        endProcess(engine);
        endProcess(bench);
        endGuardsOf(m_folder.path());
    }

    /// Leaves the processor to the engine and the bench meanwhile.
    template <class Condition> static bool waitFor(Condition condition, int limit_ms = 20000) {
        return test::waitFor(
            [&] {
                QThread::msleep(2);
                return condition();
            },
            limit_ms);
    }
    QString experiment() const { return m_folder.filePath(QStringLiteral("rig.json")); }
    QString portOf(const char* role) const { return m_folder.filePath(QLatin1String(role)); }
    QString session() const { return m_folder.filePath(QStringLiteral("run.bask")); }
    void writeExperiment(const QByteArray& text) const {
        QFile file(experiment());
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    /// A controller with registers instead of the hotplate, by a shipped profile; empty: the hotplate. Before
    /// the bench is started.
    void makeHeater(const QByteArray& profile) const {
        QByteArray text = m_rig;
        if (!profile.isEmpty()) {
            text.replace("\"driver\": \"namur\"",
                         "\"driver\": \"modbus\", \"unit\": 2, \"profile\": \"" + profile + '"');
            text.replace("\"data_bits\": 7", "\"data_bits\": 8").replace("\"even\"", "\"none\"");
            const auto& all = shippedProfiles();
            if (!std::ranges::find(all, profile.toStdString(), &ModbusProfile::name)->watchdog)
                text.replace("\"watchdog_s\": 20", "\"unattended_heat\": true");
        }
        writeExperiment(text);
        QFile::remove(portOf("devices.json")); // another device answers there from here on
    }

    /// Only to one that runs: the id 0 of one that has ended means all of this test's group, ctest too.
    static void sendSignal(const QProcess& process, int number) {
        if (process.processId() > 0)
            ::kill(static_cast<pid_t>(process.processId()), number);
        else
            ADD_FAILURE() << process.program().toStdString() << " has ended";
    }
    static void endProcess(QProcess& process) {
        if (process.state() == QProcess::NotRunning)
            return;
        sendSignal(process, SIGCONT);
        process.kill();
        process.waitForFinished();
    }
    void startBench(double heating_s = 10.0) {
        m_told.clear();
        bench.start(QStringLiteral(BASK_PROGRAM),
                    {QStringLiteral("simulate-rig"), experiment(), QStringLiteral("--heating-time"),
                     QString::number(heating_s)});
        ASSERT_TRUE(waitFor([&] { return told().contains("heater "); }));
    }
    void startEngine(const QStringList& arguments = {}) {
        engine.setProcessChannelMode(QProcess::MergedChannels);
        QProcessEnvironment environment = engine.processEnvironment(); // as a test may have set it
        if (environment.isEmpty())
            environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("BASK_SETTINGS_DIR"), m_folder.path());
        engine.setProcessEnvironment(environment);
        engine.start(QStringLiteral(BASK_PROGRAM),
                     QStringList{QStringLiteral("run"), experiment(), QStringLiteral("--live"),
                                 QStringLiteral("--confirm-place"), QStringLiteral("--accept-limits"),
                                 QStringLiteral("--overwrite"), QStringLiteral("-o"), session()} +
                         arguments);
    }
    /// The heat is on: the run has begun.
    void waitUntilHeating() {
        ASSERT_TRUE(
            waitFor([&] { return state().isHeating || engine.state() == QProcess::NotRunning; }, 60000) &&
            engine.state() != QProcess::NotRunning)
            << engine.readAll().toStdString();
    }

    void tell(const QByteArray& line) {
        m_told.clear();
        bench.write(line + '\n');
        ASSERT_TRUE(bench.waitForBytesWritten(5000));
        ASSERT_TRUE(waitFor([&] { return told().contains(line + '\n'); }));
    }
    BenchState state() {
        m_told.clear();
        bench.write("state\n");
        BenchState out;
        if (!waitFor([&] { return told().contains("degC\n"); }, 5000))
            return out;
        static const QRegularExpression kLine(
            QStringLiteral("plate (\\S+) degC (\\w+); robot (\\S+) (\\S+) (\\S+) m; objects (.*) degC"));
        const auto match = kLine.match(QString::fromUtf8(m_told));
        out.plate_degC = match.captured(1).toDouble();
        out.isHeating = match.captured(2) == QLatin1String("heating");
        out.place_m = {match.captured(3).toDouble(), match.captured(4).toDouble(),
                       match.captured(5).toDouble()};
        for (const QString& value : match.captured(6).split(QLatin1Char(' ')))
            out.objects_degC.push_back(value.toDouble());
        return out;
    }
    /// When the bytes came that switched the bench's heat off, by SteadyClock; empty: it is on.
    std::optional<double> off_s() {
        m_told.clear();
        bench.write("switched\n");
        if (!waitFor([&] { return told().contains(" s\n"); }, 5000))
            return std::nullopt;
        static const QRegularExpression kLine(QStringLiteral("heat off since (\\S+) s"));
        const auto match = kLine.match(QString::fromUtf8(m_told));
        return match.hasMatch() ? std::optional(match.captured(1).toDouble()) : std::nullopt;
    }
    /// Its exit code, once it has ended.
    std::optional<int> ended(int limit_ms) {
        if (!engine.waitForFinished(limit_ms) || engine.exitStatus() != QProcess::NormalExit)
            return std::nullopt;
        return engine.exitCode();
    }

    QProcess bench, engine;

private:
    const QByteArray& told() {
        bench.waitForReadyRead(5);
        return m_told += bench.readAllStandardOutput();
    }
    QTemporaryDir m_folder;
    QByteArray m_rig;
    QByteArray m_told;
};

} // namespace bask::test
