#include "engine/drivers/modbus_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"
#include "engine/drivers/off_program.h"
#include "engine/drivers/sensor_fault.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/profile_registers.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr int kMaxTries = 3; // of a write that has no effect; set points may be kept in a memory that wears
constexpr double kAgain_s = 10.0;                  // then, to switch off
constexpr double kSetEvery_s = 5.0, kStep_K = 0.5; // of a set point that moves
constexpr double kJump_K = 3.0;                    // at once: from here on it is told as another one
constexpr double kFollow_s = 3.0;                  // a controller takes what was written

ModbusRequest writeRequest(const RegisterSpec& spec, std::vector<std::uint16_t> values) {
    const auto count = static_cast<int>(values.size());
    return {0, count == 1 ? 6 : 16, spec.address, count, std::move(values)};
}

bool isSame(const ModbusRequest& a, const ModbusRequest& b) {
    return a.function == b.function && a.address == b.address && a.values == b.values;
}

/// As near a set point reads back, rounded.
double within_K(const RegisterSpec& spec) {
    return 0.51 * resolution_K(spec) + 0.01;
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
        if (const auto time = watchdogRegisters(profile, settings.watchdog_s); !time)
            return Error(time.error().code(), "watchdog", time.error().message.args);
        if (settings.watchdog_s < 3.0 * settings.period_s)
            return Error(
                MessageCode::ValueOutOfRange, "watchdog",
                {formatNumber(settings.watchdog_s), formatNumber(3.0 * settings.period_s), "1500", "s"});
    }
    return std::unique_ptr<ModbusHeater>(new ModbusHeater(link, clock, settings));
}

ModbusHeater::ModbusHeater(ModbusLink& link, const Clock& clock, const ModbusHeaterSettings& settings)
    : m_settings(settings), m_clock(clock),
      m_exchange(link, clock, settings.unit, std::max(settings.silentAfter_s, 3.0 * settings.period_s)),
      m_identity(settings.profile), m_ranges(controllerPoll(settings.profile)) {}

void ModbusHeater::work() {
    if (const auto reply = m_exchange.work())
        take(*reply);
    if (!m_exchange.isLive())
        m_identity.forget();
    if (m_wanted_K && m_clock.now_s() >= m_until_s)
        switchOff(); // nobody said on again
    if (m_overtakes && m_isOffDue && m_identity.isKnown() && m_exchange.mayOvertake()) {
        m_isOffDue = false;
        return write(offRequest(), true);
    }
    if (m_exchange.canSend())
        sendNext();
}

void ModbusHeater::take(const ModbusReply& reply) {
    const bool isWrite = std::exchange(m_isWriting, false);
    m_isRefused = !reply.ok() && !isWrite;
    if (isWrite) {
        m_writeProblem = reply ? Message{} : reply.error().message;
        if (m_writeProblem.code == MessageCode::DeviceSilent && m_tries > 0)
            --m_tries;
    } else if (reply) {
        takeRead(*reply);
    }
    if (!reply && !m_wanted_K && (isOn() || m_mayBeOn) && !isWorn())
        m_isOffDue = true; // again, though nothing can be read back
}

void ModbusHeater::takeRead(const std::vector<std::uint16_t>& values) {
    const RegisterRange& range = m_ranges[m_next];
    m_image.store(range, values);
    if (range.contains(rangeOf(*m_settings.profile.processValue)))
        m_measured_s = m_exchange.asked_s();
    if (++m_next == m_ranges.size())
        takeCycle();
}

/// False: not in one that is known.
bool ModbusHeater::takeUnit() {
    ModbusProfile& p = m_settings.profile;
    m_unitProblem = {};
    if (!p.temperatureUnit)
        return true;
    const double told = quantity(*p.temperatureUnit);
    if (told == p.unitCelsius || told == p.unitFahrenheit) {
        p = inUnit(p, told == p.unitCelsius ? RegisterUnit::Celsius : RegisterUnit::Fahrenheit);
        return true;
    }
    m_unitProblem = {MessageCode::DeviceAnswersWrong,
                     {m_exchange.name(),
                      "its unit (degC, degF) is not told: its register holds " + formatNumber(told, 6)}};
    return false;
}

