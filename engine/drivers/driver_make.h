#pragma once
// What a driver needs to be made, and the type in which it is returned.

#include "engine/base/clock.h"
#include "engine/base/result.h"
#include "engine/devices/device.h"
#include "engine/drivers/byte_link.h"
#include "engine/drivers/modbus_link.h"
#include "engine/guard/guard_messages.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

namespace bask {

enum class ProgramRole;

/// The links of one device, with its port and line settings. The links and the clock outlive the device.
class DriverLinks {
public:
    virtual ~DriverLinks() = default;
    virtual const Clock& clock() const = 0;
    virtual ByteLink& serial() = 0;
    /// Returns a link that other devices may use, too.
    virtual ModbusLink& modbus() = 0;
    virtual ByteLink& tcp(int port) = 0;
    /// Returns a link to the standard input and output of the program that the port names.
    virtual ByteLink& program(ProgramRole role) = 0;
};

/// A device with the role that it has.
template <class Role> struct MadeDevice {
    template <class Driver>
    MadeDevice(std::unique_ptr<Driver> driver, std::function<guard::OffProgram()> off = {})
        : device(driver.get()), role(std::move(driver)), offProgram(std::move(off)) {}
    /// Combines a device with an object for its role.
    MadeDevice(Device& behind, std::unique_ptr<Role> front) : device(&behind), role(std::move(front)) {}

    Device* device; ///< owned by `role`
    std::unique_ptr<Role> role;
    /// Returns what switches the heater off in its present state.
    std::function<guard::OffProgram()> offProgram;
};

/// Returns the driver for a spec that checkRig accepts; throws std::invalid_argument for any other.
template <class Driver> std::unique_ptr<Driver> made(Result<std::unique_ptr<Driver>> driver) {
    if (!driver)
        throw std::invalid_argument(describe(driver.error()));
    return std::move(*driver);
}

} // namespace bask
