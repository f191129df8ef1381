#pragma once
// What a search for Modbus units is to ask, and what it has found.

#include "engine/base/message.h"
#include "engine/protocols/serial_settings.h"

#include <string>
#include <vector>

namespace bask {

/// A profile all of whose registers a unit has, with temperatures that a laboratory can have.
struct ProfileFit {
    std::string profile;
    std::vector<double> temperatures_K; ///< of its channels, or process value and set point; NaN: none
    std::string signature;              ///< what its identity registers hold; empty if it names none
    bool isTypeTold = false;            ///< the unit itself reports that it is such a device
    int registers = 0;                  ///< number of registers that were read for it

    bool operator==(const ProfileFit&) const = default;
};

struct FoundUnit {
    int unit = 0;
    std::vector<ProfileFit> fits; ///< the most probable one first
    /// The first unit with the same signature: a device on a network may answer to every number. 0: none.
    int sameAs = 0;

    bool operator==(const FoundUnit&) const = default;
};

/// Settings of serial lines that Modbus devices have, the most usual first.
inline const std::vector<SerialSettings> kCommonModbusLines{
    {19200, 8, 'E', 1}, {9600, 8, 'N', 1},  {9600, 8, 'E', 1},   {19200, 8, 'N', 1},
    {38400, 8, 'N', 1}, {57600, 8, 'N', 1}, {115200, 8, 'N', 1}, {4800, 8, 'N', 1}};

struct ModbusSearchSpec {
    std::string port; ///< path of a serial port, or address of a host
    bool isNetwork = false;
    /// Settings of a serial port, tried until a unit answers; at least one, also for a network.
    std::vector<SerialSettings> lines{{}};
    int firstUnit = 1, lastUnit = 16;

    bool operator==(const ModbusSearchSpec&) const = default;
};

/// The state of a search; `found` is complete if it is over.
struct ModbusSearchState {
    int number = 0; ///< of the command that began it
    std::vector<FoundUnit> found;
    double progress = 0.0; ///< 0 to 1
    int unit = 0;          ///< the one that is asked now
    SerialSettings line;   ///< the setting that is tried now, or was last
    bool isOver = false;
    Message problem; ///< why it ended early; code None if it did not
};

} // namespace bask
