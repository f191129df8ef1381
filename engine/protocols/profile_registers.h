#pragma once
// Which registers of a device are read with each poll, by its profile.

#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/register_ranges.h"

#include <span>
#include <vector>

namespace bask {

RegisterRange rangeOf(const RegisterSpec& spec);
RegisterRange rangeOf(const IdentitySpec& spec);
/// Returns the register of a thermometer's channel.
RegisterSpec channelSpec(const ModbusProfile& profile, int channel);

struct PolledRange {
    RegisterRange range;
    bool isOneChannel = false; ///< if it is refused, only this channel has no value
};

/// Return what is read, in as few requests as possible. All channels of a thermometer from the first to the
/// last one used are read in one request, unless its profile asks for each channel alone.
std::vector<PolledRange> thermometerPoll(const ModbusProfile& profile, std::span<const int> channels);
std::vector<RegisterRange> controllerPoll(const ModbusProfile& profile);

} // namespace bask
