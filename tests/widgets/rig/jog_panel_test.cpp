// The robot moved by hand, with mouse and keys.

#include "widgets/rig/jog_panel.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "tests/support/wait_for.h"
#include "tests/widgets/rig/rig_bench.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct JogPanelTest : testing::Test {
    Experiment experiment = test::twoDisks();
    Snapshot snapshot = test::quietSnapshot(experiment);
    JogPanel panel;
    std::vector<Command> sent;

    JogPanelTest() {
        QObject::connect(&panel, &JogPanel::commandWanted, &panel,
                         [this](const Command& command) { sent.push_back(command); });
        panel.setLimits(experiment.robot);
        panel.apply(snapshot, true);
        panel.show();
        panel.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&panel));
    }
    template <class T> T* child(const char* name) {
        T* found = panel.findChild<T*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void click(const char* name) { QTest::mouseClick(child<QAbstractButton>(name), Qt::LeftButton); }
    const Vector6d& goal() { return std::get<MoveTo>(sent.back()).coordinates; }
    const Vector6d& twist() { return std::get<Jog>(sent.back()).twist; }
};

} // namespace

// Catches a step of the wrong size, axis, unit or direction.
TEST_F(JogPanelTest, AClickIsOneStepFromWhereTheRobotIs) {
    click("stepUp.x");
    Vector6d expected = snapshot.latest.coordinates;
    expected[kX] += 0.001;
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_TRUE(goal().isApprox(expected, 1e-12)) << goal().transpose();

    panel.apply(snapshot, true); // not moving: it has refused or arrived
    child<QComboBox>("stepLength")->setCurrentIndex(2);
    child<QComboBox>("stepAngle")->setCurrentIndex(0);
    click("stepDown.z");
    EXPECT_NEAR(goal()[kZ], snapshot.latest.coordinates[kZ] - 0.01, 1e-12);
    EXPECT_NEAR(goal()[kX], snapshot.latest.coordinates[kX], 1e-12);
    panel.apply(snapshot, true);
    click("stepUp.theta_x");
    EXPECT_NEAR(goal()[kThetaX], snapshot.latest.coordinates[kThetaX] + radFromDeg(0.1), 1e-12);
}

// Catches two quick clicks that make one step and a half.
TEST_F(JogPanelTest, TwoQuickClicksAreTwoSteps) {
    click("stepUp.x");
    snapshot.isMoving = true;
    snapshot.latest.coordinates[kX] += 0.0004; // on its way
    panel.apply(snapshot, true);
    click("stepUp.x");
    EXPECT_NEAR(goal()[kX], 0.012, 1e-12);
    // Held half-way: the next step begins where it stands.
    snapshot.isMoving = false;
    panel.apply(snapshot, true);
    click("stepUp.x");
    EXPECT_NEAR(goal()[kX], 0.0114, 1e-12);
}

// Catches a robot that goes on after the button was let go, or that stops while it is held.
TEST_F(JogPanelTest, AHeldButtonMovesUntilItIsLetGo) {
    auto* button = child<QToolButton>("holdDown.z");
    QTest::mousePress(button, Qt::LeftButton);
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_NEAR(twist()[kZ], -0.25 * experiment.robot.maxSpeed_m_s, 1e-15);
    EXPECT_EQ(twist().head<2>().norm() + twist().tail<3>().norm(), 0.0);
    ASSERT_TRUE(test::waitFor([this] { return sent.size() == 3; }));
    EXPECT_NEAR(twist()[kZ], -0.25 * experiment.robot.maxSpeed_m_s, 1e-15);
    QTest::mouseRelease(button, Qt::LeftButton);
    EXPECT_EQ(twist().norm(), 0.0);
    EXPECT_FALSE(panel.findChild<QTimer*>()->isActive());
}

// Catches a turn about the wrong axis where the robot is tilted, or at the wrong speed.
TEST_F(JogPanelTest, AHeldTurnIsAboutTheCoordinatesAxis) {
    experiment.robot.free = {true, true, true, true, true, true};
    panel.setLimits(experiment.robot);
    snapshot.latest.coordinates.tail<3>() << 0.1, 0.4, -0.7;
    panel.apply(snapshot, true);
    child<QDoubleSpinBox>("jogSpeed")->setValue(100);
    QTest::mousePress(child<QToolButton>("holdUp.theta_x"), Qt::LeftButton);
    const Eigen::Vector3d axis = rotationAxes(snapshot.latest.coordinates).col(0);
    EXPECT_TRUE(twist().tail<3>().isApprox(experiment.robot.maxRotation_rad_s * axis, 1e-12));
    EXPECT_EQ(twist().head<3>().norm(), 0.0);
    QTest::mouseRelease(child<QToolButton>("holdUp.theta_x"), Qt::LeftButton);
}

// Catches motion that goes on when a run takes the robot, the page changes or the window loses the keyboard.
TEST_F(JogPanelTest, WhateverTakesTheButtonAwayEndsTheMotion) {
    auto* button = child<QToolButton>("holdUp.x");
    const auto isEnded = [this] { return std::get<Jog>(sent.back()).twist.norm() == 0.0; };

    QTest::mousePress(button, Qt::LeftButton);
    panel.apply(snapshot, false); // armed: the engine has the robot, a zero Jog would be refused
    EXPECT_FALSE(panel.findChild<QTimer*>()->isActive());
    EXPECT_EQ(sent.size(), 1U);
    panel.apply(snapshot, true);
    QTest::mouseRelease(button, Qt::LeftButton);

    QTest::mousePress(button, Qt::LeftButton);
    EXPECT_FALSE(isEnded());
    panel.hide();
    EXPECT_TRUE(isEnded());
    panel.show();
    QTest::mouseRelease(button, Qt::LeftButton);

    QTest::mousePress(button, Qt::LeftButton);
    EXPECT_FALSE(isEnded());
    QEvent away(QEvent::WindowDeactivate);
    QApplication::sendEvent(&panel, &away);
    EXPECT_TRUE(isEnded());
    EXPECT_FALSE(panel.findChild<QTimer*>()->isActive());
    QTest::mouseRelease(button, Qt::LeftButton);
}

