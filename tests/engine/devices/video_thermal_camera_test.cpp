// Thermal frames from recordings and from devices that misbehave.

#include "engine/base/message_code.h"
#include "engine/devices/shutter_watch.h"
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

TEST(ThermalFrames, PlayAFileOfSeveralAtTheProfilesRate) {
    const ScratchFolder folder;
    write(folder / "three.raw", leptonBytes(300.0) + leptonBytes(310.0) + leptonBytes(320.0));
    auto source = openThermalFrames(folder / "three.raw", lepton());
    ASSERT_TRUE(source) << describe(source.error());
    for (const double expected_K : {300.0, 310.0, 320.0, 300.0}) {
        const auto caught = (*source)->next();
        ASSERT_TRUE(caught) << describe(caught.error());
        EXPECT_NEAR(caught->frame.picture.at(0, 0), expected_K, 1e-9);
        if (expected_K < 320.0) {
            EXPECT_NEAR((*source)->period_s(), 1.0 / 9.0, 1e-9);
        }
    }
    ThermalProfile timeless = lepton();
    timeless.frameRate_Hz.reset();
    const auto refused = openThermalFrames(folder / "three.raw", timeless);
    ASSERT_FALSE(refused);
    EXPECT_NE(wordsOf(refused.error()).find("frame_rate_Hz"), std::string::npos);
}

/// A folder with a good first and last frame and these between them.
void writeRecording(const ScratchFolder& folder, const std::vector<std::string>& between, double period_s) {
    std::string times = "file,time_s\n";
    const auto add = [&](std::size_t k, const std::string& bytes) {
        write(folder / (std::to_string(k) + ".raw"), bytes);
        times += std::to_string(k) + ".raw," + std::to_string(static_cast<double>(k) * period_s) + "\n";
    };
    add(0, leptonBytes(300.0));
    for (std::size_t k = 0; k < between.size(); ++k)
        add(k + 1, between[k]);
    add(between.size() + 1, leptonBytes(310.0));
    write(folder / "times.csv", times);
}

std::string constantBytes() {
    std::string bytes;
    for (int k = 0; k < 160 * 120; ++k)
        bytes += "\x30\x75";
    return bytes;
}

const std::vector<std::string> kBadFrames{constantBytes(), leptonBytes(300.0, 1000), ""};

// Catches: a recording that ends, or begins again, at a frame of a closed shutter or a damaged one; and one
// whose times shift by it.
TEST(ThermalFrames, AFrameThatCannotBeUsedIsAnErrorOfItsOwn) {
    const ScratchFolder folder;
    writeRecording(folder, kBadFrames, 0.125);
    auto source = openThermalFrames(folder / "", lepton());
    ASSERT_TRUE(source) << describe(source.error());
    for (int round = 0; round < 2; ++round) {
        EXPECT_TRUE((*source)->next());
        for (const MessageCode expected :
             {MessageCode::ThermalPictureConstant, MessageCode::ThermalFrameSize, MessageCode::FileEmpty}) {
            const auto bad = (*source)->next();
            ASSERT_FALSE(bad);
            EXPECT_EQ(bad.error().code(), expected);
            EXPECT_NEAR((*source)->period_s(), 0.125, 1e-9);
        }
        const auto last = (*source)->next();
        ASSERT_TRUE(last);
        EXPECT_NEAR(last->frame.picture.at(0, 0), 310.0, 1e-9);
    }
}

// Catches: a closed shutter at the very beginning that keeps a recording from being opened, and one without
// a good frame that is opened or played for ever.
TEST(ThermalFrames, OneGoodFrameIsNeeded) {
    const ScratchFolder folder;
    write(folder / "a.raw", constantBytes());
    write(folder / "b.raw", leptonBytes(300.0));
    auto source = openThermalFrames(folder / "", lepton());
    ASSERT_TRUE(source) << describe(source.error());
    EXPECT_FALSE((*source)->next());
    EXPECT_TRUE((*source)->next());
    write(folder / "b.raw", "cut off");
    EXPECT_NE((*source)->next().error().code(), MessageCode::CameraNotOpened);
    EXPECT_EQ((*source)->next().error().code(), MessageCode::CameraNotOpened) << "a whole round";
    const auto none = openThermalFrames(folder / "", lepton());
    ASSERT_FALSE(none);
    EXPECT_NE(wordsOf(none.error()).find("a.raw"), std::string::npos) << wordsOf(none.error());
}

