// The whole engine over serial lines that neither it nor the simulators have made: socat's, as cables.

#include "engine/base/message_code.h"
#include "engine/recording/session_file.h"
#include "tests/app/rig_processes.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <memory>

namespace bask::test {
namespace {

constexpr double kBand_K = 0.5;
constexpr double kTarget_degC = 40.0;

/// The engine at one end of three cables, the simulators at the other.
class SocatRigTest : public RigProcesses {
protected:
    SocatRigTest() {
        EXPECT_TRUE(QDir(folder()).mkdir(QStringLiteral("far")));
        for (std::size_t i = 0; i < cables.size(); ++i) {
            const QString name = QLatin1String(kNames[i]);
            const QString end = QStringLiteral("PTY,raw,echo=0,link=%1");
            cables[i].start(QStringLiteral("socat"), {end.arg(folder() + '/' + name), end.arg(far() + name)});
        }
        EXPECT_TRUE(waitFor([&] {
            return std::ranges::all_of(kNames, [&](const char* name) { return QFile::exists(far() + name); });
        })) << "socat";
    }
    ~SocatRigTest() override {
        // The cables last: a terminal's name that is free may be another test's by then.
        for (QProcess* process : {&engine, &bench, &cables[0], &cables[1], &cables[2]}) {
            process->kill();
            process->waitForFinished();
        }
    }

    QString folder() const { return QFileInfo(experiment()).path(); }
    QString far() const { return folder() + QStringLiteral("/far/"); }

    /// The experiment, but for a machine that may be busy; and one for the far ends.
    void write(const QByteArray& experimentText) const {
        QJsonObject root = QJsonDocument::fromJson(experimentText).object();
        root[QStringLiteral("safety")] = QJsonObject{{QStringLiteral("stale_periods"), 10}};
        const QByteArray text = QJsonDocument(root).toJson();
        const QByteArray ports = (folder() + '/').toUtf8();
        const std::array contents{text, QByteArray(text).replace(ports, far().toUtf8())};
        const std::array paths{experiment(), far() + QStringLiteral("rig.json")};
        for (std::size_t i = 0; i < paths.size(); ++i) {
            QFile file(paths[i]);
            ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(contents[i]) == contents[i].size());
        }
    }
    QByteArray read(const QString& path) const {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }
    void startFarBench(const QString& heating_s) {
        bench.start(QStringLiteral(BASK_PROGRAM),
                    {QStringLiteral("simulate-rig"), far() + QStringLiteral("rig.json"),
                     QStringLiteral("--open"), QStringLiteral("--heating-time"), heating_s});
        ASSERT_TRUE(waitFor([&] { return !state().objects_degC.empty(); }))
            << bench.readAllStandardError().toStdString();
    }
    /// The true temperatures come to their targets and stay there for longer than "settled" takes.
    void expectSettledWithin(int limit_s, const QString& heating_s) {
        ASSERT_NO_FATAL_FAILURE(startFarBench(heating_s));
        ASSERT_NO_FATAL_FAILURE(runUntilSettled(limit_s));
        const auto record = readSession(session().toStdString());
        ASSERT_TRUE(record) << describe(record.error());
        EXPECT_FALSE(state().isHeating);
        EXPECT_EQ(engine.exitCode(), 0) << engine.readAll().toStdString();
        EXPECT_FALSE(record->simulated);
        EXPECT_EQ(record->outcome, "settled");
        expectComplete(*record);
    }

private:
    /// Ends it, as Ctrl+C does; or it ends by itself.
    void runUntilSettled(int limit_s) {
        constexpr qint64 kHeld_ms = 36000;
        startEngine({QStringLiteral("--duration"), QString::number(limit_s)});
        ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
        QElapsedTimer run, within;
        run.start();
        BenchState state;
        const auto isOver = [&] {
            QThread::msleep(200);
            state = this->state();
            const bool isWithin =
                state.objects_degC.size() == 3 && std::ranges::all_of(state.objects_degC, [](double t_degC) {
                    return std::abs(t_degC - kTarget_degC) <= kBand_K;
                });
            if (!isWithin)
                within.invalidate();
            else if (!within.isValid())
                within.start();
            return engine.state() == QProcess::NotRunning ||
                   (within.isValid() && within.elapsed() > kHeld_ms);
        };
        ASSERT_TRUE(waitFor(isOver, 1000 * limit_s)) << testing::PrintToString(state.objects_degC);
        std::printf("in the band after %.0f s\n", 1e-3 * static_cast<double>(run.elapsed() - kHeld_ms));
        if (engine.state() != QProcess::NotRunning)
            sendSignal(engine, SIGINT);
        ASSERT_TRUE(engine.state() == QProcess::NotRunning || ended(120000))
            << engine.readAll().toStdString();
    }
    static void expectComplete(const SessionRecord& record) {
        const auto controlled = record.controlledSamples();
        const double period_s = record.experiment.sampling.period_s;
        ASSERT_FALSE(controlled.empty());
        EXPECT_GE(static_cast<double>(controlled.size()), 0.8 * controlled.back().time_s / period_s)
            << "a sample each period, but for what a busy machine loses";
        for (std::size_t i = 1; i < controlled.size(); ++i)
            EXPECT_LT(controlled[i].time_s - controlled[i - 1].time_s, std::max(1.0, 2.0 * period_s)) << i;
    }

protected:
    static constexpr std::array kNames{"robot", "thermometer", "heater"};
    std::array<QProcess, 3> cables;
};

} // namespace

