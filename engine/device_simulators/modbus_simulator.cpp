#include "engine/device_simulators/modbus_simulator.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/fault_names.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kFrameGap_s = 0.1; // a request in pieces further apart is noise
constexpr int kIllegalFunction = 1, kIllegalAddress = 2, kIllegalValue = 3, kDeviceFailure = 4;
constexpr int kMaxAsked = 125;
constexpr double kJump_K = 30.0, kHalfJump_s = 0.5, kRise_K_s = 2.0;
const std::vector<std::string> kModbusFaults{"none",        "silent",     "open",     "short",
                                             "frozen",      "jumping",    "rising",   "wrong-unit",
                                             "short-reply", "late-reply", "exception"};

using Registers = std::vector<std::uint16_t>;

/// What the registers hold when a quantity is beyond them.
Registers endOf(const RegisterSpec& spec, bool isHigh) {
    switch (spec.type) {
    case RegisterType::Int16:
        return {static_cast<std::uint16_t>(isHigh ? 0x7fff : 0x8000)};
    case RegisterType::Uint16:
        return {static_cast<std::uint16_t>(isHigh ? 0xffff : 0)};
    case RegisterType::Int32:
    case RegisterType::Uint32:
    case RegisterType::Float32:
        break;
    }
    RegisterSpec words = spec; // as a word order only
    words.type = RegisterType::Uint32;
    words.scale = 1.0;
    words.offset = 0.0;
    const double bits = spec.type == RegisterType::Float32 ? 0x7fc00000 // not a number
                        : spec.type == RegisterType::Int32 ? (isHigh ? 0x7fffffff : 0x80000000)
                                                           : (isHigh ? 0xffffffff : 0.0);
    return registersFromQuantity(words, bits).value();
}

Registers registersOf(const ModbusProfile& profile, const RegisterSpec& spec, double t_K) {
    auto values = registersFromTemperature(profile, spec, t_K);
    return values ? *values : endOf(spec, t_K > 300.0);
}

/// What such a sensor looks like: the profile's number for it, no current or too much, ohms that no PT100
/// has, the end of the type.
Registers faultyRegisters(const RegisterSpec& spec, const std::string& fault) {
    const bool isOpen = fault == "open";
    for (const auto& [number, word] : spec.faults) {
        if (word == fault)
            return registersFromQuantity(spec, spec.scale * number + spec.offset).value();
    }
    if (spec.unit == RegisterUnit::Milliampere)
        return registersFromQuantity(spec, isOpen ? 0.0 : 21.6).value();
    if (spec.unit == RegisterUnit::Ohm && !isOpen)
        return registersFromQuantity(spec, 0.0).value();
    return endOf(spec, isOpen);
}

} // namespace

void ModbusSimulator::addThermometer(int unit, const ModbusProfile& profile, double t_K) {
    if (!profile.channel)
        throw std::invalid_argument("ModbusSimulator: a profile without channels");
    Unit& added = m_units[unit];
    added.profile = profile;
    added.channels_K.assign(static_cast<std::size_t>(profile.channels), t_K);
    for (int i = 0; i < profile.channelStep * profile.channels; ++i) // those between are there too
        added.registers[{profile.channel->function, profile.channel->address + i}] = 0;
    addKind(added);
    refresh(added);
}

/// What tells it from others.
void ModbusSimulator::addKind(Unit& unit) {
    const ModbusProfile& profile = unit.profile;
    if (profile.deviceType)
        store(unit, *profile.deviceType,
              registersFromQuantity(*profile.deviceType, profile.deviceTypes.front()).value());
    for (int i = 0; profile.identity && i < profile.identity->count; ++i)
        unit.registers[{profile.identity->function, profile.identity->address + i}] =
            static_cast<std::uint16_t>(4700 + i);
}

