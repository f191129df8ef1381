#pragma once
// A four-axis Dobot arm (MG400, M1 Pro) as a Robot: bounded straight moves, one at a time.
//
// The arm's speed is a whole percentage of its own maximum, not a number. Therefore each step is a short
// move, up to twice as fast as requested, followed by a pause until the step's time is over. No move is
// faster than the limit: the overall speed factor is set to it, and the reported positions are checked. The
// encoders are absolute, so no homing is needed.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/devices/robot.h"
#include "engine/drivers/link_keeper.h"
#include "engine/drivers/step_planner.h"
#include "engine/protocols/dobot_messages.h"
#include "engine/protocols/line_splitter.h"

#include <algorithm>
#include <deque>
#include <optional>

namespace bask {

struct RobotDriver;

class DobotRobot final : public Robot, public Device {
public:
    static constexpr double kElsewhere = 0.5; ///< mm, degrees; as in GrblRobot
    static constexpr int kAcceleration_percent = 20;
    static constexpr double kFullSpeed_mm_s = 500.0; ///< default if it is not given
    static constexpr double kLargest_mm_s = 20.0;    ///< until limitSpeed(); also in degrees per second

    /// Links to its ports 29999, 30003 and 30004, and the clock, must outlive it. Axes are X, Y, Z and R;
    /// those that are not in the map stay where they are. Full speed is that of its playback settings.
    DobotRobot(ByteLink& dashboard, ByteLink& motion, ByteLink& feedback, const Clock& clock, AxisMap map,
               MotionGuard guard, double fullSpeed_mm_s = kFullSpeed_mm_s);

    /// Sets the largest speed and rotation, as MovL counts them: no command is faster.
    void limitSpeed(double max_m_s, double max_rad_s) override;

    void work() override;
    DeviceStatus status() const override;

    Result<RobotState> state() override;
    /// Returns an Error also while something prevents it from moving. Throws std::invalid_argument for
    /// numbers that are not finite.
    Result<void> setTwist(const Vector6d& twist, double validFor_s) override;
    void setRetreating(bool isRetreating) override;
    Result<void> halt() override;
    Result<void> home() override; ///< always RobotCannotHome
    /// Clears the alarm that state() shows: ends an alarm or a pause, and enables the arm.
    Result<void> clearAlarm() override;

    /// Returns the number of replies that did not fit the request or could not be read.
    int discarded() const { return m_discarded; }

private:
    struct Asked {
        std::string command; ///< in lower case
        double sent_s;
    };
    struct Step {
        PlannedStep plan;
        double taken_s = 0.0;
        bool isTaken = false, wasRunning = false, isCancelled = false;
    };

    bool areLinksOpen(double now_s);
    void begin(double now_s);
    void lose(const Message& why, double now_s);
    void watch(double now_s);
    void listen(double now_s);
    void takeReply(const DobotReply& reply, double now_s);
    void takeSetUp(const DobotReply& reply, double now_s);
    void takeMoveReply(const std::string& text, double now_s);
    void takeFeedback(const DobotFeedback& feedback, double now_s);
    void takeTime(const DobotFeedback& feedback, double now_s);
    void takeFrames(const DobotFeedback& feedback);
    void takeMode();
    void followStep();
    void checkPlace();
    std::vector<double> axesOf(const DobotPosition& position);
    void discard(const std::string& words, double now_s);
    void takeStrange(double now_s);
    Message silent(double silent_s) const;
    void act(double now_s);
    void setUp();
    void sendStep(double now_s);
    int speedFactor() const;
    int speedOf(const PlannedStep& plan) const;
    void checkPace();
    void stopMove();
    void failStep(const char* words);
    bool isMoving() const;
    /// Returns whether a move after the last reset waits in its queue, although the queue may be stopped.
    bool isResetDue() const { return m_reset_s < std::max(m_halted_s, m_answered_s); }
    Message alarm() const;
    Message keepsFromTwist() const;
    void note(const Message& message, double now_s);
    Error notLive() const;

    LinkKeeper m_dashboard, m_motion, m_feedback;
    const Clock& m_clock;
    StepPlanner m_planner;
    double m_fullSpeed_mm_s, m_largest_mm_s = kLargest_mm_s, m_largest_deg_s = kLargest_mm_s;

    LinkState m_linkState = LinkState::Closed;
    Message m_problem, m_note;
    double m_noteUntil_s = -1e300;
    bool m_isOpen = false, m_wasLive = false;
    double m_opened_s = 0.0, m_lastPacket_s = -1e300, m_lastRead_s = 0.0, m_rate_Hz = 0.0,
           m_replyTime_s = 0.0;
    int m_discarded = 0;
    LineSplitter m_dashboardReplies{";"}, m_motionReplies{";"};
    DobotFeedbackReader m_packets;
    std::size_t m_strangeBytes = 0; ///< of the feedback port, counted so far
    double m_strange_s = -1e300;    ///< when the last of them came

    std::deque<std::string> m_toAsk; ///< commands for the dashboard, one after the other
    std::optional<Asked> m_asked;
    std::optional<double> m_move_s; ///< time of a move that is not acknowledged
    std::optional<Step> m_step;
    /// Whether its speed and frames were accepted since the last reset or enabling.
    bool m_isSetUp = false;
    bool m_mustReset = false, m_mustContinue = false; ///< its queue was stopped by an error
    bool m_isHalting = false, m_isIdleSeen = false;
    double m_halted_s = 0.0, m_answered_s = 0.0, m_reset_s = -1e300;
    /// Until then its modes are no alarms, because a reset or enabling causes them.
    double m_quietUntil_s = 0.0;
    double m_askErrors_s = -1e300;

    DobotMode m_mode = DobotMode::Starting;
    DobotPosition m_position{}, m_still{}; ///< as reported; positions of axes without a coordinate
    std::vector<double> m_at;
    double m_at_s = 0.0;
    DobotPosition m_pacedAt{}; ///< position some packets before
    std::uint64_t m_paced_ms = 0;
    double m_offset_s = 0.0; ///< from the engine's clock to the controller's
    std::uint64_t m_time_ms = 0;
    std::optional<double> m_otherFrame_s; ///< since when its frames are not 0
    double m_setUp_s = 0.0;
    std::vector<double> m_spanFrom, m_spanTo; ///< it stands between these
    bool m_isPlaceToCheck = false;

    std::optional<int> m_alarm; ///< 0: number not reported
    std::optional<int> m_refused;
    std::optional<double> m_elsewhere;
    bool m_isRetreating = false;
    std::string m_failure; ///< detected here; its controller does not report it
    std::string m_pausedBy;
    bool m_isDisabled = false, m_isSlow = false;
};

/// Returns its entry in the driver catalogue.
RobotDriver dobotDriver();

} // namespace bask
