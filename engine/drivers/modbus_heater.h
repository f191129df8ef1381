#pragma once
// Temperature controllers over Modbus as heat sources, described by a profile. The registers are read
// continuously, and written only where they differ from the wanted values.

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
    double period_s = 0.25;     ///< period of polls, which also prevent the device's watchdog from tripping
    double silentAfter_s = 1.0; ///< without a valid reply for this long the device is lost
    double watchdog_s = 30.0;   ///< if the profile has one
};

/// The default state is off: a controller that is found on is switched off. Off is the profile's run register
/// or, if there is none, its set point for off. The watchdog is set before heat goes on. Controllers may
/// store set points in memory that wears out: a moving set point is written in steps, at most 3 K or 5 s
/// late. If a controller reports its unit, it is read and set in that unit; if it reports an unknown unit, it
/// gives no temperature and is not heated.
class ModbusHeater final : public HeatSource, public Device {
public:
    /// `link` and `clock` must outlive it; the link may be shared. Errors: ValueOutOfRange (unit, period, a
    /// watchdog time or set point that the registers cannot store), JsonMissingKey (not a controller).
    static Result<std::unique_ptr<ModbusHeater>> create(ModbusLink& link, const Clock& clock,
                                                        const ModbusHeaterSettings& settings);

    void work() override;
    DeviceStatus status() const override { return m_identity.told(m_exchange.status(), m_exchange.name()); }
    void expect(const std::string& signature) override { m_identity.expect(signature); }
    Result<Reading> read() override;
    /// Also refused if the device did not accept what was written: SafetySetPointOther, DeviceException. If
    /// it had accepted it but has another value now, it was stopped (SafetySourceStopped) or set
    /// (SafetySetPointOther) at the device: it is switched off, and this is refused until heatOff().
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    /// Returns an Error if the device does not answer; it is switched off as soon as it does. Also returns
    /// why three attempts failed; it tries again every 10 s, however often this is called.
    Result<void> heatOff() override;
    /// True if heat is wanted, or not yet confirmed to be off.
    bool heating() const override;
    HeatState heatState() const override;
    std::optional<double> setPoint_K() const override;
    bool hasWatchdog() const override { return m_settings.profile.watchdog.has_value(); }

    /// Returns what switches it off, for its guard: the frames that write off and read it back, with the time
    /// that they take on that line.
    guard::OffProgram offProgram(const SerialSettings& line) const;

private:
    ModbusHeater(ModbusLink& link, const Clock& clock, const ModbusHeaterSettings& settings);
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
    std::optional<double> m_wanted_K;                ///< the requested set point
    double m_until_s = 0.0;                          ///< end of the request
    double m_set_K = 0.0;                            ///< the value of m_wanted_K that the device should have
    double m_set_s = 0.0, m_changed_s = 0.0;         ///< time of the last change of m_set_K and of m_wanted_K
    bool m_isSetTaken = false, m_isRunTaken = false; ///< whether they were read back correctly
    Message m_refusal;                               ///< why it was switched off; until heatOff()
    bool m_isOffDue = false;                         ///< switch off at once, before anything else
    bool m_overtakes = false;                        ///< the first off overtakes the request in progress
    bool m_mayBeOn = false;                          ///< written on, and not completely read as off since
    bool m_isKnown = false;                          ///< every register has been read once
    double m_cycle_s = -1e300;                       ///< when all were last read
    Message m_unitProblem;                           ///< why its unit is unknown
    bool m_isFresh = false;                          ///< all were read since the newest write
    std::size_t m_next = 0;                          ///< index in m_ranges
    double m_due_s = -1e300, m_measured_s = 0.0;
    bool m_isRefused = false;  ///< the newest read was refused
    bool m_isWriting = false;  ///< m_written is in progress
    ModbusRequest m_written{}; ///< the newest write
    int m_tries = 0;           ///< number of answered attempts without effect so far
    double m_again_s = 0.0;    ///< earliest next attempt after many
    double m_off_s = -1e300;   ///< when it was to go off
    Message m_writeProblem;    ///< problem of the newest write
};

/// Returns its entry in the driver catalogue.
HeatSourceDriver modbusHeaterDriver();
/// Returns that of the same devices on a network.
HeatSourceDriver modbusTcpHeaterDriver();

} // namespace bask
