// The Modbus link against programs that others wrote, and such a program against the simulated line. A peer
// that is not installed is skipped; packaging/install-deps.sh has them all.

#include "engine/base/units.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "tests/engine/drivers/modbus_line_fixture.h"

#include <QRegularExpression>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <string_view>

namespace bask {
namespace {

using Registers = std::vector<std::uint16_t>;

const ModbusProfile& shippedProfile(std::string_view name) {
    const auto& all = shippedProfiles();
    return *std::find_if(all.begin(), all.end(), [&](const ModbusProfile& p) { return p.name == name; });
}

/// Until it answers; programs take a while to start.
bool answers(const std::function<bool()>& once) {
    for (int i = 0; i < 40; ++i) {
        if (once())
            return true;
    }
    return false;
}

// -- python3-pymodbus, behind two terminals joined by socat

class PymodbusTest : public test::ModbusLineTest {
protected:
    /// Why not, or empty.
    std::string serve() {
        const QString script = BASK_PYMODBUS_SERVER;
        QString python;
        for (const char* candidate :
             {"python3", "/usr/bin/python3"}) { // the first in PATH may be another one
            QProcess check;
            check.start(candidate, {script, "--check"});
            if (check.waitForFinished(30000) && check.exitStatus() == QProcess::NormalExit &&
                check.exitCode() == 0)
                python = candidate;
        }
        if (python.isEmpty())
            return "no python3 with pymodbus and serial_asyncio";
        if (!join())
            return "no socat";
        peer.start(python, {script, QString::fromStdString(farPort)});
        openLink();
        EXPECT_TRUE(answers([&] {
            return ask({1, 3, 0, 1}).ok();
        })) << peer.readAllStandardError().toStdString();
        return {};
    }
    void signal(int what) const { // of one that has ended the id is 0, which means all of this test's group
        if (peer.processId() > 0)
            ::kill(static_cast<pid_t>(peer.processId()), what);
        else
            ADD_FAILURE() << "the peer has ended";
    }
};

// Catches a reading of the protocol that is ours alone.
TEST_F(PymodbusTest, RegistersWritesAndExceptions) {
    if (const std::string why = serve(); !why.empty())
        GTEST_SKIP() << why;
    EXPECT_EQ(answered({1, 3, 0, 3}).value(), (Registers{1000, 1001, 1002}));
    EXPECT_EQ(answered({1, 4, 10, 2}).value(), (Registers{2010, 2011}));
    EXPECT_TRUE(answered({1, 6, 20, 1, {0xBEEF}}).ok());
    EXPECT_TRUE(answered({1, 16, 21, 2, {0x0000, 0x4296}}).ok());
    EXPECT_EQ(answered({1, 3, 20, 3}).value(), (Registers{0xBEEF, 0x0000, 0x4296}));
    const ModbusReply beyond = answered({1, 3, 200, 1});
    ASSERT_FALSE(beyond.ok());
    EXPECT_EQ(beyond.error().code(), MessageCode::DeviceException);
    EXPECT_EQ(beyond.error().message.args.at(2), "2");
}

// Catches a server that is stopped for a while: silence is told, its late answers are used for nothing else.
TEST_F(PymodbusTest, StoppedAndContinued) {
    if (const std::string why = serve(); !why.empty())
        GTEST_SKIP() << why;
    signal(SIGSTOP);
    EXPECT_EQ(refusal({1, 3, 3, 1}), MessageCode::DeviceSilent); // 32767
    EXPECT_EQ(refusal({1, 3, 3, 1}), MessageCode::DeviceSilent);
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int number = link->send({1, 3, 4, 1});
    signal(SIGCONT);
    std::optional<ModbusReply> reply;
    ASSERT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
    if (reply->ok()) { // then it is its own
        EXPECT_EQ(reply->value(), Registers{1004});
    }
    for (int address = 4; address < 20; ++address) {
        const ModbusReply next = answered({1, 3, address, 1});
        if (next.ok()) {
            EXPECT_EQ(next.value(), Registers{static_cast<std::uint16_t>(1000 + address)});
        }
    }
    EXPECT_EQ(answered({1, 3, 5, 1}).value(), Registers{1005});
}

// -- libmodbus' own adversary (tests/unit-test-server.c of its sources, as its package has them)

class LibmodbusTest : public test::ModbusLineTest {
protected:
    static constexpr int kUnit = 17, kFirst = 0x160, kBusy = 0x170, kWrongUnit = 0x171, kLate = 0x172;