void ModbusSimulator::addController(int unit, const ModbusProfile& profile, const SimulatedPlate& plate) {
    if (!profile.processValue || !profile.setPoint)
        throw std::invalid_argument("ModbusSimulator: a profile without a process value");
    Unit& added = m_units[unit];
    added.profile = profile;
    added.plate = plate;
    added.plate_K = plate.ambient_K;
    const double off_K = kelvinFromCelsius(profile.setPointOff_degC);
    for (const auto& spec : {profile.setPoint, profile.setPointWritten}) {
        if (spec)
            store(added, *spec, registersOf(profile, *spec, off_K));
    }
    if (profile.run)
        store(added, *profile.run, registersFromQuantity(*profile.run, profile.runOff).value());
    if (profile.watchdog)
        store(added, *profile.watchdog, registersFromQuantity(*profile.watchdog, 0.0).value());
    addKind(added);
    if (const auto& unit = profile.temperatureUnit) {
        const bool isFahrenheit = profile.processValue->unit == RegisterUnit::Fahrenheit;
        store(added, *unit,
              registersFromQuantity(*unit, isFahrenheit ? profile.unitFahrenheit : profile.unitCelsius)
                  .value());
    }
    refresh(added);
}

void ModbusSimulator::setTemperature(int unit, int channel, double t_K) {
    Unit& u = m_units.at(unit);
    u.channels_K.at(static_cast<std::size_t>(channel)) = t_K;
    if (m_fault != "frozen")
        refresh(u);
}

void ModbusSimulator::removeChannel(int unit, int channel) {
    Unit& u = m_units.at(unit);
    u.channels_K.at(static_cast<std::size_t>(channel)) = std::numeric_limits<double>::quiet_NaN();
    const RegisterSpec& spec = *u.profile.channel;
    for (int i = 0; i < registerCount(spec.type); ++i)
        u.registers.erase({spec.function, spec.address + channel * u.profile.channelStep + i});
}

double ModbusSimulator::setPoint_K(int unit) const {
    const Unit& u = m_units.at(unit);
    return temperatureAt(u, u.profile.setPointWritten ? *u.profile.setPointWritten : *u.profile.setPoint);
}

bool ModbusSimulator::isOn(int unit) const {
    return isOn(m_units.at(unit));
}

std::uint16_t ModbusSimulator::registerAt(int unit, int function, int address) const {
    return m_units.at(unit).registers.at({function, address});
}

void ModbusSimulator::setRegister(int unit, int function, int address, std::uint16_t value) {
    m_units.at(unit).registers[{function, address}] = value;
}

void ModbusSimulator::store(Unit& unit, const RegisterSpec& spec, const Registers& values, int shift) {
    for (std::size_t i = 0; i < values.size(); ++i)
        unit.registers[{spec.function, spec.address + shift + static_cast<int>(i)}] = values[i];
}

double ModbusSimulator::quantityAt(const Unit& unit, const RegisterSpec& spec) {
    Registers values;
    for (int i = 0; i < registerCount(spec.type); ++i)
        values.push_back(unit.registers.at({spec.function, spec.address + i}));
    return quantityFromRegisters(spec, values);
}

double ModbusSimulator::temperatureAt(const Unit& unit, const RegisterSpec& spec) {
    const double quantity = quantityAt(unit, spec);
    return spec.unit == RegisterUnit::Kelvin       ? quantity
           : spec.unit == RegisterUnit::Fahrenheit ? kelvinFromDisplay(quantity, TemperatureUnit::Fahrenheit)
                                                   : kelvinFromCelsius(quantity);
}

bool ModbusSimulator::isOn(const Unit& unit) {
    return !unit.profile.run || quantityAt(unit, *unit.profile.run) == unit.profile.runOn;
}

void ModbusSimulator::advance(double now_s) {
    for (auto& [address, unit] : m_units) {
        if (m_hasTime && unit.profile.processValue)
            advance(unit, m_now_s, now_s);
        if (!m_hasTime)
            unit.asked_s = now_s;
        if (m_fault != "frozen")
            refresh(unit);
    }
    m_now_s = now_s;
    m_hasTime = true;
}