TEST(VideoThermalCamera, PlaysPastFramesThatCannotBeUsedAndCountsThem) {
    const ScratchFolder folder;
    writeRecording(folder, kBadFrames, 0.02);
    VideoThermalCamera camera(folder / "", lepton(), kTestClock);
    EXPECT_TRUE(waitUntil([&] {
        const auto newest = camera.newest();
        return newest && std::abs((*newest)->frame.picture.at(0, 0) - 310.0) < 1e-6;
    }));
    ASSERT_TRUE(waitUntil([&] { return camera.leftOut().count >= 6; })) << "the second round, too";
    EXPECT_TRUE(camera.newest());
    ASSERT_TRUE(camera.leftOut().last);
    EXPECT_NE(camera.leftOut().last->where.find(".raw"), std::string::npos);
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

/// A live camera that sends frames of nothing.
class BadSource final : public ThermalFrameSource {
public:
    BadSource(const std::shared_ptr<std::atomic<int>>& opened, std::shared_ptr<std::atomic<bool>> isBad)
        : m_isBad(std::move(isBad)) {
        ++*opened;
    }
    Result<CaughtThermalFrame> next() override {
        if (*m_isBad)
            return Error{MessageCode::ThermalPictureConstant, "scripted"};
        m_from_K += 0.01;
        auto frame = frameOfBytes(leptonBytes(m_from_K), lepton(), "scripted");
        return CaughtThermalFrame{std::move(*frame), kTestClock.now_s()};
    }

private:
    std::shared_ptr<std::atomic<bool>> m_isBad;
    double m_from_K = 300.0;
};

// Catches: a live camera that is closed at the first frame that cannot be used, or never opened again.
TEST(VideoThermalCamera, IsOpenedAgainWhenNoGoodFrameComesForASecond) {
    const auto opened = std::make_shared<std::atomic<int>>(0);
    const auto isBad = std::make_shared<std::atomic<bool>>(false);
    VideoThermalCamera camera("scripted", lepton(), kTestClock, [=](const std::function<bool()>&) {
        return Result<std::unique_ptr<ThermalFrameSource>>(std::make_unique<BadSource>(opened, isBad));
    });
    ASSERT_TRUE(waitUntil([&] { return camera.newest().ok(); }));
    *isBad = true;
    ASSERT_TRUE(waitUntil([&] { return camera.leftOut().count > 3; }));
    *isBad = false;
    const std::uint64_t before = camera.newest().value()->number;
    ASSERT_TRUE(waitUntil([&] { return camera.newest().value()->number > before + 3; }));
    EXPECT_EQ(*opened, 1) << "as little as a shutter does";
    *isBad = true;
    ASSERT_TRUE(waitUntil([&] { return !camera.newest().ok(); }));
    EXPECT_EQ(camera.newest().error().code(), MessageCode::CameraLost);
    EXPECT_NE(wordsOf(camera.newest().error()).find("one value"), std::string::npos);
    *isBad = false;
    EXPECT_TRUE(waitUntil([&] { return camera.newest().ok(); }));
    EXPECT_GT(*opened, 1);
}

TEST(ShutterWatch, SeesAGapThatIsLongForTheCamera) {
    ShutterWatch fast(25.0), slow(5.0);
    for (int k = 0; k < 20; ++k)
        fast.add(0.04 * k);
    EXPECT_FALSE(fast.opened_s());
    fast.add(0.76 + 0.29);
    EXPECT_FALSE(fast.opened_s()) << "a frame or two were lost";
    fast.add(1.05 + 0.31);
    EXPECT_EQ(fast.opened_s(), 1.36);
    fast.add(1.4);
    EXPECT_EQ(fast.opened_s(), 1.36);
    slow.add(0.0);
    slow.add(0.4);
    EXPECT_FALSE(slow.opened_s());
    slow.add(0.95);
    EXPECT_EQ(slow.opened_s(), 0.95);
}

// Catches a shutter event that is not told, or told at another time, and one of a camera opened anew.
TEST(VideoThermalCamera, TellsWhenItsShutterWasOpenAgain) {
    const auto state = std::make_shared<std::atomic<int>>(0);
    VideoThermalCamera camera("scripted", lepton(), kTestClock, [state](const std::function<bool()>&) {
        return Result<std::unique_ptr<ThermalFrameSource>>(std::make_unique<ShutterSource>(state));
    });
    ASSERT_TRUE(waitUntil([&] { return camera.newest().ok(); }));
    EXPECT_FALSE(camera.newest().value()->shutter_s);
    *state = 1;
    const double shut_s = kTestClock.now_s();
    ASSERT_TRUE(waitUntil([&] { return kTestClock.now_s() > shut_s + 0.45; }));
    (void)camera.newest();
    *state = 0;
    const double open_s = kTestClock.now_s();
    ASSERT_TRUE(waitUntil([&] {
        const auto frame = camera.newest();
        return frame && (*frame)->shutter_s && *(*frame)->shutter_s > shut_s;
    }));
    const auto frame = camera.newest().value();
    EXPECT_GE(*frame->shutter_s, open_s - 0.1);
    EXPECT_LE(*frame->shutter_s, frame->time_s + 1e-9);
}

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
