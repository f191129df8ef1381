#pragma once
// Which devices were met at their ports, kept in a file, and the trial of one device alone.

#include "engine/rig/real_rig.h"
#include "engine/runtime/background_thread.h"
#include "engine/runtime/snapshot.h"

#include <memory>
#include <string>

namespace bask {

/// The first device that is met at its place is remembered. No call but the constructor touches the disk.
class MetDevices {
public:
    /// Reads the file; an empty name keeps nothing.
    explicit MetDevices(std::string file);

    const DeviceMemory& memory() const { return m_memory; }
    /// Why the file could not be read; None: it could. It is written anew with the next device.
    const Message& problem() const { return m_problem; }
    void remember(const RealRig& rig, BackgroundThread& disk);
    /// Another device at that place is taken from now on.
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
    bool mayEndElsewhere() const { return m_rig.mayEndElsewhere(); }

private:
    SteadyClock m_clock;
    RealRig m_rig;
};

} // namespace bask
