// Links on threads of their own: whatever holds them up, the engine's calls do not wait, and what they say is
// what they would say by themselves.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/drivers/byte_link_on_thread.h"
#include "engine/drivers/serial_link.h"
#include "tests/support/echo_device.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace bask {
namespace {

using std::chrono::milliseconds;

/// Gives back what is written; held up by each look at it for so long.
struct Line {
    std::atomic<int> heldUp_ms{0};
    std::atomic<bool> isPlugged{true};
    std::atomic<int> opened{0}, closed{0};
    std::mutex mutex;
    std::string unread, written; ///< under the mutex
    std::string allWritten() {
        const std::lock_guard lock(mutex);
        return written;
    }
};

class EchoLink final : public ByteLink {
public:
    explicit EchoLink(Line& line) : m_line(line) {}
    void open() override {
        ++m_line.opened;
        m_isOpen = m_line.isPlugged;
        const std::lock_guard lock(m_line.mutex);
        m_line.unread.clear();
    }
    void close() override {
        ++m_line.closed;
        m_isOpen = false;
    }
    bool isOpen() const override { return m_isOpen && m_line.isPlugged; }
    Message problem() const override {
        return m_line.isPlugged ? Message{} : Message{MessageCode::LinkLost, {"line", "unplugged"}};
    }
    std::string read() override {
        std::this_thread::sleep_for(milliseconds(m_line.heldUp_ms));
        const std::lock_guard lock(m_line.mutex);
        return std::exchange(m_line.unread, {});
    }
    void write(std::string_view bytes) override {
        const std::lock_guard lock(m_line.mutex);
        m_line.unread += bytes;
        m_line.written += bytes;
    }
    std::string name() const override { return "line"; }

private:
    Line& m_line;
    bool m_isOpen = false;
};

/// How long each of the calls took at the most, ms.
template <class Call> double longest_ms(Call call, int times) {
    double longest = 0.0;
    for (int i = 0; i < times; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        call();
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        longest = std::max(longest, took.count());
        std::this_thread::sleep_for(milliseconds(2));
    }
    return longest;
}

struct LinkOnThread : testing::Test {
    std::string heardUntil(const std::string& wanted) {
        std::string heard;
        test::waitFor([&] { return (heard += link.read()).find(wanted) != std::string::npos; });
        return heard;
    }
    bool isOpened() {
        link.open();
        return test::waitFor([&] { return link.isOpen(); });
    }

    Line line;
    ByteLinkOnThread link{"line", [this] { return std::make_unique<EchoLink>(line); }};
};

} // namespace

// Catches bytes that waited while the link was held up, and are taken for new.
TEST_F(LinkOnThread, WhatWaitedAtALinkThatIsHeldUpIsOld) {
    ASSERT_TRUE(isOpened());
    const SteadyClock clock;
    link.write("a");
    heardUntil("a");
    line.heldUp_ms = 300;
    std::this_thread::sleep_for(milliseconds(20)); // it looks, and is held up
    const double came_s = clock.now_s();
    {
        const std::lock_guard lock(line.mutex);
        line.unread += "b";
    }
    heardUntil("b");
    EXPECT_LE(link.emptyAt_s(), came_s);
    EXPECT_GT(clock.now_s(), came_s + 0.2);
    line.heldUp_ms = 0;
    heardUntil("");
    const double later_s = clock.now_s();
    ASSERT_TRUE(test::waitFor([&] { return link.read().empty() && link.emptyAt_s() > later_s; }))
        << "an empty line is told, too";
}

// Catches an engine that waits for a terminal that the machine holds up.
TEST_F(LinkOnThread, NoCallWaitsForALinkThatIsHeldUp) {
    ASSERT_TRUE(isOpened());
    line.heldUp_ms = 400;
    const double took_ms = longest_ms(
        [&] {
            link.write("a");
            (void)link.read();
            (void)link.isOpen();
            (void)link.problem();
        },
        100);
    EXPECT_LT(took_ms, 200.0);
    line.heldUp_ms = 0;
    link.write("end");
    EXPECT_NE(heardUntil("end").find("end"), std::string::npos);
    EXPECT_EQ(line.allWritten(), std::string(100, 'a') + "end") << "in order, each once";
}

// Catches last words that are lost in a close, and bytes of before it that are read after it.
TEST_F(LinkOnThread, WhatIsWrittenBeforeACloseIsSentAndWhatCameIsForgotten) {
    ASSERT_TRUE(isOpened());
    link.write("stop");
    link.close();
    EXPECT_FALSE(link.isOpen());
    EXPECT_TRUE(test::waitFor([&] { return line.closed > 0; }));
    EXPECT_EQ(line.allWritten(), "stop");
    link.write("nobody");
    ASSERT_TRUE(isOpened());
    link.write("new");
    EXPECT_EQ(heardUntil("new"), "new");
    EXPECT_EQ(line.allWritten(), "stopnew");
}

// Catches a loss that is not told, or that is not over when the plug is back.
TEST_F(LinkOnThread, ALossIsToldAndOver) {
    ASSERT_TRUE(isOpened());
    line.isPlugged = false;
    EXPECT_TRUE(test::waitFor([&] { return !link.isOpen(); }));
    EXPECT_EQ(link.problem().code, MessageCode::LinkLost);
    link.open();
    EXPECT_TRUE(test::waitFor([&] { return link.problem().code == MessageCode::LinkLost; }));
    EXPECT_FALSE(link.isOpen());
    line.isPlugged = true;
    ASSERT_TRUE(isOpened());
    EXPECT_EQ(link.problem().code, MessageCode::None);
}

// Catches a queue without an end while nobody takes its bytes.
TEST_F(LinkOnThread, TooMuchThatNobodyTakesIsAStuckLink) {
    ASSERT_TRUE(isOpened());
    line.heldUp_ms = 500;
    std::this_thread::sleep_for(milliseconds(50)); // it is held up by now
    for (int i = 0; i < 50; ++i)
        link.write(std::string(100, 'x'));
    EXPECT_FALSE(link.isOpen());
    EXPECT_EQ(link.problem(), (Message{MessageCode::LinkStuck, {"line"}}));
    line.heldUp_ms = 0;
    EXPECT_TRUE(isOpened());
}

// Catches a real port that does not work there.
TEST(LinkOnThreadOnAPort, GoesThereAndBackAndIsToldUnplugged) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("bask_thread_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::string path = folder / "port";
    test::EchoDevice device;
    auto server = PtyServer::create(device, path);
    ASSERT_TRUE(server.ok());
    ByteLinkOnThread link(path, [&] { return std::make_unique<SerialLink>(path, SerialSettings{}); });
    link.open();
    ASSERT_TRUE(test::waitFor([&] {
        (*server)->work(0.0);
        return link.isOpen();
    }));
    link.write("hello\n");
    std::string heard;
    EXPECT_TRUE(test::waitFor([&] {
        (*server)->work(0.0);
        return (heard += link.read()) == "HELLO\n"; // it is louder than what it hears
    })) << heard;
    server->reset();
    EXPECT_TRUE(test::waitFor([&] { return !link.isOpen(); }));
    EXPECT_EQ(link.problem().code, MessageCode::LinkLost);
    std::filesystem::remove_all(folder);
}

} // namespace bask
