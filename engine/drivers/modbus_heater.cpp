#include "engine/drivers/modbus_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/drivers/sensor_fault.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr int kMostTries = 3; // of a write that has no effect; set points may be kept in a memory that wears

RegisterRange rangeOf(const RegisterSpec& spec) {
    return {spec.function, spec.address, registerCount(spec.type)};
}

ModbusRequest writeRequest(const RegisterSpec& spec, std::vector<std::uint16_t> values) {
    const auto count = static_cast<int>(values.size());
    return {0, count == 1 ? 6 : 16, spec.address, count, std::move(values)};
}

bool isSame(const ModbusRequest& a, const ModbusRequest& b) {
    return a.function == b.function && a.address == b.address && a.values == b.values;
}

} // namespace

Result<std::unique_ptr<ModbusHeater>> ModbusHeater::create(ModbusLink& link, const Clock& clock,
                                                           const ModbusHeaterSettings& settings) {
    const ModbusProfile& profile = settings.profile;
    if (!profile.processValue || !profile.setPoint)
        return Error(MessageCode::JsonMissingKey, "profile",
                     {profile.processValue ? "set_point" : "process_value"});
    if (settings.unit < 1 || settings.unit > 247)
        return Error(MessageCode::ValueOutOfRange, "unit", {std::to_string(settings.unit), "1", "247", ""});
    if (!(settings.period_s > 0.0 && settings.period_s <= 60.0))
        return Error(MessageCode::ValueOutOfRange, "period",
                     {formatNumber(settings.period_s), "0", "60", "s"});
    const RegisterSpec& written = profile.setPointWritten ? *profile.setPointWritten : *profile.setPoint;
    const double off_K = kelvinFromCelsius(profile.setPointOff_degC);
    if (const auto off = registersFromTemperature(profile, written, off_K); !profile.run && !off)
        return Error(MessageCode::ValueOutOfRange, "profile.set_point_off_degC", off.error().message.args);
    if (profile.watchdog) {
        const auto time =
            registersFromQuantity(*profile.watchdog, settings.watchdog_s / profile.watchdogUnit_s);
        if (!time || settings.watchdog_s < 3.0 * settings.period_s)
            return Error(MessageCode::ValueOutOfRange, "watchdog",
                         {formatNumber(settings.watchdog_s), formatNumber(3.0 * settings.period_s),
                          formatNumber(65535.0 * profile.watchdogUnit_s), "s"});
    }
    return std::unique_ptr<ModbusHeater>(new ModbusHeater(link, clock, settings));
}

ModbusHeater::ModbusHeater(ModbusLink& link, const Clock& clock, const ModbusHeaterSettings& settings)
    : m_settings(settings), m_clock(clock),
      m_exchange(link, clock, settings.unit, std::max(settings.silentAfter_s, 3.0 * settings.period_s)) {
    listRanges();
}

void ModbusHeater::listRanges() {
    const ModbusProfile& p = m_settings.profile;
    std::vector<RegisterRange> ranges{rangeOf(*p.processValue), rangeOf(*p.setPoint)};
    for (const auto& spec : {p.run, p.watchdog, p.sensorFault}) {
        if (spec)
            ranges.push_back(rangeOf(*spec));
    }
    for (const StatusSpec& status : p.status)
        ranges.push_back({status.function, status.address, 1});
    m_ranges = joinedRanges(std::move(ranges));
}

void ModbusHeater::work() {
    if (const auto reply = m_exchange.work())
        take(*reply);
    if (m_wanted_K && m_clock.now_s() >= m_until_s)
        (void)heatOff(); // nobody said on again
    if (m_exchange.canSend())
        sendNext();
}

void ModbusHeater::take(const ModbusReply& reply) {
    const bool isWrite = std::exchange(m_isWriting, false);
    m_isRefused = !reply.ok() && !isWrite;
    if (isWrite)
        m_writeProblem = reply ? Message{} : reply.error().message;
    else if (reply)
        takeRead(*reply);
    else if (!m_wanted_K && isOn())
        m_isOffDue = true; // again, though nothing can be read back
}

void ModbusHeater::takeRead(const std::vector<std::uint16_t>& values) {
    const RegisterRange& range = m_ranges[m_next];
    m_image.store(range, values);
    if (range.contains(rangeOf(*m_settings.profile.processValue)))
        m_measured_s = m_exchange.answered_s();
    if (++m_next == m_ranges.size())
        takeCycle();
}

void ModbusHeater::takeCycle() {
    const ModbusProfile& p = m_settings.profile;
    RegisterValue value =
        temperatureFromRegisters(p, *p.processValue, m_image.registers(rangeOf(*p.processValue)));
    for (const StatusSpec& status : p.status) {
        if (isAtFault(status, 0, m_image.registers({status.function, status.address, 1}).front()))
            value.fault = status.fault;
    }
    if (p.sensorFault && quantity(*p.sensorFault) != 0.0)
        value.fault = "open";
    m_reading = {m_measured_s, value.fault.empty() ? value.value_K : 0.0, value.fault.empty(),
                 sensorFault(value.fault)};
    m_next = 0;
    m_isKnown = m_isFresh = true;
    if (!correction())
        m_tries = 0;
}

void ModbusHeater::sendNext() {
    if (std::exchange(m_isOffDue, false))
        return write(offRequest());
    if (m_isFresh) {
        const auto change = correction();
        const bool isWorn = change && m_wanted_K && isSame(*change, m_written) && m_tries >= kMostTries;
        if (change && !isWorn)
            return write(*change);
    }
    const double now_s = m_clock.now_s();
    const bool waits = m_next == 0 || m_isRefused;
    if (waits && now_s < m_due_s)
        return;
    if (waits)
        m_due_s = now_s + m_settings.period_s;
    m_isFresh = false;
    const RegisterRange& range = m_ranges[m_next];
    m_exchange.send({0, range.function, range.address, range.count});
}

