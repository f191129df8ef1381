#include "engine/runtime/fault_script.h"

#include <algorithm>
#include <array>

namespace bask {
namespace {

/// A fault and what its device has then.
template <class Trouble> struct FaultRow {
    SimulatedFault fault;
    Trouble trouble;
};

constexpr std::array kSensorRows{FaultRow{SimulatedFault::SensorLost, SensorTrouble::Lost},
                                 FaultRow{SimulatedFault::SensorOpen, SensorTrouble::Open},
                                 FaultRow{SimulatedFault::SensorShort, SensorTrouble::Short},
                                 FaultRow{SimulatedFault::SensorFrozen, SensorTrouble::Frozen},
                                 FaultRow{SimulatedFault::SensorJumping, SensorTrouble::Jumping},
                                 FaultRow{SimulatedFault::SensorOff, SensorTrouble::Off}};
constexpr std::array kRobotRows{FaultRow{SimulatedFault::RobotLost, RobotTrouble::LinkLost},
                                FaultRow{SimulatedFault::RobotAlarm, RobotTrouble::Alarm},
                                FaultRow{SimulatedFault::RobotRestarted, RobotTrouble::Restarted},
                                FaultRow{SimulatedFault::RobotSlow, RobotTrouble::Slow}};
constexpr std::array kSourceRows{FaultRow{SimulatedFault::SourceLost, SourceTrouble::LinkLost},
                                 FaultRow{SimulatedFault::SourceSilent, SourceTrouble::Silent},
                                 FaultRow{SimulatedFault::SourceNotHeating, SourceTrouble::NotHeating},
                                 FaultRow{SimulatedFault::SourceHeatsAlone, SourceTrouble::HeatsAlone},
                                 FaultRow{SimulatedFault::SourceOverheats, SourceTrouble::Overheats},
                                 FaultRow{SimulatedFault::SourceLimited, SourceTrouble::Limited},
                                 FaultRow{SimulatedFault::SourceKeepsHeat, SourceTrouble::KeepsHeat}};

template <class Rows> const auto* rowOf(const Rows& rows, SimulatedFault fault) {
    const auto found = std::ranges::find(rows, fault, [](const auto& row) { return row.fault; });
    return found == rows.end() ? nullptr : &*found;
}

std::size_t sensorsOf(SimulatedRig& rig) {
    return static_cast<std::size_t>(rig.simulatedThermometer().channels());
}

bool hasFault(SimulatedRig& rig, SimulatedFault fault, std::size_t object) {
    if (const auto* row = rowOf(kSensorRows, fault))
        return rig.simulatedThermometer().trouble(object) == row->trouble;
    if (const auto* row = rowOf(kRobotRows, fault))
        return rig.simulatedRobot().trouble() == row->trouble;
    if (const auto* row = rowOf(kSourceRows, fault))
        return rig.simulatedHeatSource().trouble() == row->trouble;
    switch (fault) {
    case SimulatedFault::SensorsSwapped:
        return rig.simulatedThermometer().swapped() && rig.simulatedThermometer().swapped()->first == object;
    case SimulatedFault::ObjectHot:
        return rig.isHot(object);
    case SimulatedFault::SourceCovered:
        return rig.simulatedCamera().isCovered();
    case SimulatedFault::CameraLost:
        return rig.simulatedCamera().isUnplugged();
    default:
        return false;
    }
}

/// Calls `take` with each fault, and of those of objects with each object.
template <class Take> void forEachFault(SimulatedRig& rig, const Take& take) {
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        for (std::size_t object = 0; object < (isOfObject(fault) ? sensorsOf(rig) : 1); ++object)
            take(fault, object);
    }
}

} // namespace

void setFault(SimulatedRig& rig, SimulatedFault fault, std::size_t object, bool isOn) {
    if (isOfObject(fault) && object >= sensorsOf(rig))
        return;
    if (const auto* row = rowOf(kSensorRows, fault))
        return rig.simulatedThermometer().setTrouble(object, isOn ? row->trouble : SensorTrouble::None,
                                                     rig.environment_K());
    if (const auto* row = rowOf(kRobotRows, fault))
        return rig.simulatedRobot().setTrouble(isOn ? row->trouble : RobotTrouble::None);
    if (const auto* row = rowOf(kSourceRows, fault))
        return rig.simulatedHeatSource().setTrouble(isOn ? row->trouble : SourceTrouble::None);
    switch (fault) {
    case SimulatedFault::SensorsSwapped:
        return rig.simulatedThermometer().setSwapped(object, (object + 1) % sensorsOf(rig), isOn);
    case SimulatedFault::ObjectHot:
        return rig.setHot(object, isOn);
    case SimulatedFault::SourceCovered:
        rig.simulatedSourceTracker().setLost(isOn);
        return rig.simulatedCamera().setCovered(isOn);
    case SimulatedFault::CameraLost:
        rig.simulatedSourceTracker().setLost(isOn);
        if (rig.simulatedThermalCamera() != nullptr)
            rig.simulatedThermalCamera()->setUnplugged(isOn);
        return rig.simulatedCamera().setUnplugged(isOn);
    default:
        return;
    }
}

void endFault(SimulatedRig& rig, SimulatedFault fault, std::size_t object) {
    if (!(isOfObject(fault) && object >= sensorsOf(rig)) && hasFault(rig, fault, object))
        setFault(rig, fault, object, false);
}

void clearFaults(SimulatedRig& rig) {
    forEachFault(rig,
                 [&rig](SimulatedFault fault, std::size_t object) { setFault(rig, fault, object, false); });
}

std::vector<ActiveFault> activeFaults(SimulatedRig& rig) {
    std::vector<ActiveFault> active;
    forEachFault(rig, [&](SimulatedFault fault, std::size_t object) {
        if (hasFault(rig, fault, object))
            active.push_back({fault, object});
    });
    return active;
}

std::vector<ScriptedFault> FaultScript::play(SimulatedRig& rig, double runTime_s) {
    std::vector<ScriptedFault> raised;
    for (const bool isOn : {false, true}) { // those that end come first: they may be about the same device
        for (std::size_t i = 0; i < m_faults.size(); ++i) {
            const ScriptedFault& fault = m_faults[i];
            const bool isDue = runTime_s >= fault.time_s && !(fault.until_s && runTime_s >= *fault.until_s);
            if (isDue != isOn || m_isOn[i] == isDue)
                continue;
            m_isOn[i] = isDue;
            setFault(rig, fault.fault, fault.object, isDue);
            if (isDue)
                raised.push_back(fault);
        }
    }
    return raised;
}

} // namespace bask