void ModbusHeater::takeCycle() {
    const ModbusProfile& p = m_settings.profile;
    m_identity.take(m_image);
    if (!takeUnit() && m_wanted_K)
        switchOff();
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
    m_cycle_s = m_clock.now_s();
    if (m_wanted_K)
        compare();
    if (!m_wanted_K && !isOn())
        m_mayBeOn = false;
    if (!correction())
        m_tries = 0;
}

/// What was taken and is gone was changed there, by a person or a protection, and is not for us to change
/// back.
void ModbusHeater::compare() {
    const auto& run = m_settings.profile.run;
    const bool isSet = isSetTo(m_set_K);
    const bool isRunning = run && holds(*run, m_settings.profile.runOn);
    if (m_isRunTaken && !isRunning)
        m_refusal = {MessageCode::SafetySourceStopped, {}};
    else if (m_isSetTaken && !isSet)
        m_refusal = {MessageCode::SafetySetPointOther,
                     {formatNumber(celsiusFromKelvin(m_set_K)),
                      formatNumber(celsiusFromKelvin(readBack_K(writtenSetPoint())))}};
    m_isSetTaken = isSet;
    m_isRunTaken = isRunning;
    if (m_refusal != Message{})
        switchOff();
}

void ModbusHeater::switchOff() {
    m_wanted_K.reset();
    m_isOffDue = m_overtakes = true;
    m_tries = 0;
    m_off_s = m_clock.now_s();
}

