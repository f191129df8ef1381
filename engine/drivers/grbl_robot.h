#pragma once
// A robot under Grbl 1.1 or grblHAL as a Robot: bounded jogs, one at a time.
//
// At most one step is under way: `$J` to an absolute machine position that the guard approved, sent only to
// a controller that is idle and owes no answer. A dead engine stops the robot at the end of that step.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/devices/robot.h"
#include "engine/drivers/link_keeper.h"
#include "engine/drivers/step_planner.h"
#include "engine/protocols/grbl_lines.h"
#include "engine/protocols/line_splitter.h"

#include <optional>

namespace bask {

struct RobotDriver;

class GrblRobot final : public Robot, public Device {
public:
    /// A robot that ends a step, or is found again, farther from its place than this may have lost it; mm,
    /// degrees.
    static constexpr double kElsewhere = 0.5;

    /// Its place is not sure before it has been homed or a person has confirmed it: a controller that was
    /// just started says zero wherever it stands. `mustHome`: homed it must be; empty: it must where its
    /// controller says that it can ($22). Link and clock must outlive it.
    GrblRobot(ByteLink& link, const Clock& clock, AxisMap map, MotionGuard guard,
              std::optional<bool> mustHome);

    void work() override;
    DeviceStatus status() const override;
    void expect(const std::string& signature) override { m_expected = signature; }

    Result<RobotState> state() override;
    /// An Error, too, while something keeps it from moving. Throws std::invalid_argument for numbers that are
    /// not finite.
    Result<void> setTwist(const Vector6d& twist, double validFor_s) override;
    void setRetreating(bool isRetreating) override;
    Result<void> halt() override;
    Result<void> home() override;
    /// Clears what state() shows as its alarm, and nothing behind it: after a limit switch the controller
    /// first, and called again the doubt about its place.
    Result<void> clearAlarm() override;

    /// Answers that did not fit what was asked, and lines that could not be read.
    int discarded() const { return m_discarded; }

private:
    static constexpr double kSettle_s = 0.2; ///< what was under way when the link was opened is not heard
    static constexpr int kNotTold = -1;      ///< the number of an alarm

    enum class Kind { Settings, Version, Jog, Unlock, Home };
    /// The line that is not acknowledged.
    struct Pending {
        Kind kind;
        double sent_s;
        bool hasReport = false; ///< something that only this line asks for has come
        bool hasUnits = false;  ///< $13 among it
        std::string version{};  ///< what `$I` has told so far
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
    // What it says
    void listen(double now_s);
    void take(const GrblLine& line, double now_s);
    void takeAnswer(int error, double now_s);
    void takeAnswerTo(const Pending& line, int error, double now_s);
    void takeStatus(const GrblStatus& status, double now_s);
    void takeState(const GrblStatus& status);
    void takeHome();
    void endHomeState();
    void takeBanner(const GrblBanner& banner, double now_s);
    void takeReport(const std::string& text, double now_s);
    void takeSetting(const GrblSetting& setting);
    /// Of its axes in the map's order; empty where it does not tell all of them.
    std::vector<double> positionsIn(const GrblStatus& status);
    void checkPlace();
    void discard(const std::string& words, double now_s);
    // What it is told
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
    bool isResting() const; ///< Idle or Alarm, where it reads its `$` lines
    Message keepsFromMoving() const;
    Message keepsFromTwist() const { return m_isRetreating ? keepsFromMoving() : alarm(); }
    Message alarm() const;
    static Message refusal(int error);
    void note(const Message& message, double now_s);
    Error notLive() const;
    bool isOther() const { return m_expected && !m_signature.empty() && m_signature != *m_expected; }
    bool isIdentified() const { return m_expected && m_signature == *m_expected; }

    ByteLink& m_link;
    LinkKeeper m_keeper;
    const Clock& m_clock;
    StepPlanner m_planner;
    std::optional<bool> m_mustHome;

    LinkState m_linkState = LinkState::Closed;
    Message m_problem;
    Message m_note; ///< told for a while though it works
    double m_noteUntil_s = -1e300;
    bool m_wasLive = false;
    double m_heard_s = -1e300; ///< for its liveness: reports, acknowledgements, banners
    double m_lastReply_s = -1e300, m_replyTime_s = 0.0, m_rate_Hz = 0.0;
    std::string m_identity, m_lastGarbage;
    std::string m_signature;               ///< by its `$I` since the link was opened; empty: not told yet
    std::optional<std::string> m_expected; ///< of the one that is meant
    int m_discarded = 0;
    LineSplitter m_splitter;

    std::optional<double> m_asked_s; ///< `?` that is not answered
    double m_lastAsk_s = -1e300;
    std::optional<Pending> m_line;
    std::optional<double> m_fence_s; ///< a `$G` whose report tells that all before it is settled
    double m_linesFrom_s = 0.0;      ///< late answers are waited for until then
    std::optional<double> m_reset_s; ///< 0x18 whose banner has not come
    std::optional<Kind> m_next;      ///< Unlock or Home, as soon as a line may be sent
    double m_nextFrom_s = 0.0;
    bool m_isHalting = false;
    std::optional<double>
        m_homeStop_s; ///< when homing was to end; over when the robot has shown that it took it
    std::optional<double> m_runStop_s; ///< when what runs was to be held
    bool m_wasRunReset = false;
    double m_stopAgain_s = -1e300; ///< the byte for either of them was sent last
    bool m_isIdleSeen = false;     ///< since the last line was acknowledged
    bool m_isSetUp = false, m_tellsInches = false;
    std::optional<bool> m_canHome; ///< as it tells
    double m_setUpFrom_s = 0.0;

    std::optional<Step> m_step;
    GrblStatus m_status;
    std::vector<double> m_offset; ///< WCO
    std::vector<double> m_at;     ///< axes, as told last
    double m_at_s = 0.0;
    std::vector<double> m_spanFrom, m_spanTo; ///< it stands between these
    bool m_isPlaceToCheck = false;

    std::optional<int> m_alarm;
    std::optional<int> m_refused;
    std::optional<double> m_elsewhere;
    std::string m_held;
    bool m_isHomed = false, m_isConfirmed = false; ///< since it started
    bool m_isRetreating = false;
    bool m_hasRestarted = false, m_isSlow = false, m_isPlaceInDoubt = false;
};

/// Its entry in the catalogue of drivers.
RobotDriver grblDriver();

} // namespace bask
