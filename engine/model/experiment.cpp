#include "engine/model/experiment.h"

#include "engine/base/edge_units.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"
#include "engine/control/controller_catalogue.h"
#include "engine/model/checker.h"
#include "engine/model/coordinate_range.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/material_library.h"
#include "engine/model/shape_check.h"
#include "engine/model/uneven_source.h"
#include "engine/thermography/camera_profile.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/face_temperature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace bask {
namespace {

using std::to_string;

constexpr int kOutlineSamples = 256;
constexpr std::size_t kMaxTitleLength = 1000;
constexpr double kMaxSourceRadius_m = 10.0;
constexpr double kMaxUncertainty_mm = 20.0; // of a thermal camera's place, at the objects
constexpr double kSamePlace = 1e-9;         // m, rad
constexpr double kMaxRendered_px = 4096.0;  // of a simulated camera, whose pictures are painted one by one
constexpr double kMaxMarkers = 64.0;

/// Calls checkValue(path of the point, value) for each point of a table; its times must not be negative and
/// grow.
template <class T, class CheckValue>
void checkTimeTable(Checker& check, const std::string& path, const TimeTable<T>& table,
                    CheckValue checkValue) {
    for (std::size_t i = 0; i < table.size() && !check.failed(); ++i) {
        const std::string point = path + '[' + to_string(i) + "].";
        check.range(point + "time_s", table[i].time_s, 0.0, kMaxRunTime_s, "s");
        if (i > 0 && !(table[i].time_s > table[i - 1].time_s))
            check.fail(MessageCode::TimesNotGrowing, point + "time_s",
                       {formatNumber(table[i].time_s, 10), formatNumber(table[i - 1].time_s, 10)});
        checkValue(point, table[i].value);
    }
}

/// h is given as a number and by a word.
void failTwice(Checker& check, const std::string& path) {
    check.fail(MessageCode::JsonTwoSpellings, path + "convection", {"convection", "convection_W_m2K"});
}

void checkSource(Checker& check, const Experiment& e) {
    checkShape(check, "source.contour", e.source.shape, e.source.origin, kMaxSourceRadius_m);
    const auto temperature = [&](const std::string& path, double value_K) {
        check.quantity(path, "temperature", EdgeUnit::Temperature, value_K, kMinTemperature_degC,
                       kMaxTemperature_degC);
    };
    check.parameters("source.", sourceParameters(), e.source);
    checkTimeTable(check, "source.temperature_profile", e.source.temperatureProfile, temperature);
    checkCoordinates(check, "source.pose.", e.source.pose, kMaxPlace_cm, true);
    check.quantity("environment.", "temperature", EdgeUnit::Temperature, e.environment_K, -50.0, 500.0);
    check.parameters("air.", airParameters(), e.air);
    if (e.air.isNatural && e.air.convection_W_m2K)
        failTwice(check, "air.");
    if (check.failed())
        return;
    const double J =
        netSourcePower_W_m2(e.source.model, e.source.temperature_K, e.source.emittance, e.environment_K);
    if (!(J > 0.0))
        check.fail(MessageCode::SourceTooWeak, "source", {formatNumber(J)});
    checkUnevenness(check, "source.", e.source.uneven, e, e.source.emittance);
}

void checkName(Checker& check, const std::string& where, const std::string& name,
               std::set<std::string>& names) {
    const bool blank = name.find_first_not_of(" \t\r\n") == std::string::npos;
    if (blank)
        check.fail(MessageCode::NameEmpty, where);
    else
        check.name(where, name);
    if (!check.failed() && !names.insert(name).second)
        check.fail(MessageCode::DuplicateName, where, {name});
}

void checkObject(Checker& check, const std::string& path, const ObjectSpec& object,
                 std::set<std::string>& names) {
    checkName(check, path + ".name", object.name, names);
    checkShape(check, path + ".contour", object.shape, object.origin, kMaxObjectRadius_m);
    checkMaterial(check, path + ".material.", object.material);
    if (object.simulatedMaterial)
        checkMaterial(check, path + ".simulated_material.", *object.simulatedMaterial);
    checkCoordinates(check, path + ".mounting.", object.mounting, kMaxMounting_cm, false);
    check.quantity(path + ".", "target", EdgeUnit::Temperature, object.target_K, kMinTemperature_degC,
                   kMaxTemperature_degC);
    check.parameters(path + ".", objectLimitParameters(), object);
    if (object.estimatedRates)
        check.parameters(path + ".believed_rates.", heatRateParameters(), *object.estimatedRates);
}

void checkObjects(Checker& check, const Experiment& e) {
    if (e.objects.empty())
        return check.fail(MessageCode::NoObjects, "objects");
    const int freedom = e.robot.degreesOfFreedom();
    if (freedom == 0)
        return check.fail(MessageCode::NoFreeAxis, "robot.free");
    if (std::cmp_greater(e.objects.size(), freedom))
        return check.fail(MessageCode::TooManyObjects, "objects",
                          {to_string(e.objects.size()), to_string(freedom)});
    std::set<std::string> names;
    for (std::size_t i = 0; i < e.objects.size() && !check.failed(); ++i)
        checkObject(check, "objects[" + to_string(i) + "]", e.objects[i], names);
}

void checkPlates(Checker& check, const Experiment& e) {
    std::set<std::string> names;
    for (const ObjectSpec& object : e.objects)
        names.insert(object.name);
    const auto checkEach = [&](const std::vector<PlateSpec>& plates, const std::string& list,
                               const std::string& pose, double max_m, double maxPlace_cm) {
        if (plates.size() > kMaxPlates)
            check.range(list, static_cast<double>(plates.size()), 0.0, static_cast<double>(kMaxPlates));
        for (std::size_t i = 0; i < plates.size() && !check.failed(); ++i) {
            const std::string path = list + '[' + to_string(i) + "].";
            checkName(check, path + "name", plates[i].name, names);
            checkShape(check, path + "contour", plates[i].shape, plates[i].origin, max_m);
            checkCoordinates(check, path + pose, plates[i].pose, maxPlace_cm, false);
        }
    };
    checkEach(e.fixtures, "fixtures", "mounting.", kMaxObjectRadius_m, kMaxMounting_cm);
    checkEach(e.shields, "shields", "pose.", kMaxSourceRadius_m, kMaxPlace_cm);
}

void checkRobot(Checker& check, const Experiment& e) {
    const RobotLimits& robot = e.robot;
    check.parameters("robot.", robotParameters(), robot);
    for (int k = 0; k < 6 && !check.failed(); ++k) {
        const auto name = kCoordinateNames[static_cast<std::size_t>(k)];
        const EdgeUnit unit = coordinateUnit(k);
        const auto [min, max, unused] = coordinateRange(k, kMaxPlace_cm, true);
        check.quantity("robot.lower.", name, unit, robot.lower[k], min, max);
        check.quantity("robot.upper.", name, unit, robot.upper[k], min, max);
        const bool free = robot.free[static_cast<std::size_t>(k)];
        if (robot.lower[k] > robot.upper[k] || (free && robot.lower[k] == robot.upper[k]))
            check.fail(MessageCode::LimitsReversed, "robot.lower." + readableKey(name, unit),
                       {formatNumber(fromSi(robot.lower[k], unit).value),
                        formatNumber(fromSi(robot.upper[k], unit).value)});
    }
}

/// Least and greatest height (m) over the source plane of any point of a shape's outline.
struct HeightRange {
    double min_m, max_m;
};

HeightRange heightsOf(const Shape& shape, const Pose& X_SB) {
    const Eigen::RowVector2d slope = X_SB.linear().block<1, 2>(2, 0);
    const double origin_m = X_SB.translation().z();
    if (const auto* disk = outlineAs<Disk>(shape)) {
        const double rise_m = disk->radius_m * slope.norm();
        return {origin_m - rise_m, origin_m + rise_m};
    }
    HeightRange heights{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Eigen::Vector2d& p : shapeOutline(shape, kOutlineSamples)) {
        heights.min_m = std::min(heights.min_m, origin_m + slope.dot(p));
        heights.max_m = std::max(heights.max_m, origin_m + slope.dot(p));
    }
    return heights;
}

/// At every pose that the source is said to have: between those of its motion nobody looks.
void checkShields(Checker& check, const Experiment& e) {
    std::vector<Vector6d> sources{e.source.pose, e.simulation.sourcePose.value_or(e.source.pose)};
    for (const auto& [unused_s, pose] : e.simulation.sourceMotion)
        sources.push_back(pose);
    for (std::size_t i = 0; i < e.shields.size(); ++i)
        for (const Vector6d& source : sources) {
            const Pose X_SB = poseFromCoordinates(source).inverse() * poseFromCoordinates(e.shields[i].pose);
            const double height_m = heightsOf(e.shields[i].shape, X_SB).min_m;
            if (!(height_m >= kMinShieldHeight_m - 1e-9))
                check.fail(MessageCode::ShieldBelowSource, "shields[" + to_string(i) + "].pose",
                           {formatNumber(height_m * 1e3), formatNumber(kMinShieldHeight_m * 1e3)});
        }
}

void checkStart(Checker& check, const Experiment& e) {
    for (int k = 0; k < 6 && !check.failed(); ++k) {
        const double value = e.start[k];
        if (value >= e.robot.lower[k] && value <= e.robot.upper[k])
            continue;
        const EdgeUnit unit = coordinateUnit(k);
        const auto name = kCoordinateNames[static_cast<std::size_t>(k)];
        const auto text = [unit](double si) {
            return formatNumber(fromSi(si, unit).value, 6) + ' ' + std::string(readableUnit(unit));
        };
        check.fail(MessageCode::StartOutsideWorkspace, "robot.start." + readableKey(name, unit),
                   {name, text(value), text(e.robot.lower[k]), text(e.robot.upper[k])});
    }
    if (check.failed())
        return;
    const Pose X_SR = poseFromCoordinates(e.source.pose).inverse();
    const Pose X_SE = X_SR * poseFromCoordinates(e.start);
    double floor_m = 0.0;
    const PlateSpec* highest = nullptr;
    for (const PlateSpec& shield : e.shields)
        if (const double top_m = heightsOf(shield.shape, X_SR * poseFromCoordinates(shield.pose)).max_m;
            top_m > floor_m) {
            floor_m = top_m;
            highest = &shield;
        }
    const double least_m = floor_m + e.robot.clearance_m;
    const auto checkHeld = [&](const std::string& name, const Shape& shape, const Vector6d& mounting) {
        const double height_m = heightsOf(shape, X_SE * poseFromCoordinates(mounting)).min_m;
        if (height_m >= least_m - 1e-9)
            return;
        const std::string is = formatNumber(height_m * 1e3), needed = formatNumber(least_m * 1e3);
        if (highest)
            check.fail(MessageCode::StartTooCloseToShield, "robot.start",
                       {name, is, needed, highest->name, formatNumber(floor_m * 1e3)});
        else
            check.fail(MessageCode::StartTooClose, "robot.start", {name, is, needed});
    };
    for (const ObjectSpec& object : e.objects)
        checkHeld(object.name, object.shape, object.mounting);
    for (const PlateSpec& fixture : e.fixtures)
        checkHeld(fixture.name, fixture.shape, fixture.pose);
}

void checkController(Checker& check, const ControllerSettings& c) {
    for (const ControllerEntry& entry : controllerCatalogue())
        for (const ControllerGain& gain : entry.gains)
            check.parameter(std::string("controller.") + entry.group + '.', *gain.facts, gain.get(c));
    check.parameters("controller.", controllerParameters(), c);
}

void checkSampling(Checker& check, const SamplingSpec& s) {
    check.range("sampling.window", s.window, s.order + 1, 1000, "samples");
    check.parameters("sampling.", samplingParameters(), s);
}

void checkSimulation(Checker& check, const SimulationSpec& s, double period_s) {
    check.parameters("simulation.", simulationParameters(), s);
    if (s.naturalConvection && s.convection_W_m2K != 0.0)
        failTwice(check, "simulation.");
    check.range("simulation.duration_limit_s", s.durationLimit_s, period_s, kMaxRunTime_s, "s");
}

/// With its place inside of a larger part.
Result<void> inside(const std::string& path, Result<void> result) {
    if (result)
        return result;
    Error error = result.error();
    error.where = path + error.where;
    return error;
}

void checkCameraModel(Checker& check, const std::string& path, const CameraModel& camera) {
    check.parameters(path, cameraModelParameters(), camera);
    const std::size_t coefficients = camera.distortion.size();
    if (coefficients != 0 && coefficients != 4 && coefficients != 5 && coefficients != 8)
        check.fail(MessageCode::DistortionUnusable, path + "distortion", {to_string(coefficients)});
    for (const double k : camera.distortion)
        check.range(path + "distortion", k, -1e4, 1e4);
    for (const double deviation : camera.deviations)
        check.range(path + "deviations", deviation, 0.0, 1e6);
    if (camera.rms_px)
        check.range(path + "rms_px", *camera.rms_px, 0.0, 1e4, "px");
}

void checkVision(Checker& check, const Experiment& e) {
    const VisionSpec& vision = e.vision;
    if (!isMarkerDictionary(vision.dictionary))
        return check.fail(MessageCode::ValueUnknown, "vision.dictionary",
                          {vision.dictionary, markerDictionaries()});
    check.range("vision.markers", static_cast<double>(vision.markers.size()), 0.0, kMaxMarkers, "markers");
    for (std::size_t i = 0; i < vision.markers.size() && !check.failed(); ++i)
        checkCoordinates(check, "vision.markers[" + to_string(i) + "].pose.", vision.markers[i].pose,
                         kMaxPlace_cm, true);
    check.take(inside("vision.", checkLayout(markerLayout(vision))));
    if (vision.camera)
        checkCameraModel(check, "vision.camera.", *vision.camera);
    if (vision.cameraPose)
        checkCoordinates(check, "vision.camera_pose.", *vision.cameraPose, kMaxPlace_cm, false);
    if (e.source.tracked && vision.marks(Part::Source) && !vision.followsSource())
        check.fail(MessageCode::SourceNotFollowed, "source.tracked");
}

void checkSimulatedCamera(Checker& check, const SimulatedCameraSpec& camera) {
    const std::string path = "simulation.camera.";
    if (camera.model) {
        checkCameraModel(check, path + "model.", *camera.model);
        check.range(path + "model.width_px", camera.model->width, 16.0, kMaxRendered_px, "px");
        check.range(path + "model.height_px", camera.model->height, 16.0, kMaxRendered_px, "px");
    }
    if (camera.pose)
        checkCoordinates(check, path + "pose.", *camera.pose, kMaxPlace_cm, false);
    check.parameters(path, simulatedCameraParameters(), camera);
}

/// The lens of a thermal camera, for pictures of its profile's size.
void checkThermalLens(Checker& check, const std::string& path, const CameraModel& lens,
                      const ThermalProfile& profile) {
    checkCameraModel(check, path, lens);
    if (check.failed())
        return;
    check.range(path + "width_px", lens.width, profile.width, profile.width, "px");
    check.range(path + "height_px", lens.height, profile.height, profile.height, "px");
    if (!check.failed() && !PixelRays::isUsable(lens))
        check.fail(MessageCode::LensNotInvertible, path + "distortion");
}

void checkThermalCalibration(Checker& check, const std::string& path, const ThermalCalibration& calibration,
                             const ThermalProfile& profile) {
    if (calibration.lens)
        checkThermalLens(check, path + "lens.", *calibration.lens, profile);
    if (calibration.pose)
        checkCoordinates(check, path + "pose.", *calibration.pose, kMaxPlace_cm, false);
    if (calibration.poseUncertainty_m)
        check.quantity(path, "pose_uncertainty", EdgeUnit::LengthMm, *calibration.poseUncertainty_m, 0.0,
                       kMaxUncertainty_mm);
}

/// Refuses a target that the camera cannot tell, of a face that reflects the room: one of low emittance looks
/// cooler than it is.
Result<void> checkTold(const ObjectSpec& object, const ThermalProfile& profile, double environment_K) {
    const FaceSurroundings face{object.material.emittance, {}, environment_K};
    const auto band = bandOf(profile);
    const auto limit_K = [&](double apparent_K, double otherwise_degC) {
        const auto limit = faceTemperature(*band, face, apparent_K);
        return limit ? limit->T_K : kelvinFromCelsius(otherwise_degC);
    };
    const double min_K = limit_K(profile.min_K, kMinTemperature_degC);
    const double max_K =
        limit_K(std::min(profile.max_K, profile.warnAbove_K.value_or(profile.max_K)), kMaxTemperature_degC);
    if (object.target_K >= min_K && object.target_K <= max_K)
        return {};
    return Error(
        MessageCode::TargetNotTold, {},
        {object.name, temperatureArg(object.target_K), temperatureArg(min_K), temperatureArg(max_K)});
}

void checkReadings(Checker& check, const Experiment& e) {
    constexpr double kOldest_s = 0.8; // of a frame: behind a closed shutter and under way
    for (std::size_t i = 0; i < e.objects.size(); ++i) {
        if (e.objects[i].readBy == ReadBy::Contact)
            continue;
        if (!e.rig && !e.simulation.thermalCamera)
            check.fail(MessageCode::ReadByNoCamera, "objects[" + to_string(i) + "].read_by",
                       {e.objects[i].name});
        check.range("sampling.period_s", e.sampling.period_s, kOldest_s / e.safety.stalePeriods, 60.0, "s");
    }
    if (!e.rig || !e.rig->thermalCamera)
        return;
    checkThermalCalibration(check, "rig.thermal_camera.", e.rig->thermalCamera->calibration,
                            e.rig->thermalCamera->profile);
}

void checkSimulatedThermalCamera(Checker& check, const SimulatedThermalCameraSpec& camera) {
    const std::string path = "simulation.thermal_camera.";
    std::string names;
    const ThermalProfile* known = nullptr;
    for (const ThermalProfile& profile : shippedThermalProfiles()) {
        names += (names.empty() ? "" : ", ") + profile.name;
        if (profile.name == camera.profile && profile.frameRate_Hz)
            known = &profile;
    }
    if (known == nullptr)
        check.fail(MessageCode::ValueUnknown, path + "profile", {plainWords(camera.profile), names});
    else
        checkThermalCalibration(check, path + "calibration.", camera.calibration, *known);
    if (camera.pose)
        checkCoordinates(check, path + "pose.", *camera.pose, kMaxPlace_cm, false);
    check.parameters(path, simulatedThermalCameraParameters(), camera);
}

/// The trip limits must lie over the warning limits, and the source's over what it is asked for.
void checkSafety(Checker& check, const Experiment& e) {
    const SafetySpec& s = e.safety;
    const auto limit = [&](const std::string& path, std::string_view name, double value_K, double min_K) {
        check.quantity(path, name, EdgeUnit::Temperature, value_K,
                       std::max(kMinTemperature_degC, celsiusFromKelvin(min_K)), kMaxTemperature_degC);
    };
    check.parameters("safety.", safetyParameters(), s);
    limit("safety.", "trip", s.trip_K, s.warning_K);
    for (std::size_t i = 0; i < e.objects.size() && !check.failed(); ++i)
        limit("objects[" + to_string(i) + "].", "trip", tripLimit_K(e, e.objects[i]),
              warningLimit_K(e, e.objects[i]));
    if (s.sourceTrip_K)
        limit("safety.", "source_trip", *s.sourceTrip_K, highestSetPoint_K(e.source));
}

void checkFaults(Checker& check, const Experiment& e) {
    const std::vector<ScriptedFault>& faults = e.simulation.faults;
    for (std::size_t i = 0; i < faults.size() && !check.failed(); ++i) {
        const std::string path = "simulation.faults[" + to_string(i) + "].";
        check.range(path + "time_s", faults[i].time_s, 0.0, kMaxRunTime_s, "s");
        if (faults[i].until_s)
            check.range(path + "until_s", *faults[i].until_s, faults[i].time_s, kMaxRunTime_s, "s");
        if (faults[i].object >= e.objects.size())
            check.fail(MessageCode::ValueOutOfRange, path + "object",
                       {to_string(static_cast<std::ptrdiff_t>(faults[i].object)), "0",
                        to_string(e.objects.size() - 1), ""});
    }
}

void checkTrueUnevenness(Checker& check, const Experiment& e, double emittance) {
    if (e.simulation.sourceUneven)
        checkUnevenness(check, "simulation.source_", *e.simulation.sourceUneven, e, emittance);
}

/// The simulated source: where it goes and what it truly is.
void checkTrueSource(Checker& check, const Experiment& e) {
    const TimeTable<Vector6d>& motion = e.simulation.sourceMotion;
    const Vector6d first = e.simulation.sourcePose.value_or(e.source.pose);
    checkCoordinates(check, "simulation.source_pose.", first, kMaxPlace_cm, true);
    const std::string path = "simulation.source_motion";
    checkTimeTable(check, path, motion, [&](const std::string& point, const Vector6d& q) {
        checkCoordinates(check, point, q, kMaxPlace_cm, false);
    });
    for (int k = 0; k < 6 && !motion.empty() && !check.failed(); ++k) {
        const EdgeUnit unit = coordinateUnit(k);
        const auto name = kCoordinateNames[static_cast<std::size_t>(k)];
        const auto text = [unit](double si) {
            return formatNumber(fromSi(si, unit).value, 6) + ' ' + std::string(readableUnit(unit));
        };
        if (std::abs(motion.front().value[k] - first[k]) > kSamePlace)
            check.fail(MessageCode::MotionElsewhere, path + "[0]." + readableKey(name, unit),
                       {name, text(motion.front().value[k]), text(first[k])});
    }
    if (check.failed())
        return;
    if (!e.simulation.sourceEmittance)
        return checkTrueUnevenness(check, e, e.source.emittance);
    check.positive("simulation.source_emittance", *e.simulation.sourceEmittance, 1.0);
    const double J = netSourcePower_W_m2(e.source.model, e.source.temperature_K,
                                         *e.simulation.sourceEmittance, e.environment_K);
    if (!check.failed() && !(J > 0.0))
        check.fail(MessageCode::SourceTooWeak, "simulation.source_emittance", {formatNumber(J)});
    checkTrueUnevenness(check, e, *e.simulation.sourceEmittance);
}

} // namespace

