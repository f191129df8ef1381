#include "engine/device_simulators/terminal_server.h"

#include "engine/base/message_code.h"
#include "tests/support/echo_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

/// A terminal that is there before the server, as socat makes it; the test has its other end.
class TerminalServerTest : public testing::Test {
protected:
    TerminalServerTest() {
        fs::create_directories(m_folder);
        plugIn();
    }
    ~TerminalServerTest() override {
        ::close(m_far);
        fs::remove_all(m_folder);
    }

    void plugIn() {
        m_far = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
        ASSERT_EQ(::grantpt(m_far), 0);
        ASSERT_EQ(::unlockpt(m_far), 0);
        fs::remove(m_path);
        fs::create_symlink(::ptsname(m_far), m_path);
    }
    std::string answer(TerminalServer& server, const std::string& said, double now_s) {
        EXPECT_EQ(::write(m_far, said.data(), said.size()), static_cast<ssize_t>(said.size()));
        std::string all;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
        while (all.size() < said.size() && std::chrono::steady_clock::now() < end) {
            server.work(now_s);
            char piece[256];
            if (const ssize_t n = ::read(m_far, piece, sizeof piece); n > 0)
                all.append(piece, static_cast<std::size_t>(n));
        }
        return all;
    }

    fs::path m_folder = fs::temp_directory_path() / ("bask_terminal_" + std::to_string(::getpid()));
    std::string m_path = m_folder / "port";
    int m_far = -1;
    test::EchoDevice m_device;
};

} // namespace

// Catches bytes changed on the way, and a server that does not come back to a cable that does.
TEST_F(TerminalServerTest, bytesGoThroughUnchangedAlsoAfterTheCableWasPulled) {
    auto server = TerminalServer::open(m_device, m_path);
    ASSERT_TRUE(server) << describe(server.error());
    const std::string sent("a\r\n\x03\x04\x11\x13\x18?\0\xff\x7f z", 14),
        back("A\r\n\x03\x04\x11\x13\x18?\0\xff\x7f Z", 14);
    EXPECT_EQ(answer(**server, sent, 0.0), back);
    ::close(m_far);
    (*server)->work(1.0);
    plugIn();
    (*server)->work(1.0);
    EXPECT_EQ(answer(**server, sent, 1.0 + TerminalServer::kReopen_s), back);
}

// Catches a server of nothing, and a file taken for a terminal.
TEST_F(TerminalServerTest, whatIsNoTerminalIsRefused) {
    const auto nowhere = TerminalServer::open(m_device, m_folder / "none");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code(), MessageCode::FileUnwritable);
    EXPECT_FALSE(TerminalServer::open(m_device, "/dev/null"));
}

} // namespace bask
