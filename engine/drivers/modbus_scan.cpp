#include "engine/drivers/modbus_scan.h"

#include "engine/base/message_code.h"
#include "engine/protocols/profile_registers.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bask {
namespace {

constexpr double kColdest_K = 223.15, kHottest_K = 873.15;         // that a laboratory can have
constexpr double kRoomColdest_K = 273.15, kRoomHottest_K = 333.15; // of most sensors when they are set up
constexpr RegisterRange kProbe{3, 0, 1};

/// What tells temperatures: the channels, or process value and set point.
std::vector<RegisterSpec> temperaturesOf(const ModbusProfile& profile) {
    std::vector<RegisterSpec> out;
    for (int i = 0; profile.channel && i < profile.channels; ++i)
        out.push_back(channelSpec(profile, i));
    for (const auto& spec : {profile.processValue, profile.setPoint})
        if (spec)
            out.push_back(*spec);
    return out;
}

/// As the driver asks for them.
std::vector<PolledRange> pollOf(const ModbusProfile& profile) {
    if (profile.channel) {
        std::vector<int> channels(static_cast<std::size_t>(profile.channels));
        std::iota(channels.begin(), channels.end(), 0);
        return thermometerPoll(profile, channels);
    }
    std::vector<PolledRange> out;
    for (const RegisterRange& range : controllerPoll(profile))
        out.push_back({range, false});
    return out;
}

bool isInRoom(const ProfileFit& fit) {
    return std::ranges::all_of(fit.temperatures_K, [](double t_K) {
        return std::isnan(t_K) || (t_K >= kRoomColdest_K && t_K <= kRoomHottest_K);
    });
}

bool isMoreProbable(const ProfileFit& a, const ProfileFit& b) {
    return std::tuple(a.isTypeTold, isInRoom(a), a.registers) >
           std::tuple(b.isTypeTold, isInRoom(b), b.registers);
}

bool isFromGateway(int exception) {
    return exception == kNoGatewayPath || exception == kNoGatewayAnswer;
}

} // namespace

ModbusScan::ModbusScan(ModbusLink& link, int firstUnit, int lastUnit)
    : m_link(link), m_first(firstUnit), m_unit(firstUnit), m_last(lastUnit) {
    begin(firstUnit);
}

void ModbusScan::begin(int unit) {
    m_unit = unit;
    m_ranges = {kProbe};
    m_all = 1;
    m_isThere = false;
    m_has.clear();
    m_image.clear();
}

double ModbusScan::progress() const {
    if (m_isOver)
        return 1.0;
    const double ofUnit =
        m_isThere ? 1.0 - static_cast<double>(m_ranges.size()) / static_cast<double>(m_all) : 0.0;
    return (m_unit - m_first + ofUnit) / (m_last - m_first + 1);
}

bool ModbusScan::work() {
    if (m_isOver)
        return false;
    if (m_asked) {
        const auto reply = m_link.takeReply(*m_asked);
        if (!reply)
            return isLinkThere();
        m_asked.reset();
        take(*reply);
    }
    if (m_ranges.empty()) {
        if (m_isThere)
            conclude();
        m_isOver = m_unit >= m_last;
        if (m_isOver)
            return false;
        begin(m_unit + 1);
    }
    ask();
    return isLinkThere();
}

/// A link that had no answer for long is closed by itself; here that is no harm.
bool ModbusScan::isLinkThere() {
    if (!m_link.isOpen() && m_link.problem().code == MessageCode::DeviceSilent)
        m_link.open();
    return m_link.isOpen() || m_link.problem().code == MessageCode::None;
}

/// A late answer of the unit before has that unit's number; one of this unit might be another range's.
void ModbusScan::ask() {
    const RegisterRange& range = m_ranges.front();
    const ModbusRequest request{m_unit, range.function, range.address, range.count};
    if (m_link.isFree())
        m_asked = m_link.send(request);
    else if (!m_isThere && m_link.mayOvertake())
        m_asked = m_link.overtake(request);
}

