// Files that come whole or not at all: a full disk, a signal or a kill at any step.

#include "engine/base/whole_file.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/base/replaced_files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

std::string textIn(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class WholeFiles : public ::testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "bask-whole-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        m_folder = name;
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string at(const std::string& name) const { return (m_folder / name).string(); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(at(name)) << text; }
    std::set<std::string> names() const {
        std::set<std::string> all;
        for (const fs::directory_entry& entry : fs::directory_iterator(m_folder))
            all.insert(entry.path().filename().string());
        return all;
    }
    /// In a process of its own, which is then killed, as by SIGKILL: no destructor runs.
    template <class Body> static void killedAfter(const Body& body) {
        const pid_t child = ::fork();
        if (child == 0) {
            body();
            ::kill(::getpid(), SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
    }

    fs::path m_folder;
};

/// No file of this process may grow beyond so many bytes: writes fail as on a full disk.
class Room {
public:
    explicit Room(rlim_t bytes) {
        m_signal = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit less = m_before;
        less.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &less);
    }
    ~Room() {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_signal);
    }
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

private:
    rlimit m_before{};
    void (*m_signal)(int);
};

TEST_F(WholeFiles, AreReplacedThroughLinksWithTheirRights) {
    write("old", "old");
    ASSERT_EQ(::chmod(at("old").c_str(), 0640), 0);
    fs::create_symlink("old", at("link"));
    fs::create_symlink("new", at("to-come"));
    ASSERT_TRUE(writeWholeFile(at("link"), "new"));
    ASSERT_TRUE(writeWholeFile(at("to-come"), "first"));
    EXPECT_EQ(textIn(at("old")), "new");
    EXPECT_TRUE(fs::is_symlink(at("link")));
    EXPECT_EQ(textIn(at("new")), "first");
    EXPECT_EQ(fs::status(at("old")).permissions(), fs::perms(0640));
    EXPECT_EQ(names(), (std::set<std::string>{"link", "new", "old", "to-come"}));
}

TEST_F(WholeFiles, AreRefusedInWords) {
    fs::create_directory(at("folder"));
    const auto inFolder = writeWholeFile(at("folder"), "x"), nowhere = writeWholeFile(at("no/x"), "x");
    ASSERT_FALSE(inFolder);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(describe(inFolder.error()), at("folder") + ": the file cannot be written: Is a directory");
    EXPECT_EQ(describe(nowhere.error()),
              at("no/x") + ": the file cannot be written: No such file or directory");
}

// Catches: the first of two outputs that stays when there is no room for the second, or an old one that is
// gone.
TEST_F(WholeFiles, SeveralComeTogetherOrNotAtAll) {
    write("a", "old");
    const std::vector<WholeFile> files{{at("a"), "new"}, {at("b"), std::string(5000, 'b')}};
    {
        const Room little(1000);
        const auto written = writeWholeFiles(files);
        ASSERT_FALSE(written);
        EXPECT_EQ(describe(written.error()), at("b") + ": the file cannot be written: File too large");
    }
    EXPECT_EQ(names(), std::set<std::string>{"a"});
    EXPECT_EQ(textIn(at("a")), "old");
    fs::create_directory(at("c"));
    EXPECT_FALSE(writeWholeFiles({{at("a"), "new"}, {at("c"), "c"}}));
    EXPECT_EQ(textIn(at("a")), "old");
    fs::remove(at("c"));
    ASSERT_TRUE(writeWholeFiles(files));
    EXPECT_EQ(names(), (std::set<std::string>{"a", "b"}));
    EXPECT_EQ(textIn(at("a")), "new");
}

// Catches: what a kill leaves that lies there for ever.
TEST_F(WholeFiles, WhatAKillLeavesIsClearedByTheNext) {
    killedAfter([&] {
        const auto hidden = HiddenFolder::in(m_folder.string());
        std::ofstream(hidden->place("half")) << "half";
        ::kill(::getpid(), SIGKILL);
    });
    ASSERT_EQ(names().size(), 1U);
    EXPECT_TRUE(names().begin()->starts_with(".bask-part-")) << *names().begin();
    ASSERT_TRUE(writeWholeFile(at("a"), "whole"));
    EXPECT_EQ(names(), std::set<std::string>{"a"});
}

// Catches: a folder of a process that lives, which another deletes, and one of another computer.
TEST_F(WholeFiles, WhatIsInUseOrOfAnotherComputerStays) {
    auto inUse = HiddenFolder::in(m_folder.string());
    ASSERT_TRUE(inUse);
    std::ofstream(inUse->place("half")) << "half";
    fs::create_directory(at(".bask-part-elsewhere-1-1"));
    killedAfter([&] { clearLeft(m_folder.string()); });
    EXPECT_TRUE(fs::exists(inUse->place("half")));
    EXPECT_TRUE(fs::exists(at(".bask-part-elsewhere-1-1")));
}

// Catches: an old file that a kill, while it is being replaced, leaves under a hidden name only.
TEST_F(WholeFiles, AnOldOneWhoseReplacementIsKilledComesBack) {
    write("gone", "old");
    write("there", "old");
    killedAfter([&] {
        ReplacedFiles replaced;
        (void)replaced.setAside(at("gone"));
        (void)replaced.setAside(at("there"));
        fs::remove(at("gone"));
        write("there", "new");
        ::kill(::getpid(), SIGKILL);
    });
    EXPECT_FALSE(fs::exists(at("gone")));
    ASSERT_TRUE(writeWholeFile(at("a"), "whole"));
    EXPECT_EQ(textIn(at("gone")), "old");
    EXPECT_EQ(names(), (std::set<std::string>{"a", "gone", "there"}));
}

TEST_F(WholeFiles, ReplacedOnesComeBackUnlessTheNewAreKept) {
    write("a", "old");
    for (const bool isKept : {false, true}) {
        {
            ReplacedFiles replaced;
            ASSERT_TRUE(replaced.setAside(at("a")));
            ASSERT_TRUE(replaced.setAside(at("b")));
            ASSERT_TRUE(writeWholeFile(at("a"), "new"));
            ASSERT_TRUE(writeWholeFile(at("b"), "new"));
            ASSERT_TRUE(replaced.setAside(at("a"))) << "a second time changes nothing";
            if (isKept)
                replaced.keepNew();
        }
        EXPECT_EQ(textIn(at("a")), isKept ? "new" : "old");
        EXPECT_EQ(names(), (isKept ? std::set<std::string>{"a", "b"} : std::set<std::string>{"a"}));
    }
}

} // namespace
} // namespace bask
