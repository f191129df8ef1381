#include "engine/studies/alarm_draw.h"

#include "engine/base/units.h"
#include "engine/control/controller_catalogue.h"
#include "engine/control/steady_states.h"
#include "engine/rig/rig_setup.h"
#include "engine/studies/camera_sight.h"
#include "engine/studies/study_random.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kMinPower_W_m2 = 200.0; // of a source that is worth its plug
constexpr int kPosesPerSource = 300;     // tried before another source is drawn

double logUniform(StudyRandom& random, double min, double max) {
    return std::exp(uniform(random, std::log(min), std::log(max)));
}

std::size_t oneOf(StudyRandom& random, std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

bool isLikely(StudyRandom& random, double probability) {
    return uniform(random, 0.0, 1.0) < probability;
}

/// From 0.5 mm of PLA, 30 % filled, to 3 mm of aluminium; painted, or bare metal.
Material drawMaterial(StudyRandom& random) {
    Material material;
    if (isLikely(random, 0.5)) {
        material = {
            "PLA", 0.9, 0.9, 1800.0, 1240.0, uniform(random, 0.0005, 0.003), uniform(random, 0.3, 1.0)};
        material.emittance = material.absorptance = uniform(random, 0.85, 0.95);
        return material;
    }
    material = {"aluminium", 0.9, 0.9, 904.0, 2700.0, uniform(random, 0.0005, 0.003), 1.0};
    material.emittance = material.absorptance =
        isLikely(random, 0.25) ? uniform(random, 0.2, 0.4) : uniform(random, 0.85, 0.95);
    return material;
}

/// Targets that a pose holds, which a camera that has to read the objects sees; empty: none was found.
std::vector<double> drawTargets(StudyRandom& random, const RigGeometry& geometry, const CameraSight& sight,
                                const Experiment& experiment) {
    const std::vector<HeatRates> rates = trueRates(experiment);
    for (int attempt = 0; attempt < kPosesPerSource; ++attempt) {
        const Vector6d q = drawAllowedPose(random, geometry, experiment.start);
        const Eigen::VectorXd F = geometry.viewFactorsFast(q);
        const Eigen::VectorXd steady_K = steadyTemperatures_K(rates, geometry.neighbours(), F);
        std::vector<double> targets_K(steady_K.begin(), steady_K.end());
        if (std::ranges::min(targets_K) >= experiment.environment_K + kAlarmMinRise_K &&
            std::ranges::max(targets_K) <= kAlarmMaxTarget_K && sight.isGood(q))
            return targets_K;
    }
    return {};
}

void drawObjects(StudyRandom& random, Experiment& experiment) {
    const std::size_t count = std::min<std::size_t>(1 + oneOf(random, 3), experiment.objects.size());
    experiment.objects.resize(count);
    for (ObjectSpec& object : experiment.objects) {
        if (isLikely(random, 0.5)) {
            object.shape = Disk{uniform(random, 0.01, 0.02)};
            object.origin = {};
        }
        object.material = drawMaterial(random);
        object.simulatedMaterial.reset();
        object.estimatedRates.reset();
    }
}

void drawSource(StudyRandom& random, Experiment& experiment) {
    SourceSpec& source = experiment.source;
    do {
        source.model = isLikely(random, 0.5) ? SourceModel::Gray : SourceModel::Paper;
        source.temperature_K = kelvinFromCelsius(uniform(random, 150.0, 300.0));
        source.emittance = uniform(random, 0.25, 0.95);
    } while (trueSurroundings(experiment, source.temperature_K).netSourcePower_W_m2 < kMinPower_W_m2);
}

void drawEstimates(StudyRandom& random, Experiment& experiment) {
    const std::vector<HeatRates> rates = trueRates(experiment);
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const double heating = logUniform(random, 1.0 / kAlarmEstimateFactor, kAlarmEstimateFactor);
        const double cooling = logUniform(random, 1.0 / kAlarmEstimateFactor, kAlarmEstimateFactor);
        experiment.objects[i].estimatedRates =
            HeatRates{rates[i].lambda1 * heating, rates[i].lambda2 * cooling, rates[i].lambda3 * cooling};
    }
}

