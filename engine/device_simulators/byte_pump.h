#pragma once
// Moves bytes between a simulated device and a non-blocking descriptor.

#include "engine/device_simulators/byte_device.h"

namespace bask {

class BytePump {
public:
    /// `device` must outlive it.
    explicit BytePump(ByteDevice& device) : m_device(device) {}

    /// Moves the available bytes in both directions. Returns false if the other end is closed.
    bool work(int descriptor, double now_s);
    /// Call when a new host has connected.
    void opened(double now_s) { m_device.opened(now_s); }
    /// Nobody listens: bytes from the device are lost, as on an unconnected line.
    void discard(double now_s);

private:
    bool take(int descriptor, double now_s);
    bool give(int descriptor);

    ByteDevice& m_device;
    std::string m_pending; ///< sent, but not yet accepted by the other end
};

} // namespace bask