Result<OriginalShape> shapeFromOutline(const Contour& outline, const std::vector<Contour>& holes,
                                       int harmonics) {
    const Eigen::Vector2d centroid = contourCentroid(outline);
    OriginalShape made;
    made.origin.outline = shifted(outline, -centroid);
    made.origin.harmonics = harmonics;
    for (const Contour& hole : holes)
        made.origin.holes.push_back(shifted(hole, -centroid));
    if (harmonics == 0) {
        made.shape = withHoles(made.origin.outline, made.origin.holes);
    } else {
        const Result<FourierFit> fit = fitFourier(made.origin.outline, harmonics);
        if (!fit)
            return fit.error();
        made.shape = shapeOfFit(*fit, made.origin.holes);
    }
    if (const auto whole = checkHoles(made.shape, "holes"); !whole)
        return whole.error();
    return made;
}

double sourceSetPoint_K(const SourceSpec& source, double time_s) {
    return valueAt(source.temperatureProfile, time_s, source.temperature_K);
}

double highestSetPoint_K(const SourceSpec& source) {
    double highest_K = source.temperatureProfile.empty() ? source.temperature_K : 0.0;
    for (const auto& [unused_s, value_K] : source.temperatureProfile)
        highest_K = std::max(highest_K, value_K);
    return highest_K;
}