Experiment drawExperiment(StudyRandom& random, const Experiment& rig) {
    const auto& controllers = controllerCatalogue();
    static constexpr double kResolutions_K[] = {0.0, 0.01, 0.1};
    Experiment experiment = rig;
    experiment.controller.kind = controllers[oneOf(random, controllers.size())].kind;
    experiment.controller.estimatedRateErrorFactor = 1.0; // the beliefs are drawn below
    SimulationSpec& simulation = experiment.simulation;
    simulation.seed = random();
    simulation.sensorNoise_K = logUniform(random, 0.02, 0.1);
    simulation.sensorResolution_K = kResolutions_K[oneOf(random, std::size(kResolutions_K))];
    simulation.sensorOffset_K = 0.3;
    simulation.sensorLag_s = uniform(random, 0.0, kAlarmLag_s);
    simulation.convection_W_m2K = uniform(random, 0.0, kAlarmConvection_W_m2K);
    simulation.faults.clear();
    for (int attempt = 0; attempt < kMaxDraws / kPosesPerSource; ++attempt) {
        experiment.objects = rig.objects;
        drawObjects(random, experiment);
        drawSource(random, experiment);
        const auto geometry = rigGeometry(experiment);
        experiment.start = drawAllowedPose(random, *geometry, rig.start);
        const CameraSight sight(experiment);
        if (!sight.isGood(experiment.start))
            continue;
        const std::vector<double> targets_K = drawTargets(random, *geometry, sight, experiment);
        if (targets_K.empty())
            continue;
        for (std::size_t i = 0; i < targets_K.size(); ++i)
            experiment.objects[i].target_K = targets_K[i];
        drawEstimates(random, experiment);
        return experiment;
    }
    throw std::invalid_argument("study of alarms: no pose holds the objects warm enough");
}

/// Targets changed, a hold, a second run after a stopped one.
std::vector<AlarmAction> drawActions(StudyRandom& random, const Experiment& experiment) {
    using Kind = AlarmAction::Kind;
    const auto geometry = rigGeometry(experiment);
    const CameraSight sight(experiment);
    std::vector<AlarmAction> actions;
    const auto newTargets = [&](double time_s, Kind kind) {
        if (auto targets_K = drawTargets(random, *geometry, sight, experiment); !targets_K.empty())
            actions.push_back({time_s, kind, std::move(targets_K)});
    };
    for (std::size_t n = oneOf(random, 3); n > 0; --n)
        newTargets(uniform(random, 60.0, kAlarmRun_s), Kind::SetTargets);
    if (isLikely(random, 0.5)) {
        const double hold_s = uniform(random, 30.0, kAlarmRun_s - 200.0);
        actions.push_back({hold_s, Kind::Hold});
        actions.push_back({hold_s + uniform(random, 5.0, 150.0), Kind::Resume});
    }
    if (isLikely(random, 0.4))
        newTargets(uniform(random, 200.0, kAlarmRun_s - 300.0), Kind::Stop);
    std::ranges::stable_sort(actions, {}, &AlarmAction::time_s);
    return actions;
}

/// The rig with the usual thermal camera at its usual place, which is known.
Experiment readSo(Experiment rig, ReadBy readBy) {
    if (readBy == ReadBy::Contact)
        return rig;
    rig.simulation.thermalCamera.emplace();
    for (ObjectSpec& object : rig.objects)
        object.readBy = readBy;
    return rig;
}

void drawCamera(StudyRandom& random, Experiment& experiment) {
    experiment.simulation.thermalCamera->noise_K = logUniform(random, 0.02, 0.1);
    for (ObjectSpec& object : experiment.objects) {
        object.simulatedMaterial = trueMaterial(object);
        if (isLikely(random, 0.5))
            object.material.emittance =
                std::min(object.material.emittance + uniform(random, -kAlarmEmittance, kAlarmEmittance), 1.0);
    }
}

