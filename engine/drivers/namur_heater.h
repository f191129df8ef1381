#pragma once
// A laboratory hotplate with the NAMUR protocol (IKA) as a heat source.

#include "engine/devices/heat_source.h"
#include "engine/drivers/link_watch.h"
#include "engine/guard/guard_messages.h"
#include "engine/protocols/line_splitter.h"

namespace bask {

struct HeatSourceDriver;

struct NamurHeaterConfig {
    bool isProbeUsed = false;       ///< the external probe is at the hot surface, not the plate's own sensor
    double watchdog_s = 30.0;       ///< of the plate: 20 to 1500
    bool mayHeatUnattended = false; ///< allowed also if the plate does not echo its watchdog
    bool operator==(const NamurHeaterConfig&) const = default;
};

/// The plate does not answer commands, so its set point is read back repeatedly; a difference is reported as
/// SafetySetPointOther. Its own watchdog is served while heat is requested and, once the heat is confirmed
/// off after heatOff(), also later: otherwise it would end every run with an error at the plate. If the
/// engine dies, the plate goes off by itself. Off means STOP and a set point of 0 degC that is read back.
class NamurHeater final : public HeatSource, public Device {
public:
    static constexpr double kDeadline_s = 0.5; ///< for one answer
    /// Wait after a missing answer, so that a late one is not taken for the next one; kDeadline_s with the
    /// probe, because its channel is also that of the set point.
    static constexpr double kQuiet_s = 0.25;
    static constexpr double kSilence_s = 2.0; ///< without a temperature for this long it is lost
    static constexpr double kPoll_s = 0.2;    ///< between two temperatures

    /// `link` and `clock` must outlive it. Throws std::invalid_argument for a watchdog time that no plate
    /// has.
    NamurHeater(ByteLink& link, const Clock& clock, const NamurHeaterConfig& config);

    void work() override;
    DeviceStatus status() const override;
    void expect(const std::string& name) override { m_expected = name; }

    /// The time of the reading is that of the request.
    Result<Reading> read() override;
    /// Refuses set points outside 0 to 310 degC, which no plate has. If the plate has not echoed its watchdog
    /// twice, its heat goes off, and this returns an Error until heatOff().
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    /// Returns an Error if the link is closed, and after three attempts that do not change the set point.
    Result<void> heatOff() override;
    /// True if heat is requested, or not yet confirmed off; false for a plate that never answered.
    bool heating() const override {
        return m_isOn || (m_isOffDue && (m_wasOn || (m_watch.isLive() && !isOther())));
    }
    HeatState heatState() const override;
    std::optional<double> setPoint_K() const override { return m_readBack_K; }
    /// True until the plate fails to echo it.
    bool hasWatchdog() const override;

    /// Returns what switches any such plate off, for its guard: STOP, then set point 0, which is read back.
    static guard::OffProgram offProgram();

    /// Returns the number of answers so far that did not fit.
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
    std::optional<std::string> m_expected; ///< name of the expected device; "": it reports none
    bool m_isNameTold = false;             ///< since the link was opened, or the request was not answered

    Question m_asked = Question::None;
    double m_askedAt_s = 0.0, m_nextLine_s = 0.0, m_nextPoll_s = 0.0;
    int m_polls = 0, m_namesLeft = 0;
    std::optional<Reading> m_reading;

    // Heat
    bool m_isOn = false;
    bool m_isFed = false; ///< whether its watchdog runs: it has been on, and the caller is still there
    double m_until_s = -1e300, m_setPoint_K = 0.0, m_sent_K = 0.0;
    bool m_mustSet = false, m_mustStart = false;
    double m_nextSet_s = 0.0;
    bool m_isOffDue = false;                     ///< not yet confirmed off
    bool m_wasOn = false;                        ///< since it was last confirmed off
    bool m_mustZero = false, m_mustLook = false; ///< for the set point of a plate that should be off
    int m_stopsLeft = 0;
    double m_off_s = 0.0, m_nextStop_s = 0.0, m_nextWatchdog_s = 0.0;
    bool m_isWatched = false; ///< whether the watchdog was echoed since heat was requested
    int m_unechoed = 0;       ///< number of watchdogs in a row that were sent but not echoed
    Message m_refusal;        ///< why the heat went off by itself; until heatOff()
    std::optional<double> m_readBack_K;
    int m_others = 0; ///< number of set points read back in a row that differ from the one sent
};

/// Returns its entry in the driver catalogue.
HeatSourceDriver namurHeaterDriver();

} // namespace bask
