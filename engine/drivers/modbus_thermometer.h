#pragma once
// Thermometer modules over Modbus, described by a profile: reads every channel in as few requests as the
// device allows.

#include "engine/devices/thermometer.h"
#include "engine/drivers/modbus_exchange.h"
#include "engine/drivers/modbus_identity.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/profile_registers.h"
#include "engine/protocols/register_ranges.h"

#include <memory>

namespace bask {

struct ThermometerDriver;

struct ModbusThermometerSettings {
    int unit = 1;
    ModbusProfile profile{};
    std::vector<int> channels;  ///< channels of the device, in the order of the readings
    double period_s = 0.1;      ///< period of polls
    double silentAfter_s = 1.0; ///< without a valid reply for this long it is lost
};

class ModbusThermometer final : public Thermometer, public Device {
public:
    /// `link` and `clock` must outlive it; the link may be shared. Errors: ValueOutOfRange (unit, a channel,
    /// a period under 0.1 s), JsonMissingKey (a profile without a channel).
    static Result<std::unique_ptr<ModbusThermometer>> create(ModbusLink& link, const Clock& clock,
                                                             const ModbusThermometerSettings& settings);

    void work() override;
    DeviceStatus status() const override { return m_identity.told(m_exchange.status(), m_exchange.name()); }
    void expect(const std::string& signature) override { m_identity.expect(signature); }
    void setPeriod(double period_s) override;
    int channels() const override { return static_cast<int>(m_settings.channels.size()); }
    /// Returns the readings, each with the time at which its register was requested.
    Result<std::vector<Reading>> read() override;

private:
    struct Request {
        PolledRange polled;
        bool isRefused = false; ///< the newest one
        double asked_s = 0.0;   ///< time of the newest one that was answered
    };

    ModbusThermometer(ModbusLink& link, const Clock& clock, const ModbusThermometerSettings& settings);
    void take(const ModbusReply& reply);
    Reading reading(int channel) const;
    void publish();

    ModbusThermometerSettings m_settings;
    const Clock& m_clock;
    ModbusExchange m_exchange;
    ModbusIdentity m_identity;
    std::vector<Request> m_requests; ///< of a poll
    RegisterImage m_image;
    std::size_t m_next = 0;   ///< index in m_requests
    bool m_isRefused = false; ///< the newest request was refused
    double m_due_s = -1e300;
    std::vector<Reading> m_readings;
};

/// Returns its entry in the driver catalogue.
ThermometerDriver modbusThermometerDriver();
/// Returns that of the same devices on a network.
ThermometerDriver modbusTcpThermometerDriver();

} // namespace bask
