// The end-effector's pose in the source by a camera: as sure as it is said to be, whatever goes wrong in the
// pictures.

#include "engine/calibration/relative_pose.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/rig_scene.h"

namespace bask {
namespace {

using test::RigScene;

constexpr int kFrames = 30;

Result<RelativePose> poseOf(const std::vector<MarkerFrame>& frames, const RigScene& scene,
                            const MarkerLayout& assumed) {
    return relativePose(frames, assumed, Part::Source, Part::EndEffector, scene.camera);
}

MarkerLayout without(MarkerLayout layout, std::initializer_list<int> ids) {
    std::erase_if(layout.markers,
                  [&](const PlacedMarker& m) { return std::ranges::find(ids, m.id) != ids.end(); });
    return layout;
}

struct Configuration {
    std::string name;
    RigScene scene;
};

std::vector<Configuration> configurations() {
    std::vector<Configuration> all(7);
    all[0].name = "standard";
    all[1].name = "straight on";
    all[1].scene.X_CS = test::facingCamera({-0.12, 0.02, 0.6}, {0.02, 0.01, 0.1});
    all[1].scene.X_CE = test::facingCamera({0.17, -0.03, 0.6}, {0.01, -0.02, -0.4});
    all[2].name = "steep";
    all[2].scene.X_CS = test::facingCamera({-0.12, 0.02, 0.6}, {1.0, 0.1, 0.1});
    all[2].scene.X_CE = test::facingCamera({0.17, -0.03, 0.6}, {-0.2, 0.9, -0.4});
    all[3].name = "far";
    all[3].scene.X_CS = test::facingCamera({-0.3, 0.02, 1.5}, {0.4, 0.2, 0.1});
    all[3].scene.X_CE = test::facingCamera({0.3, -0.03, 1.4}, {-0.3, 0.4, -0.4});
    all[4].name = "three and two markers";
    all[4].scene.layout = without(test::standardLayout(), {2, 12});
    all[5].name = "one marker each, 60 mm, tilted";
    all[5].scene.layout = without(test::standardLayout(), {1, 2, 3, 11, 12});
    for (PlacedMarker& marker : all[5].scene.layout.markers)
        marker.side_m = 0.06;
    all[5].scene.X_CS = test::facingCamera({-0.12, 0.02, 0.6}, {0.7, 0.2, 0.1});
    all[5].scene.X_CE = test::facingCamera({0.17, -0.03, 0.6}, {-0.3, 0.6, -0.4});
    all[6].name = "no distortion, 8 coefficients";
    all[6].scene.camera.distortion = {0, 0, 0, 0, 0, 0, 0, 0};
    return all;
}

// Root mean square of the errors' length and angle over trials, beside what the covariance says.
struct Spread {
    double position_m = 0.0, angle_rad = 0.0;
};

Spread expectedOf(const Matrix6d& covariance) {
    return {std::sqrt(covariance.topLeftCorner<3, 3>().trace()),
            std::sqrt(covariance.bottomRightCorner<3, 3>().trace())};
}

// Catches: an estimate that loses precision (a robust loss that throws corners away, a wrong weight), and a
// prediction that promises too much: errors over 40 trials, and what is said of them, are within 1.3 times
// the prediction.
TEST(RelativePose, EveryConfigurationIsAsGoodAsPredicted) {
    for (const auto& [name, scene] : configurations()) {
        std::mt19937 random(5);
        constexpr int kTrials = 40;
        const Spread predicted =
            expectedOf(*predictedCovariance(scene.layout, Part::Source, scene.X_CS, Part::EndEffector,
                                            scene.X_CE, scene.camera, kFrames, scene.corner_px));
        Spread seen, said;
        for (int k = 0; k < kTrials; ++k) {
            const auto pose = poseOf(scene.frames(kFrames, random), scene, scene.layout);
            ASSERT_TRUE(pose) << name << ": " << describe(pose.error());
            const Vector6d d = displacementBetween(pose->X_AB, scene.X_SE());
            seen.position_m += d.head<3>().squaredNorm() / kTrials;
            seen.angle_rad += d.tail<3>().squaredNorm() / kTrials;
            said.position_m += expectedOf(pose->covariance).position_m / kTrials;
            said.angle_rad += expectedOf(pose->covariance).angle_rad / kTrials;
            EXPECT_NEAR(pose->a.corner_px, scene.corner_px, 0.15 * scene.corner_px) << name;
        }
        seen = {std::sqrt(seen.position_m), std::sqrt(seen.angle_rad)};
        EXPECT_LT(seen.position_m, 1.3 * predicted.position_m) << name;
        EXPECT_LT(seen.angle_rad, 1.3 * predicted.angle_rad) << name;
        EXPECT_LT(said.position_m, 1.3 * predicted.position_m) << name;
        EXPECT_LT(said.angle_rad, 1.3 * predicted.angle_rad) << name;
        EXPECT_GT(seen.position_m, predicted.position_m / 1.3) << name;
        EXPECT_GT(seen.angle_rad, predicted.angle_rad / 1.3) << name;
    }
}

// Catches: the promise of issue 7 broken: 1 mm and 0.3 degrees (2 sigma) of four markers and three, and a
// verdict that says otherwise.
TEST(RelativePose, StandardMarkersAreGoodToAMillimetre) {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [name, scene] = configurations()[k];
        std::mt19937 random(7);
        const auto pose = poseOf(scene.frames(kFrames, random), scene, scene.layout);
        ASSERT_TRUE(pose) << name;
        EXPECT_LT(pose->spread.position_m, 1e-3) << name;
        EXPECT_LT(degFromRad(pose->spread.angle_rad), 0.3) << name;
        EXPECT_EQ(judged(*pose).verdict, Verdict::Good) << describe(judged(*pose).reason);
        EXPECT_TRUE(pose->a.remarks.empty() && pose->b.remarks.empty()) << name;
    }
}

// Catches: a covariance that is not honest, in either direction, or is of another tangent space, axes or
// order than it says: of 500 trials over turned and moved scenes 90 to 99 % lie within the 95 % bound.
TEST(RelativePose, CovarianceIsHonest) {
    std::mt19937 random(2026);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    constexpr int kTrials = 500;
    int within = 0;
    double sum = 0.0;
    for (int k = 0; k < kTrials; ++k) {
        RigScene scene;
        const auto turn = [&] {
            return Eigen::Vector3d(0.6 * any(random), 0.6 * any(random), 3 * any(random));
        };
        scene.X_CS = test::facingCamera({-0.12 + 0.02 * any(random), 0.03 * any(random), 0.6}, turn());
        scene.X_CE = test::facingCamera({0.17, 0.05 * any(random), 0.6 + 0.05 * any(random)}, turn());
        const auto pose = poseOf(scene.frames(kFrames, random), scene, scene.layout);
        ASSERT_TRUE(pose) << describe(pose.error());
        const double error = test::normalisedError(pose->X_AB, pose->covariance, scene.X_SE());
        within += error < test::kChiSquare6At95 ? 1 : 0;
        sum += error;
    }
    EXPECT_GE(within, 450);
    EXPECT_LE(within, 495);
}

// Catches: an estimate spoiled by what detectors do: wrong ids, corners in another order, markers hidden for
// a time, one corner covered, the same id twice.
TEST(RelativePose, WrongSightingsAreLeftOut) {
    const RigScene scene;
    std::mt19937 random(11);
    auto frames = scene.frames(kFrames, random);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        MarkerFrame& frame = frames[k];
        if (k % 4 == 0) // ids exchanged
            std::swap(frame[0].id, frame[5].id);
        if (k % 5 == 1) // read from another side
            std::ranges::rotate(frame[1].corners_px, frame[1].corners_px.begin() + 1);
        if (k % 3 == 2) // a corner covered
            frame[2].corners_px[3] += Eigen::Vector2d(9.0, -6.0);
        if (k % 6 == 5) // a reflection
            frame.push_back({frame[3].id, frame[6].corners_px});
        if (k % 2 == 1) // hidden
            frame.erase(frame.begin() + 4);
    }
    const auto pose = poseOf(frames, scene, scene.layout);
    ASSERT_TRUE(pose) << describe(pose.error());
    EXPECT_LT(test::normalisedError(pose->X_AB, pose->covariance, scene.X_SE()), 22.5); // 99.9 %
    EXPECT_EQ(judged(*pose).verdict, Verdict::Good) << describe(judged(*pose).reason);
    EXPECT_TRUE(pose->a.remarks.empty());
    EXPECT_EQ(pose->a.used[0].outliers, 8);
}