void ModbusHeater::sendNext() {
    const bool mayWrite = m_identity.isKnown();
    if (mayWrite && std::exchange(m_isOffDue, false))
        return write(offRequest());
    if (mayWrite && m_isFresh) {
        const auto change = correction();
        if (change && !(isSame(*change, m_written) && isWorn()))
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
void ModbusHeater::write(const ModbusRequest& request, bool overtakes) {
    m_overtakes = false;
    m_tries = isSame(m_written, request) ? m_tries + 1 : 1;
    m_written = request;
    m_mayBeOn = m_mayBeOn || m_wanted_K;
    m_again_s = m_clock.now_s() + kAgain_s;
    m_isWriting = true;
    m_isFresh = false;
    m_next = 0;
    m_due_s = m_clock.now_s() + (m_tries > 1 ? m_settings.period_s : 0.0);
    if (overtakes)
        m_exchange.overtake(request);
    else
        m_exchange.send(request);
}

/// Tried in vain so often that it is not to be tried now; off is, later.
bool ModbusHeater::isWorn() const {
    return m_tries >= kMaxTries && (m_wanted_K || m_clock.now_s() < m_again_s);
}

/// What is to be written next, by what was read.
std::optional<ModbusRequest> ModbusHeater::correction() const {
    if (!m_wanted_K)
        return isOn() ? std::optional(offRequest()) : std::nullopt;
    const ModbusProfile& p = m_settings.profile;
    if (p.watchdog) {
        auto time = watchdogRegisters(p, m_settings.watchdog_s).value();
        if (m_image.registers(rangeOf(*p.watchdog)) != time)
            return writeRequest(*p.watchdog, std::move(time));
    }
    if (!isSetTo(m_set_K))
        return setPointRequest(m_set_K);
    if (p.run && !holds(*p.run, p.runOn))
        return writeRequest(*p.run, registersFromQuantity(*p.run, p.runOn).value());
    return std::nullopt;
}

ModbusRequest ModbusHeater::offRequest() const {
    const ModbusProfile& p = m_settings.profile;
    if (p.run)
        return writeRequest(*p.run, registersFromQuantity(*p.run, p.runOff).value());
    return setPointRequest(kelvinFromCelsius(p.setPointOff_degC));
}

guard::OffProgram ModbusHeater::offProgram(const SerialSettings& line) const {
    constexpr double kReply_s = 0.3, kGap_s = 0.02;
    const auto ms = [&](double s, double bytes) {
        return static_cast<int>(std::lround(1e3 * (s + onTheLine_s(line, bytes))));
    };
    const ModbusRequest off = offRequest();
    const ModbusQuery write{m_settings.unit, off.function, off.address, off.count, off.values};
    const std::string bytes = modbusRequest(write), echo = modbusWriteReply(write);
    const auto size = static_cast<double>(bytes.size()), frames = size + static_cast<double>(echo.size());
    guard::OffProgram program;
    program.quiet_ms = static_cast<std::uint16_t>(ms(1e-3 * program.quiet_ms, size + kModbusGapBytes));
    add(program, offWrite(bytes, echo, ms(kReply_s, frames), ms(kGap_s, kModbusGapBytes)));
    add(program, offReadBack(ms(kReply_s, frames)));
    return program;
}

/// By the same measure as isOn(): a controller may round what is written, or limit it.
guard::OffStep ModbusHeater::offReadBack(int reply_ms) const {
    constexpr double kFarthest_K = 200.0; // below off: it is no set point but the mark of a fault
    const ModbusRequest off = offRequest();
    const RegisterSpec& spec = m_settings.profile.run ? *m_settings.profile.run : writtenSetPoint();
    const ModbusQuery question{m_settings.unit, spec.function, spec.address, off.count, {}};
    const bool isScaled = spec.unit == RegisterUnit::Celsius || spec.unit == RegisterUnit::Fahrenheit ||
                          spec.unit == RegisterUnit::Kelvin;
    if (m_settings.profile.run || !isScaled)
        return offWhenBytes(modbusRequest(question),
                            modbusReadReply(m_settings.unit, spec.function, off.values), reply_ms);
    const double perKelvin = (spec.unit == RegisterUnit::Fahrenheit ? 1.8 : 1.0) / spec.scale;
    const double written = (quantityFromRegisters(spec, off.values) - spec.offset) / spec.scale;
    const double a = written + within_K(spec) * perKelvin, b = written - kFarthest_K * perKelvin;
    return offWhenRegister(question, spec, std::min(a, b), std::max(a, b), reply_ms);
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

bool ModbusHeater::holds(const RegisterSpec& spec, double number) const {
    return m_image.registers(rangeOf(spec)) == registersFromQuantity(spec, number).value();
}

/// NaN where the register tells none.
double ModbusHeater::readBack_K(const RegisterSpec& spec) const {
    const RegisterValue value =
        temperatureFromRegisters(m_settings.profile, spec, m_image.registers(rangeOf(spec)));
    return value.fault.empty() ? value.value_K : std::numeric_limits<double>::quiet_NaN();
}

/// As near as what was written, rounded, is read.
bool ModbusHeater::isSetTo(double setPoint_K) const {
    const RegisterSpec& spec = writtenSetPoint();
    const auto written = setPointRequest(setPoint_K).values;
    const double expected_K = temperatureFromRegisters(m_settings.profile, spec, written).value_K;
    return std::abs(readBack_K(spec) - expected_K) <= within_K(spec);
}

/// Whether the device is to be set to what is wanted now: it differs much, or for long.
bool ModbusHeater::isSetDue() const {
    const double now_s = m_clock.now_s(), change_K = std::abs(*m_wanted_K - m_set_K);
    return change_K >= kJump_K || (change_K >= kStep_K && now_s >= m_set_s + kSetEvery_s) ||
           (change_K > 0.0 && now_s >= m_changed_s + kSetEvery_s);
}

bool ModbusHeater::isOn() const {
    const ModbusProfile& p = m_settings.profile;
    if (!m_isKnown)
        return false;
    if (p.run)
        return !holds(*p.run, p.runOff);
    const double off_K = kelvinFromCelsius(p.setPointOff_degC);
    return !(readBack_K(writtenSetPoint()) <= off_K) && !isSetTo(off_K);
}

/// Off as it was written, but heating towards something else: a ramp of its own, or a second set point.
bool ModbusHeater::isDriven() const {
    const ModbusProfile& p = m_settings.profile;
    return m_isKnown && !m_wanted_K && !p.run && p.setPointWritten && !isOn() &&
           !(readBack_K(*p.setPoint) <= kelvinFromCelsius(kHighestOff_degC));
}

Message ModbusHeater::exchanged() const {
    return m_identity.problem(m_exchange.name());
}

Result<Reading> ModbusHeater::read() {
    if (!m_exchange.isLive() || !m_isKnown)
        return m_exchange.error();
    for (const Message& problem : {m_identity.isOther() ? exchanged() : Message{}, m_unitProblem})
        if (problem != Message{})
            return Error(problem.code, "", problem.args);
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
    for (const Message& problem : {m_identity.isOther() ? exchanged() : Message{}, m_unitProblem, m_refusal})
        if (problem != Message{})
            return Error(problem.code, "", problem.args);
    const double now_s = m_clock.now_s();
    const bool isBegun = !m_wanted_K;
    if (m_wanted_K != setPoint_K)
        m_changed_s = now_s;
    m_wanted_K = setPoint_K;
    m_until_s = now_s + validFor_s;
    if (isBegun)
        m_isRunTaken = false;
    if (isBegun || isSetDue()) {
        m_set_K = setPoint_K;
        m_set_s = now_s;
        m_isSetTaken = false;
        m_tries = 0;
    }
    m_isOffDue = false;
    return taken();
}

Result<void> ModbusHeater::heatOff() {
    m_refusal = {};
    if (m_wanted_K)
        switchOff();
    if (!m_exchange.isLive())
        return m_exchange.error();
    if (m_identity.isOther())
        return Error(exchanged().code, "", exchanged().args);
    return taken();
}

/// Whether the device takes what is written to it.
Result<void> ModbusHeater::taken() const {
    const double off_K = kelvinFromCelsius(m_settings.profile.setPointOff_degC);
    const double set_K = m_wanted_K ? m_set_K : off_K;
    const auto other = [set_K](double back_K) {
        return Error(MessageCode::SafetySetPointOther, "",
                     {formatNumber(celsiusFromKelvin(set_K)), formatNumber(celsiusFromKelvin(back_K))});
    };
    if (isDriven() && m_clock.now_s() >= m_off_s + kFollow_s)
        return other(readBack_K(*m_settings.profile.setPoint));
    if (m_tries < kMaxTries)
        return {};
    if (m_writeProblem != Message{})
        return Error(m_writeProblem.code, "", m_writeProblem.args);
    if (isSetTo(set_K) || (!m_wanted_K && m_settings.profile.run))
        return Error(MessageCode::DeviceAnswersWrong, "",
                     {m_exchange.name(), "what was written is not there when it is read back"});
    return other(readBack_K(writtenSetPoint()));
}

bool ModbusHeater::heating() const {
    return m_wanted_K || m_isOffDue || (!m_identity.isOther() && (m_mayBeOn || isOn() || isDriven()));
}

/// Of a device that was away the registers are those of before, until they were all read again.
HeatState ModbusHeater::heatState() const {
    const double max_s = std::max(m_settings.silentAfter_s, 3.0 * m_settings.period_s);
    if (!m_exchange.isLive() || !m_isKnown || m_identity.isOther() || m_clock.now_s() - m_cycle_s > max_s)
        return HeatState::Unknown;
    return heating() || m_tries > 0 ? HeatState::On : HeatState::Off;
}

std::optional<double> ModbusHeater::setPoint_K() const {
    if (!m_exchange.isLive() || !m_isKnown)
        return std::nullopt;
    const double setPoint_K = readBack_K(*m_settings.profile.setPoint);
    return std::isnan(setPoint_K) ? std::nullopt : std::optional(setPoint_K);
}

HeatSourceDriver modbusHeaterDriver() {
    HeatSourceDriver driver;
    driver.key = "modbus";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Modbus RTU controller");
    driver.serial = {19200, 8, 'E', 1};
    driver.isModbus = true;
    driver.parameters = {deviceParameter(heatSourceParameters(), "unit", SetupStep::Connection),
                         deviceParameter(heatSourceParameters(), "watchdog", SetupStep::Use)};
    driver.parameters.back().applies = [](const HeatSourceDeviceSpec& spec) {
        return spec.profile.watchdog.has_value(); // or it would seem to have one
    };
    driver.make = [](DriverLinks& links, const HeatSourceDeviceSpec& spec) -> MadeDevice<HeatSource> {
        ModbusHeaterSettings settings{spec.unit, spec.profile};
        settings.watchdog_s = spec.watchdog_s;
        auto heater = made(ModbusHeater::create(links.modbus(), links.clock(), settings));
        const ModbusHeater* known = heater.get();
        return {std::move(heater), [known, line = spec.serial] { return known->offProgram(line); }};
    };
    return driver;
}

HeatSourceDriver modbusTcpHeaterDriver() {
    HeatSourceDriver driver = modbusHeaterDriver();
    driver.key = "modbus_tcp";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Modbus TCP controller");
    driver.link = DriverLink::Network;
    return driver;
}

} // namespace bask
