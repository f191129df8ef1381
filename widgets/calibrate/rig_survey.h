#pragma once
// Collects views of a rig at rest: at one pose of the robot, or at several poses to which it is sent.

#include "engine/calibration/hand_eye.h"
#include "engine/control/rig_geometry.h"

#include <optional>
#include <vector>

namespace bask {

/// Returns poses around `from`, within the robot's workspace and clear of the source, never nearer to it,
/// that determine the camera's pose; the last one is `from`.
std::vector<Vector6d> surveyPoses(const RigGeometry& geometry, const Vector6d& from);

/// Frames count after the robot has been at rest for kStill_s of the camera's time.
class RigSurvey {
public:
    static constexpr double kStill_s = 0.5;
    /// a robot that has not started after this time stays where it is
    static constexpr double kNoMove_s = 3.0;
    enum class State { Idle, Travelling, Standing, Done };

    /// Collects this number of frames at each goal, or at the present pose if there is none.
    void begin(std::vector<Vector6d> goals, int frames);
    void cancel() { m_state = State::Idle; }
    const Vector6d& start() const { return m_start; } ///< pose of the robot at the beginning

    /// If the robot stops before its goal, it was paused: the survey ends, so that it does not continue.
    void setRobot(const Vector6d& coordinates, bool isMoving);
    /// Returns whether the frame counts: then it is of the pose of the last view.
    bool addFrame(double time_s, const MarkerFrame& frame);
    /// Returns the next goal for the robot; each goal is returned once.
    std::optional<Vector6d> takeGoal();

    State state() const { return m_state; }
    bool isOn() const { return m_state == State::Travelling || m_state == State::Standing; }
    int poses() const { return m_goals.empty() ? 1 : static_cast<int>(m_goals.size()); }
    int framesWanted() const { return m_frames * poses(); }
    int framesTaken() const;
    /// Whether one of its views is from another pose than the first.
    bool hasMoved() const;
    /// One view for each pose of the robot.
    const std::vector<HandEyeView>& views() const { return m_views; }

private:
    void next();
    bool isThere() const;

    State m_state = State::Idle;
    std::vector<Vector6d> m_goals;
    int m_frames = 0;
    std::size_t m_goal = 0;
    bool m_goalTold = true;
    bool m_setOff = false;
    Vector6d m_robot = Vector6d::Zero();
    Vector6d m_start = Vector6d::Zero();
    bool m_isMoving = false;
    std::optional<double> m_still_s; ///< camera's time since which nothing has moved
    std::optional<double> m_sent_s;
    std::vector<HandEyeView> m_views;
};

} // namespace bask
