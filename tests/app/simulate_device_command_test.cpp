// bask simulate-device as a process of its own, with Bask's drivers at the other end of its serial port.

#include "engine/base/units.h"
#include "engine/drivers/namur_heater.h"
#include "engine/drivers/serial_link.h"
#include "engine/drivers/stream_thermometer.h"
#include "tests/support/wait_for.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <csignal>

namespace bask::test {
namespace {

class SimulateDeviceTest : public testing::Test {
protected:
    ~SimulateDeviceTest() override {
        m_process.kill();
        m_process.waitForFinished();
    }
    void start(const QStringList& arguments) {
        m_process.start(QStringLiteral(BASK_PROGRAM),
                        QStringList{QStringLiteral("simulate-device")} + arguments);
    }
    /// Its exit code once it has ended.
    int ended() {
        if (!m_process.waitForFinished(20000) || m_process.exitStatus() != QProcess::NormalExit)
            return -1;
        return m_process.exitCode();
    }

    QTemporaryDir m_folder;
    QString m_link = m_folder.filePath(QStringLiteral("port"));
    QProcess m_process;
    SteadyClock m_clock;
};

// Catches a device that the driver cannot talk to, and a link that stays behind.
TEST_F(SimulateDeviceTest, theHeaterHeatsAndEndsWithItsSignal) {
    start({QStringLiteral("heater"), QStringLiteral("--link"), m_link});
    SerialLink link(m_link.toStdString(), {9600, 7, 'E', 1});
    NamurHeater heater(link, m_clock, {});
    EXPECT_TRUE(waitFor([&] {
        heater.work();
        (void)heater.keepHeating(kelvinFromCelsius(100.0), 1.0);
        return heater.read().ok() && heater.read().value().value_K > kelvinFromCelsius(20.5);
    }));
    EXPECT_EQ(heater.status().identity, "IKA simulated");
    EXPECT_EQ(QString::fromUtf8(m_process.readAllStandardOutput()), m_link + QLatin1Char('\n'));
    m_process.terminate();
    EXPECT_EQ(ended(), 0);
    EXPECT_FALSE(QFileInfo(m_link).isSymLink());
}

// Catches a link that stays behind when the terminal is closed: the next shell may get its number.
TEST_F(SimulateDeviceTest, theLinkGoesWithTheTerminal) {
    m_process.setChildProcessModifier([] { (void)std::signal(SIGHUP, SIG_DFL); }); // as in a terminal
    start({QStringLiteral("heater"), QStringLiteral("--link"), m_link});
    ASSERT_TRUE(waitFor([this] { return m_process.readAllStandardError().contains("Ctrl+C"); }));
    ASSERT_TRUE(QFileInfo(m_link).isSymLink());
    ASSERT_EQ(::kill(static_cast<pid_t>(m_process.processId()), SIGHUP), 0);
    EXPECT_EQ(ended(), 0);
    EXPECT_FALSE(QFileInfo(m_link).isSymLink());
}

// Catches a command that nohup does not keep.
TEST_F(SimulateDeviceTest, anIgnoredHangupStaysIgnored) {
    m_process.setChildProcessModifier([] { (void)std::signal(SIGHUP, SIG_IGN); });
    start({QStringLiteral("heater"), QStringLiteral("--link"), m_link});
    ASSERT_TRUE(waitFor([this] { return m_process.readAllStandardError().contains("Ctrl+C"); }));
    ASSERT_EQ(::kill(static_cast<pid_t>(m_process.processId()), SIGHUP), 0);
    EXPECT_FALSE(m_process.waitForFinished(300));
    m_process.terminate();
    EXPECT_EQ(ended(), 0);
}

// Catches a fault that is not raised.
TEST_F(SimulateDeviceTest, theThermometerHasItsFault) {
    start({QStringLiteral("thermometer"), QStringLiteral("--link"), m_link, QStringLiteral("--fault"),
           QStringLiteral("open")});
    SerialLink link(m_link.toStdString(), {});
    StreamThermometer thermometer(link, m_clock, 3);
    std::vector<Reading> readings;
    EXPECT_TRUE(waitFor([&] {
        thermometer.work();
        if (const auto read = thermometer.read())
            readings = *read;
        return readings.size() == 3 && readings[0].time_s > 0.0 && readings[2].valid;
    }));
    EXPECT_EQ(readings.at(0).fault, SensorFault::Open);
    EXPECT_NEAR(readings.at(1).value_K, kelvinFromCelsius(40.0), 6.0);
}

// Catches bad input that is taken for something, and a file that is replaced by a link.
TEST_F(SimulateDeviceTest, badInputIsRefusedInWords) {
    QFile precious(m_folder.filePath(QStringLiteral("precious")));
    ASSERT_TRUE(precious.open(QIODevice::WriteOnly));
    struct Case {
        QStringList arguments;
        const char* words;
    };
    for (const Case& each :
         {Case{{"heater"}, "--link is needed"}, Case{{"toaster", "--link", m_link}, "heater"},
          Case{{"heater", "--link", m_link, "--driver", "grbl"}, "namur"},
          Case{{"heater", "--link", m_link, "--fault", "melted"}, "stuck-on"},
          Case{{"heater", "--link", precious.fileName()}, "is not a link"}}) {
        start(each.arguments);
        EXPECT_EQ(ended(), 2) << each.words;
        const QString said = QString::fromUtf8(m_process.readAllStandardError());
        EXPECT_TRUE(said.contains(QLatin1String(each.words))) << said.toStdString();
        EXPECT_FALSE(QFileInfo(m_link).isSymLink());
    }
    EXPECT_FALSE(QFileInfo(precious.fileName()).isSymLink());
    start({QStringLiteral("--help")});
    EXPECT_EQ(ended(), 0);
    EXPECT_TRUE(m_process.readAllStandardOutput().contains("wrong-channel"));
}

} // namespace
} // namespace bask::test
