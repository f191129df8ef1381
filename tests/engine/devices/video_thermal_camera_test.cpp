// Thermal frames from recordings and from devices that misbehave.

#include "engine/base/message_code.h"
#include "engine/devices/video_thermal_camera.h"
#include "tests/engine/devices/video_samples.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>

namespace bask {
namespace {

using test::ScratchFolder;
using test::waitUntil;

const SteadyClock kTestClock;

ThermalProfile lepton() {
    return findThermalProfile("lepton-3.5").value();
}

/// A frame of the Lepton with a ramp from this temperature, as it sends it.
std::string leptonBytes(double from_K, std::size_t pixels = 160 * 120) {
    std::string bytes;
    for (std::size_t k = 0; k < pixels; ++k) {
        const auto number =
            static_cast<unsigned>(std::lround(100.0 * from_K)) + static_cast<unsigned>(k % 97);
        bytes += static_cast<char>(number & 0xffU);
        bytes += static_cast<char>(number >> 8U);
    }
    return bytes;
}

void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string wordsOf(const Error& error) {
    return error.message.args.size() > 1 ? error.message.args[1].text() : "";
}

TEST(ThermalFrames, PlayAFolderAtItsTimesRoundAndRound) {
    const ScratchFolder folder;
    write(folder / "a.raw", leptonBytes(300.0));
    write(folder / "b.raw", leptonBytes(310.0));
    write(folder / "times.csv", "file,time_s\na.raw,0\nb.raw,0.2\n");
    auto source = openThermalFrames(folder / "", lepton());
    ASSERT_TRUE(source) << describe(source.error());
    for (const double expected_K : {300.0, 310.0, 300.0}) {
        const auto caught = (*source)->next();
        ASSERT_TRUE(caught) << describe(caught.error());
        EXPECT_NEAR(caught->frame.picture.at(0, 0), expected_K, 1e-9);
        EXPECT_GT((*source)->period_s(), 0.0);
        if (expected_K == 300.0) {
            EXPECT_NEAR((*source)->period_s(), 0.2, 1e-9);
        }
    }
}

TEST(ThermalFrames, AreRefusedInWordsWhenTheyAreOpened) {
    const ScratchFolder folder;
    write(folder / "short.raw", leptonBytes(300.0, 1000));
    write(folder / "empty.raw", "");
    for (const std::string& name : {folder / "short.raw", folder / "empty.raw", folder / "", folder / "none",
                                    std::string(), std::string("/dev/null")}) {
        const auto source = openThermalFrames(name, lepton());
        ASSERT_FALSE(source) << name;
        EXPECT_EQ(source.error().code(), MessageCode::CameraNotOpened) << name;
        EXPECT_FALSE(wordsOf(source.error()).empty()) << name;
    }
}

TEST(VideoThermalCamera, HandsOutTheFramesOfARecording) {
    const ScratchFolder folder;
    write(folder / "a.raw", leptonBytes(300.0));
    write(folder / "b.raw", leptonBytes(310.0));
    write(folder / "times.csv", "file,time_s\na.raw,0\nb.raw,0.1\n");
    VideoThermalCamera camera(folder / "", lepton(), kTestClock);
    bool isFirst = false, isSecond = false;
    EXPECT_TRUE(waitUntil([&] {
        if (const auto newest = camera.newest()) {
            const double first_K = (*newest)->frame.picture.at(0, 0);
            isFirst = isFirst || std::abs(first_K - 300.0) < 1e-6;
            isSecond = isSecond || std::abs(first_K - 310.0) < 1e-6;
            EXPECT_LE((*newest)->time_s, kTestClock.now_s());
        }
        return isFirst && isSecond;
    }));
}

/// A camera whose shutter closes for a while, and then another sort of frame comes.
class ShutterSource final : public ThermalFrameSource {
public:
    explicit ShutterSource(std::shared_ptr<std::atomic<int>> state) : m_state(std::move(state)) {}
    Result<CaughtThermalFrame> next() override {
        if (*m_state == 2)
            return Error{MessageCode::CameraNotOpened, "", {"scripted", "another format"}};
        m_from_K += *m_state == 0 ? 0.01 : 0.0;
        auto frame = frameOfBytes(leptonBytes(m_from_K), lepton(), "scripted");
        return CaughtThermalFrame{std::move(*frame), kTestClock.now_s()};
    }

private:
    std::shared_ptr<std::atomic<int>> m_state;
    double m_from_K = 300.0;
};

TEST(VideoThermalCamera, KeepsTheLastFrameWhileTheShutterIsClosedAndTellsALoss) {
    const auto state = std::make_shared<std::atomic<int>>(0);
    VideoThermalCamera camera("scripted", lepton(), kTestClock, [state](const std::function<bool()>&) {
        return Result<std::unique_ptr<ThermalFrameSource>>(std::make_unique<ShutterSource>(state));
    });
    ASSERT_TRUE(waitUntil([&] { return camera.newest().ok(); }));
    *state = 1;
    std::uint64_t number = 0;
    int same = 0;
    ASSERT_TRUE(waitUntil([&] {
        const auto newest = camera.newest();
        if (!newest)
            return true; // longer than any shutter
        same += (*newest)->number == number ? 1 : 0;
        number = (*newest)->number;
        return same > 20;
    }));
    *state = 2;
    ASSERT_TRUE(waitUntil([&] { return !camera.newest().ok(); }));
    EXPECT_EQ(camera.newest().error().code(), MessageCode::CameraLost);
}

} // namespace
} // namespace bask
