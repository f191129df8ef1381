#pragma once
// Manual control of the robot: steps, motion while a button is pressed, moving to a pose, homing, clearing
// alarms.

#include "engine/control/robot_limits.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace bask {

/// A pressed button sends Jog every kRepeat_ms, and a zero Jog when it is released in any way. Object names
/// end in the coordinate's ("theta_x"): "at.", "stepDown.", "stepUp.", "holdDown.", "holdUp.", "goTo.";
/// others "robotPlace" (while that is not known), "stepLength", "stepAngle", "jogSpeed", "goToPose",
/// "takePose", "homeRobot", "clearAlarm", "robotProblem".
class JogPanel : public QWidget {
    Q_OBJECT

public:
    static constexpr int kRepeat_ms = 200;

    explicit JogPanel(QWidget* parent = nullptr);

    void setLimits(const RobotLimits& limits);
    /// `mayMove`: no run is armed or on, no fault is latched.
    void apply(const Snapshot& snapshot, bool mayMove);

signals:
    void commandWanted(const bask::Command& command);
    void homeWanted(); ///< once a person has confirmed it

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Row {
        QLabel *name, *at;
        QToolButton *holdDown, *stepDown, *stepUp, *holdUp;
        QDoubleSpinBox* goTo;
    };
    QWidget* buildSteps();
    QWidget* buildRows();
    QWidget* buildButtons();
    QToolButton* stepButton(int coordinate, int direction);
    QToolButton* holdButton(int coordinate, int direction);
    void step(int coordinate, int direction);
    void hold(QToolButton* button, int coordinate, int direction);
    void repeat();
    void letGo();
    void takePose();
    void goToPose();
    void showEnabled();
    void showPlace();
    void retranslate();

    RobotLimits m_limits;
    Vector6d m_at = Vector6d::Zero();
    std::optional<Vector6d> m_goal; ///< goal of the steps in progress
    bool m_isMoving = false;
    bool m_mayMove = false;
    bool m_mayHome = false;
    bool m_isPoseTaken = false; ///< the fields were set once to the robot's pose
    Message m_alarm;
    PlaceState m_place = PlaceState::Sure;
    double m_placeAge_s = 0.0;

    QToolButton* m_held = nullptr; ///< the pressed button that moves the robot
    int m_heldCoordinate = 0, m_heldDirection = 0;
    QTimer m_repeat{this};

    std::array<Row, 6> m_rows{};
    QLabel *m_stepLabel, *m_speedLabel, *m_goLabel, *m_problem, *m_placeMark, *m_placeLabel;
    QComboBox *m_stepLength, *m_stepAngle;
    QDoubleSpinBox* m_speed;
    QPushButton *m_go, *m_take, *m_home, *m_clear;
};

} // namespace bask