double warningLimit_K(const Experiment& experiment, const ObjectSpec& object) {
    return object.warning_K.value_or(experiment.safety.warning_K);
}

double tripLimit_K(const Experiment& experiment, const ObjectSpec& object) {
    return object.trip_K.value_or(experiment.safety.trip_K);
}

const char* readByName(ReadBy readBy) {
    switch (readBy) {
    case ReadBy::Contact:
        break;
    case ReadBy::Camera:
        return "camera";
    case ReadBy::Both:
        return "both";
    }
    return "contact";
}

std::optional<ThermalProfile> thermalProfile(const Experiment& experiment, bool simulated) {
    if (!simulated)
        return experiment.rig && experiment.rig->thermalCamera
                   ? std::optional(experiment.rig->thermalCamera->profile)
                   : std::nullopt;
    if (!experiment.simulation.thermalCamera && !readsByCamera(experiment))
        return std::nullopt;
    return findThermalProfile(
               experiment.simulation.thermalCamera.value_or(SimulatedThermalCameraSpec()).profile)
        .value();
}

ThermalCalibration thermalCalibration(const Experiment& experiment, bool simulated) {
    if (simulated)
        return experiment.simulation.thermalCamera.value_or(SimulatedThermalCameraSpec()).calibration;
    return experiment.rig && experiment.rig->thermalCamera ? experiment.rig->thermalCamera->calibration
                                                           : ThermalCalibration();
}