void addFault(StudyRandom& random, AlarmCase& drawn) {
    drawn.fault.object = oneOf(random, drawn.experiment.objects.size());
    drawn.fault.time_s = uniform(random, 60.0, 900.0);
    // What happens before belongs to the draw; after it the operator is not there.
    std::erase_if(drawn.actions,
                  [&](const AlarmAction& action) { return action.time_s > drawn.fault.time_s - 30.0; });
    const bool isPaused = !drawn.actions.empty() && drawn.actions.back().kind == AlarmAction::Kind::Hold;
    if (isPaused)
        drawn.actions.pop_back();
    switch (drawn.fault.fault) {
    case SimulatedFault::SourceHeatsAlone: // those with its heat off
    case SimulatedFault::SourceKeepsHeat:
        drawn.actions.push_back({drawn.fault.time_s + 5.0, AlarmAction::Kind::Stop});
        break;
    case SimulatedFault::SensorOff: // also one that is cold at once, as when its wire breaks to another's
        drawn.offLag_s = isLikely(random, 0.25) ? 0.0 : logUniform(random, 1.0, kAlarmOffLag_s);
        break;
    case SimulatedFault::SourceCovered:
        drawn.experiment.source.tracked = true;
        break;
    case SimulatedFault::CameraLost: // the camera that follows the source, where there is no thermal one
        drawn.experiment.source.tracked = !drawn.experiment.simulation.thermalCamera;
        break;
    default:
        break;
    }
}

} // namespace

std::vector<SimulatedFault> alarmFaults(ReadBy readBy) {
    std::vector<SimulatedFault> faults;
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        const bool isOfSensor = isOfObject(fault) && fault != SimulatedFault::ObjectHot;
        if (readBy == ReadBy::Both ||
            (fault != SimulatedFault::SensorsSwapped && !(isOfSensor && readBy == ReadBy::Camera)))
            faults.push_back(fault);
    }
    return faults;
}

double alarmFaultFrequency(SimulatedFault fault) {
    switch (fault) {
    case SimulatedFault::None:
        return 0.0;
    case SimulatedFault::SourceCovered:
        return 20.0;
    case SimulatedFault::SensorLost:
    case SimulatedFault::SensorOpen:
        return 10.0;
    case SimulatedFault::SensorJumping:
    case SimulatedFault::SensorOff:
        return 8.0;
    case SimulatedFault::RobotAlarm:
        return 5.0;
    case SimulatedFault::SensorShort:
    case SimulatedFault::RobotSlow:
    case SimulatedFault::SourceNotHeating:
    case SimulatedFault::SourceLimited:
    case SimulatedFault::CameraLost:
        return 3.0;
    case SimulatedFault::SensorFrozen:
    case SimulatedFault::RobotLost:
    case SimulatedFault::RobotRestarted:
    case SimulatedFault::SourceLost:
    case SimulatedFault::SourceSilent:
        return 2.0;
    case SimulatedFault::ObjectHot:
    case SimulatedFault::SensorsSwapped:
        return 1.0;
    case SimulatedFault::SourceOverheats:
    case SimulatedFault::SourceKeepsHeat:
        return 0.3;
    case SimulatedFault::SourceHeatsAlone:
        return 0.1;
    }
    throw std::logic_error("alarmFaultFrequency: no such fault");
}

AlarmCase drawAlarmCase(const std::vector<Experiment>& rigs, AlarmDraw draw, ReadBy readBy,
                        std::uint64_t seed, int index) {
    StudyRandom random = studyRandom(seed, index);
    const auto job = static_cast<std::size_t>(index);
    AlarmCase drawn;
    drawn.duration_s = kAlarmRun_s;
    if (draw == AlarmDraw::Paper) {
        drawn.experiment = readSo(rigs.at(job / 2 % rigs.size()), readBy);
        if (job % 2 == 1)
            drawn.experiment.controller.kind = ControllerKind::LevelServo;
        drawn.experiment.simulation.seed = seed + job / (2 * rigs.size());
        drawn.duration_s = drawn.experiment.simulation.durationLimit_s;
    } else {
        if (draw == AlarmDraw::Faulty) {
            const std::vector<SimulatedFault> faults = alarmFaults(readBy);
            drawn.fault.fault = faults[job % faults.size()];
        }
        const std::size_t minObjects = drawn.fault.fault == SimulatedFault::SensorsSwapped ? 2 : 1;
        if (std::ranges::none_of(rigs,
                                 [&](const Experiment& rig) { return rig.objects.size() >= minObjects; }))
            throw std::invalid_argument("study of alarms: no rig has the objects of the fault");
        do
            drawn.experiment = drawExperiment(random, readSo(rigs.at(oneOf(random, rigs.size())), readBy));
        while (drawn.experiment.objects.size() < minObjects);
        drawn.actions = drawActions(random, drawn.experiment);
    }
    if (readBy != ReadBy::Contact)
        drawCamera(random, drawn.experiment);
    if (draw == AlarmDraw::Faulty)
        addFault(random, drawn);
    return drawn;
}

} // namespace bask
