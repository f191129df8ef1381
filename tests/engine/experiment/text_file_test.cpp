#include "engine/experiment/text_file.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace bask {
namespace {

/// No file of this process may grow: writes fail as on a full disk.
class NoRoom {
public:
    NoRoom() {
        m_signal = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit none = m_before;
        none.rlim_cur = 0;
        ::setrlimit(RLIMIT_FSIZE, &none);
    }
    ~NoRoom() {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_signal);
    }

private:
    rlimit m_before{};
    void (*m_signal)(int);
};

} // namespace

// Catches an experiment that is replaced by an empty file, with success, when the disk is full.
TEST(TextFile, OnAFullDiskTheOldOneStaysAndItIsSaid) {
    const std::string path =
        std::filesystem::temp_directory_path() / ("text-file-" + std::to_string(::getpid()));
    for (const std::size_t size : {10U, 100'000U}) { // less and more than what is held back
        ASSERT_TRUE(writeTextFile(path, "old"));
        {
            const NoRoom full;
            const auto written = writeTextFile(path, std::string(size, 'x'));
            ASSERT_FALSE(written) << size;
            EXPECT_EQ(written.error().code(), MessageCode::FileUnwritable);
            EXPECT_NE(describe(written.error()).find("File too large"), std::string::npos)
                << describe(written.error());
        }
        std::ifstream file(path);
        std::string kept;
        file >> kept;
        EXPECT_EQ(kept, "old") << size;
    }
    std::filesystem::remove(path);
}

} // namespace bask
