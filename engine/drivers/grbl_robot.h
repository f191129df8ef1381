#pragma once
// A robot with Grbl 1.1 or grblHAL as a Robot: bounded jogs, one at a time.
//
// Only one step is in progress at a time: `$J` to an absolute machine position that the motion guard
// approved, sent only to a controller that is idle and has answered everything. If the engine dies, the robot
// stops at the end of that step.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/devices/robot.h"
#include "engine/drivers/link_keeper.h"
#include "engine/drivers/step_planner.h"
#include "engine/protocols/grbl_lines.h"
#include "engine/protocols/line_splitter.h"

#include <array>
#include <optional>

namespace bask {

struct RobotDriver;

class GrblRobot final : public Robot, public Device {
public:
    /// If a robot ends a step, or is found again, farther from its position than this, it may have lost its
    /// position; mm, degrees.
    static constexpr double kElsewhere = 0.5;

    /// Its position is unsure until it has been homed or a person has confirmed it, because a controller that
    /// was just started reports zero at any position. `mustHome`: it must be homed; if empty, this is so if
    /// its controller can home ($22). Link and clock must outlive it.
    GrblRobot(ByteLink& link, const Clock& clock, AxisMap map, MotionGuard guard,
              std::optional<bool> mustHome);

    void work() override;
    DeviceStatus status() const override;
    void expect(const std::string& signature) override { m_expected = signature; }

    Result<RobotState> state() override;
    /// Returns an Error also while something prevents it from moving. Throws std::invalid_argument for
    /// numbers that are not finite.
    Result<void> setTwist(const Vector6d& twist, double validFor_s) override;
    void setRetreating(bool isRetreating) override;
    /// By the rates and accelerations that its controller reports ($110, $120 ...), since each step begins
    /// and ends at rest.
    std::optional<RobotLag> lagAt(double speed_m_s, double rotation_rad_s, double validFor_s) const override;
    Result<void> halt() override;
    Result<void> home() override;
    /// Clears only the alarm that state() shows: after a limit switch, the first call clears the controller,
    /// and the second one the doubt about its position.
    Result<void> clearAlarm() override;

    /// Returns the number of answers that did not fit the request, and of lines that could not be read.
    int discarded() const { return m_discarded; }

private:
    /// Answers within this time after opening the link are ignored, because they may be old.
    static constexpr double kSettle_s = 0.2;
    static constexpr int kNotTold = -1; ///< the alarm's number was not reported

    enum class Kind { Settings, Version, Modes, Mark, Jog, Unlock, Home };
    /// A line that is not acknowledged yet.
    struct Pending {
        Kind kind;
        double sent_s;
        bool hasReport = false; ///< a report that only this line requests has arrived
        bool hasUnits = false;  ///< including $13
        std::string version{};  ///< what `$I` has reported so far
    };
    static constexpr double kStepMargin_s = 0.01;
    struct Step {
        PlannedStep plan;
        double end_s;
        bool isTaken = false;
        bool isCancelled = false;
    };

    // The link
    bool isLinkOpen(double now_s);
    void begin(double now_s);
    void lose(const Message& why, double now_s);
    void watch(double now_s);
    void ask(double now_s);
    // Input
    void listen(double now_s);
    void take(const GrblLine& line, double now_s);
    void takeAnswer(int error, double now_s);
    void takeAnswerTo(const Pending& line, int error, double now_s);
    void takeStatus(const GrblStatus& status, double now_s);
    void takeState(const GrblStatus& status);
    void takeHome();
    void endHomeState();
    void doubtPlace();
    void takeBanner(const GrblBanner& banner, double now_s);
    void takeReport(const std::string& text, double now_s);
    void takeModes(const std::string& text);
    void takeSetting(const GrblSetting& setting);
    /// Returns the positions of its axes in the map's order; empty if not all are reported.
    std::vector<double> positionsIn(const GrblStatus& status);
    void checkPlace(bool wasIdle);
    void checkStepTime();
    void takeForeign();
    void discard(const std::string& words, double now_s);
    // Output
    void act(double now_s);
    bool maySend(double now_s) const;
    void send(Kind kind, const std::string& line, double now_s);
    void sendFence(double now_s);
    void sendStep(double now_s);
    void setUp(double now_s);
    void reset(std::optional<Kind> then, double now_s);
    void stopJog();
    void stopHoming(double now_s);
    void stopRun(double now_s);
    void workStops(double now_s);
    void dropMotion();
    bool clearHold();
    Result<void> clearDoubt();

