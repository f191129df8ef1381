#include "engine/thermography/frame_file.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

// Catches: another frame than the one that was asked for, a first one that is taken unasked, and frames
// beyond the end.
TEST(FrameFile, ofSeveralFramesOneIsChosen) {
    const ThermalProfile lepton = findThermalProfile("lepton-3.5").value();
    std::ifstream told(kFolders + "three.json");
    const auto middle_degC = nlohmann::json::parse(told).get<std::vector<double>>();
    for (const char* name : {"three.raw", "three.tif", "three_motorola.tif"}) {
        SCOPED_TRACE(name);
        const std::string path = kFolders + name;
        EXPECT_EQ(frameCount(path, lepton).value(), 3U);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto frame = readFrame(path, lepton, k);
            ASSERT_TRUE(frame) << describe(frame.error());
            EXPECT_NEAR(frame->picture.at(80, 60), kelvinFromCelsius(middle_degC[k]), 1e-9);
        }
        EXPECT_EQ(readFrame(path, lepton, 3).error().code(), MessageCode::ThermalFrameNone);
        EXPECT_NE(describe(readFrame(path, lepton).error()).find("holds 3"), std::string::npos);
        EXPECT_NE(describe(readFrame(path, lepton).error()).find("--frame"), std::string::npos);
        EXPECT_EQ(framesOfFile(path, lepton).value(),
                  (std::vector<TimedFrame>{{path, 0.0, 0}, {path, 1.0 / 9.0, 1}, {path, 2.0 / 9.0, 2}}));
        ThermalProfile timeless = lepton;
        timeless.frameRate_Hz.reset();
        EXPECT_EQ(framesOfFile(path, timeless).error().code(), MessageCode::ThermalTimesNeeded);
    }
    for (const char* name :
         {"lepton.raw", "lepton.png", "lepton.tif", "comma.csv", "lepton_without_ending"}) {
        SCOPED_TRACE(name);
        const std::string path = kFolders + name;
        EXPECT_EQ(frameCount(path, lepton).value(), 1U);
        EXPECT_EQ(framesOfFile(path, lepton).value(), (std::vector<TimedFrame>{{path, 0.0}}));
        EXPECT_EQ(readFrame(path, lepton, 0).value().picture, readFrame(path, lepton).value().picture);
        EXPECT_EQ(readFrame(path, lepton, 1).error().code(), MessageCode::ThermalFrameNone);
    }
    EXPECT_EQ(frameCount(kFolders + "either.raw", lepton).error().code(), MessageCode::ThermalFramesEither);
    EXPECT_EQ(frameCount(kFolders + "short.raw", lepton).error().code(), MessageCode::ThermalFrameSize);
    EXPECT_EQ(frameCount(kFolders + "big.tif", lepton).error().code(), MessageCode::ThermalBigTiff);
}

// Catches: a recording of more bytes than a frame may have, of which none can be read.
TEST(FrameFile, theCamerasBytesMayBeALongRecording) {
    const ThermalProfile lepton = findThermalProfile("lepton-3.5").value();
    const TemporaryFolder folder;
    const std::string path = (folder.path / "long.raw").string();
    fs::copy_file(kFolders + "three.raw", path);
    fs::resize_file(path, 2000U * 38400U); // 73 MiB, of which most are on no disk
    EXPECT_EQ(frameCount(path, lepton).value(), 2000U);
    EXPECT_EQ(readFrame(path, lepton, 1).value().picture,
              readFrame(kFolders + "three.raw", lepton, 1).value().picture);
    EXPECT_EQ(readFrame(path, lepton, 1999).error().code(), MessageCode::ThermalPictureConstant);
}

TEST(FrameFile, aMissingFileOrAFolderIsToldSo) {
    EXPECT_EQ(readFrame(kFolders + "gone.raw", ours()).error().code(), MessageCode::FileNotFound);
    EXPECT_EQ(readFrame(kFolders + "folder", ours()).error().code(), MessageCode::FileUnreadable);
}

} // namespace bask
