#include "engine/device_simulators/pty_server.h"

#include "engine/base/message_code.h"
#include "tests/support/echo_device.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end.
class PtyServerTest : public testing::Test {
protected:
    PtyServerTest() { fs::create_directories(m_folder); }
    ~PtyServerTest() override { fs::remove_all(m_folder); }

    std::unique_ptr<PtyServer> serve() {
        auto server = PtyServer::create(m_device, m_link);
        EXPECT_TRUE(server.ok());
        return std::move(*server);
    }
    int open() const { return ::open(m_link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK); }

    fs::path m_folder = fs::temp_directory_path() / ("bask_pty_" + std::to_string(::getpid()));
    std::string m_link = m_folder / "robot";
    test::EchoDevice m_device;
};

void say(int client, const std::string& text) {
    ASSERT_EQ(::write(client, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

/// Until `count` bytes are there, or the time is over.
std::string heard(PtyServer& server, int client, std::size_t count, int limit_ms = 1000) {
    std::string all;
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(limit_ms);
    while (all.size() < count && std::chrono::steady_clock::now() < end) {
        server.work(0.0);
        char piece[256];
        if (const ssize_t n = ::read(client, piece, sizeof piece); n > 0)
            all.append(piece, static_cast<std::size_t>(n));
    }
    return all;
}

// Catches bytes changed on the way (echo, CR to LF, control characters taken for signals) or held back.
TEST_F(PtyServerTest, everyByteGoesThroughUnchanged) {
    const auto server = serve();
    const int client = open();
    ASSERT_GE(client, 0);
    const std::string sent("a\r\n\x03\x04\x11\x13\x18?\0\xff\x7f z", 14);
    say(client, sent);
    EXPECT_EQ(heard(*server, client, 14), std::string("A\r\n\x03\x04\x11\x13\x18?\0\xff\x7f Z", 14));
    EXPECT_EQ(m_device.heard, sent);
    ::close(client);
}

// Catches a server that dies with its client, and one that hands the next client what the last left unread
// or what was said to nobody.
TEST_F(PtyServerTest, clientsComeAndGo) {
    const auto server = serve();
    m_device.toSay = "to nobody";
    server->work(0.0);
    for (int round = 0; round < 3; ++round) {
        const int client = open();
        ASSERT_GE(client, 0);
        say(client, "hello");
        EXPECT_EQ(heard(*server, client, 5), "HELLO") << "client " << round;
        m_device.toSay = "left unread";
        server->work(0.0);
        say(client, "bye");
        ::close(client);
        m_device.heard.clear();
        server->work(0.0);
        EXPECT_EQ(m_device.heard, "bye") << "what it said last is heard";
        server->work(0.0);
        m_device.toSay = "to nobody";
        server->work(0.0);
    }
}

// Catches a port that nobody but root can open after a client that was killed: it had it for itself alone.
TEST_F(PtyServerTest, aKilledClientDoesNotKeepThePort) {
    fs::permissions(m_folder, fs::perms::all);
    const bool isRoot = ::geteuid() == 0;
    if (isRoot && ::seteuid(65534) != 0)
        FAIL() << "nobody";
    const auto server = serve();
    const int killed = open();
    EXPECT_GE(killed, 0);
    EXPECT_EQ(::ioctl(killed, TIOCEXCL), 0);
    say(killed, "hello");
    EXPECT_EQ(heard(*server, killed, 5), "HELLO");
    ::close(killed);
    server->work(0.0);
    const int next = open();
    EXPECT_GE(next, 0) << std::strerror(errno);
    say(next, "hello");
    EXPECT_EQ(heard(*server, next, 5), "HELLO");
    ::close(next);
    EXPECT_TRUE(!isRoot || ::seteuid(0) == 0);
}

// Catches a server that waits, or that keeps everything, for a client that does not read.
TEST_F(PtyServerTest, aClientThatDoesNotReadIsNotWaitedFor) {
    const auto server = serve();
    const int client = open();
    ASSERT_GE(client, 0);
    for (int i = 0; i < 1000; ++i) {
        m_device.toSay.assign(1000, 'x');
        server->work(0.0);
    }
    const std::string late = heard(*server, client, 1000000, 50);
    EXPECT_GT(late.size(), 1000u);
    EXPECT_LT(late.size(), 100000u);
    ::close(client);
}

// Catches a link left behind, a link that cannot be taken over after a crash, and a lost file of the user's.
TEST_F(PtyServerTest, theLinkIsReplacedAndRemovedAndNothingElseIs) {
    fs::create_symlink("/dev/pts/left-behind", m_link);
    auto first = serve();
    EXPECT_EQ(fs::read_symlink(m_link), first->path());
    auto second = serve(); // the cable in another socket
    EXPECT_EQ(fs::read_symlink(m_link), second->path());
    first.reset();
    EXPECT_EQ(fs::read_symlink(m_link), second->path()) << "not its own link any more";
    second.reset();
    EXPECT_FALSE(fs::is_symlink(m_link));

    std::ofstream(m_link) << "precious";
    const auto refused = PtyServer::create(m_device, m_link);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code(), MessageCode::SimulatedPortTaken);
    EXPECT_TRUE(fs::is_regular_file(m_link));
    const auto nowhere = PtyServer::create(m_device, m_folder / "none" / "robot");
    ASSERT_FALSE(nowhere.ok());
    EXPECT_EQ(nowhere.error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), {}), 1) << "nothing left beside it";
}

} // namespace
} // namespace bask
