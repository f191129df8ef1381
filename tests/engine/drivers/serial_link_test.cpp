#include "engine/drivers/serial_link.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/pty_server.h"
#include "tests/support/echo_device.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

/// A real QSerialPort on a real pseudo-terminal that can be unplugged.
class SerialLinkTest : public testing::Test {
protected:
    SerialLinkTest() {
        fs::create_directories(m_folder);
        plugIn();
    }
    ~SerialLinkTest() override { fs::remove_all(m_folder); }

    void plugIn() {
        auto server = PtyServer::create(m_device, m_path);
        ASSERT_TRUE(server.ok());
        m_server = std::move(*server);
    }
    void unplug() { m_server.reset(); }

    /// Bytes and events move until `condition` holds.
    template <class Condition> bool until(Condition condition, int limit_ms = 5000) {
        return test::waitFor(
            [&] {
                if (m_server)
                    m_server->work(0.0);
                m_heard += m_link.read();
                return condition();
            },
            limit_ms);
    }

    fs::path m_folder = fs::temp_directory_path() / ("bask_serial_" + std::to_string(::getpid()));
    std::string m_path = m_folder / "port";
    test::EchoDevice m_device;
    std::unique_ptr<PtyServer> m_server;
    SerialLink m_link{m_path, SerialSettings{9600, 7, 'E', 1}};
    std::string m_heard;
};

double processorTime_s() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Catches a link that loses or changes bytes, or does not follow the symbolic link that names the port.
TEST_F(SerialLinkTest, bytesGoThroughBothWays) {
    EXPECT_FALSE(m_link.isOpen());
    EXPECT_EQ(m_link.read(), "");
    m_link.write("nobody hears");
    m_link.open();
    ASSERT_TRUE(m_link.isOpen()) << describe(m_link.problem());
    EXPECT_EQ(m_link.name(), m_path);
    m_link.write("IN_pv_2 \r\n");
    m_link.write(std::string("\0\x13\x11", 3));
    const std::string expected("IN_PV_2 \r\n\0\x13\x11", 13);
    EXPECT_TRUE(until([&] { return m_heard.size() >= expected.size(); }));
    EXPECT_EQ(m_heard, expected);
    EXPECT_EQ(m_link.problem(), Message{});
}

// Catches bytes that wait for the event loop's next turn: a reading would be taken for newer than it is.
TEST_F(SerialLinkTest, whatHasComeIsReadWithoutTheEventLoop) {
    m_link.open();
    m_device.toSay = "23.4\n";
    m_server->work(0.0);
    EXPECT_EQ(m_link.read(), "23.4\n");
}

