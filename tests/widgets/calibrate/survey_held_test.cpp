// A tour of the robot that the operator ends by Hold.

#include "widgets/calibrate/rig_survey.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

Vector6d at(double x_m) {
    Vector6d q = Vector6d::Zero();
    q[kX] = x_m;
    return q;
}

} // namespace

// Catches a robot that is held on its way and, half a second later, sets off by itself to the next pose.
TEST(RigSurvey, AHeldRobotIsNotSentOn) {
    RigSurvey survey;
    survey.setRobot(at(0.0), false);
    survey.begin({at(0.1), at(0.2)}, 2);
    ASSERT_TRUE(survey.takeGoal());
    survey.setRobot(at(0.02), true);
    survey.setRobot(at(0.03), false); // held
    for (int frame = 0; frame < 300; ++frame) {
        survey.addFrame(frame / 30.0, {});
        ASSERT_FALSE(survey.takeGoal()) << frame;
    }
    EXPECT_EQ(survey.state(), RigSurvey::State::Idle);
}

TEST(RigSurvey, ARobotThatArrivesIsSentOn) {
    RigSurvey survey;
    survey.setRobot(at(0.0), false);
    survey.begin({at(0.1), at(0.2)}, 2);
    ASSERT_TRUE(survey.takeGoal());
    survey.setRobot(at(0.02), true);
    survey.setRobot(at(0.0999), false);
    bool isSentOn = false;
    for (int frame = 0; frame < 60 && !isSentOn; ++frame) {
        survey.addFrame(frame / 30.0, {});
        isSentOn = survey.takeGoal().has_value();
    }
    EXPECT_TRUE(isSentOn);
}

} // namespace bask
