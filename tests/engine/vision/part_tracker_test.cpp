// The tracker on pictures: markers drawn, found, followed.

#include "engine/vision/part_tracker.h"

#include "engine/base/units.h"
#include "tests/support/marker_pictures.h"

#include <gtest/gtest.h>

#include <functional>

namespace bask {
namespace {

constexpr double kPartFrame_s = 1.0 / 30.0;

const Pose kStart = test::facingFrom({-0.03, 0.02, 0.6}, {0.35, 0.2, 0.1});

Pose moved(const Eigen::Vector3d& way, const Eigen::Vector3d& turn_rad) {
    Vector6d displacement;
    displacement << way, turn_rad;
    return displaced(kStart, displacement);
}

/// 10 cm and 20 degrees in 10 s.
Pose bySteadyHand(double t) {
    const double share = test::carriedShare(t / 10.0);
    return moved(share * Eigen::Vector3d(0.09, 0.02, -0.04),
                 radFromDeg(20.0) * share * Eigen::Vector3d(0.2, 0.3, 0.93).normalized());
}

struct PartBench {
    MarkerLayout layout; ///< as it is
    test::MarkerPictures pictures;
    PartTracker tracker;
    double t = 0.0;

    explicit PartBench(const MarkerLayout& is = test::fourOnTheSource(),
                       const CameraModel& camera = test::plainCamera())
        : layout(is), pictures(camera), tracker(is, Part::Source, camera) {}

    TrackStep show(GreyPicture picture) {
        t += kPartFrame_s;
        return tracker.step({t, 0.0, static_cast<std::uint64_t>(std::lround(30.0 * t)), std::move(picture)});
    }
    TrackStep show(const Pose& X_CP) { return show(pictures.of(layout, X_CP)); }
    TrackStep hide() {
        GreyPicture picture = pictures.blank();
        pictures.addNoise(picture);
        return show(picture);
    }
    /// Error of the pose now.
    Vector6d off(const Pose& truth) const {
        const auto pose = tracker.at(t);
        return pose ? displacementBetween(pose->X_CP, truth) : Vector6d::Constant(1e3);
    }
    double off_m(const Pose& truth) const { return off(truth).head<3>().norm(); }
    double off_deg(const Pose& truth) const { return degFromRad(off(truth).tail<3>().norm()); }
};

MarkerLayout oneOf60mm() {
    return {{"4X4_50"}, {{Part::Source, 2, 0.06, Pose::Identity()}}};
}

/// The middle of the plain camera's pictures: enough for one small marker, in a ninth of the time.
CameraModel middleOfThePicture() {
    CameraModel camera = test::plainCamera();
    camera.cx -= (camera.width - 426) / 2;
    camera.cy -= (camera.height - 240) / 2;
    camera.width = 426;
    camera.height = 240;
    return camera;
}

} // namespace

// Catches a pose that lags behind the hand or is promised surer than it is, and a search of the whole picture
// where one near the last place will do.
TEST(PartTracker, FollowsACarriedSource) {
    PartBench bench;
    int searchedAll = 0, frames = 0, within = 0;
    double worst_m = 0.0, worst_deg = 0.0;
    while (bench.t < 6.0) { // beyond where the hand is fastest
        const TrackStep step = bench.show(bySteadyHand(bench.t + kPartFrame_s));
        ASSERT_EQ(step.state, TrackState::Tracking) << bench.t;
        EXPECT_EQ(step.found.size(), 4U);
        EXPECT_TRUE(step.left_out.empty());
        searchedAll += step.searchedAll ? 1 : 0;
        const auto pose = bench.tracker.at(bench.t);
        const Vector6d off = bench.off(bySteadyHand(bench.t));
        ++frames;
        within += off.dot(pose->covariance.ldlt().solve(off)) < 12.592 ? 1 : 0; // 95 % of chi square (6)
        worst_m = std::max(worst_m, off.head<3>().norm());
        worst_deg = std::max(worst_deg, degFromRad(off.tail<3>().norm()));
    }
    EXPECT_LT(worst_m, 3e-4);
    EXPECT_LT(worst_deg, 0.1);
    EXPECT_GE(within, 0.95 * frames); // corners in clean pictures are better than the 0.2 px that are assumed
    EXPECT_EQ(searchedAll, 1);
}

// Catches a pose that stays where the last frame was instead of being carried on to now.
TEST(PartTracker, CarriesThePoseOnToNow) {
    PartBench bench;
    while (bench.t < 5.0)
        bench.show(bySteadyHand(bench.t + kPartFrame_s));
    const double later_s = bench.t + 0.1; // at 1.9 cm/s and 3.7 degrees/s
    const auto pose = bench.tracker.at(later_s);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->time_s, later_s);
    EXPECT_EQ(pose->seen_s, bench.t);
    const Vector6d off = displacementBetween(pose->X_CP, bySteadyHand(later_s));
    EXPECT_LT(off.head<3>().norm(), 8e-4);
    EXPECT_GT(displacementBetween(bySteadyHand(bench.t), bySteadyHand(later_s)).head<3>().norm(), 1.8e-3);
}

