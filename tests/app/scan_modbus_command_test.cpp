// bask scan-modbus as a process of its own, with simulated devices at a serial port and at an address.

#include "tests/support/terminal.h"
#include "tests/support/wait_for.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

class ScanModbusTest : public testing::Test {
protected:
    ~ScanModbusTest() override {
        m_device.kill();
        m_device.waitForFinished();
    }
    /// Starts a simulated device and returns the port that it prints.
    QString start(const QStringList& arguments) {
        m_device.start(QStringLiteral(BASK_PROGRAM),
                       QStringList{QStringLiteral("simulate-device")} + arguments);
        waitFor([&] { return m_device.canReadLine() || m_device.state() == QProcess::NotRunning; }, 60000);
        return QString::fromUtf8(m_device.readLine()).trimmed();
    }
    int scan(const QStringList& arguments) {
        QProcess process;
        process.start(QStringLiteral(BASK_PROGRAM), QStringList{QStringLiteral("scan-modbus")} + arguments);
        const bool isOver = process.waitForFinished(120000) && process.exitStatus() == QProcess::NormalExit;
        m_out = process.readAllStandardOutput();
        m_said = QString::fromUtf8(process.readAllStandardError());
        return isOver ? process.exitCode() : -1;
    }
    /// The same with a terminal for what it says meanwhile.
    int scanOnTerminal(const QStringList& arguments) {
        test::Terminal terminal;
        QProcess process;
        process.setChildProcessModifier([far = terminal.far()] { ::dup2(far, STDERR_FILENO); });
        process.start(QStringLiteral(BASK_PROGRAM), QStringList{QStringLiteral("scan-modbus")} + arguments);
        const bool isOver = process.waitForFinished(120000) && process.exitStatus() == QProcess::NormalExit;
        m_out = process.readAllStandardOutput();
        m_said = QString::fromUtf8(terminal.written());
        return isOver ? process.exitCode() : -1;
    }

    QTemporaryDir m_folder;
    QProcess m_device;
    QByteArray m_out;
    QString m_said;
};

} // namespace

// Catches a device on a network that is not found, or found with another profile, and JSON that nothing
// reads.
TEST_F(ScanModbusTest, FindsADeviceOnANetwork) {
    const QString address = start({"thermometer", "--driver", "modbus_tcp", "--link", "0"});
    ASSERT_TRUE(address.startsWith(QStringLiteral("127.0.0.1:"))) << address.toStdString();
    ASSERT_EQ(scan({address, "--units", "1-2", "--json"}), 0) << m_said.toStdString();
    const QJsonObject found = QJsonDocument::fromJson(m_out).object();
    EXPECT_EQ(found.value("port").toString(), address);
    EXPECT_TRUE(found.value("line").isNull());
    const QJsonArray units = found.value("units").toArray();
    ASSERT_EQ(units.size(), 1);
    const QJsonObject unit = units.first().toObject();
    EXPECT_EQ(unit.value("unit").toInt(), 1);
    const QJsonObject fit = unit.value("profiles").toArray().first().toObject();
    EXPECT_EQ(fit.value("profile").toString(), QStringLiteral("labjack-t7-thermocouples"));
    EXPECT_TRUE(fit.value("type_told").toBool());
    EXPECT_EQ(fit.value("identity").toString(), QStringLiteral("125c 125d"));
    const QJsonArray temperatures = fit.value("temperatures_degC").toArray();
    ASSERT_EQ(temperatures.size(), 14);
    EXPECT_NEAR(temperatures[2].toDouble(), 35.0, 1e-3);
    EXPECT_TRUE(temperatures[1].isNull());
}

// Catches a serial line that is scanned with one setting only, and a unit among others that is missed.
TEST_F(ScanModbusTest, FindsADeviceOnASerialPort) {
    const QString port =
        start({"heater", "--driver", "modbus", "--link", m_folder.filePath(QStringLiteral("port"))});
    ASSERT_EQ(scan({port, "--units", "1-3", "--line", "9600-8N1"}), 0) << m_said.toStdString();
    EXPECT_TRUE(m_out.contains("unit 1:")) << m_out.toStdString();
    EXPECT_TRUE(m_out.contains("  eurotherm-2400:")) << m_out.toStdString();
    EXPECT_TRUE(m_out.contains("The line is 9600-8N1.")) << m_out.toStdString();
    EXPECT_EQ(scanOnTerminal({port, "--units", "9-14", "--line", "9600-8N1,19200-8E1"}), 3);
    EXPECT_TRUE(m_out.contains("No unit from 9 to 14 answers.")) << m_out.toStdString();
    static const QRegularExpression kLine(
        QStringLiteral("\\d+ %, about [^,]+ left, 19200-8E1, unit \\d+\\x1b"));
    EXPECT_TRUE(m_said.contains(kLine)) << m_said.toStdString();
}

TEST_F(ScanModbusTest, BadInputIsRefusedInWords) {
    struct Case {
        QStringList arguments;
        const char* words;
    };
    for (const Case& each :
         {Case{{"/dev/null", "--units", "0-16"}, "--units"},
          Case{{"/dev/null", "--units", "16-1"}, "--units"},
          Case{{"/dev/null", "--units", "1-248"}, "--units"}, Case{{"/dev/null", "--line", "9600"}, "--line"},
          Case{{"/dev/null", "--line", "9600-8N1,"}, "--line"},
          Case{{"/dev/null", "--line", "9999999-8N1"}, "--line"},
          Case{{m_folder.filePath(QStringLiteral("none"))}, "none"}, Case{{"two words"}, "it is no address"},
          Case{{"127.0.0.1:1"}, "127.0.0.1:1"}}) {
        EXPECT_EQ(scan(each.arguments), 2) << each.words;
        EXPECT_TRUE(m_said.contains(QLatin1String(each.words))) << m_said.toStdString();
        EXPECT_TRUE(m_out.isEmpty()) << m_out.toStdString();
    }
}

} // namespace bask::test
