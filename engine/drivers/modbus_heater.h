#pragma once
// Temperature controllers over Modbus as heat sources, by profile: what the device holds is read over and
// over, and written only where it differs from what is wanted.

#include "engine/devices/device.h"
#include "engine/devices/heat_source.h"
#include "engine/drivers/modbus_exchange.h"
#include "engine/drivers/modbus_identity.h"
#include "engine/guard/guard_messages.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/register_ranges.h"
#include "engine/protocols/serial_settings.h"

#include <memory>

namespace bask {

struct HeatSourceDriver;

struct ModbusHeaterSettings {
    int unit = 1;
    ModbusProfile profile{};
    double period_s = 0.25;     ///< of polls, which keep the device's watchdog quiet
    double silentAfter_s = 1.0; ///< without a fitting reply it is lost
    double watchdog_s = 30.0;   ///< where the profile has one
};

/// Off is what it is without anybody's word: found on, it is switched off. Off is the profile's run register,
/// or without one its set point for off. The watchdog is set before heat goes on. Controllers may keep set
/// points where writing wears: one that moves is written in steps, at most 3 K or 5 s late. One that tells
/// its unit is read and set in that; telling none that is known, it gives no temperature and is not heated.
class ModbusHeater final : public HeatSource, public Device {
public:
    /// `link` and `clock` must outlive it; the link may be shared. Errors: ValueOutOfRange (unit, period, a
    /// watchdog time or set point that the registers cannot hold), JsonMissingKey (not a controller).
    static Result<std::unique_ptr<ModbusHeater>> create(ModbusLink& link, const Clock& clock,
                                                        const ModbusHeaterSettings& settings);

    void work() override;
    DeviceStatus status() const override { return m_identity.told(m_exchange.status(), m_exchange.name()); }
    void expect(const std::string& signature) override { m_identity.expect(signature); }
    Result<Reading> read() override;
    /// Refused besides when the device did not take what was written: SafetySetPointOther, DeviceException;
    /// and until heatOff(), when it had taken it and holds something else now: it was stopped
    /// (SafetySourceStopped) or set otherwise (SafetySetPointOther) there, and is switched off.
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    /// An Error when the device does not answer; it is switched off as soon as it does. And why three tries
    /// were in vain; it is tried again every 10 s, however often this is called.
    Result<void> heatOff() override;
    /// Wanted, or not yet seen to be off.
    bool heating() const override;
    HeatState heatState() const override;
    std::optional<double> setPoint_K() const override;
    bool hasWatchdog() const override { return m_settings.profile.watchdog.has_value(); }

    /// What switches it off, for its guard: the frames that write off, and read it back, with the time that
    /// they take on that line.
    guard::OffProgram offProgram(const SerialSettings& line) const;

private:
    ModbusHeater(ModbusLink& link, const Clock& clock, const ModbusHeaterSettings& settings);
    void listRanges();
    void take(const ModbusReply& reply);
    bool takeUnit();
    void takeRead(const std::vector<std::uint16_t>& values);
    void takeCycle();
    void sendNext();
    void write(const ModbusRequest& request, bool overtakes = false);
    std::optional<ModbusRequest> correction() const;
    ModbusRequest offRequest() const;
    guard::OffStep offReadBack(int reply_ms) const;
    ModbusRequest setPointRequest(double setPoint_K) const;
    const RegisterSpec& writtenSetPoint() const;
    double quantity(const RegisterSpec& spec) const;
    bool holds(const RegisterSpec& spec, double number) const;
    double readBack_K(const RegisterSpec& spec) const;
    bool isSetTo(double setPoint_K) const;
    bool isSetDue() const;
    bool isOn() const;
    bool isDriven() const;
    bool isWorn() const;
    Message exchanged() const;
    void compare();
    void switchOff();
    Result<void> taken() const;

    ModbusHeaterSettings m_settings;
    const Clock& m_clock;
    ModbusExchange m_exchange;
    ModbusIdentity m_identity;
    std::vector<RegisterRange> m_ranges; ///< requests of a cycle
    RegisterImage m_image;
    Reading m_reading;
    std::optional<double> m_wanted_K;                ///< heat towards it
    double m_until_s = 0.0;                          ///< then it is wanted no more
    double m_set_K = 0.0;                            ///< of m_wanted_K, what the device is to hold
    double m_set_s = 0.0, m_changed_s = 0.0;         ///< when it, and m_wanted_K, became what they are
    bool m_isSetTaken = false, m_isRunTaken = false; ///< read back as they are to be
    Message m_refusal;                               ///< why it was switched off; until heatOff()
    bool m_isOffDue = false;                         ///< at once, before anything else
    bool m_overtakes = false;                        ///< the first off, what is under way
    bool m_mayBeOn = false;                          ///< written on, and not read off in whole since
    bool m_isKnown = false;                          ///< every register has been read once
    double m_cycle_s = -1e300;                       ///< when they were all read last
    Message m_unitProblem;                           ///< in which unit it counts is not known
    bool m_isFresh = false;                          ///< all of them since the newest write
    std::size_t m_next = 0;                          ///< of m_ranges
    double m_due_s = -1e300, m_measured_s = 0.0;
    bool m_isRefused = false;  ///< the newest read
    bool m_isWriting = false;  ///< m_written is under way
    ModbusRequest m_written{}; ///< newest
    int m_tries = 0;           ///< of it that were answered, without effect so far
    double m_again_s = 0.0;    ///< not before, when it was tried often
    double m_off_s = -1e300;   ///< when it was to go off
    Message m_writeProblem;    ///< of it
};

/// Its entry in the catalogue of drivers.
HeatSourceDriver modbusHeaterDriver();

} // namespace bask
