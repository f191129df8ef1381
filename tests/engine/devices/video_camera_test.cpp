// The camera on its own thread: newest frame, told lost in time, taken up again, never waited for.

#include "engine/base/message_code.h"
#include "engine/devices/video_camera.h"
#include "tests/engine/devices/video_samples.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>

namespace bask {
namespace {

using test::ScratchFolder;
using test::waitUntil;

const SteadyClock kClock;
constexpr double kLoss_s = 2.5; // 1.1 where the machine is free; frames in a buffer last longer

bool sees(VideoCamera& camera) {
    return camera.newest().ok();
}
MessageCode codeOf(VideoCamera& camera) {
    const auto newest = camera.newest();
    return newest ? MessageCode::None : newest.error().code();
}
std::string wordsOf(VideoCamera& camera) {
    const auto newest = camera.newest();
    return newest || newest.error().message.args.size() < 2 ? "" : newest.error().message.args[1].text();
}

/// Seconds from the last frame caught to the loss told.
double timeToLoss(VideoCamera& camera) {
    double caught_s = kClock.now_s();
    EXPECT_TRUE(waitUntil([&] {
        const auto newest = camera.newest();
        if (newest)
            caught_s = (*newest)->caught_s;
        return !newest;
    }));
    EXPECT_EQ(codeOf(camera), MessageCode::CameraLost);
    return kClock.now_s() - caught_s;
}

/// What a scripted source does next.
struct Script {
    std::atomic<bool> hangs{false}, repeats{false}, fails{false};
    std::atomic<int> openings{0}, hung{0};
    std::promise<void> release; ///< of what hangs
    std::shared_future<void> released = release.get_future().share();
};

/// A device as bad as devices are; grey by turns.
class ScriptedSource final : public FrameSource {
public:
    explicit ScriptedSource(std::shared_ptr<Script> script) : m_script(std::move(script)) {}
    Result<CaughtPicture> next() override {
        if (m_script->hangs) {
            ++m_script->hung;
            m_script->released.wait();
        }
        ::poll(nullptr, 0, 5);
        if (m_script->fails)
            return Error{MessageCode::CameraNotOpened, "", {"scripted", "pulled out"}};
        if (!m_script->repeats)
            ++m_grey;
        CaughtPicture caught;
        caught.picture.width = caught.picture.height = 40;
        caught.picture.values.assign(1600, m_grey);
        caught.caught_s = kClock.now_s();
        return caught;
    }

private:
    std::shared_ptr<Script> m_script;
    std::uint8_t m_grey = 0;
};

VideoCamera::Opener openerOf(std::shared_ptr<Script> script) {
    return [script](const std::function<bool()>&) -> Result<std::unique_ptr<FrameSource>> {
        ++script->openings;
        if (script->fails)
            return Error{MessageCode::CameraNotOpened, "", {"scripted", "not there"}};
        return Result<std::unique_ptr<FrameSource>>(std::make_unique<ScriptedSource>(script));
    };
}

} // namespace

// Catches: a queue of old frames in front of the newest, numbers that do not grow, times on a wrong clock or
// in the future.
TEST(VideoCamera, HandsOutTheNewestFrame) {
    const ScratchFolder folder;
    test::writeVideo(folder / "ten.avi", 10, 50.0);
    ManualClock engine;
    engine.advanceTo(1000.0);
    VideoCamera camera(folder / "ten.avi", engine);
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    const auto first = *camera.newest();
    EXPECT_EQ(first->picture.width, 320);
    EXPECT_EQ(first->picture.height, 240);
    EXPECT_LE(first->time_s, 1000.0);
    EXPECT_GT(first->time_s, 999.0);
    // Not asked for a while: what stands there then is of now.
    const double asked_s = kClock.now_s() + 0.3;
    EXPECT_TRUE(waitUntil([&] { return kClock.now_s() > asked_s; }));
    const auto later = *camera.newest();
    EXPECT_GE(later->number, first->number + 5);
    EXPECT_LT(kClock.now_s() - later->caught_s, 0.25);
    // Played at its rate, not as fast as it decodes.
    EXPECT_LE(later->number, first->number + 60);
}

// Catches: the first second of a camera told as a fault.
TEST(VideoCamera, IsOpeningBeforeTheFirstFrame) {
    auto script = std::make_shared<Script>();
    script->hangs = true;
    VideoCamera camera("scripted", kClock, openerOf(script));
    EXPECT_EQ(codeOf(camera), MessageCode::CameraOpening);
    script->hangs = false;
    script->release.set_value();
    EXPECT_TRUE(waitUntil([&] { return sees(camera); }));
}

// Catches: a bad source that is told as lost or as opening for ever; words that are not the source's; one
// that is not tried again when the file is there.
TEST(VideoCamera, SaysWhyItIsNotOpenedAndTriesAgain) {
    const ScratchFolder folder;
    VideoCamera camera(folder / "late.avi", kClock);
    ASSERT_TRUE(waitUntil([&] { return codeOf(camera) == MessageCode::CameraNotOpened; }));
    EXPECT_EQ(wordsOf(camera), "there is no such file or device");
    test::writeVideo(folder / "whole.avi", 10);
    std::filesystem::rename(folder / "whole.avi", folder / "late.avi");
    EXPECT_TRUE(waitUntil([&] { return sees(camera); }, 5.0));
}

// Catches: a file that went away and came back, not taken up again, or with numbers from the start.
TEST(VideoCamera, TakesAFolderUpAgain) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "views");
    cv::imwrite(folder / "views/a.png", test::even(90));
    VideoCamera camera(folder / "views", kClock);
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    const std::uint64_t before = (*camera.newest())->number;
    std::filesystem::rename(folder / "views", folder / "away");
    EXPECT_LT(timeToLoss(camera), 1.25);
    EXPECT_NE(wordsOf(camera), "");
    std::filesystem::rename(folder / "away", folder / "views");
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }, 5.0));
    EXPECT_GT((*camera.newest())->number, before);
}

