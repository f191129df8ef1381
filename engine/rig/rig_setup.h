#pragma once
// From an experiment to what runs it: estimated rates, the simulated rig, verdicts on the targets.

#include "engine/control/controller.h"
#include "engine/control/joint_feasibility.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/face_reflections.h"
#include "engine/rig/object_thermometer.h"
#include "engine/rig/real_rig.h"
#include "engine/simulation/simulated_rig.h"

#include <memory>
#include <vector>

namespace bask {

/// Returns the rates of the objects' assumed materials, at the source's set temperature and the given
/// environment.
std::vector<HeatRates> nominalRates(const Experiment& experiment, double environment_K);

/// Returns the true rates of the simulated plant, with its air.
std::vector<HeatRates> trueRates(const Experiment& experiment);

/// Returns the true material of a simulated object.
const Material& trueMaterial(const ObjectSpec& object);
/// Returns what the simulated objects exchange heat with, the source having a temperature, K.
Surroundings trueSurroundings(const Experiment& experiment, double source_K);
/// Returns where the simulated source has other temperatures than its own.
const Unevenness& trueUnevenness(const Experiment& experiment);
/// Returns the geometry with the simulated source as it truly radiates.
std::shared_ptr<const RigGeometry> trueRigGeometry(const Experiment& experiment);
/// Returns the air of the simulated plant.
Air trueAir(const Experiment& experiment);
/// Returns the true rates of one simulated object.
HeatRates trueRates(const ObjectSpec& object, const Surroundings& surroundings);

/// Returns what is believed of what the objects' faces reflect.
ReflectingRig reflectingRig(const Experiment& experiment);

/// Returns the start values of a controller: an object's given rates, else its material's with the
/// experiment's random (seeded) error factors; with the air that the experiment assumes.
std::vector<HeatRates> estimatedRates(const Experiment& experiment, double environment_K);

/// Returns the request for the joint feasibility of the experiment's targets, without a look-up.
FeasibilityRequest feasibilityRequest(const Experiment& experiment);
/// Returns its verdict; takes about 50 to 100 ms.
JointVerdict jointVerdict(const Experiment& experiment);

SimulatedRigConfig simulatedRigConfig(const Experiment& experiment);

/// Returns the thermal camera of a simulated rig as thermometer; null for one without. The rig must outlive
/// it.
std::unique_ptr<CameraThermometer> cameraThermometer(const Experiment& experiment, SimulatedRig& rig);
/// Returns the thermometer of a rig with a thermal camera; null for one without. The rig must outlive it.
std::unique_ptr<ObjectThermometer> objectThermometer(const Experiment& experiment, SimulatedRig& rig);
std::unique_ptr<ObjectThermometer> objectThermometer(const Experiment& experiment, RealRig& rig,
                                                     const Clock& clock);

} // namespace bask
