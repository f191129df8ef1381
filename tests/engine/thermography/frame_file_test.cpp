#include "engine/thermography/frame_file.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace bask {
namespace {

namespace fs = std::filesystem;

const std::string kFolders = BASK_FRAMES "/";

struct TemporaryFolder {
    fs::path path = fs::temp_directory_path() /
                    ("bask_frames_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                     ::testing::UnitTest::GetInstance()->current_test_info()->name());
    TemporaryFolder() {
        fs::remove_all(path);
        fs::create_directory(path);
    }
    ~TemporaryFolder() { fs::remove_all(path); }
    void write(const char* name, const std::string& text) const { std::ofstream(path / name) << text; }
};

ThermalProfile ours() {
    return findThermalProfile(kFolders + "ours.json").value();
}

} // namespace

// Catches: frame 10 before frame 2, a note among the frames, times that are not the profile's.
TEST(FrameFolder, playsInTheOrderOfNamesAtTheProfilesRate) {
    const auto frames = framesOfFolder(kFolders + "folder", ours());
    ASSERT_TRUE(frames) << describe(frames.error());
    const std::string folder = kFolders + "folder/";
    EXPECT_EQ(*frames, (std::vector<TimedFrame>{{folder + "frame1.bin", 0.0},
                                                {folder + "frame2.bin", 0.5},
                                                {folder + "frame10.bin", 1.0}}));
    for (const TimedFrame& frame : *frames)
        EXPECT_TRUE(readFrame(frame.path, ours()));
}

TEST(FrameFolder, playsAtTheTimesThatAreBesideThem) {
    const auto frames = framesOfFolder(kFolders + "timed", std::nullopt);
    ASSERT_TRUE(frames) << describe(frames.error());
    const std::string folder = kFolders + "timed/";
    EXPECT_EQ(*frames, (std::vector<TimedFrame>{{folder + "b.csv", 0.0}, {folder + "a.csv", 1.25}}));
    EXPECT_TRUE(readFrame(frames->front().path, std::nullopt));
}

// Catches: times that are made up, and files outside of the folder that are read.
TEST(FrameFolder, refusesTimesThatAreNone) {
    EXPECT_EQ(framesOfFolder(kFolders + "gone", ours()).error().code(), MessageCode::FileNotFound);
    EXPECT_EQ(framesOfFolder(kFolders + "folder", std::nullopt).error().code(),
              MessageCode::ThermalTimesNeeded);
    const TemporaryFolder folder;
    EXPECT_EQ(framesOfFolder(folder.path.string(), ours()).error().code(), MessageCode::ThermalNoFrames);
    folder.write("a.csv", "1");
    folder.write("b.csv", "2");
    const char* refused[] = {"a.csv,0\n",
                             "file,time\na.csv,0\n",
                             "file,time_s\na.csv,0\nc.csv,1\n",
                             "file,time_s\na.csv,0\nb.csv,0\n",
                             "file,time_s\na.csv,1\nb.csv,0\n",
                             "file,time_s\na.csv,nan\n",
                             "file,time_s\na.csv\n",
                             "file,time_s\n../a.csv,0\n",
                             "file,time_s\n/etc/passwd,0\n",
                             "file,time_s\n.,0\n"};
    for (const char* text : refused) {
        folder.write(kFrameTimesFile, text);
        const auto frames = framesOfFolder(folder.path.string(), ours());
        ASSERT_FALSE(frames) << text;
        EXPECT_EQ(frames.error().code(), MessageCode::ThermalTimesLine) << text;
    }
    folder.write(kFrameTimesFile, "file,time_s\n");
    EXPECT_EQ(framesOfFolder(folder.path.string(), ours()).error().code(), MessageCode::ThermalNoFrames);
    folder.write(kFrameTimesFile, "");
    EXPECT_EQ(framesOfFolder(folder.path.string(), ours()).error().code(), MessageCode::FileEmpty);
}

TEST(FrameFile, aMissingFileOrAFolderIsToldSo) {
    EXPECT_EQ(readFrame(kFolders + "gone.raw", ours()).error().code(), MessageCode::FileNotFound);
    EXPECT_EQ(readFrame(kFolders + "folder", ours()).error().code(), MessageCode::FileUnreadable);
}

} // namespace bask