// Catches: a loss told late or never while read() blocks for ever (OpenCV's read time-out does nothing for a
// FIFO); a newest() that waits for it; no frames any more once the writer goes on.
TEST(VideoCamera, ToldLostWhileTheWriterStands) {
    const ScratchFolder folder;
    ASSERT_EQ(::mkfifo((folder / "camera").c_str(), 0600), 0);
    VideoCamera camera(folder / "camera", kClock);
    const test::FifoWriter writer(folder / "camera");
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    const std::uint64_t before = (*camera.newest())->number;
    writer.stop();
    const int hanging = VideoCamera::hanging();
    const double loss_s = timeToLoss(camera);
    RecordProperty("loss_ms", static_cast<int>(1e3 * loss_s));
    EXPECT_LT(loss_s, kLoss_s);
    EXPECT_EQ(wordsOf(camera), "it does not answer");
    double longest_s = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const double begin_s = kClock.now_s();
        (void)codeOf(camera);
        longest_s = std::max(longest_s, kClock.now_s() - begin_s);
    }
    EXPECT_LT(longest_s, 0.05);
    // A second reader of a FIFO would get halves of pictures: this one is waited for.
    const double end_s = kClock.now_s() + VideoCamera::kHanging_s;
    EXPECT_TRUE(waitUntil([&] { return !sees(camera) && kClock.now_s() > end_s; }));
    EXPECT_EQ(VideoCamera::hanging(), hanging);
    writer.goOn();
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    EXPECT_GT((*camera.newest())->number, before);
}

// Catches: isOpened() believed, which stays true after the end; frames left in a buffer told as alive for
// longer; another writer not listened to.
TEST(VideoCamera, ToldLostWhenTheWriterIsKilled) {
    const ScratchFolder folder;
    ASSERT_EQ(::mkfifo((folder / "camera").c_str(), 0600), 0);
    VideoCamera camera(folder / "camera", kClock);
    test::FifoWriter writer(folder / "camera");
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    writer.end();
    const double loss_s = timeToLoss(camera);
    RecordProperty("loss_ms", static_cast<int>(1e3 * loss_s));
    EXPECT_LT(loss_s, kLoss_s);
    EXPECT_EQ(wordsOf(camera), "it has ended");
    const test::FifoWriter next(folder / "camera");
    EXPECT_TRUE(waitUntil([&] { return sees(camera); }));
}

// Catches: a driver believed that hands out its last buffer again and again after the cable is out.
TEST(VideoCamera, TheSamePictureAgainIsNone) {
    auto script = std::make_shared<Script>();
    VideoCamera camera("scripted", kClock, openerOf(script));
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    script->repeats = true;
    EXPECT_LT(timeToLoss(camera), 1.25);
    EXPECT_NE(wordsOf(camera).find("same picture"), std::string::npos);
    EXPECT_TRUE(waitUntil([&] { return script->openings > 1; })); // tried anew
    script->repeats = false;
    EXPECT_TRUE(waitUntil([&] { return sees(camera); }));
}