// Catches: one marker that is always wrong (its id is of another place, its corners turned) pulling the pose,
// or silence about it.
TEST(RelativePose, AMarkerThatIsAlwaysWrongIsNamed) {
    const RigScene scene;
    std::mt19937 random(12);
    auto frames = scene.frames(kFrames, random);
    for (MarkerFrame& frame : frames) {
        std::ranges::rotate(frame[1].corners_px, frame[1].corners_px.begin() + 1);
        frame[5].corners_px = frame[0].corners_px;
    }
    const auto pose = poseOf(frames, scene, scene.layout);
    ASSERT_TRUE(pose) << describe(pose.error());
    EXPECT_TRUE(test::says(pose->a.remarks, MessageCode::MarkerLeftOut, "1"));
    EXPECT_TRUE(test::says(pose->b.remarks, MessageCode::MarkerLeftOut, "11"));
    EXPECT_LT(test::normalisedError(pose->X_AB, pose->covariance, scene.X_SE()), 22.5);
}

// Catches: a print of another size that is believed, grossly or by 4 %; the others name it with its side.
TEST(RelativePose, AMarkerOfAnotherSizeIsFound) {
    for (const double side_m : {0.04, 0.048, 0.06}) {
        RigScene scene;
        const MarkerLayout assumed = scene.layout;
        scene.layout.markers[2].side_m = side_m;
        std::mt19937 random(13);
        const auto pose = poseOf(scene.frames(kFrames, random), scene, assumed);
        ASSERT_TRUE(pose) << describe(pose.error());
        ASSERT_TRUE(test::says(pose->a.remarks, MessageCode::MarkerSideOther, "2")) << side_m;
        const auto& remark =
            *std::ranges::find(pose->a.remarks, MessageCode::MarkerSideOther, &Message::code);
        EXPECT_NEAR(std::stod(remark.args[1].text()), 1e3 * side_m, 1.0);
        for (const char* other : {"0", "1", "3"})
            EXPECT_FALSE(test::says(pose->a.remarks, MessageCode::MarkerSideOther, other)) << side_m;
        EXPECT_LT(test::normalisedError(pose->X_AB, pose->covariance, scene.X_SE()), 22.5) << side_m;
    }
}