/// And everything is read back at once.
void ModbusHeater::write(const ModbusRequest& request) {
    m_tries = isSame(m_written, request) ? m_tries + 1 : 1;
    m_written = request;
    m_isWriting = true;
    m_isFresh = false;
    m_next = 0;
    m_due_s = m_clock.now_s() + (m_tries > 1 ? m_settings.period_s : 0.0);
    m_exchange.send(request);
}

/// What is to be written next, by what was read.
std::optional<ModbusRequest> ModbusHeater::correction() const {
    if (!m_wanted_K)
        return isOn() ? std::optional(offRequest()) : std::nullopt;
    const ModbusProfile& p = m_settings.profile;
    if (p.watchdog) {
        auto time = registersFromQuantity(*p.watchdog, m_settings.watchdog_s / p.watchdogUnit_s).value();
        if (m_image.registers(rangeOf(*p.watchdog)) != time)
            return writeRequest(*p.watchdog, std::move(time));
    }
    if (!isSetTo(*m_wanted_K))
        return setPointRequest(*m_wanted_K);
    if (p.run && quantity(*p.run) != p.runOn)
        return writeRequest(*p.run, registersFromQuantity(*p.run, p.runOn).value());
    return std::nullopt;
}

ModbusRequest ModbusHeater::offRequest() const {
    const ModbusProfile& p = m_settings.profile;
    if (p.run)
        return writeRequest(*p.run, registersFromQuantity(*p.run, p.runOff).value());
    return setPointRequest(kelvinFromCelsius(p.setPointOff_degC));
}

const RegisterSpec& ModbusHeater::writtenSetPoint() const {
    const ModbusProfile& p = m_settings.profile;
    return p.setPointWritten ? *p.setPointWritten : *p.setPoint;
}

ModbusRequest ModbusHeater::setPointRequest(double setPoint_K) const {
    const RegisterSpec& spec = writtenSetPoint();
    return writeRequest(spec, registersFromTemperature(m_settings.profile, spec, setPoint_K).value());
}

double ModbusHeater::quantity(const RegisterSpec& spec) const {
    return quantityFromRegisters(spec, m_image.registers(rangeOf(spec)));
}

/// NaN where the register tells none.
double ModbusHeater::readBack_K() const {
    const RegisterSpec& spec = *m_settings.profile.setPoint;
    const RegisterValue value =
        temperatureFromRegisters(m_settings.profile, spec, m_image.registers(rangeOf(spec)));
    return value.fault.empty() ? value.value_K : std::numeric_limits<double>::quiet_NaN();
}

/// As near as what was written, rounded, is told by what is read.
bool ModbusHeater::isSetTo(double setPoint_K) const {
    const RegisterSpec& spec = writtenSetPoint();
    const auto written = setPointRequest(setPoint_K).values;
    const double expected_K = temperatureFromRegisters(m_settings.profile, spec, written).value_K;
    return std::abs(readBack_K() - expected_K) <= 0.51 * resolution_K(*m_settings.profile.setPoint) + 0.01;
}

bool ModbusHeater::isOn() const {
    const ModbusProfile& p = m_settings.profile;
    if (!m_isKnown)
        return false;
    if (p.run)
        return quantity(*p.run) != p.runOff;
    const double off_K = kelvinFromCelsius(p.setPointOff_degC);
    return !(readBack_K() <= off_K) && !isSetTo(off_K);
}

Result<Reading> ModbusHeater::read() {
    if (!m_exchange.isLive() || !m_isKnown)
        return m_exchange.error();
    return m_reading;
}

Result<void> ModbusHeater::keepHeating(double setPoint_K, double validFor_s) {
    const auto fits = registersFromTemperature(m_settings.profile, writtenSetPoint(), setPoint_K);
    if (!fits)
        return Error(fits.error().code(), "set point", fits.error().message.args);
    if (!(validFor_s > 0.0))
        return Error(MessageCode::ValueNotPositive, "valid for", {formatNumber(validFor_s)});
    if (!m_exchange.isLive() || !m_isKnown)
        return m_exchange.error();
    if (m_wanted_K != setPoint_K)
        m_tries = 0;
    m_wanted_K = setPoint_K;
    m_until_s = m_clock.now_s() + validFor_s;
    m_isOffDue = false;
    return taken();
}

Result<void> ModbusHeater::heatOff() {
    if (m_wanted_K) {
        m_isOffDue = true;
        m_tries = 0;
    }
    m_wanted_K.reset();
    if (!m_exchange.isLive())
        return m_exchange.error();
    return taken();
}

/// Whether the device takes what is written to it.
Result<void> ModbusHeater::taken() const {
    if (m_tries < kMostTries)
        return {};
    if (m_writeProblem != Message{})
        return Error(m_writeProblem.code, "", m_writeProblem.args);
    const double set_K = m_wanted_K.value_or(kelvinFromCelsius(m_settings.profile.setPointOff_degC));
    if (isSetTo(set_K) || (!m_wanted_K && m_settings.profile.run))
        return Error(MessageCode::DeviceAnswersWrong, "",
                     {m_exchange.name(), "what was written is not there when it is read back"});
    return Error(MessageCode::SafetySetPointOther, "",
                 {formatNumber(celsiusFromKelvin(set_K)), formatNumber(celsiusFromKelvin(readBack_K()))});
}

bool ModbusHeater::heating() const {
    return m_wanted_K || m_isOffDue || isOn();
}

std::optional<double> ModbusHeater::setPoint_K() const {
    if (!m_exchange.isLive() || !m_isKnown || std::isnan(readBack_K()))
        return std::nullopt;
    return readBack_K();
}

} // namespace bask
