#pragma once
// What a driver is made with, and as what it is handed over.

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

/// The links of one device, as its port and line are set. They and the clock outlive it.
class DriverLinks {
public:
    virtual ~DriverLinks() = default;
    virtual const Clock& clock() const = 0;
    virtual ByteLink& serial() = 0;
    /// Other devices may use it, too.
    virtual ModbusLink& modbus() = 0;
    virtual ByteLink& tcp(int port) = 0;
};

/// A device that plays a role.
template <class Role> struct MadeDevice {
    template <class Driver>
    MadeDevice(std::unique_ptr<Driver> driver, std::function<guard::OffProgram()> off = {})
        : device(driver.get()), role(std::move(driver)), offProgram(std::move(off)) {}
    /// One role around the device.
    MadeDevice(Device& behind, std::unique_ptr<Role> front) : device(&behind), role(std::move(front)) {}

    Device* device; ///< belongs to `role`
    std::unique_ptr<Role> role;
    std::function<guard::OffProgram()> offProgram; ///< what switches a heater off as it is now
};

/// Of a spec that checkRig lets pass; of another one it throws std::invalid_argument.
template <class Driver> std::unique_ptr<Driver> made(Result<std::unique_ptr<Driver>> driver) {
    if (!driver)
        throw std::invalid_argument(describe(driver.error()));
    return std::move(*driver);
}

} // namespace bask
