#include "engine/runtime/engine_session.h"

#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {

Result<PoseReading> EngineSession::Tracker::read() {
    if (session.vision && session.loop.experiment().vision.followsSource())
        return session.vision->read();
    if (session.simulated)
        return session.simulated->sourceTracker().read();
    return PoseReading();
}

namespace {

std::unique_ptr<SimulatedRig> simulatedRig(const Experiment& experiment, const KeptRig& kept) {
    if (kept.rig)
        return nullptr;
    auto rig = std::make_unique<SimulatedRig>(simulatedRigConfig(experiment));
    if (kept.condition)
        rig->use(*kept.condition);
    return rig;
}

} // namespace

EngineSession::EngineSession(const Experiment& experiment, const Clock& wall, KeptRig kept)
    : steady(wall), simulated(simulatedRig(experiment, kept)), real(std::move(kept.rig)),
      thermometer(simulated ? objectThermometer(experiment, *simulated)
                            : objectThermometer(experiment, *real, wall)),
      vision(std::move(kept.watcher)), tracker(*this), loop(experiment, devices(experiment), clock()),
      script(experiment.simulation.faults) {
    Camera* camera = simulated ? &simulated->camera() : real->camera();
    if (camera != nullptr && !vision)
        vision = std::make_unique<VisionThread>(*camera, simulated ? "simulated" : experiment.rig->camera,
                                                clock());
    if (!real)
        return;
    real->setGuard([this](const Vector6d& from, const Vector6d& to) {
        return loop.readings().geometry()->mayStep(from, to, loop.experiment().robot);
    });
    real->limitSpeed(experiment.robot);
    real->setPeriod(experiment.sampling.period_s);
}

std::optional<RigCondition> EngineSession::condition(const Experiment& edited) const {
    if (!simulated || edited.rig)
        return std::nullopt;
    RigCondition out = simulated->condition();
    const std::vector<double> before_K = std::exchange(out.objects_K, {});
    const auto& objects = loop.experiment().objects;
    for (const ObjectSpec& object : edited.objects) {
        const auto same = std::ranges::find(objects, object.name, &ObjectSpec::name);
        out.objects_K.push_back(same == objects.end()
                                    ? std::nan("")
                                    : before_K[static_cast<std::size_t>(same - objects.begin())]);
    }
    if (edited.start != loop.experiment().start)
        out.coordinates.reset();
    return out;
}

RigDevices EngineSession::devices(const Experiment& experiment) {
    if (!simulated)
        return {real->robot(), thermometerOf(experiment), real->heatSource(), {}, &tracker,
                true,          thermometer.get()};
    return {simulated->robot(),
            thermometerOf(experiment),
            simulated->heatSource(),
            [this] { return simulated->trueTemperatures_K(); },
            &tracker,
            false,
            thermometer.get()};
}

Thermometer& EngineSession::thermometerOf(const Experiment& experiment) {
    if (thermometer)
        return *thermometer;
    if (simulated)
        return simulated->thermometer();
    return readsByCamera(experiment) ? noCamera : real->thermometer();
}

/// A real source is not known well enough to say how long it takes.
SourceWarmUp EngineSession::warmUp() const {
    const bool isOfRun = isRunOn(loop.state()) && loop.state() != RunState::Stopping;
    const double atStart_K = sourceSetPoint_K(loop.experiment().source, 0.0);
    SourceWarmUp out{isOfRun ? loop.heatSetPoint_K().value_or(atStart_K) : atStart_K};
    if (simulated)
        out.in_s = simulated->simulatedHeatSource().heatingTime_s(out.setPoint_K, SourceWarmUp::kWarm_K);
    return out;
}

void EngineSession::tell(Snapshot& snapshot) const {
    const RigReadings& readings = loop.readings();
    const double now_s = clock().now_s();
    snapshot.state = loop.state();
    snapshot.reasons = loop.reasons();
    snapshot.remedy = loop.remedy();
    snapshot.pending = loop.pending();
    snapshot.canRetreat = loop.keepsFromRetreat().code == MessageCode::None;
    snapshot.isAway = loop.isAway();
    snapshot.runTime_s = loop.runTime_s();
    snapshot.clock_s = now_s;
    snapshot.latest = loop.latest();
    snapshot.simulated = simulated != nullptr;
    if (simulated)
        snapshot.faults = activeFaults(*simulated);
    snapshot.place = loop.motion().placeState();
    snapshot.placeAge_s = loop.motion().placeAge_s();
    // if it is unknown, the robot does not report its position
    if (simulated && snapshot.place != PlaceState::Unknown)
        snapshot.latest.coordinates = simulated->simulatedRobot().coordinates();
    if (real)
        snapshot.devices = real->devices();
    snapshot.sampleTime_s = readings.sampleTime_s();
    snapshot.sampleAge_s = now_s - readings.sampleTime_s();
    for (std::size_t i = 0; i < loop.experiment().objects.size(); ++i) {
        snapshot.sensors.push_back(loop.sensorTrust(i));
        snapshot.readingAges_s.push_back(readings.sensors().age_s(i, now_s));
        snapshot.toldReadings_K.push_back(readings.sensors().told_K(i, now_s));
        snapshot.uncertainties_K.push_back(readings.sensors().uncertainty_K(i));
    }
    snapshot.source_K = readings.source_K();
    snapshot.sourceAge_s = readings.sourceAge_s();
    snapshot.heat = loop.heat().state();
    snapshot.heatOn = loop.heat().isOn();
    snapshot.isMoving = loop.motion().isMoving();
    snapshot.tracking = readings.tracking();
    snapshot.robotAlarm = readings.robot().alarm;
    snapshot.isPlaceSure = readings.robot().isPlaceSure;
    snapshot.heatSetPoint_K = loop.heatSetPoint_K();
    snapshot.unaskedFall = loop.unaskedFall();
    snapshot.warmUp = warmUp();
    snapshot.isSourceManual = real && real->heatSource().isManual();
    snapshot.zeroing = readings.sensors().zeroing();
    if (const auto zero = loop.findZero(); !zero)
        snapshot.zeroProblem = zero.error().message;
    snapshot.controller = loop.experiment().controller;
    snapshot.experiment = loop.experiment().title;
    for (const ObjectSpec& object : loop.experiment().objects) {
        snapshot.objects.push_back(object.name);
        snapshot.targets_K.push_back(object.target_K);
    }
}

bool haveSameSensors(const Experiment& a, const Experiment& b) {
    if (a.objects.size() != b.objects.size() || a.environment_K != b.environment_K ||
        a.rig.has_value() != b.rig.has_value())
        return false;
    if (!std::ranges::equal(a.objects, b.objects, {}, &ObjectSpec::readBy, &ObjectSpec::readBy))
        return false;
    if (a.rig)
        return a.rig->thermometer == b.rig->thermometer &&
               isSameDevice(a.rig->thermalCamera, b.rig->thermalCamera);
    SimulationSpec other = b.simulation; // what is believed of its camera is not simulated
    if (other.thermalCamera && a.simulation.thermalCamera)
        other.thermalCamera->calibration = a.simulation.thermalCamera->calibration;
    return a.simulation == other;
}

} // namespace bask
