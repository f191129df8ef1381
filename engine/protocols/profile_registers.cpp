#include "engine/protocols/profile_registers.h"

#include "engine/protocols/register_values.h"

#include <algorithm>
#include <utility>

namespace bask {
namespace {

std::vector<RegisterRange> withStatusAndIdentity(std::vector<RegisterRange> ranges,
                                                 const ModbusProfile& profile) {
    for (const StatusSpec& status : profile.status)
        ranges.push_back({status.function, status.address, 1});
    if (profile.identity)
        ranges.push_back(rangeOf(*profile.identity));
    if (profile.deviceType)
        ranges.push_back(rangeOf(*profile.deviceType));
    return joinedRanges(std::move(ranges));
}

} // namespace

RegisterRange rangeOf(const RegisterSpec& spec) {
    return {spec.function, spec.address, registerCount(spec.type)};
}

RegisterRange rangeOf(const IdentitySpec& spec) {
    return {spec.function, spec.address, spec.count};
}

RegisterSpec channelSpec(const ModbusProfile& profile, int channel) {
    RegisterSpec spec = *profile.channel;
    spec.address += channel * profile.channelStep;
    return spec;
}

std::vector<PolledRange> thermometerPoll(const ModbusProfile& profile, std::span<const int> channels) {
    std::vector<RegisterRange> common;
    if (!profile.isOneByOne) {
        const auto [first, last] = std::ranges::minmax(channels);
        const RegisterRange begin = rangeOf(channelSpec(profile, first));
        const RegisterRange end = rangeOf(channelSpec(profile, last));
        common.push_back({begin.function, begin.address, end.address + end.count - begin.address});
    }
    std::vector<PolledRange> out;
    for (const RegisterRange& range : withStatusAndIdentity(std::move(common), profile))
        out.push_back({range, false});
    if (profile.isOneByOne)
        for (const int channel : channels)
            out.push_back({rangeOf(channelSpec(profile, channel)), true});
    return out;
}

std::vector<RegisterRange> controllerPoll(const ModbusProfile& profile) {
    std::vector<RegisterRange> ranges{rangeOf(*profile.processValue), rangeOf(*profile.setPoint)};
    for (const auto& spec : {profile.setPointWritten, profile.run, profile.watchdog, profile.sensorFault,
                             profile.temperatureUnit})
        if (spec)
            ranges.push_back(rangeOf(*spec));
    return withStatusAndIdentity(std::move(ranges), profile);
}

} // namespace bask
