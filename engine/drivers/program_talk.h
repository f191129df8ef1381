#pragma once
// The conversation with a program that drives a device, docs/program-driver.md: its hello, requests and their
// answers in order, the program's clock, and when the program is ended.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/drivers/link_keeper.h"
#include "engine/drivers/program_clock.h"
#include "engine/drivers/reply_rate.h"
#include "engine/protocols/line_splitter.h"
#include "engine/protocols/program_lines.h"

#include <deque>
#include <functional>
#include <optional>
#include <string>

namespace bask {

/// What was asked.
struct ProgramRequest {
    enum class Kind { Hello, Read, Stop, Velocity, Step, Home, Clear, Heat, Off };
    Kind kind;
    std::int64_t id;
    double sent_s;
};

/// Link and clock must outlive it.
class ProgramTalk {
public:
    static constexpr double kHello_s = 10.0; ///< longest time from the start to the hello
    static constexpr double kSlow_s = 0.5;   ///< an answer after this time is slow
    /// Without an answer for this time the program is ended; without a state it is not live.
    static constexpr double kSilence_s = 1.0;
    static constexpr double kNoState_s = 5.0; ///< without a state for this time it is started again
    static constexpr double kClockOff_s = 0.5;
    static constexpr int kMaxBad = 3; ///< lines within kBadWindow_s; then it is ended
    static constexpr double kBadWindow_s = 10.0;

    using Take = std::function<void(const ProgramLine& line, const ProgramRequest* asked)>;

    ProgramTalk(ByteLink& link, const Clock& clock, ProgramRole role);

    enum class Turn { Closed, Opened, Open };
    /// Reads what has arrived and gives each valid line to `take`, with the request that it answers; null:
    /// none is. Asks for the state if that is due. Opened: the program was started anew; everything from
    /// before is invalid.
    Turn work(const Take& take);
    /// Sets the time between two questions for the state, s.
    void setPeriod(double period_s);

    /// Writes a request; nothing is written to a program that has not said hello, or is another one.
    void send(ProgramRequest::Kind kind);
    void sendVelocity(const std::vector<double>& rates, double validFor_s);
    void sendStep(const std::vector<double>& to, double duration_s);
    void sendHeat(double setPoint_K, double validFor_s);
    bool isWaitingFor(ProgramRequest::Kind kind) const;

    /// Whether it has said hello, is the expected one, and its state is known and not old.
    bool isLive() const;
    /// Whether its oldest answer is late.
    bool isSlow() const;
    bool isOther() const;
    const std::optional<ProgramHello>& hello() const { return m_hello; }
    /// Returns when the state in a line was measured, at the latest, on the engine's clock.
    double measuredAt_s(const ProgramLine& line, const ProgramRequest* asked) const;
    void expect(const std::string& signature) { m_expected = signature; }

    /// Says that it does not fit the rig; it is not live from now on, and nothing is written to it.
    void refuse(const std::string& words);
    /// Reports a line that is not used. The program is ended if there are too many.
    void complain(const std::string& words);

    DeviceStatus status() const;
    /// Returns the error of a device that is not live.
    Error error() const;
    const std::string& name() const { return m_name; }

private:
    void begin();
    void note(const std::string& words);
    void end(const std::string& words);
    void end(const Message& why);
    void takeLine(const std::string& line, const Take& take);
    std::deque<ProgramRequest>::iterator find(const std::optional<std::int64_t>& id);
    bool answers(const ProgramLine& line, std::optional<ProgramRequest>& asked);
    bool checkClock(const ProgramLine& line, const ProgramRequest* asked);
    void takeHello(const ProgramHello& hello);
    void watch();
    bool mayWrite() const { return m_hello && !isOther() && m_misfit.empty(); }
    template <class Write> void write(ProgramRequest::Kind kind, Write text);
    Message problem() const;
    std::string signature() const;

    LinkKeeper m_keeper;
    const Clock& m_clock;
    ProgramRole m_role;
    const std::string m_name;
    LineSplitter m_lines{"\n", program::kLongestLine};
    std::optional<std::string> m_expected;
    std::optional<ProgramHello> m_hello;
    std::string m_misfit; ///< why it does not fit the rig
    std::deque<ProgramRequest> m_asked;
    std::int64_t m_id = 0, m_seq = 0;
    double m_period_s = 0.05, m_nextRead_s = 0.0;
    double m_hello_s = -1e300, m_state_s = -1e300, m_replyTime_s = 0.0;
    bool m_wasLive = false;
    ProgramClock m_programClock;
    std::deque<double> m_bad_s;
    int m_discards = 0;
    Message m_ended, m_complaint;
    double m_complained_s = -1e300;
    ReplyRate m_rate;
};

} // namespace bask
