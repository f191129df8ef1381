// Pictures of the thermal camera in a session: stored without loss, exported, and not there where there is no
// camera.

#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/session_file.h"
#include "engine/thermography/frame_file.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/told_shares.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace bask {
namespace {

Experiment withCamera() {
    Experiment experiment = test::twoDisks();
    experiment.simulation.thermalCamera.emplace().profile = "lepton-3.5";
    return experiment;
}

struct ThermalFramesOfASession : testing::Test {
    QTemporaryDir folder;
    std::string path = folder.filePath("run.bask").toStdString();
    std::string frames = folder.filePath("frames").toStdString();
    ThermalProfile profile = findThermalProfile("lepton-3.5").value();

    void record(const Experiment& experiment, int count) {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < count; ++k) {
            ASSERT_TRUE((*writer)->add(test::madeUpSample(experiment, k)));
            ASSERT_TRUE((*writer)->add(
                TraceFrame{0.5 + k, std::make_shared<ThermalPicture>(test::madeUpPicture(profile, k))}));
        }
        ASSERT_TRUE((*writer)->finish("settled"));
    }
};

} // namespace

TEST_F(ThermalFramesOfASession, AreStoredWithoutLossAndExportedAsAFolderThatPlays) {
    record(withCamera(), 12);
    int k = 0;
    ASSERT_TRUE(readThermalFrames(path, [&](double time_s, const std::string& png) {
        EXPECT_EQ(time_s, 0.5 + k);
        EXPECT_EQ(frameOfImage(png, profile, "png").value().picture, test::madeUpPicture(profile, k)) << k;
        ++k;
    }));
    EXPECT_EQ(k, 12);
    test::ToldShares shares;
    const auto files = exportThermalFrames(path, frames, shares.told());
    shares.expectAWhole(12);
    ASSERT_TRUE(files) << describe(files.error());
    EXPECT_EQ(files->size(), 14U);
    const auto read = readFrame(frames + "/frame_0000012.tif", profile);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->picture, test::madeUpPicture(profile, 11));
    std::ifstream times(frames + "/times.csv");
    const std::string text{std::istreambuf_iterator<char>(times), {}};
    EXPECT_EQ(framesOfFolder(frames, profile).value().size(), 12U);
    EXPECT_EQ(text.find("file,time_s\nframe_0000001.tif,0.5\n"), 0U) << text;
    // The CSV export leaves them out: they are no table.
    const auto tables = exportSessionCsv(path, folder.filePath("csv").toStdString());
    ASSERT_TRUE(tables);
    for (const std::string& file : *tables)
        EXPECT_EQ(file.find("thermal_frame"), std::string::npos);
}

// Catches a moment that gets a later picture, or one of another place in the table.
TEST_F(ThermalFramesOfASession, AreFoundByTheirMoment) {
    for (const int count : {1, 2, 7, 12}) {
        record(withCamera(), count);
        const auto session = RecordedSession::open(path);
        ASSERT_TRUE(session);
        EXPECT_TRUE((*session)->hasThermalFrames());
        for (double time_s = -1.0; time_s < 15.0; time_s += 0.25) {
            const auto frame = (*session)->thermalFrameAt(time_s);
            ASSERT_TRUE(frame) << describe(frame.error());
            const int expected = std::clamp(static_cast<int>(std::floor(time_s - 0.5)), 0, count - 1);
            EXPECT_EQ(frame->time_s, 0.5 + expected) << time_s;
            EXPECT_EQ(frame->number, expected + 1);
            EXPECT_EQ(frameOfImage(frame->png, profile, "png").value().picture,
                      test::madeUpPicture(profile, expected));
        }
        std::filesystem::remove(path);
    }
    record(withCamera(), 0);
    const auto session = RecordedSession::open(path);
    ASSERT_TRUE(session);
    EXPECT_FALSE((*session)->hasThermalFrames());
    EXPECT_FALSE((*session)->thermalFrameAt(1.0));
}

TEST_F(ThermalFramesOfASession, OfTheCamerasReadingsNothingIsLost) {
    const Experiment experiment = withCamera();
    record(experiment, 12);
    const auto session = readSession(path);
    ASSERT_TRUE(session);
    for (int k = 0; k < 12; ++k)
        EXPECT_TRUE(test::sameSample(session->samples[static_cast<std::size_t>(k)],
                                     test::madeUpSample(experiment, k)))
            << k;
}

TEST_F(ThermalFramesOfASession, AreNotThereWithoutACamera) {
    const Experiment experiment = test::twoDisks();
    {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE(writer);
        ASSERT_TRUE((*writer)->add(test::madeUpSample(experiment, 0)));
        EXPECT_THROW((void)(*writer)->add(
                         TraceFrame{0.5, std::make_shared<ThermalPicture>(test::madeUpPicture(profile, 0))}),
                     std::invalid_argument);
    }
    ASSERT_TRUE(readThermalFrames(path, [](double, const std::string&) { ADD_FAILURE(); }));
    const auto files = exportThermalFrames(path, frames);
    ASSERT_FALSE(files);
    EXPECT_EQ(files.error().code(), MessageCode::NoThermalFrames);
}

} // namespace bask
