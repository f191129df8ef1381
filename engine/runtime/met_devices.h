#pragma once
// The known devices at their ports and the confirmed programs, kept in files, and the trial of one device
// alone.

#include "engine/drivers/confirmed_programs.h"
#include "engine/experiment/program_memory.h"
#include "engine/rig/real_rig.h"
#include "engine/runtime/background_thread.h"
#include "engine/runtime/snapshot.h"

#include <memory>
#include <string>
#include <utility>

namespace bask {

/// Remembers the first device that answers at each place. Only the constructor waits for the disk.
class MetDevices {
public:
    /// Reads the file, and programs.json beside it; with an empty name nothing is kept.
    explicit MetDevices(std::string file);

    const DeviceMemory& memory() const { return m_memory; }
    const std::shared_ptr<ConfirmedPrograms>& programs() const { return m_programs; }
    /// Why a file could not be read; None if both could. It is overwritten with the next new device or
    /// program.
    const Message& problem() const { return m_problem; }
    void remember(const RealRig& rig, BackgroundThread& disk);
    /// Forgets the device at that place, so that another one is accepted there.
    void forget(RealRig& rig, DeviceRole role, BackgroundThread& disk);
    /// Allows a program to be started; without `isKept` only by this object.
    void confirm(const std::string& command, const std::string& hash, bool isKept, BackgroundThread& disk);

private:
    void keep(BackgroundThread& disk) const;

    std::string m_file, m_programFile;
    DeviceMemory m_memory;
    ProgramMemory m_kept;
    std::shared_ptr<ConfirmedPrograms> m_programs = std::make_shared<ConfirmedPrograms>();
    Message m_problem;
};

/// One device alone. It may be closed after the engine has ended.
class DeviceTrial {
public:
    DeviceTrial(const RigSpec& spec, const MetDevices& met, std::shared_ptr<TrafficLog> traffic)
        : m_rig(spec, m_clock, met.memory(), met.programs(), std::move(traffic)) {}

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
