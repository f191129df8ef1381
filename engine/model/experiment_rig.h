#pragma once
// What an experiment says of its rig: the geometry for view factors, the surroundings for heat rates.

#include "engine/control/rig_geometry.h"
#include "engine/model/experiment.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/silhouette_outline.h"

#include <memory>
#include <string>
#include <vector>

namespace bask {

/// Returns the objects as they are mounted on the end-effector.
std::vector<MountedContour> mountedContours(const Experiment& experiment);

/// Returns the fixtures and shields of an experiment.
Screens screensOf(const Experiment& experiment);
/// Returns the names of all that takes light, as TakenLight counts them: objects, fixtures, shields.
std::vector<std::string> takerNames(const Experiment& experiment);

/// Returns what a thermal camera sees of the rig.
SilhouetteScene silhouetteScene(const Experiment& experiment);

/// Without a pose the camera shows pictures only.
struct PlacedThermalCamera {
    CameraModel lens;
    std::optional<Pose> X_RC;
    SightUncertainty sight{}; ///< by that of X_RC
};
/// Returns what is believed of the thermal camera of the simulated or the real rig; empty if it has none.
std::optional<PlacedThermalCamera> believedThermalCamera(const Experiment& experiment, bool simulated);
/// Returns X_RC of the simulated one as it truly is.
Pose trueThermalPose(const Experiment& experiment);

/// Returns the geometry of an experiment that validates.
std::shared_ptr<const RigGeometry> rigGeometry(const Experiment& experiment);
/// Returns the same without what the objects reflect to one another: with the source's own view factors.
std::shared_ptr<const RigGeometry> rigGeometryWithoutExchange(const Experiment& experiment);

/// Returns what the objects exchange heat with, as the experiment assumes, at the source's set temperature
/// and an environment, K.
Surroundings surroundingsOf(const Experiment& experiment, double environment_K);
/// Same in the environment that the experiment states.
Surroundings surroundingsOf(const Experiment& experiment);

/// Returns the rates of an object's assumed material.
HeatRates heatRates(const ObjectSpec& object, const Surroundings& surroundings);
/// Returns the rates that a controller and the checks start from: the object's given ones, with the air's
/// loss in proportion to their lambda2, else its material's.
HeatRates startRates(const ObjectSpec& object, const Surroundings& surroundings);

} // namespace bask
