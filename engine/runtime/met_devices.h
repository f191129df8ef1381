#pragma once
// The known devices at their ports, kept in a file, and the trial of one device alone.

#include "engine/rig/real_rig.h"
#include "engine/runtime/background_thread.h"
#include "engine/runtime/snapshot.h"

#include <memory>
#include <string>

namespace bask {

/// Remembers the first device that answers at each place. Only the constructor waits for the disk.
class MetDevices {
public:
    /// Reads the file; with an empty name nothing is kept.
    explicit MetDevices(std::string file);

    const DeviceMemory& memory() const { return m_memory; }
    /// Why the file could not be read; None if it could. It is overwritten with the next new device.
    const Message& problem() const { return m_problem; }
    void remember(const RealRig& rig, BackgroundThread& disk);
    /// Forgets the device at that place, so that another one is accepted there.
    void forget(RealRig& rig, DeviceRole role, BackgroundThread& disk);

private:
    void keep(BackgroundThread& disk) const;

    std::string m_file;
    DeviceMemory m_memory;
    Message m_problem;
};

/// One device alone. It may be closed after the engine has ended.
class DeviceTrial {
public:
    DeviceTrial(const RigSpec& spec, const DeviceMemory& memory) : m_rig(spec, m_clock, memory) {}

    void work() { m_rig.work(); }
    TriedDevice state();
    std::unique_ptr<Camera> takeCamera() { return m_rig.takeCamera(); }
    std::unique_ptr<ThermalCamera> takeThermalCamera() { return m_rig.takeThermalCamera(); }
    bool mayEndElsewhere() const { return m_rig.mayEndElsewhere(); }

private:
    SteadyClock m_clock;
    RealRig m_rig;
};

} // namespace bask