// Catches any link of the chain that is wrong or slow, or works only on terminals of our own making: the
// objects' true temperatures come to their targets and stay, the recording is whole, and the plate is off in
// the end. Thin disks, which are fast.
TEST_F(SocatRigTest, thinDisksSettle) {
    write(read(experiment()));
    expectSettledWithin(300, QStringLiteral("10"));
}

// The experiment that Bask ships and runs by default, as it is, on a rig: real time, so outside of CI.
TEST_F(SocatRigTest, theShippedThreeObjectsSettle) {
    const QJsonValue rig = QJsonDocument::fromJson(read(experiment())).object()[QStringLiteral("rig")];
    QJsonObject shipped =
        QJsonDocument::fromJson(read(QStringLiteral(BASK_EXAMPLES "/three-objects.json"))).object();
    shipped[QStringLiteral("rig")] = rig;
    for (const QString& place : {folder(), far()})
        ASSERT_TRUE(
            QFile::link(QStringLiteral(BASK_EXAMPLES "/contours"), place + QStringLiteral("/contours")));
    write(QJsonDocument(shipped).toJson());
    expectSettledWithin(1800, QStringLiteral("60"));
}

// Catches a cable pulled out of the robot that leaves the heat on; and lines of Qt's own on the console, one
// for each bad answer.
TEST_F(SocatRigTest, aRobotUnpluggedEndsTheHeat) {
    write(read(experiment()));
    startFarBench(QStringLiteral("10"));
    startEngine();
    ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
    for (const char* fault : {"thermometer bad-crc", "thermometer wrong-unit"}) {
        tell(fault);
        QElapsedTimer bad;
        bad.start();
        ASSERT_TRUE(waitFor([&] { return bad.elapsed() > 1200; })); // three answers at the least
    }
    tell("thermometer none");
    ASSERT_TRUE(state().isHeating);
    for (const QString& place : {folder() + '/', far()}) // as udev does
        ASSERT_TRUE(QFile::remove(place + QStringLiteral("robot")));
    sendSignal(cables[0], SIGKILL);
    QElapsedTimer unplugged;
    unplugged.start();
    ASSERT_TRUE(waitFor([&] { return !state().isHeating; }, 5000));
    EXPECT_LT(unplugged.elapsed(), 1000);
    // The fault is recorded on, since its objects stand before a hot plate, until a person ends that.
    std::string said;
    ASSERT_TRUE(waitFor(
        [&] {
            said += engine.readAll().toStdString();
            return said.find("the run is over") != std::string::npos;
        },
        60000));
    sendSignal(engine, SIGINT);
    EXPECT_EQ(ended(30000), 1);
    said += engine.readAll().toStdString();
    EXPECT_NE(said.find("the link to"), std::string::npos) << said;
    EXPECT_EQ(said.find("qt.modbus"), std::string::npos) << said;
    const auto record = readSession(session().toStdString());
    ASSERT_TRUE(record.ok());
    EXPECT_EQ(record->outcome, "fault");
}

} // namespace bask::test