// Catches a jog that the keyboard cannot do, and one that keys do while the focus is elsewhere.
TEST_F(JogPanelTest, KeysJogWhileAButtonHasTheFocusOnly) {
    auto* button = child<QToolButton>("holdUp.y");
    button->setFocus();
    QTest::keyPress(button, Qt::Key_Space);
    EXPECT_GT(twist()[kY], 0.0);
    QTest::keyRelease(button, Qt::Key_Space);
    EXPECT_EQ(twist().norm(), 0.0);
    const std::size_t count = sent.size();
    child<QDoubleSpinBox>("goTo.x")->setFocus();
    for (const auto key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_PageDown})
        QTest::keyClick(child<QDoubleSpinBox>("goTo.x"), key);
    EXPECT_EQ(sent.size(), count);
}

// Catches a pose that is read in the wrong unit, jumps in what was not typed, or leaves the workspace by
// rounding.
TEST_F(JogPanelTest, GoesToTheTypedPose) {
    EXPECT_NEAR(child<QDoubleSpinBox>("goTo.z")->value(), 150.0, 1e-9); // begins where the robot is
    child<QDoubleSpinBox>("goTo.x")->setValue(-12.5);
    child<QDoubleSpinBox>("goTo.theta_x")->setValue(1e9); // the largest
    click("goToPose");
    Vector6d expected = snapshot.latest.coordinates;
    expected[kX] = -0.0125;
    expected[kThetaX] = experiment.robot.upper[kThetaX];
    EXPECT_TRUE(goal().isApprox(expected, 1e-9)) << goal().transpose();
    EXPECT_LE(goal()[kThetaX], experiment.robot.upper[kThetaX]);
    click("takePose");
    EXPECT_NEAR(child<QDoubleSpinBox>("goTo.x")->value(), 10.0, 1e-9);
}

// Catches controls of axes that the robot does not have.
TEST_F(JogPanelTest, OnlyFreeCoordinatesAreShown) {
    EXPECT_TRUE(child<QToolButton>("stepUp.theta_x")->isVisible());
    EXPECT_FALSE(child<QToolButton>("stepUp.theta_y")->isVisible());
    EXPECT_FALSE(child<QDoubleSpinBox>("goTo.theta_z")->isVisible());
}

// Catches coordinates of a robot that does not answer, shown as if it were there.
TEST_F(JogPanelTest, TheLastPlaceOfALostRobotIsGreyWithItsAge) {
    const auto ink = [this] { return child<QLabel>("at.x")->palette().color(QPalette::WindowText); };
    panel.apply(snapshot, true);
    EXPECT_FALSE(child<QLabel>("robotPlace")->isVisible());
    const QString at = child<QLabel>("at.x")->text();
    const QColor known = ink();
    snapshot.place = PlaceState::Unknown;
    snapshot.placeAge_s = 12.3;
    panel.apply(snapshot, false);
    EXPECT_TRUE(child<QLabel>("robotPlace")->isVisible());
    EXPECT_TRUE(child<QLabel>("robotPlace")->text().contains("UNKNOWN"));
    EXPECT_TRUE(child<QLabel>("robotPlace")->text().contains("12 s old"));
    EXPECT_EQ(child<QLabel>("at.x")->text(), at);
    EXPECT_NE(ink(), known);
    snapshot.place = PlaceState::Sure;
    panel.apply(snapshot, true);
    EXPECT_FALSE(child<QLabel>("robotPlace")->isVisible());
    EXPECT_EQ(ink(), known);
}

// Catches motion offered during a run, and an alarm that nobody sees or cannot clear.
TEST_F(JogPanelTest, FollowsWhatTheEngineAllows) {
    snapshot.state = RunState::Running;
    panel.apply(snapshot, false);
    for (const char* name : {"stepUp.x", "holdUp.x", "goToPose", "homeRobot"})
        EXPECT_FALSE(child<QAbstractButton>(name)->isEnabled()) << name;
    EXPECT_FALSE(child<QPushButton>("clearAlarm")->isEnabled());
    EXPECT_FALSE(child<QLabel>("robotProblem")->isVisible());

    snapshot.robotAlarm = {MessageCode::RobotAlarm, {"1", "hard limit"}};
    panel.apply(snapshot, false);
    EXPECT_TRUE(child<QLabel>("robotProblem")->text().contains("hard limit"));
    click("clearAlarm");
    EXPECT_TRUE(std::holds_alternative<ClearRobotAlarm>(sent.back()));

    snapshot.robotAlarm = {};
    snapshot.place = PlaceState::Unsure;
    panel.apply(snapshot, true);
    EXPECT_TRUE(child<QLabel>("robotProblem")->isVisible());
    snapshot.state = RunState::Fault; // for that very reason
    panel.apply(snapshot, false);
    QSignalSpy home(&panel, &JogPanel::homeWanted);
    const std::size_t before = sent.size();
    click("homeRobot");
    EXPECT_EQ(home.count(), 1);
    EXPECT_EQ(sent.size(), before) << "nobody has been asked";
    snapshot.place = PlaceState::Unknown; // the engine would refuse
    panel.apply(snapshot, false);
    EXPECT_FALSE(child<QPushButton>("homeRobot")->isEnabled());
}

} // namespace bask
