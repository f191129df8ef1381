// A camera looked at on a thread of its own: what is followed, what is shown, and nothing of a task that is
// over.

#include "engine/vision/vision_thread.h"

#include "engine/base/message_code.h"
#include "tests/support/marker_pictures.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace bask {
namespace {

constexpr double kLimit_s = 60.0;

template <class Condition> bool comesTrue(Condition condition) {
    const double end_s = SteadyClock().now_s() + kLimit_s;
    while (!condition()) {
        if (SteadyClock().now_s() > end_s)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

/// Hands out what it is given; can be lost, and can hold up whoever asks.
class FakeCamera final : public Camera {
public:
    Result<std::shared_ptr<const CameraFrame>> newest() override {
        ++calls;
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return !m_isHeldUp; });
        if (m_isLost || !m_frame)
            return Error{MessageCode::CameraLost, "", {"test", "unplugged"}};
        return m_frame;
    }
    void show(double time_s, const GreyPicture& picture) {
        const std::lock_guard lock(m_mutex);
        m_frame = std::make_shared<CameraFrame>(
            CameraFrame{time_s, SteadyClock().now_s(), m_number++, picture}); // the first has number 0
    }
    void setLost(bool isLost) {
        const std::lock_guard lock(m_mutex);
        m_isLost = isLost;
    }
    void holdUp(bool isHeldUp) {
        {
            const std::lock_guard lock(m_mutex);
            m_isHeldUp = isHeldUp;
        }
        m_changed.notify_all();
    }
    std::atomic<int> calls = 0;

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::shared_ptr<const CameraFrame> m_frame;
    std::uint64_t m_number = 0;
    bool m_isLost = false, m_isHeldUp = false;
};

struct VisionThreadTest : testing::Test {
    ManualClock clock;
    FakeCamera camera;
    test::MarkerPictures pictures{test::plainCamera()};
    Pose X_RC = Pose(Eigen::Translation3d(0.1, -0.4, 0.5));
    Pose X_CS = test::facingFrom({0.0, 0.02, 0.6}, {0.35, 0.2, 0.1});
    GreyPicture picture = pictures.of(test::fourOnTheSource(), X_CS);
    std::optional<VisionThread> vision{std::in_place, camera, "fake", clock};

    VisionTask task(bool follow, bool show) const {
        return {test::fourOnTheSource(), test::plainCamera(), X_RC, follow, show, std::nullopt};
    }
    void frame() {
        clock.advance(1.0 / 30.0);
        camera.show(clock.now_s(), picture);
    }
    bool isFollowed() {
        const auto reading = vision->read();
        return reading && reading->valid;
    }
    bool isShown() { return vision->newest() != nullptr; }
};

} // namespace

// Catches: a source that is followed only while somebody looks, in another frame, or by a pose that is told
// as surer than it is.
TEST_F(VisionThreadTest, FollowsTheSourceWhileNothingIsShown) {
    vision->setTask(task(true, false));
    EXPECT_FALSE(isFollowed());
    frame();
    ASSERT_TRUE(comesTrue([&] { return isFollowed(); }));
    EXPECT_FALSE(isShown());
    const double seen_s = clock.now_s();
    clock.advance(0.02);
    const PoseReading reading = *vision->read();
    EXPECT_EQ(reading.seen_s, seen_s);
    EXPECT_EQ(reading.time_s, clock.now_s());
    EXPECT_FALSE(reading.predicted);
    EXPECT_LT(((X_RC * X_CS).translation() - reading.X_RS.translation()).norm(), 2e-3);
    EXPECT_GT(reading.latency_s, 0.0);
    clock.advance(2.0 * PartTracker::kPredicted_s);
    EXPECT_FALSE(isFollowed()) << "not seen for too long";
}

// Catches: markers that are missing or told of another part, the view of before shown on after it was
// switched off, or made though nobody looks.
TEST_F(VisionThreadTest, ShowsOnlyWhenAsked) {
    frame();
    VisionTask wanted = task(true, true);
    wanted.layout.markers.pop_back();
    vision->setTask(wanted);
    ASSERT_TRUE(comesTrue([&] { return isShown(); }));
    const auto view = vision->newest();
    EXPECT_EQ(view->cameraName, "fake");
    EXPECT_EQ(view->problem.code, MessageCode::None);
    ASSERT_EQ(view->markers.size(), 4U);
    for (const ViewedMarker& marker : view->markers) {
        const bool isListed = marker.marker.id != 3;
        EXPECT_EQ(marker.part.has_value(), isListed) << marker.marker.id;
        EXPECT_EQ(marker.poses.has_value(), isListed) << marker.marker.id;
    }
    EXPECT_EQ(view->tracking, TrackState::Tracking);
    ASSERT_TRUE(view->source);
    EXPECT_LT((view->source->X_CP.translation() - X_CS.translation()).norm(), 2e-3);
    EXPECT_FALSE(view->board);
    vision->setTask(task(true, false));
    EXPECT_FALSE(isShown());
    frame();
    ASSERT_TRUE(comesTrue([&] { return isFollowed(); }));
    EXPECT_FALSE(isShown());
}

// Catches: half a processor spent while nobody wants anything.
TEST_F(VisionThreadTest, LeavesTheCameraAloneWithoutATask) {
    frame();
    vision->setTask(task(false, true));
    ASSERT_TRUE(comesTrue([&] { return isShown(); }));
    vision->setTask(task(false, false));
    camera.holdUp(true);
    const int calls = camera.calls; // one may be under way
    camera.holdUp(false);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_LE(camera.calls, calls + 1);
}

