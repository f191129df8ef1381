#pragma once
// A laboratory hotplate that speaks NAMUR (IKA) as heat source.

#include "engine/devices/heat_source.h"
#include "engine/drivers/link_watch.h"
#include "engine/guard/guard_messages.h"
#include "engine/protocols/line_splitter.h"

namespace bask {

struct HeatSourceDriver;

struct NamurHeaterConfig {
    bool isProbeUsed = false;       ///< the external probe is at the hot surface, not the plate's own sensor
    double watchdog_s = 30.0;       ///< of the plate: 20 to 1500
    bool mayHeatUnattended = false; ///< also where the plate does not say its watchdog back
    bool operator==(const NamurHeaterConfig&) const = default;
};

/// The plate says nothing to what it is told to do, so its set point is read back again and again; a
/// difference is told as SafetySetPointOther. Its own watchdog is fed while heat is asked for, and, once the
/// heat is seen to be off, after heatOff(), or it would end every run with an error at the plate; an engine
/// that dies leaves a plate that goes off by itself. Off is STOP and a set point of 0 degC that reads back.
class NamurHeater final : public HeatSource, public Device {
public:
    static constexpr double kDeadline_s = 0.5; ///< of one answer
    static constexpr double kQuiet_s = 0.25; ///< after one that did not come, so that it is not taken for the
                                             ///< next one's; kDeadline_s with the probe, whose channel the
                                             ///< set point has too
    static constexpr double kSilence_s = 2.0; ///< without a temperature: lost
    static constexpr double kPoll_s = 0.2;    ///< between two temperatures

    /// `link` and `clock` must outlive it. Throws std::invalid_argument on a watchdog that no plate has.
    NamurHeater(ByteLink& link, const Clock& clock, const NamurHeaterConfig& config);

    void work() override;
    DeviceStatus status() const override;
    void expect(const std::string& name) override { m_expected = name; }

    /// The time is that of the question.
    Result<Reading> read() override;
    /// Refuses what no plate can be set to, 0 to 310 degC. An Error too, until heatOff(), when the plate has
    /// not said its watchdog back twice; its heat is off then.
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    /// An Error when the link is closed, and after three tries that are not seen in the set point.
    Result<void> heatOff() override;
    /// Asked for, or not yet seen to be off; not of a plate that never answered.
    bool heating() const override {
        return m_isOn || (m_isOffDue && (m_wasOn || (m_watch.isLive() && !isOther())));
    }
    HeatState heatState() const override;
    std::optional<double> setPoint_K() const override { return m_readBack_K; }
    /// As far as is known: until it was not said back.
    bool hasWatchdog() const override;

    /// What switches any such plate off, for its guard: STOP, set point 0, which is read back.
    static guard::OffProgram offProgram();

    /// Answers that did not fit so far.
    int discards() const { return m_watch.discards(); }

private:
    enum class Question { None, Name, Temperature, SetPoint, Watchdog };

    void begin();
    void takeLine(const std::string& line);
    void takeName(std::string name);
    bool takeTemperature(const std::string& line);
    bool takeSetPoint(const std::string& line);
    void giveUpLate();
    void speak();
    void order();
    void poll();
    void ask(Question question, const std::string& command);
    void say(const std::string& command);
    void stop();
    void sayStop();
    void watchdogUnechoed();
    Result<void> offSeen() const;
    bool isOther() const { return m_expected && m_isNameTold && m_name != *m_expected; }
    Message exchanged() const;
    bool isSetPointOther() const;

    ByteLink& m_link;
    const Clock& m_clock;
    NamurHeaterConfig m_config;
    LinkWatch m_watch;
    LineSplitter m_lines;
    std::string m_name;
    std::optional<std::string> m_expected; ///< name of the one that is meant; "": it tells none
    bool m_isNameTold = false;             ///< since the link was opened, or it was asked in vain

    Question m_asked = Question::None;
    double m_askedAt_s = 0.0, m_nextLine_s = 0.0, m_nextPoll_s = 0.0;
    int m_polls = 0, m_namesLeft = 0;
    std::optional<Reading> m_reading;

    // Heat
    bool m_isOn = false;
    bool m_isFed = false; ///< the watchdog: it has been on, and whoever asked is there still
    double m_until_s = -1e300, m_setPoint_K = 0.0, m_sent_K = 0.0;
    bool m_mustSet = false, m_mustStart = false;
    double m_nextSet_s = 0.0;
    bool m_isOffDue = false;                     ///< not yet seen to be off
    bool m_wasOn = false;                        ///< since it was seen to be off last
    bool m_mustZero = false, m_mustLook = false; ///< the set point of one that is to be off
    int m_stopsLeft = 0;
    double m_off_s = 0.0, m_nextStop_s = 0.0, m_nextWatchdog_s = 0.0;
    bool m_isWatched = false; ///< the watchdog was echoed since heat was asked for
    int m_unechoed = 0;       ///< watchdogs sent and not echoed, in a row
    Message m_refusal;        ///< why the heat went off by itself; until heatOff()
    std::optional<double> m_readBack_K;
    int m_others = 0; ///< set points read back in a row that are not the one set
};

/// Its entry in the catalogue of drivers.
HeatSourceDriver namurHeaterDriver();

} // namespace bask
