// Programs that are really started: what is allowed, what they are told at their end, and what they cannot
// do.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/drivers/confirmed_programs.h"
#include "engine/drivers/program_files.h"
#include "engine/drivers/program_link.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>
#include <unistd.h>

namespace bask::test {
namespace {

class ProgramLinkTest : public testing::Test {
protected:
    ProgramLinkTest() {
        m_folder = std::filesystem::path(testing::TempDir()) / ("program_link_" + std::to_string(::getpid()));
        std::filesystem::create_directories(m_folder);
    }
    ~ProgramLinkTest() override {
        link.reset();
        ProgramLink::waitForAll();
        std::filesystem::remove_all(m_folder);
    }

    std::string script(const std::string& text, const std::string& name = "program.sh") const {
        const std::string path = (m_folder / name).string();
        std::ofstream(path) << text;
        return path;
    }
    std::string fileOf(const char* name) const { return (m_folder / name).string(); }
    std::string textOf(const char* name) const {
        std::ifstream file(fileOf(name));
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void confirm(const std::string& command) const { m_confirmed->add(programFiles(command).value().hash); }
    void make(const std::string& command, const std::string& device = "test") {
        link = std::make_unique<ProgramLink>(command, device, m_confirmed);
        link->open();
    }
    void makeOpen(const std::string& command) {
        confirm(command);
        make(command);
        ASSERT_TRUE(waitFor([&] { return link->isOpen(); })) << describe(link->problem());
    }
    bool comes(const std::string& words) {
        return waitFor([&] { return (m_read += link->read()).find(words) != std::string::npos; });
    }
    bool fails(MessageCode code) {
        return waitFor([&] { return link->problem().code == code; });
    }
    static bool isGone(const std::string& pid) {
        return waitFor([&] { // one that has ended is there until somebody has asked for its exit code
            std::ifstream file("/proc/" + std::to_string(std::stoi(pid)) + "/stat");
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            return text.empty() || text.find(") Z") != std::string::npos;
        });
    }

    std::filesystem::path m_folder;
    std::shared_ptr<ConfirmedPrograms> m_confirmed = std::make_shared<ConfirmedPrograms>();
    std::unique_ptr<ProgramLink> link;
    std::string m_read;
};

// Catches a rig file that starts a program which nobody has looked at, and a script that was changed since.
TEST_F(ProgramLinkTest, StartsNothingThatIsNotConfirmed) {
    const std::string command = "sh " + script("touch '" + fileOf("ran") + "'; cat");
    make(command);
    ASSERT_TRUE(fails(MessageCode::ProgramNotConfirmed));
    EXPECT_FALSE(std::filesystem::exists(fileOf("ran")));
    EXPECT_FALSE(link->isOpen());
    confirm(command);
    ASSERT_TRUE(waitFor([&] {
        link->open();
        return link->isOpen();
    })) << "as soon as it is confirmed";
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(fileOf("ran")); }));
    link.reset();
    ProgramLink::waitForAll();
    std::filesystem::remove(fileOf("ran"));
    (void)script("touch '" + fileOf("ran") + "'; cat #");
    make(command);
    EXPECT_TRUE(fails(MessageCode::ProgramNotConfirmed)) << "changed";
    EXPECT_FALSE(std::filesystem::exists(fileOf("ran")));
    link = std::make_unique<ProgramLink>(command, "test", nullptr);
    link->open();
    EXPECT_TRUE(fails(MessageCode::ProgramNotConfirmed));
}

TEST_F(ProgramLinkTest, OtherArgumentsOrPathsAreOtherPrograms) {
    const std::string path = script("cat"), copy = script("cat", "copy.sh");
    const std::string one = programFiles("sh " + path).value().hash;
    EXPECT_EQ(programFiles("sh   \"" + path + '"').value().hash, one) << "the same words";
    EXPECT_NE(programFiles("sh " + path + " -x").value().hash, one);
    EXPECT_NE(programFiles("sh " + copy).value().hash, one);
    EXPECT_EQ(programFiles("sh " + path).value().files.size(), 2U);
    EXPECT_EQ(commandLine({"sh", "a b", "c\"d"}), "sh \"a b\" \"c\"\"\"d\"");
    EXPECT_EQ(programFiles(commandLine({"sh", "a b", "c\"d"})).value().words,
              (std::vector<std::string>{"sh", "a b", "c\"d"}));
}

TEST_F(ProgramLinkTest, SaysWhatCannotBeStarted) {
    for (const char* command : {"", "/no/such/program x", "no-such-program", "/etc/passwd", "/"}) {
        make(command);
        EXPECT_TRUE(fails(MessageCode::ProgramNotStarted)) << command;
        EXPECT_FALSE(programFiles(command)) << command;
    }
}