void calibrateThermalCamera(Experiment& experiment, const ThermalCalibration& calibration) {
    if (!experiment.rig) {
        auto& camera = experiment.simulation.thermalCamera;
        camera = camera.value_or(SimulatedThermalCameraSpec());
        camera->calibration = calibration;
    } else if (experiment.rig->thermalCamera) {
        experiment.rig->thermalCamera->calibration = calibration;
    }
}

bool readsByCamera(const Experiment& experiment) {
    return std::ranges::any_of(experiment.objects,
                               [](const ObjectSpec& object) { return object.readBy != ReadBy::Contact; });
}

std::size_t contactSensors(const std::vector<ObjectSpec>& objects) {
    return static_cast<std::size_t>(std::ranges::count_if(
        objects, [](const ObjectSpec& object) { return object.readBy != ReadBy::Camera; }));
}

double sourceTripLimit_K(const Experiment& experiment) {
    return experiment.safety.sourceTrip_K.value_or(highestSetPoint_K(experiment.source) +
                                                   SafetySpec::kSourceOver_K);
}

Result<void> checkTargets(const Experiment& experiment) {
    for (const ObjectSpec& object : experiment.objects)
        if (const double limit_K = warningLimit_K(experiment, object); object.target_K > limit_K + 1e-6)
            return Error(MessageCode::TargetAboveWarning, {},
                         {object.name, temperatureArg(object.target_K, 6), temperatureArg(limit_K, 6)});
    if (!readsByCamera(experiment))
        return {};
    const auto profile = thermalProfile(experiment, !experiment.rig);
    for (const ObjectSpec& object : experiment.objects)
        if (profile && object.readBy == ReadBy::Camera) // else a sensor tells whether it is met
            if (auto told = checkTold(object, *profile, experiment.environment_K); !told)
                return told;
    return {};
}

