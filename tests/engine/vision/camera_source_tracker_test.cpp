// The source's pose in the robot's base, from a camera's frames.

#include "engine/vision/camera_source_tracker.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "tests/support/marker_pictures.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

constexpr double kFrame_s = 1.0 / 30.0;

class StillCamera final : public Camera {
public:
    Result<std::shared_ptr<const CameraFrame>> newest() override {
        if (m_lost)
            return Error{MessageCode::CameraLost, "", {"test"}};
        return m_frame;
    }
    void show(double time_s, double caught_s, GreyPicture picture) {
        m_frame =
            std::make_shared<CameraFrame>(CameraFrame{time_s, caught_s, ++m_number, std::move(picture)});
    }
    void setLost(bool lost) { m_lost = lost; }

private:
    std::shared_ptr<const CameraFrame> m_frame;
    std::uint64_t m_number = 0;
    bool m_lost = false;
};

/// The source moves along x of R at 5 cm/s; frames come 50 ms after their light.
struct Bench {
    static constexpr double kDelay_s = 0.05;
    ManualClock clock;
    StillCamera camera;
    test::MarkerPictures pictures{test::plainCamera()};
    MarkerLayout layout = test::fourOnTheSource();
    Pose X_RC = Pose(Eigen::Translation3d(0.1, -0.4, 0.5)) *
                poseFromRotationVector(Eigen::Vector3d::Zero(), {-2.4, 0.1, 0.2});
    CameraSourceTracker tracker{camera, clock, layout, test::plainCamera(), X_RC};

    Pose X_RS(double t) const {
        return Pose(Eigen::Translation3d(0.05 * t, 0.0, 0.0)) * X_RC *
               test::facingFrom({0.0, 0.02, 0.6}, {0.35, 0.2, 0.1});
    }
    void frame(bool hidden = false) {
        clock.advance(kFrame_s);
        const double light_s = clock.now_s() - kDelay_s;
        GreyPicture picture = hidden ? pictures.blank() : pictures.of(layout, X_RC.inverse() * X_RS(light_s));
        camera.show(light_s, SteadyClock().now_s() - kDelay_s, std::move(picture));
    }
};

} // namespace

// Catches a pose of the frame's light told as one of now (2.5 mm behind), in the camera's axes, or without
// how sure it is; and a latency that leaves out what the camera took.
TEST(CameraSourceTracker, TellsThePoseOfNowInTheRobotsBase) {
    Bench bench;
    PoseReading reading;
    for (int k = 0; k < 30; ++k) {
        bench.frame();
        reading = *bench.tracker.read();
    }
    ASSERT_TRUE(reading.valid);
    EXPECT_EQ(reading.time_s, bench.clock.now_s());
    EXPECT_NEAR(reading.seen_s, bench.clock.now_s() - Bench::kDelay_s, 1e-9);
    EXPECT_FALSE(reading.predicted);
    const Vector6d off = displacementBetween(reading.X_RS, bench.X_RS(reading.time_s));
    EXPECT_LT(off.head<3>().norm(), 1e-3);
    EXPECT_LT(off.tail<3>().norm(), 0.01);
    EXPECT_GT(reading.position_m, 1e-5);
    EXPECT_LT(reading.position_m, 5e-3);
    EXPECT_GT(reading.angle_rad, 1e-4);
    EXPECT_LT(reading.angle_rad, 0.03);
    EXPECT_GT(reading.latency_s, Bench::kDelay_s);
    EXPECT_LT(reading.latency_s, 5.0);
}

// Catches one frame counted as many: the same again must not make the pose surer, only older.
TEST(CameraSourceTracker, LooksAtAFrameOnce) {
    Bench bench;
    for (int k = 0; k < 5; ++k) {
        bench.frame();
        ASSERT_TRUE(bench.tracker.read());
    }
    const PoseReading first = *bench.tracker.read();
    bench.clock.advance(0.02);
    const PoseReading again = *bench.tracker.read();
    EXPECT_EQ(again.seen_s, first.seen_s);
    EXPECT_EQ(again.time_s, first.time_s + 0.02);
    EXPECT_GT(again.position_m, first.position_m);
    EXPECT_EQ(again.latency_s, first.latency_s);
}

// Catches a prediction that counts as a sight, one that ends late, and a reading that is valid without any.
TEST(CameraSourceTracker, PredictsForItsTimeAndThenHasNoPose) {
    Bench bench;
    EXPECT_FALSE((bench.frame(true), bench.tracker.read())->valid);
    for (int k = 0; k < 20; ++k) {
        bench.frame();
        ASSERT_TRUE(bench.tracker.read());
    }
    const double seen_s = bench.tracker.read()->seen_s;
    for (int k = 0; k < 60; ++k) {
        bench.frame(true);
        const PoseReading reading = *bench.tracker.read();
        const double unseen_s = reading.time_s - seen_s;
        ASSERT_EQ(reading.valid, unseen_s <= PartTracker::kPredicted_s) << unseen_s;
        EXPECT_EQ(reading.valid, reading.predicted);
        if (reading.valid) {
            EXPECT_EQ(reading.seen_s, seen_s);
        }
    }
}

// Catches a robot that is led by one of two poses (20 degrees apart here) that one far marker allows.
TEST(CameraSourceTracker, TellsNoPoseThatMayBeTheMirroredOne) {
    Bench bench;
    const MarkerLayout one{{"4X4_50"}, {{Part::Source, 2, 0.06, Pose::Identity()}}};
    CameraSourceTracker tracker(bench.camera, bench.clock, one, test::plainCamera(), bench.X_RC);
    const auto see = [&](double deg) {
        bench.clock.advance(kFrame_s);
        const Pose X_CS = test::facingFrom({0.05, 0.02, 1.2}, {radFromDeg(deg), 0.0, 0.1});
        bench.camera.show(bench.clock.now_s(), SteadyClock().now_s(), bench.pictures.of(one, X_CS));
        return *tracker.read();
    };
    for (int k = 0; k < 2; ++k)
        EXPECT_FALSE(see(10.0).valid);
    ASSERT_TRUE(tracker.tracked());
    EXPECT_TRUE(tracker.tracked()->isAmbiguous);
    PoseReading turned;
    for (int k = 0; k < 40; ++k)
        turned = see(45.0); // at which one marker tells
    EXPECT_TRUE(turned.valid);
}

// Catches a lost camera that is taken for a hidden source, and pictures of another size that are measured in.
TEST(CameraSourceTracker, SaysWhatIsWrongWithTheCamera) {
    Bench bench;
    bench.frame();
    ASSERT_TRUE(bench.tracker.read()->valid);
    bench.camera.setLost(true);
    const auto lost = bench.tracker.read();
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().code(), MessageCode::CameraLost);
    bench.camera.setLost(false);
    bench.camera.show(1.0, 1.0, GreyPicture{640, 360, std::vector<std::uint8_t>(640 * 360, 100)});
    const auto small = bench.tracker.read();
    ASSERT_FALSE(small);
    EXPECT_EQ(small.error().code(), MessageCode::CameraSizeOther);
    EXPECT_FALSE(bench.tracker.read()) << "told again as long as it is so";
}

} // namespace bask
