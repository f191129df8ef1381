#pragma once
// A simulated device at the far end of a byte link: bytes in and bytes out, as the real one has them.

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Time is given by the caller, s, and must not decrease.
class ByteDevice {
public:
    virtual ~ByteDevice() = default;
    /// Call when a host has opened the port.
    virtual void opened(double) {}
    virtual void receive(std::string_view bytes, double now_s) = 0;
    /// Returns the bytes that it sends until now, after its delays.
    virtual std::string transmit(double now_s) = 0;
    /// Returns the names that setFault accepts; one of them is "none".
    virtual std::vector<std::string> faults() const = 0;
    /// Starts a fault and ends any other. Refuses an unknown name with ValueUnknown.
    virtual Result<void> setFault(const std::string& name) = 0;
};

} // namespace bask
