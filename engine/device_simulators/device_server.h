#pragma once
// A simulated device at a path of the file system, for any program that opens it as a serial port.

#include "engine/device_simulators/byte_device.h"

#include <memory>

namespace bask {

class DeviceServer {
public:
    virtual ~DeviceServer() = default;
    /// Moves bytes in both directions and never waits. Clients may connect and disconnect.
    virtual void work(double now_s) = 0;
};

/// Serves the device. With `isThere` it uses the existing terminal at `path`; otherwise a new one that is
/// linked there. `device` must outlive it. Errors: those of TerminalServer::open and PtyServer::create.
Result<std::unique_ptr<DeviceServer>> serveAt(const std::string& path, ByteDevice& device, bool isThere);

} // namespace bask