// Catches: a lost camera that goes unsaid, takes its last picture along, keeps a source followed for ever,
// or is not looked at again.
TEST_F(VisionThreadTest, ALostCameraIsToldAndFoundAgain) {
    vision->setTask(task(true, true));
    ASSERT_TRUE(comesTrue([&] { return isShown(); }));
    EXPECT_EQ(vision->newest()->problem.code, MessageCode::CameraLost);
    EXPECT_EQ(vision->newest()->frame, nullptr);
    frame();
    ASSERT_TRUE(comesTrue([&] { return vision->newest()->problem.code == MessageCode::None; }));
    const auto last = vision->newest()->frame;
    camera.setLost(true);
    ASSERT_TRUE(comesTrue([&] { return vision->newest()->problem.code == MessageCode::CameraLost; }));
    EXPECT_EQ(vision->newest()->frame, last);
    EXPECT_TRUE(vision->newest()->markers.empty());
    ASSERT_TRUE(comesTrue([&] { return vision->read()->predicted; }));
    clock.advance(2.0 * PartTracker::kPredicted_s);
    EXPECT_FALSE(isFollowed());
    camera.setLost(false);
    frame();
    ASSERT_TRUE(comesTrue([&] { return vision->newest()->problem.code == MessageCode::None; }));
    EXPECT_TRUE(comesTrue([&] { return isFollowed() && !vision->read()->predicted; }));
}

// Catches: what was found for a task that is over taken for the new one's: a source in R by a camera whose
// place is not known any more, and a view that is listed as before.
TEST_F(VisionThreadTest, NothingOfAnOldTaskOutlivesIt) {
    for (int round = 0; round < 5; ++round) {
        camera.holdUp(true);
        const int calls = camera.calls;
        vision->setTask(task(true, true));
        frame();
        ASSERT_TRUE(comesTrue([&] { return camera.calls > calls; })); // it is at the old task
        VisionTask other = task(false, true);
        other.X_RC.reset();
        other.layout.markers.clear();
        vision->setTask(other);
        camera.holdUp(false);
        ASSERT_TRUE(comesTrue([&] { return isShown(); }));
        for (const ViewedMarker& marker : vision->newest()->markers)
            EXPECT_FALSE(marker.part);
        EXPECT_FALSE(vision->newest()->tracking);
        EXPECT_FALSE(isFollowed());
        vision->setTask(task(false, false));
    }
}

// Catches: a page that stays empty when it is shown again and the camera (a film that has ended, a single
// picture) has nothing newer; a frame passed over for its number.
TEST_F(VisionThreadTest, ANewTaskLooksAtTheSamePictureAgain) {
    frame();
    for (int round = 0; round < 3; ++round) {
        vision->setTask(task(false, true));
        ASSERT_TRUE(comesTrue([&] { return isShown(); })) << round;
        EXPECT_EQ(vision->newest()->frame->number, 0U);
        vision->setTask(task(false, false));
    }
}

// Catches: corners of another size measured with a calibration that is not theirs; and a camera that cannot
// be calibrated anew at its size since that is told to be wrong.
TEST_F(VisionThreadTest, ACameraCalibratedForAnotherSize) {
    VisionTask wanted = task(true, true);
    wanted.camera->width = 640;
    wanted.camera->height = 360;
    frame();
    vision->setTask(wanted);
    ASSERT_TRUE(comesTrue([&] { return isShown(); }));
    auto view = vision->newest();
    EXPECT_EQ(view->problem.code, MessageCode::CameraSizeOther);
    EXPECT_EQ(view->markers.size(), 4U);
    for (const ViewedMarker& marker : view->markers)
        EXPECT_FALSE(marker.poses);
    EXPECT_FALSE(isFollowed());
    wanted.board = *parseBoard("chessboard:9x6:0.025");
    vision->setTask(wanted);
    ASSERT_TRUE(comesTrue([&] { return isShown(); }));
    view = vision->newest();
    EXPECT_EQ(view->problem.code, MessageCode::None);
    ASSERT_TRUE(view->board);
    EXPECT_FALSE(view->board->ok());
}

// Catches: following by a camera whose place, or that itself, is not calibrated.
TEST_F(VisionThreadTest, FollowsNothingWithoutCalibration) {
    frame();
    for (const bool hasCamera : {false, true}) {
        VisionTask wanted = task(true, true);
        if (!hasCamera)
            wanted.camera.reset();
        wanted.X_RC.reset();
        vision->setTask(wanted);
        ASSERT_TRUE(comesTrue([&] { return isShown(); }));
        EXPECT_FALSE(isFollowed());
        EXPECT_FALSE(vision->newest()->tracking);
    }
}

// Catches: an end that waits for ever, for a task or for a camera that has nothing.
TEST_F(VisionThreadTest, EndsAtOnceWhateverItDoes) {
    vision.reset();
    for (int round = 0; round < 40; ++round) {
        vision.emplace(camera, "fake", clock);
        if (round % 4 == 1)
            vision->setTask(task(true, false));
        if (round % 4 == 2)
            frame();
        camera.setLost(round % 4 == 3);
        if (round % 4 >= 2)
            vision->setTask(task(round % 8 > 4, true));
        const double start_s = SteadyClock().now_s();
        vision.reset();
        EXPECT_LT(SteadyClock().now_s() - start_s, 20.0) << round;
    }
}

} // namespace bask
