#pragma once
// Pictures of half the size each way: as good for what is followed, and a quarter of the work.

#include "engine/model/experiment.h"
#include "engine/simulation/simulated_camera.h"

namespace bask {

inline CameraModel halfSize(CameraModel camera) {
    camera.width /= 2;
    camera.height /= 2;
    camera.fx *= 0.5;
    camera.fy *= 0.5;
    camera.cx = 0.5 * (camera.cx + 0.5) - 0.5; // pixel centres are at whole numbers
    camera.cy = 0.5 * (camera.cy + 0.5) - 0.5;
    return camera;
}

/// The rig's camera and what the experiment knows of it.
inline Experiment withHalfSizePictures(Experiment experiment) {
    SimulatedCameraSpec& simulated = experiment.simulation.camera;
    simulated.model = halfSize(simulated.model.value_or(usualCamera()));
    experiment.vision.camera = halfSize(experiment.vision.camera.value());
    return experiment;
}

} // namespace bask
