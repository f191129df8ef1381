#include "engine/drivers/modbus_scan.h"

#include "engine/base/message_code.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kColdest_K = 223.15, kHottest_K = 873.15; ///< that a laboratory can have

RegisterRange scannedRange(const RegisterSpec& spec) {
    return {spec.function, spec.address, registerCount(spec.type)};
}

RegisterSpec channelOf(const ModbusProfile& profile, int channel) {
    RegisterSpec spec = *profile.channel;
    spec.address += channel * profile.channelStep;
    return spec;
}

/// What tells temperatures: the channels, or process value and set point.
std::vector<RegisterSpec> temperaturesOf(const ModbusProfile& profile) {
    std::vector<RegisterSpec> out;
    for (int i = 0; profile.channel && i < profile.channels; ++i)
        out.push_back(channelOf(profile, i));
    for (const auto& spec : {profile.processValue, profile.setPoint})
        if (spec)
            out.push_back(*spec);
    return out;
}

std::vector<RegisterRange> rangesOf(const ModbusProfile& profile) {
    std::vector<RegisterRange> out;
    const std::vector<RegisterSpec> temperatures = temperaturesOf(profile);
    if (profile.channel) { // in one request, as the driver asks
        const RegisterRange first = scannedRange(temperatures.front()),
                            last = scannedRange(temperatures.back());
        out.push_back({first.function, first.address, last.address + last.count - first.address});
    } else {
        for (const RegisterSpec& spec : temperatures)
            out.push_back(scannedRange(spec));
    }
    for (const auto& spec : {profile.run, profile.watchdog, profile.setPointWritten, profile.sensorFault})
        if (spec)
            out.push_back(scannedRange(*spec));
    for (const StatusSpec& status : profile.status)
        out.push_back({status.function, status.address, 1});
    if (profile.identity)
        out.push_back({profile.identity->function, profile.identity->address, profile.identity->count});
    return joinedRanges(std::move(out));
}

} // namespace

ModbusScan::ModbusScan(ModbusLink& link, int firstUnit, int lastUnit)
    : m_link(link), m_unit(firstUnit), m_last(lastUnit) {
    m_questions = {{nullptr, {3, 0, 1}}, {nullptr, {4, 0, 1}}};
}

bool ModbusScan::work() {
    if (m_asked) {
        const auto reply = m_link.takeReply(*m_asked);
        if (!reply)
            return isLinkThere();
        m_asked.reset();
        take(*reply);
    }
    while (m_questions.empty()) {
        if (m_unit >= m_last)
            return false;
        ++m_unit;
        m_isThere = false;
        m_questions = {{nullptr, {3, 0, 1}}, {nullptr, {4, 0, 1}}};
    }
    if (m_link.isFree())
        ask();
    return isLinkThere();
}

/// A link that had no answer for long is closed by itself; here that is no harm.
bool ModbusScan::isLinkThere() {
    if (!m_link.isOpen() && m_link.problem().code == MessageCode::DeviceSilent)
        m_link.open();
    return m_link.isOpen() || m_link.problem().code == MessageCode::None;
}

void ModbusScan::ask() {
    const RegisterRange& range = m_questions.front().range;
    m_asked = m_link.send({m_unit, range.function, range.address, range.count});
}

void ModbusScan::take(const ModbusReply& reply) {
    const Question asked = m_questions.front();
    m_questions.pop_front();
    if (asked.profile == nullptr) {
        const bool isAnswered = reply || reply.error().code() == MessageCode::DeviceException;
        if (!isAnswered || m_isThere)
            return;
        m_isThere = true;
        m_found.push_back({m_unit, {}});
        m_questions.clear();
        for (const ModbusProfile& profile : shippedProfiles())
            for (const RegisterRange& range : rangesOf(profile))
                m_questions.push_back({&profile, range});
        return;
    }
    if (reply)
        m_image.store(asked.range, *reply);
    m_isFit = m_isFit && reply;
    const bool isLast = m_questions.empty() || m_questions.front().profile != asked.profile;
    if (isLast && m_isFit)
        judge(*asked.profile);
    if (isLast) {
        m_isFit = true;
        m_image.clear();
    } else if (!m_isFit) { // the rest of this profile is not asked for
        while (!m_questions.empty() && m_questions.front().profile == asked.profile)
            m_questions.pop_front();
        m_isFit = true;
        m_image.clear();
    }
}

void ModbusScan::judge(const ModbusProfile& profile) {
    ProfileFit fit{profile.name, {}};
    for (const RegisterSpec& spec : temperaturesOf(profile)) {
        const RegisterValue value =
            temperatureFromRegisters(profile, spec, m_image.registers(scannedRange(spec)));
        const bool isPossible =
            value.fault.empty() && value.value_K >= kColdest_K && value.value_K <= kHottest_K;
        if (value.fault.empty() && !isPossible)
            return; // a number that is no temperature of a laboratory
        fit.temperatures_K.push_back(isPossible ? value.value_K : std::numeric_limits<double>::quiet_NaN());
    }
    if (std::ranges::any_of(fit.temperatures_K, [](double t_K) { return !std::isnan(t_K); }))
        m_found.back().fits.push_back(std::move(fit));
}

} // namespace bask
