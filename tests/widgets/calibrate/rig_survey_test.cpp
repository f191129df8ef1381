// Where the robot is sent to calibrate a rig, and which pictures count.

#include "engine/experiment/experiment_file.h"
#include "widgets/calibrate/rig_survey.h"

#include "engine/base/units.h"
#include "engine/model/experiment_rig.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

constexpr double kFrame_s = 1.0 / 15.0;

Experiment example() {
    return readExperiment(BASK_EXAMPLES "/moving-source.json").value();
}

struct RigSurveyTest : testing::Test {
    RigSurvey survey;
    Vector6d start = example().start, there = start;
    double time_s = 10.0;

    RigSurveyTest() {
        there[kX] += 0.05;
        survey.setRobot(start, false);
    }
    void frames(int count) {
        for (int k = 0; k < count; ++k, time_s += kFrame_s)
            survey.addFrame(time_s, {});
    }
    void still() { frames(static_cast<int>(std::ceil(RigSurvey::kStill_s / kFrame_s)) + 1); }
};

} // namespace

// Catches: pictures of a robot that has not come to rest, or counted where a hand has pushed it on.
TEST_F(RigSurveyTest, CountsPicturesOnlyOnceTheRobotHasStood) {
    survey.begin({}, 5);
    EXPECT_FALSE(survey.takeGoal());
    frames(7); // under half a second
    EXPECT_EQ(survey.framesTaken(), 0);
    survey.setRobot(start, true);
    frames(20);
    EXPECT_EQ(survey.framesTaken(), 0) << "it moves";
    survey.setRobot(start, false);
    frames(7);
    EXPECT_EQ(survey.framesTaken(), 0);
    survey.setRobot(there, false); // it was elsewhere without having said that it moves
    frames(8);
    EXPECT_EQ(survey.framesTaken(), 0);
    frames(1);
    EXPECT_EQ(survey.framesTaken(), 1);
    frames(10);
    EXPECT_EQ(survey.state(), RigSurvey::State::Done);
    ASSERT_EQ(survey.views().size(), 1U);
    EXPECT_EQ(survey.views()[0].frames.size(), 5U);
    EXPECT_TRUE(survey.views()[0].X_RE.isApprox(poseFromCoordinates(there)));
}

// Catches: a robot that is sent twice, pictures of the way, and poses that are not where they were seen from.
TEST_F(RigSurveyTest, GoesFromGoalToGoalToldOnce) {
    survey.begin({there, start}, 3);
    EXPECT_EQ(survey.framesWanted(), 6);
    ASSERT_EQ(survey.takeGoal(), there);
    EXPECT_FALSE(survey.takeGoal());
    frames(3); // it has not set off yet
    survey.setRobot(0.5 * (start + there), true);
    frames(20);
    EXPECT_EQ(survey.state(), RigSurvey::State::Travelling);
    EXPECT_EQ(survey.framesTaken(), 0);
    survey.setRobot(there, false);
    still();
    frames(2);
    EXPECT_EQ(survey.framesTaken(), 3);
    ASSERT_EQ(survey.takeGoal(), start);
    frames(20);
    EXPECT_EQ(survey.framesTaken(), 3) << "still at the first";
    survey.setRobot(there, true);
    survey.setRobot(start, false);
    still();
    frames(2);
    EXPECT_EQ(survey.state(), RigSurvey::State::Done);
    EXPECT_TRUE(survey.views()[1].X_RE.isApprox(poseFromCoordinates(start)));
    EXPECT_TRUE(survey.hasMoved());
    EXPECT_EQ(survey.start(), start);
}

// Catches: waiting for ever for a robot that refuses to go, and its place told as the goal's.
TEST_F(RigSurveyTest, ARobotThatDoesNotSetOffIsLookedAtWhereItIs) {
    survey.begin({there}, 2);
    ASSERT_TRUE(survey.takeGoal());
    frames(static_cast<int>(RigSurvey::kNoMove_s / kFrame_s));
    EXPECT_EQ(survey.framesTaken(), 0);
    still();
    frames(3);
    EXPECT_EQ(survey.state(), RigSurvey::State::Done);
    EXPECT_TRUE(survey.views()[0].X_RE.isApprox(poseFromCoordinates(start)));
    EXPECT_FALSE(survey.hasMoved());
}

// Catches: a survey that goes on after it was cancelled, or begins anew with what it had.
TEST_F(RigSurveyTest, CanBeCancelledAndBegunAnew) {
    survey.begin({there}, 2);
    survey.cancel();
    EXPECT_FALSE(survey.isOn());
    EXPECT_FALSE(survey.takeGoal());
    frames(100);
    EXPECT_EQ(survey.state(), RigSurvey::State::Idle);
    survey.begin({}, 3);
    still();
    survey.begin({}, 3);
    EXPECT_EQ(survey.framesTaken(), 0);
    frames(7);
    EXPECT_EQ(survey.framesTaken(), 0) << "stillness begins anew";
}

// Catches: poses outside of the workspace, or with any object nearer to the source than it was; a robot that
// is left elsewhere; too few turns to tell a camera's place.
TEST(SurveyPoses, AreAllowedNeverNearerAndEndWhereTheyBegan) {
    for (const double turn_rad : {0.0, radFromDeg(20.0)})
        for (const double height_m : {0.02, 0.15, 0.3}) { // close, in the middle, at the upper limit
            Experiment experiment = example();
            experiment.source.pose[kThetaY] = turn_rad;
            const auto geometry = rigGeometry(experiment);
            Vector6d from = experiment.start;
            from[kZ] = height_m;
            if (!geometry->allowed(from))
                continue;
            const auto poses = surveyPoses(*geometry, from);
            EXPECT_EQ(poses.back(), from);
            for (const Vector6d& pose : poses) {
                EXPECT_TRUE(geometry->allowed(pose)) << pose.transpose();
                EXPECT_GE(geometry->lowestPoint_m(pose), geometry->lowestPoint_m(from) - 1e-5)
                    << pose.transpose() << " from " << height_m;
                EXPECT_GE(geometry->away().dot((pose - from).head<3>()), -1e-9);
            }
            EXPECT_GE(poses.size(), height_m < 0.3 ? 8U : 2U) << height_m;
        }
}

// Catches: a coordinate that is not free, or lies outside of its limits, moved all the same.
TEST(SurveyPoses, MoveWhatIsFreeOnly) {
    Experiment experiment = example();
    experiment.robot.free = {true, false, true, false, false, false};
    const auto geometry = rigGeometry(experiment);
    for (const Vector6d& pose : surveyPoses(*geometry, experiment.start))
        for (const int k : {kY, kThetaX, kThetaY, kThetaZ})
            EXPECT_EQ(pose[k], experiment.start[k]) << k;
    experiment.robot.free.fill(false);
    EXPECT_EQ(surveyPoses(*rigGeometry(experiment), experiment.start).size(), 1U);
}

} // namespace bask
