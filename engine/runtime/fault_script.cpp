#include "engine/runtime/fault_script.h"

namespace bask {
namespace {

void setSensor(SimulatedRig& rig, std::size_t object, SensorTrouble trouble, bool isOn) {
    if (object < static_cast<std::size_t>(rig.simulatedThermometer().channels()))
        rig.simulatedThermometer().setTrouble(object, isOn ? trouble : SensorTrouble::None,
                                              rig.environment_K());
}

void setRobot(SimulatedRig& rig, RobotTrouble trouble, bool isOn) {
    rig.simulatedRobot().setTrouble(isOn ? trouble : RobotTrouble::None);
}

void setSource(SimulatedRig& rig, SourceTrouble trouble, bool isOn) {
    rig.simulatedHeatSource().setTrouble(isOn ? trouble : SourceTrouble::None);
}

} // namespace

void setFault(SimulatedRig& rig, SimulatedFault fault, std::size_t object, bool isOn) {
    switch (fault) {
    case SimulatedFault::None:
        return;
    case SimulatedFault::SensorLost:
        return setSensor(rig, object, SensorTrouble::Lost, isOn);
    case SimulatedFault::SensorOpen:
        return setSensor(rig, object, SensorTrouble::Open, isOn);
    case SimulatedFault::SensorShort:
        return setSensor(rig, object, SensorTrouble::Short, isOn);
    case SimulatedFault::SensorFrozen:
        return setSensor(rig, object, SensorTrouble::Frozen, isOn);
    case SimulatedFault::SensorJumping:
        return setSensor(rig, object, SensorTrouble::Jumping, isOn);
    case SimulatedFault::SensorOff:
        return setSensor(rig, object, SensorTrouble::Off, isOn);
    case SimulatedFault::SensorsSwapped:
        if (const auto sensors = static_cast<std::size_t>(rig.simulatedThermometer().channels());
            object < sensors)
            rig.simulatedThermometer().setSwapped(object, (object + 1) % sensors, isOn);
        return;
    case SimulatedFault::ObjectHot:
        if (object < static_cast<std::size_t>(rig.simulatedThermometer().channels()))
            rig.setHot(object, isOn);
        return;
    case SimulatedFault::RobotLost:
        return setRobot(rig, RobotTrouble::LinkLost, isOn);
    case SimulatedFault::RobotAlarm:
        return setRobot(rig, RobotTrouble::Alarm, isOn);
    case SimulatedFault::RobotRestarted:
        return setRobot(rig, RobotTrouble::Restarted, isOn);
    case SimulatedFault::RobotSlow:
        return setRobot(rig, RobotTrouble::Slow, isOn);
    case SimulatedFault::SourceLost:
        return setSource(rig, SourceTrouble::LinkLost, isOn);
    case SimulatedFault::SourceSilent:
        return setSource(rig, SourceTrouble::Silent, isOn);
    case SimulatedFault::SourceNotHeating:
        return setSource(rig, SourceTrouble::NotHeating, isOn);
    case SimulatedFault::SourceHeatsAlone:
        return setSource(rig, SourceTrouble::HeatsAlone, isOn);
    case SimulatedFault::SourceOverheats:
        return setSource(rig, SourceTrouble::Overheats, isOn);
    case SimulatedFault::SourceLimited:
        return setSource(rig, SourceTrouble::Limited, isOn);
    case SimulatedFault::SourceKeepsHeat:
        return setSource(rig, SourceTrouble::KeepsHeat, isOn);
    case SimulatedFault::SourceCovered:
        rig.simulatedSourceTracker().setLost(isOn);
        return rig.simulatedCamera().setCovered(isOn);
    case SimulatedFault::CameraLost:
        rig.simulatedSourceTracker().setLost(isOn);
        if (rig.simulatedThermalCamera() != nullptr)
            rig.simulatedThermalCamera()->setUnplugged(isOn);
        return rig.simulatedCamera().setUnplugged(isOn);
    }
}

void clearFaults(SimulatedRig& rig) {
    const auto channels = static_cast<std::size_t>(rig.simulatedThermometer().channels());
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        for (std::size_t object = 0; object < (isOfObject(fault) ? channels : 1); ++object)
            setFault(rig, fault, object, false);
    }
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
