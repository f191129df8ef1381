#pragma once
// Whether a simulated fault would show on a rig in its present state, and when.

#include "engine/devices/device.h"
#include "engine/model/experiment.h"

namespace bask {

enum class FaultEffect {
    AtOnce,
    WhenWarm,     ///< once the object is warmer than the room
    WhenApart,    ///< once the two objects have different temperatures
    WhenOff,      ///< when the heat is switched off
    InPictures,   ///< in the camera's pictures only: nothing else uses them
    NoneByCamera, ///< none: the thermal camera alone reads the object
    NoneAlone,    ///< none: there is no other sensor
    NoneUnmarked, ///< none: nothing follows the source, and it has no markers
    NoneUnused,   ///< none in a run: no camera follows the source or reads an object
    NoneHeatOff,  ///< none while the heat is off
    NoneHeatOn
};

bool showsNothing(FaultEffect effect);

/// Returns the effect of a fault on the simulated rig of an experiment, with the heat as it is now. A heat
/// that is not known hinders no fault.
FaultEffect faultEffect(const Experiment& experiment, HeatState heat, SimulatedFault fault,
                        std::size_t object);

} // namespace bask