    std::string serve() {
        const QString program = BASK_LIBMODBUS_SERVER;
        if (program.isEmpty())
            return "libmodbus-dev's unit-test-server.c was not there when this was built";
        if (!join())
            return "no socat";
        peer.setStandardOutputFile(QProcess::nullDevice());
        EXPECT_TRUE(answers([&] {
            if (peer.state() == QProcess::NotRunning) // it ends where it hears the rest of a question only
                peer.start(program, {"rtu", QString::fromStdString(farPort)});
            if (!link || !link->isOpen()) // after ten questions without an answer
                openLink({115200, 8, 'N', 1}, 0.3);
            return ask({kUnit, 6, kFirst, 1, {555}}).ok();
        }));
        EXPECT_TRUE(answered({kUnit, 6, kLate, 1, {32767}}).ok());
        return {};
    }
};

// Promise: a reply for another unit, a short one and a late one are never used.
TEST_F(LibmodbusTest, NothingThatDoesNotFitIsUsed) {
    if (const std::string why = serve(); !why.empty())
        GTEST_SKIP() << why;
    EXPECT_EQ(answered({kUnit, 3, kFirst, 1}).value(), Registers{555});
    EXPECT_EQ(refusal({kUnit, 3, kFirst, 2}), MessageCode::DeviceAnswersWrong)
        << "it answers with one register";
    EXPECT_EQ(answered({kUnit, 3, kFirst, 1}).value(), Registers{555});
    const ModbusReply busy = answered({kUnit, 3, kBusy, 1});
    ASSERT_FALSE(busy.ok());
    EXPECT_EQ(busy.error().code(), MessageCode::DeviceException);
    EXPECT_EQ(busy.error().message.args.at(2), "6");
    EXPECT_EQ(refusal({kUnit, 3, kWrongUnit, 1}), MessageCode::DeviceSilent);
    EXPECT_EQ(refusal({kUnit + 1, 3, kFirst, 1}), MessageCode::DeviceSilent) << "another unit";
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(refusal({kUnit, 3, kLate, 1}), MessageCode::DeviceSilent) << "it sleeps for 0.5 s";
        for (int k = 0; k < 3; ++k) {
            const ModbusReply next = ask({kUnit, 3, kFirst, 1});
            if (next.ok()) {
                EXPECT_EQ(next.value(), Registers{555});
            }
        }
    }
    EXPECT_EQ(answered({kUnit, 3, kFirst, 1}).value(), Registers{555});
}

// -- mbpoll as the client of the simulated line

class MbpollTest : public test::ModbusLineTest {
protected:
    void farEnd() override { server->work(clock.now_s()); }

    /// What it prints, or empty when it fails.
    QString poll(const QStringList& arguments) {
        peer.start("mbpoll", QStringList{"-m", "rtu", "-b", "19200", "-P", "none", "-1", "-0"} + arguments);
        until([&] { return peer.state() == QProcess::NotRunning; }, 10000);
        const QString out = peer.readAllStandardOutput();
        return peer.exitStatus() == QProcess::NormalExit && peer.exitCode() == 0 ? out : QString();
    }

    ModbusSimulator sim;
    std::unique_ptr<PtyServer> server = PtyServer::create(sim, port).value();
};

// Catches a simulator that only our own client understands.
TEST_F(MbpollTest, TalksWithTheSimulatedLine) {
    if (QStandardPaths::findExecutable("mbpoll").isEmpty())
        GTEST_SKIP() << "no mbpoll";
    sim.addThermometer(3, shippedProfile("modmux-pm6rtd"), 293.15);
    sim.setTemperature(3, 1, 333.15);
    sim.addController(5, shippedProfile("watlow-ez-zone"));
    sim.addController(6, shippedProfile("pixsys-drr245"));
    const QString path = QString::fromStdString(port);
    const QString read = poll({"-a", "3", "-t", "3", "-r", "1", "-c", "3", path});
    EXPECT_TRUE(read.contains(QRegularExpression("\\[1\\]:\\s+200\\n\\[2\\]:\\s+600\\n\\[3\\]:\\s+200")))
        << read.toStdString();
    EXPECT_FALSE(poll({"-a", "6", "-t", "4", "-r", "1001", path, "800"}).isEmpty()); // function 6
    EXPECT_EQ(sim.registerAt(6, 3, 1001), 800);
    EXPECT_FALSE(
        poll({"-a", "5", "-t", "4:float", "-r", "2160", path, "176"}).isEmpty()); // function 16, degF
    EXPECT_NEAR(sim.setPoint_K(5), kelvinFromCelsius(80.0), 1e-3);
    const QString real = poll({"-a", "5", "-t", "4:float", "-r", "2160", path});
    EXPECT_TRUE(real.contains(QRegularExpression("\\[2160\\]:\\s+176"))) << real.toStdString();
    EXPECT_TRUE(poll({"-a", "3", "-t", "3", "-r", "50", path}).isEmpty()) << "no such register";
    EXPECT_TRUE(poll({"-a", "9", "-t", "3", "-r", "1", "-o", "0.2", path}).isEmpty()) << "no such unit";
}

// -- whatever else is at hand: BASK_TEST_MODBUS_PORT=path,baud,parity,unit,function,address

TEST(AnyModbusDevice, AnswersForASecond) {
    const char* where = std::getenv("BASK_TEST_MODBUS_PORT");
    if (where == nullptr)
        GTEST_SKIP() << "BASK_TEST_MODBUS_PORT=path,baud,parity,unit,function,address is not set";
    const QStringList words = QString(where).split(',');
    ASSERT_EQ(words.size(), 6);
    const SteadyClock clock;
    const SerialSettings settings{words[1].toInt(), 8, words[2].toStdString().at(0), 1};
    RtuLink link(std::make_unique<SerialLink>(words[0].toStdString(), settings), settings, clock);
    link.open();
    ASSERT_TRUE(link.isOpen()) << describe(link.problem());
    int fitting = 0;
    const double end_s = clock.now_s() + 1.0;
    while (clock.now_s() < end_s) {
        ASSERT_TRUE(test::waitFor([&] { return link.isFree(); }));
        const int number = link.send({words[3].toInt(), words[4].toInt(), words[5].toInt(), 1});
        std::optional<ModbusReply> reply;
        ASSERT_TRUE(test::waitFor([&] { return (reply = link.takeReply(number)).has_value(); }));
        fitting += reply->ok() ? 1 : 0;
    }
    RecordProperty("replies_in_a_second", fitting);
    EXPECT_GT(fitting, 4);
}

} // namespace
} // namespace bask
