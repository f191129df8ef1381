// The thread that looks at a camera, with a camera that the test holds up, breaks and lets go.

#include "engine/vision/vision_thread.h"

#include "engine/base/message_code.h"
#include "tests/support/marker_pictures.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bask {
namespace {

const Pose kThere = test::facingFrom({0.0, 0.0, 0.6}, {0.3, 0.2, 0.0});

/// A new frame each time it is asked, as soon as the test lets it go.
class HeldCamera final : public Camera {
public:
    Result<std::shared_ptr<const CameraFrame>> newest() override {
        std::unique_lock lock(m_mutex);
        ++m_asked;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return !m_isHeld; });
        if (m_isBroken)
            throw std::runtime_error("broken");
        return std::make_shared<const CameraFrame>(CameraFrame{1.0 + 0.03 * static_cast<double>(m_number),
                                                               SteadyClock().now_s(), ++m_number, m_picture});
    }
    void set(bool isHeld, bool isBroken = false) {
        const std::lock_guard lock(m_mutex);
        m_isHeld = isHeld;
        m_isBroken = isBroken;
        m_changed.notify_all();
    }
    /// Waits until it was asked so many times more: what was asked for before is then done with.
    void awaitAsked(int times) {
        std::unique_lock lock(m_mutex);
        const int enough = m_asked + times;
        m_changed.wait(lock, [&] { return m_asked >= enough; });
    }

private:
    GreyPicture m_picture = test::MarkerPictures(test::plainCamera()).of(test::fourOnTheSource(), kThere);
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_isHeld = false, m_isBroken = false;
    int m_asked = 0;
    std::uint64_t m_number = 0;
};

VisionTask followed() {
    VisionTask task;
    task.layout = test::fourOnTheSource();
    task.camera = test::plainCamera();
    task.X_RC = Pose::Identity();
    task.follow = true;
    return task;
}

struct FaultBench {
    ManualClock clock;
    HeldCamera camera;
    VisionThread thread{camera, "test", clock};

    FaultBench() { clock.advanceTo(1.2); }
};

} // namespace

TEST(VisionThreadFault, FollowsTheSource) {
    FaultBench bench;
    bench.thread.setTask(followed());
    bench.camera.awaitAsked(4);
    const PoseReading reading = *bench.thread.read();
    ASSERT_TRUE(reading.valid);
    EXPECT_LT((reading.X_RS.translation() - kThere.translation()).norm(), 1e-3);
}

// Catches a pose by markers and camera of before, told after they were changed while a picture was looked at;
// it was told in the base by a pose of the camera that was not there any more.
TEST(VisionThreadFault, TellsNoPoseOfTheTaskBefore) {
    FaultBench bench;
    bench.thread.setTask(followed());
    bench.camera.awaitAsked(2);
    bench.camera.set(true);
    bench.camera.awaitAsked(1); // the old task's next picture is on its way
    VisionTask other;
    other.show = true;
    bench.thread.setTask(other);
    EXPECT_FALSE(bench.thread.read()->valid);
    bench.camera.set(false);
    bench.camera.awaitAsked(2); // and was looked at
    EXPECT_FALSE(bench.thread.read()->valid);
}

// Catches a program that ends, in the middle of a run, by what one picture threw on the thread.
TEST(VisionThreadFault, LivesOnAfterAPictureThatThrows) {
    FaultBench bench;
    VisionTask task = followed();
    task.show = true;
    bench.thread.setTask(task);
    bench.camera.awaitAsked(2);
    bench.camera.set(false, true);
    bench.camera.awaitAsked(3);
    ASSERT_TRUE(bench.thread.newest());
    EXPECT_EQ(bench.thread.newest()->problem.code, MessageCode::ReasonInternalFault);
    bench.camera.set(false);
    bench.camera.awaitAsked(4);
    EXPECT_TRUE(bench.thread.read()->valid);
}

} // namespace bask
