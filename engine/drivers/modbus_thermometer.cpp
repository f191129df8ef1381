#include "engine/drivers/modbus_thermometer.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"
#include "engine/drivers/sensor_fault.h"
#include "engine/protocols/profile_registers.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <numeric>

namespace bask {
namespace {

constexpr double kMinPeriod_s = 0.1, kMaxPeriod_s = 60.0;

/// A device that is asked seldom is not silent between two polls.
double silentAfter_s(const ModbusThermometerSettings& settings) {
    return std::max(settings.silentAfter_s, 3.0 * settings.period_s);
}

Error outOfRange(const char* where, double value, double min, double max, const char* unit = "") {
    return {MessageCode::ValueOutOfRange,
            where,
            {formatNumber(value), formatNumber(min), formatNumber(max), unit}};
}

} // namespace

Result<std::unique_ptr<ModbusThermometer>>
ModbusThermometer::create(ModbusLink& link, const Clock& clock, const ModbusThermometerSettings& settings) {
    const ModbusProfile& profile = settings.profile;
    if (!profile.channel)
        return Error(MessageCode::JsonMissingKey, "profile", {"channel"});
    if (settings.unit < 1 || settings.unit > 247)
        return outOfRange("unit", settings.unit, 1, 247);
    if (settings.channels.empty())
        return outOfRange("channels", 0, 1, profile.channels);
    for (const int channel : settings.channels) {
        if (channel < 0 || channel >= profile.channels)
            return outOfRange("channels", channel, 0, profile.channels - 1);
    }
    if (!(settings.period_s >= kMinPeriod_s && settings.period_s <= kMaxPeriod_s))
        return outOfRange("period", settings.period_s, kMinPeriod_s, kMaxPeriod_s, "s");
    return std::unique_ptr<ModbusThermometer>(new ModbusThermometer(link, clock, settings));
}

ModbusThermometer::ModbusThermometer(ModbusLink& link, const Clock& clock,
                                     const ModbusThermometerSettings& settings)
    : m_settings(settings), m_clock(clock), m_exchange(link, clock, settings.unit, silentAfter_s(settings)),
      m_identity(settings.profile) {
    for (const PolledRange& polled : thermometerPoll(settings.profile, settings.channels))
        m_requests.push_back({polled});
}

void ModbusThermometer::setPeriod(double period_s) {
    m_settings.period_s = std::clamp(period_s, kMinPeriod_s, kMaxPeriod_s);
    m_exchange.setSilentAfter(silentAfter_s(m_settings));
}

void ModbusThermometer::work() {
    if (const auto reply = m_exchange.work())
        take(*reply);
    if (!m_exchange.isLive()) {
        m_identity.forget();
        m_readings.clear();
    }
    const double now_s = m_clock.now_s();
    const bool waits = m_next == 0 || m_isRefused;
    if (!m_exchange.canSend() || (waits && now_s < m_due_s))
        return;
    if (waits)
        m_due_s = std::max(m_due_s + m_settings.period_s, now_s + 0.5 * m_settings.period_s); // no drift
    const RegisterRange& range = m_requests[m_next].polled.range;
    m_exchange.send({0, range.function, range.address, range.count});
}

/// After a refusal the same is asked again: another question could take its late answer.
void ModbusThermometer::take(const ModbusReply& reply) {
    Request& asked = m_requests[m_next];
    asked.isRefused =
        asked.polled.isOneChannel && !reply && reply.error().code() == MessageCode::DeviceException;
    m_isRefused = !reply.ok() && !asked.isRefused;
    if (m_isRefused)
        return;
    if (reply)
        m_image.store(asked.polled.range, *reply);
    asked.asked_s = m_exchange.asked_s();
    if (++m_next == m_requests.size())
        publish();
}

void ModbusThermometer::publish() {
    m_next = 0;
    m_identity.take(m_image);
    m_readings.clear();
    for (const int channel : m_settings.channels)
        m_readings.push_back(reading(channel));
}

Reading ModbusThermometer::reading(int channel) const {
    const ModbusProfile& profile = m_settings.profile;
    const RegisterRange range = rangeOf(channelSpec(profile, channel));
    const Request& request = *std::ranges::find_if(
        m_requests, [&](const Request& each) { return each.polled.range.contains(range); });
    RegisterValue value = request.isRefused
                              ? RegisterValue{0.0, "other"}
                              : temperatureFromRegisters(profile, *profile.channel, m_image.registers(range));
    for (const StatusSpec& status : profile.status) {
        if (isAtFault(status, channel, m_image.registers({status.function, status.address, 1}).front()))
            value.fault = status.fault;
    }
    return {request.asked_s, value.fault.empty() ? value.value_K : 0.0, value.fault.empty(),
            sensorFault(value.fault)};
}

Result<std::vector<Reading>> ModbusThermometer::read() {
    if (!m_exchange.isLive() || m_readings.empty())
        return m_exchange.error();
    if (m_identity.isOther()) {
        const Message other = m_identity.problem(m_exchange.name());
        return Error(other.code, "", other.args);
    }
    return m_readings;
}

ThermometerDriver modbusThermometerDriver() {
    ThermometerDriver driver;
    driver.key = "modbus";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Modbus RTU module");
    driver.serial = {19200, 8, 'E', 1};
    driver.isModbus = true;
    driver.parameters = {deviceParameter(thermometerParameters(), "unit", SetupStep::Connection)};
    driver.make = [](DriverLinks& links, const ThermometerDeviceSpec& spec) -> MadeDevice<Thermometer> {
        std::vector<int> channels = spec.channels;
        if (channels.empty()) {
            channels.resize(static_cast<std::size_t>(spec.profile.channels));
            std::iota(channels.begin(), channels.end(), 0);
        }
        return made(
            ModbusThermometer::create(links.modbus(), links.clock(), {spec.unit, spec.profile, channels}));
    };
    return driver;
}

ThermometerDriver modbusTcpThermometerDriver() {
    ThermometerDriver driver = modbusThermometerDriver();
    driver.key = "modbus_tcp";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Modbus TCP module");
    driver.link = DriverLink::Network;
    return driver;
}

} // namespace bask