void ModbusSimulator::advance(Unit& unit, double from_s, double to_s) {
    const ModbusProfile& p = unit.profile;
    const auto move = [&](double until_s) {
        const double setPoint_K = temperatureAt(unit, p.setPointWritten ? *p.setPointWritten : *p.setPoint);
        const bool heats = isOn(unit) && setPoint_K > unit.plate_K;
        const double goal_K = heats ? setPoint_K : unit.plate.ambient_K;
        const double time_s = heats ? unit.plate.heating_s : unit.plate.cooling_s;
        unit.plate_K = goal_K + (unit.plate_K - goal_K) * std::exp(-(until_s - from_s) / time_s);
        from_s = until_s;
    };
    const double watchdog_s = p.watchdog ? quantityAt(unit, *p.watchdog) * p.watchdogUnit_s : 0.0;
    const double trips_s = unit.asked_s + watchdog_s;
    if (watchdog_s > 0.0 && p.run && to_s > trips_s && isOn(unit)) {
        move(std::max(from_s, trips_s));
        store(unit, *p.run, registersFromQuantity(*p.run, p.runOff).value());
    }
    move(to_s);
}

void ModbusSimulator::refresh(Unit& unit) const {
    const ModbusProfile& p = unit.profile;
    for (const StatusSpec& status : p.status)
        unit.registers[{status.function, status.address}] = 0;
    for (std::size_t i = 0; i < unit.channels_K.size(); ++i)
        if (!std::isnan(unit.channels_K[i]))
            refreshSensor(unit, *p.channel, static_cast<int>(i), unit.channels_K[i] + shownTooMuch_K());
    if (!p.processValue)
        return;
    refreshSensor(unit, *p.processValue, 0, unit.plate_K);
    if (p.setPointWritten) // shows what it was set to
        store(unit, *p.setPoint, registersOf(p, *p.setPoint, temperatureAt(unit, *p.setPointWritten)));
    const bool isFaulty = m_fault == "open" || m_fault == "short";
    if (p.sensorFault)
        store(unit, *p.sensorFault, registersFromQuantity(*p.sensorFault, isFaulty ? 1.0 : 0.0).value());
}

double ModbusSimulator::shownTooMuch_K() const {
    const double since_s = m_now_s - m_fault_s;
    if (m_fault == "jumping")
        return std::fmod(since_s, 2.0 * kHalfJump_s) < kHalfJump_s ? kJump_K : 0.0;
    return m_fault == "rising" ? kRise_K_s * since_s : 0.0;
}

void ModbusSimulator::refreshSensor(Unit& unit, const RegisterSpec& spec, int channel, double t_K) const {
    const ModbusProfile& p = unit.profile;
    const bool isFaulty = m_fault == "open" || m_fault == "short";
    bool isTold = p.sensorFault.has_value();
    for (const StatusSpec& status : p.status) {
        const bool isThis = isFaulty && (status.fault == m_fault || status.fault == "other");
        isTold = isTold || isThis;
        if (isThis == status.isFaultWhenSet)
            unit.registers[{status.function, status.address}] |=
                static_cast<std::uint16_t>(1U << (status.firstBit + channel * status.bitStep));
    }
    // One that tells in a register of its own leaves the last value standing.
    const bool isShown = isFaulty && !isTold;
    store(unit, spec, isShown ? faultyRegisters(spec, m_fault) : registersOf(p, spec, t_K),
          channel * p.channelStep);
}

void ModbusSimulator::opened(double) {
    m_received.clear();
}

void ModbusSimulator::receive(std::string_view bytes, double now_s) {
    if (m_frames == Frames::Rtu && now_s - m_heard_s > kFrameGap_s)
        m_received.clear();
    m_heard_s = now_s;
    m_received += bytes;
    advance(now_s);
    if (m_frames == Frames::Tcp)
        return takeTcp(now_s);
    while (const auto query = takeModbusQuery(m_received))
        answer(*query, now_s);
}