    bool isMoving() const;
    bool isPlaceSure() const;
    bool isHomingDue() const { return m_mustHome.value_or(m_canHome.value_or(false)) && !m_isHomed; }
    bool isResting() const; ///< Idle or Alarm, in which it reads `$` lines
    Message keepsFromMoving() const;
    Message keepsFromTwist() const { return m_isRetreating ? keepsFromMoving() : alarm(); }
    Message alarm() const;
    static Message refusal(int error);
    void note(const Message& message, double now_s);
    Error notLive() const;
    bool isOther() const { return m_expected && !m_signature.empty() && m_signature != *m_expected; }
    bool isSetUpDue() const;
    bool isIdentified() const { return m_expected && m_signature == *m_expected; }

    ByteLink& m_link;
    LinkKeeper m_keeper;
    const Clock& m_clock;
    StepPlanner m_planner;
    std::optional<bool> m_mustHome;

    LinkState m_linkState = LinkState::Closed;
    Message m_problem;
    Message m_note; ///< shown for a while although it works
    double m_noteUntil_s = -1e300;
    bool m_wasLive = false;
    double m_heard_s = -1e300; ///< last sign that it is alive: reports, acknowledgements, banners
    double m_lastReply_s = -1e300, m_replyTime_s = 0.0, m_rate_Hz = 0.0;
    std::string m_identity, m_lastGarbage;
    std::string m_signature;               ///< from `$I` since the link was opened; empty: not reported yet
    std::optional<std::string> m_expected; ///< signature of the expected device
    int m_discarded = 0;
    LineSplitter m_splitter;

    std::optional<double> m_asked_s; ///< time of a `?` that is not answered
    double m_lastAsk_s = -1e300;
    std::optional<Pending> m_line;
    /// Time of a `$G` whose report shows that everything before it is answered.
    std::optional<double> m_fence_s;
    double m_linesFrom_s = 0.0;      ///< until then late answers may arrive
    std::optional<double> m_reset_s; ///< time of a 0x18 without its banner
    std::optional<Kind> m_next;      ///< Unlock or Home, to be sent as soon as possible
    double m_nextFrom_s = 0.0;
    bool m_isHalting = false;
    /// When homing was to be stopped; empty when the robot has shown that it accepted this.
    std::optional<double> m_homeStop_s;
    std::optional<double> m_runStop_s; ///< when motion was to be paused
    bool m_wasRunReset = false;
    double m_stopAgain_s = -1e300; ///< when the byte for either of them was last sent
    bool m_isIdleSeen = false;     ///< since the last line was acknowledged
    bool m_isSetUp = false, m_tellsInches = false;
    int m_reports = 0; ///< what its reports have, $10
    /// Its feed rate is one that a start would reset; whether it did is asked for after each opening.
    bool m_isMarked = false, m_isMarkToCheck = false, m_takesMark = true;
    bool m_areUnitsDue = false;    ///< somebody else may have changed its settings
    std::optional<bool> m_canHome; ///< as it reports
    /// Of its axes in grbl::kLetters, as it reports them, mm or degrees with min and s^2; 0: not reported.
    std::array<double, grbl::kLetters.size()> m_maxRate{}, m_acceleration{};
    double m_setUpFrom_s = 0.0;

    std::optional<Step> m_step;
    GrblStatus m_status;
    std::vector<double> m_at; ///< axes, as last reported
    double m_at_s = 0.0;
    std::vector<double> m_spanFrom, m_spanTo; ///< it stands between these
    bool m_isPlaceToCheck = false;

    std::optional<int> m_alarm;
    double m_alarmed_s = -1e300; ///< when a line last reported an alarm
    std::optional<int> m_refused;
    std::optional<double> m_elsewhere;
    std::string m_pausedBy;
    bool m_isHomed = false, m_isConfirmed = false; ///< since it started
    bool m_isRetreating = false;
    bool m_isStepLate = false;
    bool m_hasRestarted = false, m_isSlow = false, m_isPlaceInDoubt = false;
};

/// Returns its entry in the driver catalogue.
RobotDriver grblDriver();

} // namespace bask