void ModbusScan::take(const ModbusReply& reply) {
    const RegisterRange range = m_ranges.front();
    m_ranges.pop_front();
    m_has[{range.function, range.address, range.count}] = reply.ok();
    if (reply)
        m_image.store(range, *reply);
    const auto exception = reply ? std::nullopt : exceptionOf(reply.error());
    if (m_isThere || !(reply || (exception && !isFromGateway(*exception))))
        return;
    m_isThere = true;
    m_found.push_back({m_unit, {}});
    for (const ModbusProfile& profile : shippedProfiles())
        for (const auto& [range, isOneChannel] : pollOf(profile))
            if (std::ranges::find(m_ranges, range) == m_ranges.end() && range != kProbe)
                m_ranges.push_back(range);
    m_all = m_ranges.size();
}

void ModbusScan::conclude() {
    FoundUnit& found = m_found.back();
    for (const ModbusProfile& profile : shippedProfiles())
        if (auto fit = judged(profile))
            found.fits.push_back(std::move(*fit));
    std::ranges::stable_sort(found.fits, isMoreProbable);
    if (found.fits.empty() || found.fits.front().signature.empty())
        return;
    const auto isSame = [&](const FoundUnit& other) {
        return other.sameAs == 0 && !other.fits.empty() &&
               other.fits.front().profile == found.fits.front().profile &&
               other.fits.front().signature == found.fits.front().signature;
    };
    const auto same = std::ranges::find_if(m_found.begin(), m_found.end() - 1, isSame);
    found.sameAs = same == m_found.end() - 1 ? 0 : same->unit;
}

bool ModbusScan::has(const RegisterRange& range) const {
    const auto it = m_has.find({range.function, range.address, range.count});
    return it != m_has.end() && it->second;
}

/// Empty: it does not fit.
std::optional<ProfileFit> ModbusScan::judged(const ModbusProfile& written) const {
    ProfileFit fit{written.name, {}, {}};
    for (const auto& [range, isOneChannel] : pollOf(written)) {
        if (has(range))
            fit.registers += range.count;
        else if (!isOneChannel)
            return std::nullopt;
    }
    ModbusProfile profile = written;
    const auto quantity = [&](const RegisterSpec& spec) {
        return quantityFromRegisters(spec, m_image.registers(rangeOf(spec)));
    };
    if (profile.deviceType) {
        fit.isTypeTold = std::ranges::find(profile.deviceTypes, quantity(*profile.deviceType)) !=
                         profile.deviceTypes.end();
        if (!fit.isTypeTold)
            return std::nullopt;
    }
    if (profile.temperatureUnit) {
        const double unit = quantity(*profile.temperatureUnit);
        if (unit != profile.unitCelsius && unit != profile.unitFahrenheit)
            return std::nullopt;
        profile =
            inUnit(profile, unit == profile.unitCelsius ? RegisterUnit::Celsius : RegisterUnit::Fahrenheit);
    }
    bool isAllZero = true; // as of a device that answers 0 for whatever it has not
    for (const RegisterSpec& spec : temperaturesOf(profile)) {
        fit.temperatures_K.push_back(std::numeric_limits<double>::quiet_NaN());
        const RegisterRange range = rangeOf(spec);
        if (profile.isOneByOne && !has(range))
            continue;
        const auto registers = m_image.registers(range);
        isAllZero = isAllZero && std::ranges::all_of(registers, [](std::uint16_t word) { return word == 0; });
        const RegisterValue value = temperatureFromRegisters(profile, spec, registers);
        if (!value.fault.empty())
            continue;
        if (!(value.value_K >= kColdest_K && value.value_K <= kHottest_K))
            return std::nullopt; // a number that is no temperature of a laboratory
        fit.temperatures_K.back() = value.value_K;
    }
    const bool isAnyThere =
        std::ranges::any_of(fit.temperatures_K, [](double t_K) { return !std::isnan(t_K); });
    const bool isHeater = profile.processValue.has_value();
    if (isAllZero || !isAnyThere || (isHeater && std::isnan(fit.temperatures_K.front())))
        return std::nullopt;
    if (profile.identity)
        fit.signature = signatureFromRegisters(m_image.registers(rangeOf(*profile.identity)));
    return fit;
}

} // namespace bask
