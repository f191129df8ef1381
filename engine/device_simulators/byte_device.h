#pragma once
// A simulated device at the far end of a byte link: bytes in, bytes out, as the real one has them.

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Time is the owner's, s, and does not go back.
class ByteDevice {
public:
    virtual ~ByteDevice() = default;
    /// Its port was opened by a host.
    virtual void opened(double) {}
    virtual void receive(std::string_view bytes, double now_s) = 0;
    /// What it has to say until now, delays included.
    virtual std::string transmit(double now_s) = 0;
    /// Names that setFault knows; "none" is one.
    virtual std::vector<std::string> faults() const = 0;
    /// Begins a fault, alone. Refused with ValueUnknown for another name.
    virtual Result<void> setFault(const std::string& name) = 0;
};

} // namespace bask
