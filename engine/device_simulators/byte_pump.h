#pragma once
// Bytes between a simulated device and a descriptor that does not block.

#include "engine/device_simulators/byte_device.h"

namespace bask {

class BytePump {
public:
    /// `device` must outlive it.
    explicit BytePump(ByteDevice& device) : m_device(device) {}

    /// Moves what there is, both ways. False: the other end is gone.
    bool work(int descriptor, double now_s);
    /// A host is there, which was not before.
    void opened(double now_s) { m_device.opened(now_s); }
    /// Nobody listens: what the device says is lost, as on a line that hangs loose.
    void discard(double now_s);

private:
    bool take(int descriptor, double now_s);
    bool give(int descriptor);

    ByteDevice& m_device;
    std::string m_pending; ///< said, and not yet taken by the other end
};

} // namespace bask
