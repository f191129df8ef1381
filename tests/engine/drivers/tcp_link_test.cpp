#include "engine/drivers/tcp_link.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/tcp_server.h"
#include "tests/support/echo_device.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

class TcpLinkTest : public testing::Test {
protected:
    void plugIn(int port) { m_server = std::move(TcpServer::create(m_device, port).value()); }

    template <class Condition> bool until(TcpLink& link, Condition condition) {
        return test::waitFor(
            [&] {
                if (m_server)
                    m_server->work(0.0);
                m_heard += link.read();
                return condition();
            },
            5000);
    }

    test::EchoDevice m_device;
    std::unique_ptr<TcpServer> m_server;
    std::string m_heard;
};

// Catches lost bytes, a lost connection that is not told, and one that does not come back.
TEST_F(TcpLinkTest, bytesGoThroughAndALostConnectionComesBack) {
    plugIn(0);
    const int port = m_server->port();
    TcpLink link("127.0.0.1", port);
    EXPECT_EQ(link.name(), "127.0.0.1:" + std::to_string(port));
    link.open();
    EXPECT_FALSE(link.isOpen()) << "it waits for nothing";
    EXPECT_TRUE(until(link, [&] { return link.isOpen(); }));
    link.open(); // opened anew
    EXPECT_TRUE(until(link, [&] { return link.isOpen(); }));
    link.write("getpose()");
    EXPECT_TRUE(until(link, [&] { return m_heard == "GETPOSE()"; }));

    m_server.reset();
    EXPECT_TRUE(until(link, [&] { return !link.isOpen(); }));
    EXPECT_EQ(link.problem().code, MessageCode::LinkLost);
    link.open();
    EXPECT_TRUE(until(link, [&] { return link.problem().code != MessageCode::None; }));
    EXPECT_EQ(link.problem().code, MessageCode::LinkNotOpened);
    plugIn(port);
    link.open();
    EXPECT_TRUE(until(link, [&] { return link.isOpen(); }));
    EXPECT_EQ(link.problem(), Message{});
}

// Catches two programs that move one robot, and one that cannot be talked to after the other has ended.
TEST_F(TcpLinkTest, aDeviceIsTalkedToByOneBaskAtATime) {
    plugIn(0);
    TcpLink link("127.0.0.1", m_server->port());
    {
        TcpLink first("127.0.0.1", m_server->port());
        first.open();
        ASSERT_TRUE(until(first, [&] { return first.isOpen(); }));
        link.open();
        EXPECT_EQ(link.problem().code, MessageCode::LinkNotOpened);
        EXPECT_NE(describe(link.problem()).find("another Bask"), std::string::npos)
            << describe(link.problem());
        EXPECT_TRUE(first.isOpen());
    }
    link.open();
    EXPECT_TRUE(until(link, [&] { return link.isOpen(); }));
}

// Catches an attempt that is begun anew each time a driver asks, so that a slow one never ends.
TEST_F(TcpLinkTest, anAttemptUnderWayIsLeftInPeace) {
    plugIn(0);
    TcpLink link("127.0.0.1", m_server->port());
    EXPECT_TRUE(until(link, [&] {
        if (!link.isOpen())
            link.open();
        return link.isOpen();
    }));
}

// Catches a queue that grows without end when the device does not read.
TEST_F(TcpLinkTest, aDeviceThatDoesNotReadIsToldAndNotWaitedFor) {
    plugIn(0);
    TcpLink link("127.0.0.1", m_server->port());
    link.open();
    ASSERT_TRUE(until(link, [&] { return link.isOpen(); }));
    std::size_t taken = 0;
    for (; link.isOpen() && taken < 100000000; taken += 4000)
        link.write(std::string(4000, 'x'));
    EXPECT_FALSE(link.isOpen());
    EXPECT_EQ(link.problem().code, MessageCode::LinkStuck);
}

} // namespace
} // namespace bask