// Catches a program that gets Bask's files, terminal, process group or ignored signals.
TEST_F(ProgramLinkTest, GivesItNothingOfItsOwn) {
    std::signal(SIGPIPE, SIG_IGN);
    makeOpen("sh " +
             script("ls /proc/self/fd | tr '\\n' ' '; "
                    "awk '{print \"group\", ($5 == $1 || $5 == '$$'), \"terminal\", $7}' /proc/$$/stat; "
                    "grep SigIgn /proc/$$/status; echo end; cat"));
    ASSERT_TRUE(comes("end"));
    EXPECT_EQ(m_read.substr(0, 8), "0 1 2 3 ") << "3 is ls's own: " << m_read;
    EXPECT_NE(m_read.find("group 1 terminal 0"), std::string::npos) << m_read;
    const std::string ignored =
        m_read.substr(m_read.find("SigIgn:\t") + 16, 8); // but for the C library's own
    EXPECT_EQ(std::stoul(ignored, nullptr, 16) & 0x7fffffffU, 0U) << m_read;
}

// Catches lines that are lost, torn or late between the two.
TEST_F(ProgramLinkTest, CarriesLinesBothWays) {
    makeOpen("cat");
    std::string sent;
    for (int i = 0; i < 2000; ++i) {
        const std::string line = "line " + std::to_string(i) + '\n';
        sent += line;
        link->write(line);
        m_read += link->read();
        if (i % 50 == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(comes("line 1999\n"));
    EXPECT_EQ(m_read, sent);
    EXPECT_LE(link->emptyAt_s(), SteadyClock().now_s());
}

// Catches an end that is not told with its reason, and a program that is started again in a hurry.
TEST_F(ProgramLinkTest, TellsWhyItHasEndedAndStartsItAgainLater) {
    const std::string command =
        "sh " + script("echo x >> '" + fileOf("starts") + "'; echo the arm is off >&2; exit 3");
    confirm(command);
    make(command);
    ASSERT_TRUE(fails(MessageCode::ProgramEnded));
    EXPECT_EQ(link->problem().args.at(1), MessageArg("exit code 3, \"the arm is off\""));
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(4000);
    while (std::chrono::steady_clock::now() < until) {
        link->open();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    const auto starts = textOf("starts").size() / 2;
    EXPECT_GE(starts, 3U);
    EXPECT_LE(starts, 4U) << "after 0.5, 1 and 2 s";
}

// Catches a program, or what it has started, that goes on when its link is closed.
TEST_F(ProgramLinkTest, EndsItAndWhatItHasStarted) {
    // SIGTERM comes after 1 s, SIGKILL after 2 s: each is over before the next would have ended it.
    struct Stubborn {
        const char* text;
        double min_s, max_s;
    };
    for (const Stubborn& each : {Stubborn{"echo $$; cat > /dev/null", 0.0, 0.95},
                                 Stubborn{"echo $$; while :; do sleep 0.1; done", 0.95, 1.95},
                                 Stubborn{"trap '' TERM; echo $$; while :; do sleep 0.1; done", 1.95, 4.0},
                                 Stubborn{"sleep 1000 & echo $!; cat > /dev/null", 0.0, 0.95}}) {
        m_read.clear();
        makeOpen("sh " + script(each.text));
        ASSERT_TRUE(comes("\n")) << each.text;
        const std::string pid = m_read;
        const SteadyClock clock;
        const double from_s = clock.now_s();
        link.reset();
        EXPECT_LT(clock.now_s() - from_s, 0.25) << "nobody waits for it";
        EXPECT_TRUE(isGone(pid)) << each.text;
        const double took_s = clock.now_s() - from_s;
        EXPECT_GE(took_s, each.min_s) << each.text;
        EXPECT_LE(took_s, each.max_s) << each.text;
        ProgramLink::waitForAll();
    }
}

// Catches a flood that fills the memory or holds the engine up.
TEST_F(ProgramLinkTest, EndsABabbler) {
    for (const char* text : {"while :; do printf '%01000d\\n' 1; done", "head -c 100000000 /dev/zero; cat"}) {
        makeOpen("sh " + script(text));
        const SteadyClock clock;
        const double from_s = clock.now_s();
        double worst_s = 0.0;
        std::size_t most = 0;
        while (link->isOpen() && clock.now_s() - from_s < 5.0) {
            const double before_s = clock.now_s();
            most = std::max(most, link->read().size());
            worst_s = std::max(worst_s, clock.now_s() - before_s);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        EXPECT_EQ(link->problem().code, MessageCode::ProgramStopped) << text;
        EXPECT_LT(clock.now_s() - from_s, 0.5 + 1.0) << text;
        EXPECT_LE(most, 200000U);
        EXPECT_LT(worst_s, 0.25);
        link.reset();
        ProgramLink::waitForAll();
    }
}

// Catches two programs that drive one device.
TEST_F(ProgramLinkTest, IsStartedOnceForADevice) {
    const std::string command = "cat -u";
    makeOpen(command);
    ProgramLink second(command, "test", m_confirmed), other(command, "other", m_confirmed);
    second.open();
    other.open();
    EXPECT_TRUE(waitFor([&] { return second.problem().code == MessageCode::ProgramNotStarted; }));
    EXPECT_TRUE(waitFor([&] { return other.isOpen(); })) << "another role's";
    link.reset();
    EXPECT_TRUE(waitFor([&] {
        second.open();
        return second.isOpen();
    })) << "when the first has ended";
}

} // namespace
} // namespace bask::test