Result<void> validate(const Experiment& e) {
    Checker check;
    if (const std::size_t length = characterCount(e.title); length > kMaxTitleLength)
        check.range("title", static_cast<double>(length), 0.0, kMaxTitleLength, "characters");
    if (printable(e.title) != e.title)
        check.fail(MessageCode::NameNotPlain, "title");
    checkSource(check, e);
    checkObjects(check, e);
    checkPlates(check, e);
    checkRobot(check, e);
    checkController(check, e.controller);
    checkSampling(check, e.sampling);
    checkSimulation(check, e.simulation, e.sampling.period_s);
    checkTrueSource(check, e);
    checkSimulatedCamera(check, e.simulation.camera);
    if (e.simulation.thermalCamera)
        checkSimulatedThermalCamera(check, *e.simulation.thermalCamera);
    checkReadings(check, e);
    checkVision(check, e);
    if (e.rig && !check.failed())
        check.take(inside("rig.", checkRig(*e.rig, contactSensors(e.objects), e.robot.free)));
    checkSafety(check, e);
    checkFaults(check, e);
    if (!check.failed())
        checkShields(check, e);
    if (!check.failed())
        checkStart(check, e);
    return check.result();
}

Result<void> setTargets(Experiment& experiment, const std::vector<double>& targets_K) {
    if (targets_K.size() != experiment.objects.size())
        return Error(MessageCode::TargetCountWrong, "targets",
                     {to_string(targets_K.size()), to_string(experiment.objects.size())});
    Experiment changed = experiment;
    for (std::size_t i = 0; i < targets_K.size(); ++i)
        changed.objects[i].target_K = targets_K[i];
    if (auto valid = validate(changed); !valid)
        return valid.error();
    experiment = std::move(changed);
    return {};
}

} // namespace bask