// Catches a port refused ("Invalid argument") because a program that was killed has left it as we want it.
TEST_F(SerialLinkTest, aPortLeftByAKilledProgramIsOpenedAgain) {
    const pid_t other = ::fork();
    if (other == 0) {
        m_link.open();
        m_link.write("kept");
        ::usleep(100'000);
        ::_exit(m_link.isOpen() ? 0 : 1); // without a farewell
    }
    int left = -1;
    ASSERT_TRUE(test::waitFor([&] {
        m_server->work(0.0);
        return ::waitpid(other, &left, WNOHANG) == other;
    }));
    ASSERT_EQ(left, 0);
    m_server->work(0.0); // like a true port it forgets who had it for himself
    m_link.open();
    EXPECT_TRUE(m_link.isOpen()) << describe(m_link.problem());
}

// Catches an answer to the last session's question taken for this one's.
TEST_F(SerialLinkTest, whatWasUnreadIsForgottenWhenItIsOpenedAgain) {
    m_link.open();
    m_device.toSay = "old";
    m_server->work(0.0);
    m_link.close();
    EXPECT_FALSE(m_link.isOpen());
    m_link.open();
    m_device.toSay = "new";
    EXPECT_TRUE(until([&] { return m_heard.size() >= 3; }));
    EXPECT_EQ(m_heard, "new");
}

// Catches a storm of errors (a million a second in Qt 6.4) or a spinning notifier after the cable is out,
// and a port that does not come back under its path.
TEST_F(SerialLinkTest, unpluggedItCostsNothingAndComesBack) {
    m_link.open();
    ASSERT_TRUE(m_link.isOpen());
    unplug();
    const double before_s = processorTime_s();
    test::waitFor([&] { return !m_link.read().empty(); }, 1000); // asked all the time, as its thread does
    const double storm_s = processorTime_s() - before_s;
    RecordProperty("processor_us_in_a_second", static_cast<int>(storm_s * 1e6));
    EXPECT_LT(storm_s, 0.1) << "of one second";
    EXPECT_FALSE(m_link.isOpen());
    EXPECT_EQ(m_link.problem().code, MessageCode::LinkLost);
    m_link.open();
    EXPECT_FALSE(m_link.isOpen());
    EXPECT_EQ(m_link.problem().code, MessageCode::LinkNotOpened);
    EXPECT_EQ(m_link.problem().args.at(1), "there is no such port");

    plugIn();
    m_link.open();
    ASSERT_TRUE(m_link.isOpen());
    EXPECT_EQ(m_link.problem(), Message{});
    m_link.write("back");
    EXPECT_TRUE(until([&] { return m_heard == "BACK"; }));
}

// Catches a loss that is seen by Qt's error only (never told by Qt since 6.8), and a close that was put off
// and hits the port opened anew.
TEST_F(SerialLinkTest, aLossIsSeenByReadingAndThePortCanBeOpenedAtOnce) {
    m_link.open();
    unplug();
    m_link.read();
    EXPECT_FALSE(m_link.isOpen());
    EXPECT_EQ(m_link.problem().code, MessageCode::LinkLost);
    plugIn();
    m_link.open();
    m_link.write("on");
    EXPECT_TRUE(until([&] { return m_heard == "ON"; }));
    EXPECT_TRUE(m_link.isOpen());
}

// Catches a queue that grows without end when the device does not read.
TEST_F(SerialLinkTest, aDeviceThatDoesNotReadIsToldAndNotWaitedFor) {
    m_link.open();
    std::size_t taken = 0;
    for (; m_link.isOpen() && taken < 1000000; taken += 100)
        m_link.write(std::string(100, 'x'));
    EXPECT_LT(taken, 200000u);
    EXPECT_EQ(m_link.problem().code, MessageCode::LinkStuck);
    EXPECT_EQ(argTexts(m_link.problem()), std::vector<std::string>{m_path});
}

// Catches a stop that is thrown away with what nobody takes, when the port is closed right behind it; and a
// close that waits for what nobody takes.
TEST_F(SerialLinkTest, theLastBytesAreGivenAMomentOnClosing) {
    m_link.open();
    m_server->work(0.0); // it has seen somebody
    m_link.write("stop");
    m_link.close();
    for (int i = 0; i < 100; ++i)
        m_server->work(0.0);
    EXPECT_EQ(m_device.heard, "stop");
    m_link.open();
    while (m_link.isOpen())
        m_link.write(std::string(100, 'x'));
    const auto before = std::chrono::steady_clock::now();
    m_link.close();
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::milliseconds(200));
}

// Catches a reason that leaves a newcomer puzzled: not in the port's group, or opened by another program.
TEST_F(SerialLinkTest, whyAPortCannotBeOpenedIsTold) {
    m_link.open();
    SerialLink second(m_path, {});
    second.open();
    EXPECT_EQ(second.problem().args.at(1), "another program has it open");
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may open everything";
    const std::string locked = m_folder / "locked";
    std::ofstream(locked) << "";
    fs::permissions(locked, fs::perms::none);
    SerialLink refused(locked, {});
    refused.open();
    EXPECT_NE(refused.problem().args.at(1).text().find("dialout"), std::string::npos);
}

} // namespace
} // namespace bask