// Catches: markers glued some tenths of a millimetre and degree off, which no average of frames tells: the
// covariance widens by what the markers contradict one another, all corners of one together. Three and two
// markers tell less of that, and errors have longer tails than a normal distribution's.
TEST(RelativePose, BadlyPlacedMarkersWidenTheCovariance) {
    for (const auto& [layout, min] :
         {std::pair(test::standardLayout(), 80), {without(test::standardLayout(), {2, 12}), 70}}) {
        std::mt19937 random(14);
        std::normal_distribution<double> normal;
        int within = 0;
        for (int k = 0; k < 100; ++k) {
            RigScene scene;
            scene.layout = layout;
            for (PlacedMarker& marker : scene.layout.markers) {
                Vector6d off;
                for (int i = 0; i < 6; ++i)
                    off[i] = (i < 3 ? 3e-4 : 3e-3) * normal(random);
                marker.X_PM = displaced(marker.X_PM, off);
            }
            const auto pose = poseOf(scene.frames(kFrames, random), scene, layout);
            ASSERT_TRUE(pose) << describe(pose.error());
            within +=
                test::normalisedError(pose->X_AB, pose->covariance, scene.X_SE()) < test::kChiSquare6At95;
        }
        EXPECT_GE(within, min);
    }
}

// Catches: parts exchanged, a base that is no part, and a given deviation of corners that is not used.
TEST(RelativePose, TheBaseIsAPartAsTheOthers) {
    RigScene scene;
    std::mt19937 random(22);
    const auto frames = scene.frames(kFrames, random);
    MarkerLayout assumed = scene.layout;
    for (PlacedMarker& marker : assumed.markers)
        marker.part = marker.part == Part::EndEffector ? Part::Base : marker.part;
    const auto X_RS = relativePose(frames, assumed, Part::Base, Part::Source, scene.camera, 0.4);
    ASSERT_TRUE(X_RS) << describe(X_RS.error());
    EXPECT_LT((X_RS->X_AB.inverse().translation() - scene.X_SE().translation()).norm(), 1e-3);
    const auto byScatter = relativePose(frames, assumed, Part::Base, Part::Source, scene.camera);
    EXPECT_DOUBLE_EQ(X_RS->a.corner_px, 0.4);
    EXPECT_GT(X_RS->covariance.trace(), 2.5 * byScatter->covariance.trace());
}