// Catches: nothing told while a hand passes, a prediction that gets no less sure, one without end, and a
// source that is not found again where it went meanwhile.
TEST(PartTracker, PredictsForASecondAndFindsAgain) {
    PartBench bench;
    while (bench.t < 5.0)
        bench.show(bySteadyHand(bench.t + kPartFrame_s));
    const double seen_s = bench.t, before_m = spreadOf(bench.tracker.at(seen_s)->covariance).position_m;
    while (bench.t < seen_s + 0.5)
        EXPECT_EQ(bench.hide().state, TrackState::Predicting);
    const auto predicted = bench.tracker.at(bench.t);
    ASSERT_TRUE(predicted);
    EXPECT_EQ(predicted->seen_s, seen_s);
    EXPECT_GT(spreadOf(predicted->covariance).position_m, 5.0 * before_m);
    EXPECT_LT(bench.off_m(bySteadyHand(bench.t)), 5e-3);
    EXPECT_EQ(bench.show(bySteadyHand(bench.t + kPartFrame_s)).state, TrackState::Tracking);
    EXPECT_LT(bench.off_m(bySteadyHand(bench.t)), 5e-4);

    const double hidden_s = bench.t;
    int searchedAll = 0;
    while (bench.t < hidden_s + 3.0) {
        const TrackStep step = bench.hide();
        searchedAll += step.searchedAll ? 1 : 0;
        const bool isTold = bench.t - hidden_s <= PartTracker::kPredicted_s;
        EXPECT_EQ(step.state, isTold ? TrackState::Predicting : TrackState::Searching) << bench.t - hidden_s;
        EXPECT_EQ(bench.tracker.at(bench.t).has_value(), isTold) << bench.t - hidden_s;
    }
    EXPECT_FALSE(bench.tracker.at(hidden_s + 1.01));
    EXPECT_LE(searchedAll, 31); // of 90
    const Pose elsewhere = moved({-0.08, 0.03, 0.05}, {0.1, -0.2, 0.6});
    for (int k = 0; k < 4; ++k)
        bench.show(elsewhere);
    EXPECT_LT(bench.off_m(elsewhere), 1e-3);
}

// Catches a long run of rejected frames after the source was put elsewhere: while nobody looked, and from one
// frame to the next (then the search near the last place finds nothing, or some of it).
TEST(PartTracker, AJumpIsFollowedWithinFrames) {
    for (const double hidden_s : {0.0, 0.4})
        for (const double way_m : {0.005, 0.02, 0.1}) {
            PartBench bench;
            for (int k = 0; k < 15; ++k)
                bench.show(kStart);
            const double from_s = bench.t;
            while (bench.t < from_s + hidden_s)
                bench.hide();
            const Pose there = moved({way_m, 0.5 * way_m, 0.0}, {0.0, 0.0, 3.0 * way_m});
            int frames = 1;
            while (bench.show(there).state != TrackState::Tracking)
                ASSERT_LE(++frames, 4) << hidden_s << " s, " << way_m << " m";
            EXPECT_LT(bench.off_m(there), 1e-3) << hidden_s << " s, " << way_m << " m";
            for (int k = 0; k < 10; ++k)
                EXPECT_TRUE(bench.show(there).left_out.empty());
            EXPECT_LT(bench.off_m(there), 5e-4);
        }
}

// Catches a marker that was stuck elsewhere or has another's number drawing the pose away, from the first
// frame and in the midst, and one that is not told.
TEST(PartTracker, AWrongMarkerIsLeftOutAndTold) {
    PartBench bench;
    MarkerLayout wrong = bench.layout;
    wrong.markers[1].X_PM = Pose(Eigen::Translation3d(0.1, 0.09, 0.0)); // 1 cm off
    for (int k = 0; k < 20; ++k) {
        const bool isWrong = k < 5 || k >= 10;
        bench.layout = isWrong ? wrong : test::fourOnTheSource();
        const TrackStep step = bench.show(kStart);
        ASSERT_EQ(step.state, TrackState::Tracking);
        EXPECT_EQ(step.left_out, isWrong ? std::vector<int>{1} : std::vector<int>{}) << k;
        EXPECT_LT(bench.off_m(kStart), 5e-4);
    }
}

