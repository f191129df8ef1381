#pragma once
// What the camera shows of a rig that stands still: at one pose of the robot, or at several that it is sent
// to.

#include "engine/calibration/hand_eye.h"
#include "engine/control/rig_geometry.h"

#include <optional>
#include <vector>

namespace bask {

/// Poses about `from` within the robot's workspace and clear of the source, never nearer to it, that tell
/// where a camera stands; the last is `from`.
std::vector<Vector6d> surveyPoses(const RigGeometry& geometry, const Vector6d& from);

/// Frames count once the robot has stood for kStill_s of the camera's time.
class RigSurvey {
public:
    static constexpr double kStill_s = 0.5;
    static constexpr double kNoMove_s = 3.0; ///< a robot that does not set off stays where it is
    enum class State { Idle, Travelling, Standing, Done };

    /// Collects so many frames at each goal, or where the robot is when there is none.
    void begin(std::vector<Vector6d> goals, int frames);
    void cancel() { m_state = State::Idle; }
    const Vector6d& start() const { return m_start; } ///< where the robot was at the beginning

    /// A robot that has set off and stands short of its goal was held: the survey ends, lest it goes on.
    void setRobot(const Vector6d& coordinates, bool isMoving);
    void addFrame(double time_s, const MarkerFrame& frame);
    /// Where the robot is to be sent now; each goal is told once.
    std::optional<Vector6d> takeGoal();

    State state() const { return m_state; }
    bool isOn() const { return m_state == State::Travelling || m_state == State::Standing; }
    int poses() const { return m_goals.empty() ? 1 : static_cast<int>(m_goals.size()); }
    int framesWanted() const { return m_frames * poses(); }
    int framesTaken() const;
    /// One of its views is from elsewhere than the beginning.
    bool hasMoved() const;
    /// One a pose of the robot.
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
    std::optional<double> m_still_s; ///< camera's time since when nothing has moved
    std::optional<double> m_sent_s;
    std::vector<HandEyeView> m_views;
};

} // namespace bask
