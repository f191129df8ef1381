#pragma once
// A heat source that is switched by a program of the operator's, docs/program-driver.md.

#include "engine/devices/heat_source.h"
#include "engine/drivers/program_talk.h"

namespace bask {

struct HeatSourceDriver;

/// The heat goes off by itself in the program when nothing keeps it on, and when the input of the program
/// ends; a device with a watchdog goes off without its program, too. Off means that a state that was asked
/// for after `off` says so.
class ProgramHeater final : public HeatSource, public Device {
public:
    /// `link` and `clock` must outlive it. Without `mayHeatUnattended` a device without a watchdog of its own
    /// is not heated.
    ProgramHeater(ByteLink& link, const Clock& clock, bool mayHeatUnattended);

    void work() override;
    DeviceStatus status() const override;
    void expect(const std::string& signature) override { m_talk.expect(signature); }

    Result<Reading> read() override;
    /// Refuses set points above that of the program's hello.
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    Result<void> heatOff() override;
    /// True if heat is requested, or not yet confirmed off; false for a program that never answered.
    bool heating() const override { return m_isOn || (m_isOffDue && (m_wasOn || m_talk.isLive())); }
    HeatState heatState() const override;
    std::optional<double> setPoint_K() const override;
    Message cannotHeat() const override;
    bool hasWatchdog() const override { return !m_talk.hello() || m_talk.hello()->hasWatchdog; }

private:
    void begin();
    void take(const ProgramLine& line, const ProgramRequest* asked);
    void order();
    void stop();
    bool isSetPointOther() const;

    ProgramTalk m_talk;
    const Clock& m_clock;
    bool m_mayHeatUnattended;
    std::optional<ProgramHeaterState> m_state;
    double m_at_s = -1e300;
    bool m_isOn = false;
    double m_until_s = -1e300, m_setPoint_K = 0.0, m_sent_K = 0.0, m_heat_s = -1e300, m_validFor_s = 0.0;
    bool m_isOffDue = false; ///< not yet confirmed off
    bool m_wasOn = false;    ///< since it was last confirmed off
    double m_off_s = -1e300, m_offSent_s = -1e300;
    int m_others = 0; ///< number of set points told in a row that differ from the one sent
    std::string m_refused;
};

/// Returns its entry in the driver catalogue.
HeatSourceDriver programHeaterDriver();

} // namespace bask