// Catches covered markers taken for a loss, and a search of the whole picture in every frame for them.
TEST(PartTracker, TwoCoveredMarkersAreNoLossAndCostLittle) {
    PartBench bench;
    for (int k = 0; k < 5; ++k)
        bench.show(kStart);
    bench.layout.markers.resize(2);
    int searchedAll = 0;
    for (int k = 0; k < 60; ++k) {
        const TrackStep step = bench.show(kStart);
        EXPECT_EQ(step.state, TrackState::Tracking);
        searchedAll += step.searchedAll ? 1 : 0;
    }
    EXPECT_LT(bench.off_m(kStart), 1e-3);
    EXPECT_GE(searchedAll, 1);
    EXPECT_LE(searchedAll, 3);
}

// Catches a source that is told to be where it left the picture, and a crash at the border.
TEST(PartTracker, LeavesThePictureAndComesBack) {
    PartBench bench;
    const auto at = [](double t) { return moved({0.6 * test::carriedShare(t / 3.0), 0.0, 0.0}, {0, 0, 0}); };
    int lost = 0;
    for (double t = 0.0; t < 3.0; t += kPartFrame_s) { // out at the right, 20 cm/s
        const TrackStep step = bench.show(at(t));
        if (step.state == TrackState::Tracking) {
            EXPECT_LT(bench.off_m(at(t)), 2e-3) << t;
        } else {
            ++lost;
        }
    }
    EXPECT_GT(lost, 20);
    while (bench.t < 6.0)
        bench.show(at(3.0));
    EXPECT_FALSE(bench.tracker.at(bench.t));
    for (double t = 3.0; t > 0.0; t -= kPartFrame_s)
        bench.show(at(t));
    EXPECT_LT(bench.off_m(at(0.0)), 1e-2);
    EXPECT_TRUE(bench.tracker.at(bench.t));
}

// Catches a crash, or a pose, by pictures that show nothing; and one of another size taken for the camera's.
TEST(PartTracker, PicturesOfNothing) {
    std::mt19937 random(7);
    PartBench bench;
    GreyPicture noise = bench.pictures.blank();
    for (int k = 0; k < 5; ++k) {
        for (std::uint8_t& value : noise.values)
            value = static_cast<std::uint8_t>(random() % 256);
        EXPECT_EQ(bench.show(noise).state, TrackState::Searching);
    }
    EXPECT_EQ(bench.show(GreyPicture()).state, TrackState::Searching);
    EXPECT_EQ(bench.show(GreyPicture{1, 1, {0}}).state, TrackState::Searching);
    EXPECT_EQ(bench.show(GreyPicture{1280, 720, {0}}).state, TrackState::Searching);
    EXPECT_EQ(bench.hide().state, TrackState::Searching);
    EXPECT_FALSE(bench.tracker.at(bench.t));

    CameraModel half = test::plainCamera();
    half.width = 640;
    half.height = 360;
    PartTracker other(bench.layout, Part::Source, half);
    EXPECT_TRUE(other.step({0.0, 0.0, 1, bench.pictures.of(bench.layout, kStart)}).found.empty());
    CameraModel unknown = test::plainCamera();
    unknown.width = unknown.height = 0; // its file did not say
    PartTracker anySize(bench.layout, Part::Source, unknown);
    EXPECT_EQ(anySize.step({0.0, 0.0, 1, bench.pictures.of(bench.layout, kStart)}).state,
              TrackState::Tracking);
    EXPECT_EQ(anySize.step({0.1, 0.0, 2, GreyPicture{1, 1, {0}}}).state, TrackState::Predicting);
}

