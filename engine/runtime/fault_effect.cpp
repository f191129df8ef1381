#include "engine/runtime/fault_effect.h"

namespace bask {
namespace {

bool hasContactSensor(const Experiment& experiment, std::size_t object) {
    return object < experiment.objects.size() && experiment.objects[object].readBy != ReadBy::Camera;
}

FaultEffect swapEffect(const Experiment& experiment, std::size_t object) {
    const std::size_t count = experiment.objects.size();
    if (count < 2)
        return FaultEffect::NoneAlone;
    const bool isRead =
        hasContactSensor(experiment, object) || hasContactSensor(experiment, (object + 1) % count);
    return isRead ? FaultEffect::WhenApart : FaultEffect::NoneByCamera;
}

} // namespace

bool showsNothing(FaultEffect effect) {
    return effect >= FaultEffect::NoneByCamera;
}

FaultEffect faultEffect(const Experiment& experiment, HeatState heat, SimulatedFault fault,
                        std::size_t object) {
    switch (fault) {
    case SimulatedFault::SensorLost:
    case SimulatedFault::SensorOpen:
    case SimulatedFault::SensorShort:
    case SimulatedFault::SensorFrozen:
    case SimulatedFault::SensorJumping:
        return hasContactSensor(experiment, object) ? FaultEffect::AtOnce : FaultEffect::NoneByCamera;
    case SimulatedFault::SensorOff:
        return hasContactSensor(experiment, object) ? FaultEffect::WhenWarm : FaultEffect::NoneByCamera;
    case SimulatedFault::SensorsSwapped:
        return swapEffect(experiment, object);
    case SimulatedFault::SourceNotHeating:
    case SimulatedFault::SourceLimited:
        return heat == HeatState::Off ? FaultEffect::NoneHeatOff : FaultEffect::AtOnce;
    case SimulatedFault::SourceKeepsHeat:
        return heat == HeatState::Off ? FaultEffect::NoneHeatOff : FaultEffect::WhenOff;
    case SimulatedFault::SourceHeatsAlone:
        return heat == HeatState::On ? FaultEffect::NoneHeatOn : FaultEffect::AtOnce;
    case SimulatedFault::SourceCovered:
        if (experiment.source.tracked)
            return FaultEffect::AtOnce;
        return experiment.vision.marks(Part::Source) ? FaultEffect::InPictures : FaultEffect::NoneUnmarked;
    case SimulatedFault::CameraLost:
        return experiment.source.tracked || thermalProfile(experiment, true) ? FaultEffect::AtOnce
                                                                             : FaultEffect::NoneUnused;
    case SimulatedFault::None:
    case SimulatedFault::ObjectHot:
    case SimulatedFault::RobotLost:
    case SimulatedFault::RobotAlarm:
    case SimulatedFault::RobotRestarted:
    case SimulatedFault::RobotSlow:
    case SimulatedFault::SourceLost:
    case SimulatedFault::SourceSilent:
    case SimulatedFault::SourceOverheats:
        break;
    }
    return FaultEffect::AtOnce;
}

} // namespace bask
