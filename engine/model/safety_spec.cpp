#include "engine/model/safety_spec.h"

namespace bask {

const char* simulatedFaultName(SimulatedFault fault) {
    switch (fault) {
    case SimulatedFault::None:
        return "none";
    case SimulatedFault::SensorLost:
        return "sensor-lost";
    case SimulatedFault::SensorOpen:
        return "sensor-open";
    case SimulatedFault::SensorShort:
        return "sensor-short";
    case SimulatedFault::SensorFrozen:
        return "sensor-frozen";
    case SimulatedFault::SensorJumping:
        return "sensor-jumping";
    case SimulatedFault::SensorOff:
        return "sensor-off";
    case SimulatedFault::SensorsSwapped:
        return "sensors-swapped";
    case SimulatedFault::ObjectHot:
        return "object-hot";
    case SimulatedFault::RobotLost:
        return "robot-lost";
    case SimulatedFault::RobotAlarm:
        return "robot-alarm";
    case SimulatedFault::RobotRestarted:
        return "robot-restarted";
    case SimulatedFault::RobotSlow:
        return "robot-slow";
    case SimulatedFault::SourceLost:
        return "source-lost";
    case SimulatedFault::SourceSilent:
        return "source-silent";
    case SimulatedFault::SourceNotHeating:
        return "source-not-heating";
    case SimulatedFault::SourceHeatsAlone:
        return "source-heats-alone";
    case SimulatedFault::SourceOverheats:
        return "source-overheats";
    case SimulatedFault::SourceLimited:
        return "source-limited";
    case SimulatedFault::SourceKeepsHeat:
        return "source-keeps-heat";
    case SimulatedFault::SourceCovered:
        return "source-covered";
    case SimulatedFault::CameraLost:
        return "camera-lost";
    }
    return "";
}

bool isOfObject(SimulatedFault fault) {
    return fault >= SimulatedFault::SensorLost && fault <= SimulatedFault::ObjectHot;
}

} // namespace bask