// Catches one marker that is seen once, by mistake perhaps, told as a pose.
TEST(PartTracker, OneMarkerIsBelievedOnceASecondFrameAgrees) {
    PartBench bench(oneOf60mm());
    EXPECT_EQ(bench.show(kStart).state, TrackState::Searching);
    EXPECT_FALSE(bench.tracker.at(bench.t));
    EXPECT_EQ(bench.hide().state, TrackState::Searching);
    bench.t += 0.1;
    EXPECT_EQ(bench.show(kStart).state, TrackState::Searching);
    EXPECT_EQ(bench.show(moved({0.1, 0.0, 0.0}, {0, 0, 0})).state, TrackState::Searching);
    bench.t += 0.1;
    EXPECT_EQ(bench.show(kStart).state, TrackState::Searching);
    EXPECT_EQ(bench.show(kStart).state, TrackState::Tracking);
    EXPECT_LT(bench.off_m(kStart), 5e-3);
}

// Catches a mirrored pose told for sure: one far marker that faces the camera but for 10 degrees allows both;
// one that was seen to turn there from a pose that was sure allows one.
TEST(PartTracker, AMirroredPoseIsToldOrKnownFromBefore) {
    const MarkerLayout layout{{"4X4_50"}, {{Part::Source, 2, 0.06, Pose::Identity()}}};
    const auto turned = [](double deg) {
        return test::facingFrom({0.05, 0.02, 1.2}, {radFromDeg(deg), 0.0, 0.1});
    };
    PartBench unsure(layout, middleOfThePicture());
    unsure.show(turned(10.0));
    unsure.show(turned(10.0));
    const auto guess = unsure.tracker.at(unsure.t);
    ASSERT_TRUE(guess);
    EXPECT_TRUE(guess->isAmbiguous);
    EXPECT_GT(degFromRad(spreadOf(guess->covariance).angle_rad), 15.0); // reaches the other, 20 degrees away
    const Vector6d off = unsure.off(turned(10.0));
    EXPECT_LT(off.dot(guess->covariance.ldlt().solve(off)), 22.5);

    PartBench sure(layout, middleOfThePicture());
    for (double deg = 45.0; deg >= 10.0; deg -= 0.5) {
        sure.show(turned(deg));
        const auto pose = sure.tracker.at(sure.t);
        if (pose && !pose->isAmbiguous) {
            EXPECT_LT(sure.off_deg(turned(deg)), 6.0) << deg;
        }
    }
    EXPECT_FALSE(sure.tracker.at(sure.t)->isAmbiguous);
    EXPECT_LT(sure.off_deg(turned(10.0)), 6.0);
}

// Catches the wrong one of two poses that met and parted again, told for sure: one small marker (30 px) turns
// to the camera, rests there, and turns either way. A pose beyond its 99.9 % bound is mended within frames.
TEST(PartTracker, AMarkerThatFacedTheCameraMayTurnEitherWay) {
    for (const double rest_deg : {0.0, 3.0})
        for (const double end_deg : {30.0, -30.0}) {
            PartBench bench(oneOf60mm(), middleOfThePicture());
            int beyond = 0, ambiguous = 0;
            Pose X_CS;
            for (int k = 0; k < 240; ++k) {
                const double to = test::carriedShare(k / 75.0), away = test::carriedShare((k - 165) / 75.0);
                const double deg = 40.0 + (rest_deg - 40.0) * to + (end_deg - rest_deg) * away;
                X_CS = test::facingFrom({0.05, 0.02, 2.0}, {radFromDeg(deg), 0.0, 0.1});
                bench.show(X_CS);
                const auto pose = bench.tracker.at(bench.t);
                if (!pose)
                    continue;
                ambiguous += pose->isAmbiguous ? 1 : 0;
                const Vector6d off = displacementBetween(pose->X_CP, X_CS);
                const bool isBeyond = off.dot(pose->covariance.ldlt().solve(off)) > 22.5;
                beyond = isBeyond ? beyond + 1 : 0;
                ASSERT_LE(beyond, 5) << deg;
            }
            EXPECT_LT(bench.off_deg(X_CS), 2.0) << rest_deg << " to " << end_deg;
            EXPECT_GT(ambiguous, 10);
        }
}

// Catches a tracker that waits for time to catch up: a film that begins again.
TEST(PartTracker, BeginsAnewWhenTimeGoesBack) {
    PartBench bench;
    bench.t = 100.0;
    bench.show(kStart);
    bench.t = 0.0;
    const Pose elsewhere = moved({0.1, 0.0, 0.0}, {0, 0, 0});
    EXPECT_EQ(bench.show(elsewhere).state, TrackState::Tracking);
    EXPECT_LT(bench.off_m(elsewhere), 1e-3);
    bench.tracker.forget();
    EXPECT_FALSE(bench.tracker.at(bench.t));
}

} // namespace bask
