#pragma once
// From an experiment to what runs it: believed rates, the simulated rig, verdicts on the targets.

#include "engine/control/controller.h"
#include "engine/control/joint_feasibility.h"
#include "engine/model/experiment_rig.h"
#include "engine/simulation/simulated_rig.h"

#include <vector>

namespace bask {

/// Rates of the objects' materials, as believed, at the source's set temperature and the given environment.
std::vector<HeatRates> nominalRates(const Experiment& experiment, double environment_K);

/// Rates that the simulated plant truly has, but for convection.
std::vector<HeatRates> trueRates(const Experiment& experiment);

/// Material that a simulated object truly is.
const Material& trueMaterial(const ObjectSpec& object);
/// Net power of the simulated source at a temperature, W/m2.
double trueSourcePower_W_m2(const Experiment& experiment, double source_K);

/// Where a controller starts: an object's believed rates, else its material's, wrong by the experiment's
/// random factors (seeded).
std::vector<HeatRates> believedRates(const Experiment& experiment, double environment_K);

/// The joint question for the experiment's targets, without a look-up.
FeasibilityRequest feasibilityRequest(const Experiment& experiment);
/// Its answer: some 50 to 100 ms.
JointVerdict jointVerdict(const Experiment& experiment);

SimulatedRigConfig simulatedRigConfig(const Experiment& experiment);

} // namespace bask
