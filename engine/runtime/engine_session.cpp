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

/// Whether a sensor of one is read and disturbed as one of the other: all but which objects there are.
bool haveSameSensing(const Experiment& a, const Experiment& b) {
    if (a.environment_K != b.environment_K || a.rig.has_value() != b.rig.has_value())
        return false;
    if (a.rig)
        return a.rig->thermometer == b.rig->thermometer &&
               isSameDevice(a.rig->thermalCamera, b.rig->thermalCamera);
    SimulationSpec other = b.simulation; // what is believed of its camera is not simulated
    if (other.thermalCamera && a.simulation.thermalCamera)
        other.thermalCamera->calibration = a.simulation.thermalCamera->calibration;
    return a.simulation == other;
}

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
    const std::vector<double> offsets_K = std::exchange(out.sensorOffsets_K, {});
    const bool areSensorsKept = haveSameSensing(loop.experiment(), edited);
    for (const auto& before : objectsBefore(loop.experiment(), edited)) {
        out.objects_K.push_back(before ? before_K[*before] : std::nan(""));
        out.sensorOffsets_K.push_back(before && areSensorsKept ? offsets_K[*before] : std::nan(""));
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
    return haveSameSensing(a, b) &&
           std::ranges::equal(a.objects, b.objects, {}, &ObjectSpec::readBy, &ObjectSpec::readBy);
}

std::vector<std::optional<std::size_t>> objectsBefore(const Experiment& before, const Experiment& edited) {
    const auto find = [](const Experiment& in, const ObjectSpec& object) {
        const auto same = std::ranges::find(in.objects, object.name, &ObjectSpec::name);
        return same == in.objects.end() ? std::nullopt
                                        : std::optional(static_cast<std::size_t>(same - in.objects.begin()));
    };
    const bool canBeRenamed = before.objects.size() == edited.objects.size();
    std::vector<std::optional<std::size_t>> out;
    for (std::size_t i = 0; i < edited.objects.size(); ++i) {
        out.push_back(find(before, edited.objects[i]));
        if (!out.back() && canBeRenamed && !find(edited, before.objects[i]))
            out.back() = i;
    }
    return out;
}

std::optional<Zeroing> EngineSession::zeroingFor(const Experiment& other, bool isEdit) const {
    auto zeroing = loop.readings().sensors().zeroing();
    if (!zeroing || !haveSameSensors(loop.experiment(), other))
        return std::nullopt;
    if (!isEdit || !simulated)
        return zeroing;
    const std::vector<double> offsets_K = std::exchange(zeroing->offsets_K, {});
    for (const auto& before : objectsBefore(loop.experiment(), other)) {
        if (!before)
            return std::nullopt;
        zeroing->offsets_K.push_back(offsets_K[*before]);
    }
    return zeroing;
}

std::optional<KeptSensors> EngineSession::sensorsFor(const Experiment& edited) const {
    const Experiment& before = loop.experiment();
    if (!haveSameSensing(before, edited) || before.sampling != edited.sampling)
        return std::nullopt;
    if (real &&
        !haveSameSensors(before, edited)) // its sensors have their places, whatever the objects' names
        return std::nullopt;
    if (real)
        return KeptSensors{loop.readings().sensors(), {}};
    KeptSensors out{{edited.objects.size(), edited.sampling}, {}};
    std::vector<std::optional<std::size_t>> from = objectsBefore(before, edited);
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (!from[i] && edited.objects[i].readBy != ReadBy::Camera)
            out.ofNew.push_back(i);
        else if (from[i] && before.objects[*from[i]].readBy != edited.objects[i].readBy)
            from[i].reset();
    }
    out.channels.useReadings(loop.readings().sensors(), from);
    return out;
}

void EngineSession::useSensors(const KeptSensors& before) {
    loop.useReadings(before.channels);
    if (before.ofNew.empty())
        return;
    const SamplingSpec& sampling = loop.experiment().sampling;
    const double now_s = clock().now_s();
    std::vector<std::vector<Reading>> readings(loop.experiment().objects.size());
    for (int back = sampling.window; back > 0; --back)
        if (const auto told = simulated->thermometer().read())
            for (const std::size_t i : before.ofNew) {
                readings[i].push_back((*told)[i]);
                readings[i].back().time_s = now_s - back * sampling.period_s;
            }
    for (const std::size_t i : before.ofNew)
        loop.restSensor(i, readings[i]);
}

} // namespace bask
