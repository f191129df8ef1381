// A live thermal camera through OpenCV's V4L2, which speaks to a device of this program's own (fake_v4l2.h):
// what is asked of the camera, how its frames arrive, and what is told when it misbehaves.

#include "engine/base/message_code.h"
#include "engine/devices/video_thermal_camera.h"
#include "tests/engine/devices/fake_v4l2.h"
#include "tests/engine/devices/video_samples.h"

#include <gtest/gtest.h>

#include <linux/videodev2.h>

namespace bask {
namespace {

using test::fakeCamera;
using test::FakeCameraMood;
using test::waitUntil;

constexpr const char* kDevice = "77";
const SteadyClock kTestClock;

/// A frame of the profile: a grey picture above, where it sends one, and a ramp of temperatures.
std::string frameOf(const ThermalProfile& profile, int moreRows) {
    std::string bytes;
    const auto add = [&](unsigned number) {
        bytes += static_cast<char>(number & 0xffU);
        bytes += static_cast<char>(number >> 8U);
    };
    const auto pixels = [&](int rows) { return rows * profile.width; };
    for (int k = 0; k < pixels(profile.skipTop); ++k)
        add(0x8000U + static_cast<unsigned>(k % 200) + 20U);
    for (int k = 0; k < pixels(profile.height); ++k)
        add(static_cast<unsigned>((300.0 + 0.1 * (k % 97)) / profile.scale));
    for (int k = 0; k < pixels(profile.skipBottom + moreRows); ++k)
        add(static_cast<unsigned>(k));
    return bytes;
}

void plugIn(const ThermalProfile& profile, int moreRows = 0) {
    test::FakeCamera& camera = fakeCamera();
    camera.format = profile.pixelFormat == "YUYV" ? V4L2_PIX_FMT_YUYV : V4L2_PIX_FMT_Y16;
    camera.width = profile.width;
    camera.height = profile.skipTop + profile.height + profile.skipBottom + moreRows;
    camera.frame = frameOf(profile, moreRows);
    camera.changing = 2 * static_cast<std::size_t>(profile.width) * static_cast<std::size_t>(profile.skipTop);
    camera.opened = camera.sent = 0;
    camera.setMood(FakeCameraMood::Good);
}

ThermalProfile named(const std::string& name) {
    return findThermalProfile(name).value();
}

std::string wordsOf(const Error& error) {
    return error.message.args.size() > 1 ? error.message.args[1].text() : "";
}

// Catches: a format that OpenCV makes a picture of, rows for columns, the other byte order, rows that are not
// skipped, or the picture for people in place of the temperatures.
TEST(LiveThermalCamera, HandsOutTheNumbersOfEachCamera) {
    for (const ThermalProfile& profile : shippedThermalProfiles())
        for (const int moreRows : {0, profile.optionalBottom}) {
            plugIn(profile, moreRows);
            VideoThermalCamera camera(kDevice, profile, kTestClock);
            ASSERT_TRUE(waitUntil([&] { return camera.newest().ok(); }))
                << profile.name << ": " << describe(camera.newest().error());
            const auto expected = frameOfBytes(fakeCamera().frame, profile, "expected");
            ASSERT_TRUE(expected) << profile.name;
            ThermalPicture got = (*camera.newest())->frame.picture;
            ASSERT_EQ(got.T_K.size(), expected->picture.T_K.size()) << profile.name;
            got.T_K.front() = expected->picture.T_K.front(); // its lowest bits are noise
            EXPECT_EQ(got, expected->picture) << profile.name << ", " << moreRows << " rows more";
            const auto first = (*camera.newest())->number;
            EXPECT_TRUE(waitUntil([&] { return (*camera.newest())->number > first + 3; }));
            EXPECT_LE((*camera.newest())->time_s, kTestClock.now_s());
            EXPECT_EQ(camera.leftOut().count, 0) << profile.name;
        }
}

// Catches frames of another camera read as if they were this one's.
TEST(LiveThermalCamera, RefusesACameraThatGivesOtherFrames) {
    const auto refusal = [](const ThermalProfile& profile) {
        const auto opened = openThermalFrames(kDevice, profile);
        return opened ? std::string() : wordsOf(opened.error());
    };
    plugIn(named("p2-pro"));
    EXPECT_NE(refusal(named("lepton-3.5")).find("lepton-3.5"), std::string::npos);
    plugIn(named("lepton-3.5"));
    EXPECT_NE(refusal(named("p2-pro")).find("p2-pro"), std::string::npos);
    EXPECT_NE(refusal(named("lepton-2.5")).find("lepton-2.5"), std::string::npos) << "another size";
    fakeCamera().format = V4L2_PIX_FMT_YUYV;
    EXPECT_NE(refusal(named("lepton-3.5")).find("lepton-3.5"), std::string::npos) << "as many bytes";
    fakeCamera().setMood(FakeCameraMood::Gone);
    EXPECT_NE(refusal(named("lepton-3.5")).find("no camera"), std::string::npos);
    plugIn(named("lepton-3.5"));
    fakeCamera().setMood(FakeCameraMood::Constant);
    EXPECT_NE(refusal(named("lepton-3.5")).find("one value"), std::string::npos);
}

/// A Lepton that has given frames.
struct Live {
    Live() {
        plugIn(named("lepton-3.5"));
        camera = std::make_unique<VideoThermalCamera>(kDevice, named("lepton-3.5"), kTestClock);
        EXPECT_TRUE(waitUntil([&] { return camera->newest().ok(); }));
    }
    ~Live() { fakeCamera().setMood(FakeCameraMood::Gone); } // the capture's thread ends at once
    bool isLost() {
        return waitUntil([&] { return !camera->newest().ok(); });
    }
    bool isBack() {
        fakeCamera().setMood(FakeCameraMood::Good);
        return waitUntil([&] { return camera->newest().ok(); }, 40.0);
    }
    std::unique_ptr<VideoThermalCamera> camera;
};

void expectLostSoonAndBack(FakeCameraMood mood) {
    Live live;
    fakeCamera().setMood(mood);
    const double begun_s = kTestClock.now_s();
    ASSERT_TRUE(live.isLost());
    EXPECT_LE(kTestClock.now_s() - begun_s, 3.0);
    EXPECT_EQ(live.camera->newest().error().code(), MessageCode::CameraLost);
    EXPECT_TRUE(live.isBack());
}

TEST(LiveThermalCamera, IsLostWhenItIsUnpluggedAndComesBack) {
    expectLostSoonAndBack(FakeCameraMood::Gone);
    EXPECT_GT(fakeCamera().opened, 1);
}

TEST(LiveThermalCamera, IsLostWhenItIsSilentAndComesBack) {
    expectLostSoonAndBack(FakeCameraMood::Silent);
}

TEST(LiveThermalCamera, LeavesOutFramesOfNothingAndIsLostWhenNoOthersCome) {
    Live live;
    fakeCamera().setMood(FakeCameraMood::Constant);
    ASSERT_TRUE(live.isLost());
    EXPECT_NE(wordsOf(live.camera->newest().error()).find("one value"), std::string::npos);
    EXPECT_GT(live.camera->leftOut().count, 3);
    EXPECT_TRUE(live.isBack());
}

TEST(LiveThermalCamera, TellsWhenItsShutterWasOpenAgain) {
    Live live;
    EXPECT_FALSE(live.camera->newest().value()->shutter_s);
    const double shut_s = kTestClock.now_s();
    fakeCamera().setMood(FakeCameraMood::Silent);
    ASSERT_TRUE(waitUntil([&] { return kTestClock.now_s() > shut_s + 0.45; }));
    EXPECT_TRUE(live.camera->newest()) << "half a second is no loss";
    fakeCamera().setMood(FakeCameraMood::Good);
    ASSERT_TRUE(waitUntil([&] {
        const auto frame = live.camera->newest();
        return frame && (*frame)->shutter_s && *(*frame)->shutter_s > shut_s;
    }));
}

} // namespace
} // namespace bask
