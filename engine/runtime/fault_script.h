#pragma once
// Faults of the simulated rig: one by its name, and those of an experiment's script at their times.

#include "engine/model/safety_spec.h"
#include "engine/runtime/snapshot.h"
#include "engine/simulation/simulated_rig.h"

#include <string>
#include <vector>

namespace bask {

/// Activates or clears the fault; no effect if `object` is out of range.
void setFault(SimulatedRig& rig, SimulatedFault fault, std::size_t object, bool isOn);
/// Ends the fault if the rig has it; another fault of the same device stays.
void endFault(SimulatedRig& rig, SimulatedFault fault, std::size_t object);
/// Clears all faults.
void clearFaults(SimulatedRig& rig);
/// Returns the faults that the devices have now, whoever set them; one that a device has ended is not among
/// them.
std::vector<ActiveFault> activeFaults(SimulatedRig& rig);

class FaultScript {
public:
    explicit FaultScript(std::vector<ScriptedFault> faults)
        : m_faults(std::move(faults)), m_isOn(m_faults.size(), false) {}

    /// Activates and clears the faults that are due at this run time. Returns those that were activated by
    /// this call.
    std::vector<ScriptedFault> play(SimulatedRig& rig, double runTime_s);

private:
    std::vector<ScriptedFault> m_faults;
    std::vector<bool> m_isOn;
};

} // namespace bask
