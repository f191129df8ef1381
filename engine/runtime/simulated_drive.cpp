#include "engine/runtime/simulated_drive.h"

#include "engine/base/message_code.h"
#include "engine/rig/rig_setup.h"

#include <exception>

namespace bask {
namespace {

constexpr double kLookBefore_s = 0.5;

SimulatedRigConfig config(const Experiment& experiment) {
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    config.camera.isWallLimited = false;
    return config;
}

/// Creates the tracker of the camera, which is read once or twice in each period of the loop; null unless a
/// camera follows the source.
std::unique_ptr<CameraSourceTracker> cameraTracker(const Experiment& experiment, SimulatedRig& rig) {
    const VisionSpec& vision = experiment.vision;
    if (!experiment.source.tracked || !vision.followsSource())
        return nullptr;
    return std::make_unique<CameraSourceTracker>(rig.camera(), rig.clock(), markerLayout(vision),
                                                 *vision.camera, poseFromCoordinates(*vision.cameraPose));
}

} // namespace

SimulatedDrive::SimulatedDrive(const Experiment& experiment)
    : m_period_s(experiment.sampling.period_s), m_rig(config(experiment)),
      m_camera(cameraTracker(experiment, m_rig)), m_thermometer(objectThermometer(experiment, m_rig)),
      m_loop(experiment,
             {m_rig.robot(), m_thermometer ? *m_thermometer : m_rig.thermometer(), m_rig.heatSource(),
              [this] { return m_rig.trueTemperatures_K(); },
              m_camera ? m_camera.get() : &m_rig.sourceTracker(), false, m_thermometer.get()},
             m_rig.clock()),
      m_script(experiment.simulation.faults) {}

void SimulatedDrive::period() {
    if (m_loop.running())
        for (const ScriptedFault& raised : m_script.play(m_rig, m_loop.runTime_s()))
            m_loop.reportFault(raised.fault, raised.object);
    try {
        advance();
    } catch (const std::exception& exception) { // for example a source that is moved through the objects
        m_loop.fault({MessageCode::ReasonInternalFault, {exception.what()}});
    }
    m_loop.tick();
}

// A single marker is accepted when a second look agrees with it, before the first is forgotten.
void SimulatedDrive::advance() {
    const double before_s = m_camera && m_period_s > PartTracker::kPredicted_s ? kLookBefore_s : 0.0;
    m_rig.advance(m_period_s - before_s);
    if (before_s > 0.0) {
        (void)m_camera->look();
        m_rig.advance(before_s);
    }
}

} // namespace bask