// Catches: a device pulled out and tried without a pause, thousands of times; not tried at all.
TEST(VideoCamera, TriesAgainWithLongerAndLongerPauses) {
    auto script = std::make_shared<Script>();
    VideoCamera camera("scripted", kClock, openerOf(script));
    ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
    script->fails = true;
    EXPECT_LT(timeToLoss(camera), 1.25);
    const double begin_s = kClock.now_s();
    EXPECT_TRUE(waitUntil([&] { return kClock.now_s() - begin_s > 2.0; }));
    EXPECT_GE(script->openings, 3); // 0.25 s, 0.75 s, 1.75 s ...
    EXPECT_LE(script->openings, 5);
    script->fails = false;
    EXPECT_TRUE(waitUntil([&] { return sees(camera); }, 5.0));
}

// Catches: a hanging capture that is waited for; another begun without end; one that comes back and spoils
// the camera that has gone on, or the memory of one that is gone.
TEST(VideoCamera, LeavesWhatHangsAndBeginsAgain) {
    auto script = std::make_shared<Script>();
    const int before = VideoCamera::hanging();
    {
        VideoCamera camera("scripted", kClock, openerOf(script));
        ASSERT_TRUE(waitUntil([&] { return sees(camera); }));
        script->hangs = true;
        EXPECT_LT(timeToLoss(camera), 1.25);
        EXPECT_TRUE(waitUntil([&] {
            (void)codeOf(camera);
            return VideoCamera::hanging() == before + 1;
        }));
        EXPECT_TRUE(waitUntil([&] { return script->openings == 2; }));
        script->hangs = false; // what was begun again hangs, too
        const double begin_s = kClock.now_s();
        EXPECT_TRUE(waitUntil([&] { return sees(camera); }, 10.0));
        EXPECT_LT(kClock.now_s() - begin_s, 2.0 * VideoCamera::kHanging_s);
        script->hangs = true;
    }
    EXPECT_GE(VideoCamera::hanging(), before + 1);
    script->release.set_value();
    EXPECT_TRUE(waitUntil([&] { return VideoCamera::hanging() == before; }));
}

// Catches: a window that cannot be closed since a camera hangs; without end new threads by cameras that are
// made and hang; a bound after which none works any more although the others came back.
TEST(VideoCamera, GoesInTimeWhileItHangsAndIsBounded) {
    auto script = std::make_shared<Script>();
    script->hangs = true;
    const int before = VideoCamera::hanging();
    for (int k = 0; k < VideoCamera::kMaxHanging + 2; ++k) {
        auto camera = std::make_unique<VideoCamera>("scripted", kClock, openerOf(script));
        const int hung = std::min(k + 1, VideoCamera::kMaxHanging - before);
        EXPECT_TRUE(waitUntil([&] { return script->hung == hung; }));
        if (k >= VideoCamera::kMaxHanging - before) {
            EXPECT_EQ(codeOf(*camera), MessageCode::CameraNotOpened);
        }
        const double begin_s = kClock.now_s();
        camera.reset();
        EXPECT_LT(kClock.now_s() - begin_s, 1.0);
    }
    EXPECT_LE(VideoCamera::hanging(), VideoCamera::kMaxHanging);
    script->hangs = false;
    script->release.set_value();
    EXPECT_TRUE(waitUntil([&] { return VideoCamera::hanging() == before; }));
    VideoCamera camera("scripted", kClock, openerOf(script));
    EXPECT_TRUE(waitUntil([&] { return sees(camera); }));
}

// Catches: a camera on a FIFO that nobody writes into, which cannot be ended or holds up another one.
TEST(VideoCamera, AFifoWithoutAWriterHoldsUpNobody) {
    const ScratchFolder folder;
    ASSERT_EQ(::mkfifo((folder / "camera").c_str(), 0600), 0);
    test::writeVideo(folder / "ten.avi", 10);
    const int before = VideoCamera::hanging();
    {
        VideoCamera waiting(folder / "camera", kClock);
        VideoCamera other(folder / "ten.avi", kClock);
        EXPECT_TRUE(waitUntil([&] { return sees(other); }));
        EXPECT_EQ(codeOf(waiting), MessageCode::CameraOpening);
    }
    EXPECT_EQ(VideoCamera::hanging(), before);
}

} // namespace bask
