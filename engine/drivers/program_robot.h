#pragma once
// A robot that is driven by a program of the operator's, docs/program-driver.md.

#include "engine/devices/robot.h"
#include "engine/drivers/program_talk.h"
#include "engine/drivers/step_planner.h"

namespace bask {

struct RobotDriver;

/// Velocities and steps are those of StepPlanner: the end of each is approved before it is sent, and within
/// the limits that the program tells.
class ProgramRobot final : public Robot, public Device {
public:
    /// A robot further from where its commands should have brought it is elsewhere; mm, degrees, as in
    /// GrblRobot.
    static constexpr double kElsewhere = 0.5;

    /// `link` and `clock` must outlive it. With `mustHome` its position is unsure until it has been homed.
    ProgramRobot(ByteLink& link, const Clock& clock, AxisMap map, MotionGuard guard, bool mustHome);

    void work() override;
    DeviceStatus status() const override;
    void expect(const std::string& signature) override { m_talk.expect(signature); }

    RobotReach reach() const override;
    Result<RobotState> state() override;
    Result<void> setTwist(const Vector6d& twist, double validFor_s) override;
    void setRetreating(bool isRetreating) override;
    Result<void> halt() override;
    Result<void> home() override;
    Result<void> clearAlarm() override;

private:
    void begin();
    void take(const ProgramLine& line, const ProgramRequest* asked);
    void takeHello(const ProgramHello& hello);
    void takeState(const ProgramRobotState& state, double at_s, bool isAsked);
    void takeRefusal(ProgramRequest::Kind kind, const std::string& words);
    void checkPlace();
    void tellStop();
    void move();
    void sendVelocity();
    void sendStep();
    bool isOnItsWay() const;
    void allow(const std::vector<double>& place);
    std::vector<double> ownUnits(const std::vector<double>& positions) const;
    bool isWithinLimits(const Vector6d& target) const;
    bool isMoving() const;
    bool isPlaceSure() const;
    Message alarm() const;
    Message keepsFromTwist() const;

    ProgramTalk m_talk;
    const Clock& m_clock;
    StepPlanner m_planner;
    bool m_mustHome;

    std::vector<std::size_t> m_order; ///< of the program's axes in the map's
    std::optional<ProgramRobotState> m_state;
    std::vector<double> m_at; ///< mm and degrees, in the map's order
    double m_at_s = -1e300;
    // Of the motion that was commanded
    std::vector<double> m_rates; ///< mm/s and degrees/s; empty: none
    double m_ratesUntil_s = -1e300;
    std::optional<PlannedStep> m_step; ///< the last one, until it stands
    double m_stepSent_s = -1e300;
    bool m_isTwistNew = false;
    std::vector<double> m_spanFrom, m_spanTo;         ///< corners of where it may be; empty: anywhere
    bool m_isHalted = false;                          ///< until it is told to stand
    double m_halted_s = -1e300, m_stopped_s = -1e300; ///< since when, and when it was told last
    double m_homeSent_s = -1e300;
    bool m_isHomed = false, m_isHomeAsked = false, m_isRetreating = false, m_isResting = false;
    bool m_isHomingStopped = false; ///< until it is homed to the end, or a person has looked
    bool m_hasRestarted = false;    ///< likewise
    bool m_wasLive = false;
    std::optional<double> m_elsewhere;
    std::string m_refused;
};

/// Returns its entry in the driver catalogue.
RobotDriver programRobotDriver();

} // namespace bask