// Catches: a single small marker sold as a calibration: the operator is told some millimetres and degrees,
// and that these markers are the reason.
TEST(RelativePose, ASingleMarkerIsSaidToBePoor) {
    RigScene scene = configurations()[5].scene;
    scene.X_CS = test::facingCamera({-0.12, 0.02, 0.6}, {0.35, 0.2, 0.1});
    scene.X_CE = test::facingCamera({0.17, -0.03, 0.6}, {-0.3, 0.25, -0.4});
    std::mt19937 random(15);
    const auto pose = poseOf(scene.frames(1, random), scene, scene.layout);
    ASSERT_TRUE(pose);
    const Judgement judgement = judged(*pose);
    EXPECT_EQ(judgement.verdict, Verdict::Redo);
    EXPECT_EQ(judgement.reason.code, MessageCode::PoseLimited) << describe(judgement.reason);
    EXPECT_GT(1e3 * pose->spread.position_m, 1.0);
    EXPECT_GT(degFromRad(pose->spread.angle_rad), 1.0);
    const auto averaged = poseOf(scene.frames(kFrames, random), scene, scene.layout);
    ASSERT_TRUE(averaged);
    EXPECT_NE(judged(*averaged).verdict, Verdict::Good);
    EXPECT_EQ(judged(*averaged).reason.code, MessageCode::PoseLimited);
}

// Catches: markers blamed for a bad picture. Corners uncertain by 5 px are no fault of the layout.
TEST(RelativePose, ABadPictureIsToldFromPoorMarkers) {
    RigScene scene;
    scene.corner_px = 5.0;
    std::mt19937 random(16);
    const auto pose = relativePose(scene.frames(kFrames, random), scene.layout, Part::Source,
                                   Part::EndEffector, scene.camera);
    ASSERT_TRUE(pose) << describe(pose.error());
    EXPECT_EQ(judged(*pose).reason.code, MessageCode::PoseUncertain) << describe(judged(*pose).reason);
}

// Catches: the mirrored pose of a small marker straight on taken for sure.
TEST(RelativePose, AnAmbiguousPoseIsARedo) {
    RigScene scene;
    scene.layout = without(scene.layout, {1, 2, 3});
    scene.layout.markers[0].side_m = 0.02;
    scene.X_CS = test::facingCamera({-0.12, 0.02, 1.2}, {0.2, 0.1, 0.0});
    std::mt19937 random(17);
    const auto pose = poseOf(scene.frames(2, random), scene, scene.layout);
    ASSERT_TRUE(pose) << describe(pose.error());
    EXPECT_TRUE(pose->a.mirrored);
    EXPECT_EQ(judged(*pose).verdict, Verdict::Redo);
    EXPECT_EQ(judged(*pose).reason.code, MessageCode::PoseAmbiguous);
}

// Catches: ambiguity that many frames or another marker resolve told all the same, or the wrong pose chosen.
TEST(RelativePose, FramesAndOtherMarkersResolveTheAmbiguity) {
    RigScene scene;
    scene.layout = without(scene.layout, {1, 2, 3});
    scene.X_CS = test::facingCamera({-0.12, 0.02, 1.2}, {0.4, 0.2, 0.0});
    std::mt19937 random(18);
    int single = 0, many = 0;
    for (int k = 0; k < 20; ++k) {
        single +=
            partPose(scene.frames(1, random), scene.layout, Part::Source, scene.camera)->mirrored.has_value();
        const auto pose = partPose(scene.frames(kFrames, random), scene.layout, Part::Source, scene.camera);
        many += pose->mirrored.has_value();
        EXPECT_LT(displacementBetween(pose->X_CP, scene.X_CS).tail<3>().norm(), 0.1);
    }
    EXPECT_GT(single, 5) << "the case is no test otherwise";
    EXPECT_EQ(many, 0);
    scene.layout.markers.push_back({Part::Source, 1, 0.05, test::shifted(0.1, 0.1)});
    for (int k = 0; k < 20; ++k)
        EXPECT_FALSE(partPose(scene.frames(1, random), scene.layout, Part::Source, scene.camera)->mirrored);
}