void ModbusSimulator::takeTcp(double now_s) {
    std::string_view left = m_received;
    while (const auto frame = takeModbusTcpFrame(left)) {
        std::string line =
            modbusFrame(static_cast<unsigned char>(frame->unitAndPdu[0]), frame->unitAndPdu.substr(1));
        if (const auto query = takeModbusQuery(line))
            answer(*query, now_s, frame->transaction);
    }
    m_received.erase(0, m_received.size() - left.size());
}

std::string ModbusSimulator::framed(const std::string& frame, int transaction) const {
    if (m_frames == Frames::Rtu)
        return frame;
    if (m_fault == "garbage")
        return "HTTP/1.1 400 Bad Request\r\n\r\n";
    const int id = m_fault == "wrong-id" ? transaction ^ 0x5555 : transaction;
    return modbusTcpFrame(id, std::string_view(frame).substr(0, frame.size() - 2)); // without the CRC
}

void ModbusSimulator::answer(const ModbusQuery& query, double now_s, int transaction) {
    m_functions.push_back(query.function);
    const auto unit = m_units.find(query.unit);
    if (unit == m_units.end() || m_fault == "silent")
        return;
    unit->second.asked_s = now_s;
    const std::string words = framed(reply(unit->second, query), transaction);
    m_answers.emplace_back(now_s + (m_fault == "late-reply" ? kLateReply_s : kReplyTime_s), words);
}

std::string ModbusSimulator::reply(Unit& unit, const ModbusQuery& query) {
    ModbusQuery asked = query;
    if (m_fault == "exception")
        return modbusException(query.unit, query.function, kDeviceFailure);
    if (m_fault == "wrong-unit")
        asked.unit = query.unit % 247 + 1;
    if (!query.isKnown || (query.function != 3 && query.function != 4 && query.values.empty()))
        return modbusException(query.unit, query.function, kIllegalFunction);
    std::string out = query.values.empty() ? read(unit, asked) : write(unit, asked);
    if (m_fault == "bad-crc")
        out.back() = static_cast<char>(out.back() ^ 0x55);
    return out;
}

std::string ModbusSimulator::read(const Unit& unit, const ModbusQuery& query) const {
    if (query.count < 1 || query.count > kMaxAsked)
        return modbusException(query.unit, query.function, kIllegalValue);
    Registers values;
    for (int i = 0; i < query.count; ++i) {
        const auto it = unit.registers.find({query.function, query.address + i});
        if (it == unit.registers.end())
            return modbusException(query.unit, query.function, kIllegalAddress);
        values.push_back(it->second);
    }
    if (m_fault == "short-reply")
        values.pop_back();
    return modbusReadReply(query.unit, query.function, values);
}

std::string ModbusSimulator::write(Unit& unit, const ModbusQuery& query) {
    for (int i = 0; i < query.count; ++i) {
        if (!unit.registers.contains({3, query.address + i}))
            return modbusException(query.unit, query.function, kIllegalAddress);
    }
    for (int i = 0; i < query.count; ++i)
        unit.registers[{3, query.address + i}] = query.values[static_cast<std::size_t>(i)];
    m_writes += query.count;
    if (m_fault != "frozen")
        refresh(unit);
    return modbusWriteReply(query);
}

std::string ModbusSimulator::transmit(double now_s) {
    advance(now_s);
    std::string out;
    while (!m_answers.empty() && m_answers.front().first <= now_s) {
        out += m_answers.front().second;
        m_answers.pop_front();
    }
    return out;
}

std::vector<std::string> ModbusSimulator::faults() const {
    std::vector<std::string> out = kModbusFaults;
    if (m_frames == Frames::Rtu)
        out.insert(out.end(), {"bad-crc"});
    else
        out.insert(out.end(), {"wrong-id", "garbage"});
    return out;
}

Result<void> ModbusSimulator::setFault(const std::string& name) {
    if (const auto known = checkFault(name, faults()); !known)
        return known;
    m_fault = name;
    m_fault_s = m_now_s;
    for (auto& [address, unit] : m_units) {
        if (m_fault != "frozen")
            refresh(unit);
    }
    return {};
}

} // namespace bask