// Catches: an average over a bump of the table, or over a slow drift; a detector's noise alone is no motion.
TEST(RelativePose, AMotionWhileLookingIsRefused) {
    for (const bool isDrift : {false, true}) {
        RigScene scene;
        std::mt19937 random(19);
        std::vector<MarkerFrame> frames;
        for (int k = 0; k < kFrames; ++k) {
            frames.push_back(scene.frame(random));
            if (isDrift || k == 17)
                scene.X_CE.translation().x() += isDrift ? 1e-4 : 2e-3;
        }
        const auto pose = poseOf(frames, scene, scene.layout);
        ASSERT_FALSE(pose);
        EXPECT_EQ(pose.error().code(), MessageCode::MarkerMoved);
    }
}

// Catches: a crash, or a pose, from frames that show nothing of a part or only contradictions.
TEST(RelativePose, RefusesWhatGivesNoPose) {
    const RigScene scene;
    std::mt19937 random(20);
    EXPECT_EQ(poseOf({}, scene, scene.layout).error().code(), MessageCode::MarkersNotSeen);
    auto frames = scene.frames(3, random);
    for (MarkerFrame& frame : frames)
        frame.resize(4);
    const auto unseen = poseOf(frames, scene, scene.layout);
    EXPECT_EQ(describe(unseen.error()), "none of the markers 10, 11, 12 was seen");
    for (MarkerFrame& frame : frames) { // two markers, one turned
        frame.resize(2);
        std::ranges::rotate(frame[1].corners_px, frame[1].corners_px.begin() + 1);
    }
    EXPECT_EQ(poseOf(frames, scene, scene.layout).error().code(), MessageCode::MarkersDisagree);
    for (MarkerFrame& frame : frames)
        for (FoundMarker& found : frame)
            found.corners_px = {Eigen::Vector2d(5, 5), {5, 5}, {5, 5}, {5, 5}};
    EXPECT_EQ(poseOf(frames, scene, scene.layout).error().code(), MessageCode::MarkersDisagree);
    for (MarkerFrame& frame : frames)
        for (FoundMarker& found : frame)
            found.corners_px[0].x() = std::nan("");
    EXPECT_EQ(poseOf(frames, scene, scene.layout).error().code(), MessageCode::MarkersNotSeen);
}

// Catches: markers that a camera cannot see promised by the prediction.
TEST(RelativePose, ThePredictionIsOfWhatTheCameraShows) {
    RigScene scene;
    const auto spreadAt = [&](const Pose& X_CS) {
        const auto covariance = predictedCovariance(scene.layout, Part::Source, scene.camera, X_CS, 1);
        return covariance ? spreadOf(*covariance).position_m : -1.0;
    };
    const double whole = spreadAt(test::facingCamera({0, 0, 0.6}, {0.3, 0, 0}));
    EXPECT_GT(spreadAt(test::facingCamera({0.4, 0, 0.6}, {0.3, 0, 0})), 1.2 * whole); // half of it outside
    EXPECT_LT(spreadAt(test::facingCamera({2, 0, 0.6}, {0.3, 0, 0})), 0.0);
    EXPECT_LT(spreadAt(test::facingCamera({0, 0, 0.6}, {3.0, 0, 0})), 0.0); // from behind
}

// Catches: ids and sides that cannot be, listed.
TEST(MarkerLayout, RefusesWhatCannotBe) {
    const MarkerLayout good = test::standardLayout();
    EXPECT_TRUE(checkLayout(good));
    MarkerLayout bad = good;
    bad.markers[1].id = 0;
    EXPECT_EQ(checkLayout(bad).error().code(), MessageCode::MarkerListedTwice);
    EXPECT_EQ(checkLayout(bad).error().where, "markers[1].id");
    bad = good;
    bad.markers[6].id = 50;
    EXPECT_EQ(checkLayout(bad).error().code(), MessageCode::ValueOutOfRange);
    for (const double side_m : {0.0, -0.05, std::nan(""), 5.0}) {
        bad = good;
        bad.markers[2].side_m = side_m;
        EXPECT_EQ(checkLayout(bad).error().where, "markers[2].side_mm");
    }
    bad = good;
    bad.markers[0].X_PM.translation().x() = std::nan("");
    EXPECT_FALSE(checkLayout(bad));
}

} // namespace
} // namespace bask
