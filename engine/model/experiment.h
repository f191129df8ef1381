#pragma once
// The experiment as one value: source, environment, objects, robot, controller, sampling, simulation, seed.

#include "engine/base/result.h"
#include "engine/base/time_table.h"
#include "engine/control/controller_settings.h"
#include "engine/control/robot_limits.h"
#include "engine/model/rig_spec.h"
#include "engine/model/safety_spec.h"
#include "engine/model/thermal_camera_spec.h"
#include "engine/model/vision_spec.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/shape.h"
#include "engine/thermal/heat_balance.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Valid range of targets and source temperatures.
inline constexpr double kMinTemperature_degC = -50.0;
inline constexpr double kMaxTemperature_degC = 2000.0;

/// Where a shape came from, stored so that it can be fitted again with another number of harmonics.
struct ContourOrigin {
    std::string file;             ///< as given; only informative once the outline is embedded
    Contour outline;              ///< imported outline, centred; empty for a disk or for plain coefficients
    int harmonics = 0;            ///< number of harmonics of the present fit; 0: none
    std::vector<Contour> holes{}; ///< in the imported outline, in its coordinates
    bool operator==(const ContourOrigin&) const = default;
};

/// A shape and the outline it was made from.
struct OriginalShape {
    Shape shape;
    ContourOrigin origin; ///< without a file
};

/// Fits an outline with holes, as imported or as stored in an origin, with this number of harmonics (0: the
/// polygon itself), centred; it can be fitted again later. Errors: those of fitFourier, and those of
/// checkHoles with "holes[k]" as place if the fit cuts a hole: use more harmonics.
Result<OriginalShape> shapeFromOutline(const Contour& outline, const std::vector<Contour>& holes,
                                       int harmonics);

/// A part of an uneven source: a shape in the xy-plane of its frame P, emitting along +z. It has a
/// temperature of its own (see PartTemperature) and, if it is not empty, an emittance.
struct SourcePartSpec {
    Shape shape;
    ContourOrigin origin{};
    Vector6d pose = Vector6d::Zero(); ///< coordinates of X_SP (m, rad)
    std::optional<double> emittance{};
    double temperatureRatio = 1.0;
    double temperatureOffset_K = 0.0;
    bool operator==(const SourcePartSpec&) const = default;
};

/// The temperature of a disk source at a radius, as of a part.
struct ProfilePoint {
    double radius_m = 0.0;
    double temperatureRatio = 1.0;
    double temperatureOffset_K = 0.0;
    bool operator==(const ProfilePoint&) const = default;
};

/// Where a source has other temperatures than its own: in parts, which are then all that radiates, or along
/// the radius of a disk, linear between the points and constant before the first and after the last. At most
/// one of the two; with neither it is even.
struct Unevenness {
    std::vector<SourcePartSpec> parts{};
    std::vector<ProfilePoint> profile{};

    bool isEven() const { return parts.empty() && profile.empty(); }
    bool operator==(const Unevenness&) const = default;
};

/// Heat source: a shape about S's origin, emitting along +z.
struct SourceSpec {
    Shape shape = Disk{0.10};
    /// Set point, also used for estimated rates and verdicts; control uses the measured temperature.
    double temperature_K = 473.15;
    double emittance = 0.25;
    double emittanceUncertainty = 0.01; ///< standard; used by the thermal camera
    SourceModel model = SourceModel::Gray;
    ContourOrigin origin{};
    Vector6d pose = Vector6d::Zero(); ///< coordinates of X_RS, S in the robot's base R (m, rad)
    /// Set point by run time, K; if empty, temperature_K is used throughout.
    TimeTable<double> temperatureProfile{};
    /// Whether the pose is measured during the run and used by the controllers: with the camera if the source
    /// has markers (VisionSpec::followsSource), else with a tracker that gives poses.
    bool tracked = false;
    Unevenness uneven{}; ///< as assumed for control
    bool operator==(const SourceSpec&) const = default;
};

/// What tells an object's temperature. With both, the sensor on the object does, and the thermal camera is a
/// second opinion.
enum class ReadBy : std::uint8_t { Contact, Camera, Both };
const char* readByName(ReadBy readBy); ///< as in files: "contact"

struct ObjectSpec {
    std::string name;
    Shape shape;
    ContourOrigin origin;
    Material material; ///< as assumed for control
    Vector6d mounting =
        Vector6d::Zero(); ///< coordinates of O in E (m, rad): X_EO = poseFromCoordinates(mounting)
    double target_K = 313.15;
    /// Start values of a controller, at the source's set temperature; if empty, computed from the material.
    std::optional<HeatRates> estimatedRates;
    /// True material of the simulated object; if empty, the assumed one.
    std::optional<Material> simulatedMaterial;
    /// The object's own limit; if empty, that of all objects (SafetySpec).
    std::optional<double> warning_K{};
    std::optional<double> trip_K{};
    ReadBy readBy = ReadBy::Contact;
    bool operator==(const ObjectSpec&) const = default;
};

/// A thin opaque plate in the xy-plane of its frame B that takes light from the objects: black on both sides
/// and at the room's temperature, so it exchanges nothing else.
struct PlateSpec {
    std::string name;
    Shape shape;
    ContourOrigin origin{};
    Vector6d pose = Vector6d::Zero(); ///< coordinates of B (m, rad), in E of a fixture and in R of a shield
    bool operator==(const PlateSpec&) const = default;
};

struct SamplingSpec {
    double period_s = 1.0;
    int window = 10; ///< number of samples of the rate estimator
    int order = 3;   ///< of its polynomial
    /// Between two recorded pictures of the thermal camera; if empty, none is recorded.
    std::optional<double> thermalFramePeriod_s{};
    bool operator==(const SamplingSpec&) const = default;
};

/// Settings of the simulated rig and the length of the run.
struct SimulationSpec {
    std::uint64_t seed = 1;
    double sensorNoise_K = 0.02;
    double sensorResolution_K = 0.1;
    double sensorDelay_s = 0.0;
    double sensorOffset_K = 0.0;   ///< each sensor's constant error is drawn from +- this
    double convection_W_m2K = 0.0; ///< true h of an object's face
    double robotStep_m = 0.0001;   ///< position resolution; 0: none
    double robotStep_rad = 0.0005;
    double durationLimit_s = 1800.0; ///< latest end of a run without --duration
    double sensorLag_s = 0.0;        ///< time constant, first order
    double sensorDropout = 0.0;      ///< probability that a channel gives no reading
    double robotLatency_s = 0.0;     ///< delay until a command takes effect
    double trackingNoise_m = 0.0;    ///< standard deviation of the tracked source's pose, for each axis
    double trackingNoise_rad = 0.0;
    double trackingDelay_s = 0.0;
    /// Coordinates of X_RS by run time, linear between the points; if empty, the source does not move.
    TimeTable<Vector6d> sourceMotion{};
    std::optional<double> sourceEmittance{}; ///< true emittance of the source; if empty, the assumed one
    std::optional<Vector6d> sourcePose{};    ///< true pose at the start; if empty, the assumed one
    SimulatedCameraSpec camera{};
    std::optional<SimulatedThermalCameraSpec> thermalCamera{};
    std::vector<ScriptedFault> faults{};
    bool naturalConvection =
        false; ///< whether true h is that of natural convection; convection_W_m2K is 0 then
    std::optional<Unevenness> sourceUneven{}; ///< that of the true source; if empty, the assumed one
    bool operator==(const SimulationSpec&) const = default;
};

struct Experiment {
    std::string title;
    SourceSpec source;
    double environment_K = 298.15;
    Air air; ///< as assumed by verdicts, predictions and controllers; the simulated one is in SimulationSpec
    std::vector<ObjectSpec> objects;
    std::vector<PlateSpec> fixtures{}; ///< on the end-effector, with the objects
    /// Fixed in the room. What is held keeps the clearance from the highest point of all of them over the
    /// source's plane, so that it hits none.
    std::vector<PlateSpec> shields{};
    RobotLimits robot;
    Vector6d start{0.0, 0.0, 0.15, 0.0, 0.0, 0.0}; ///< end-effector's coordinates in R at the start
    ControllerSettings controller;
    SamplingSpec sampling;
    SimulationSpec simulation;
    VisionSpec vision;
    std::optional<RigSpec> rig; ///< the real devices; if empty, the experiment runs on the simulated rig
    SafetySpec safety;

    bool operator==(const Experiment&) const = default;
};

inline constexpr double kMinShapeRadius_m = 1e-6; ///< of any shape, about its origin
inline constexpr double kMaxObjectRadius_m = 1.0; ///< about the outline's centroid
inline constexpr std::size_t kMaxPlates = 8; ///< of fixtures, and of shields: each is asked at every pose
inline constexpr double kMinShieldHeight_m = 1e-4; ///< of any point of a shield over the source's plane
inline constexpr int kExperimentFormat = 1;        ///< version written to and accepted from JSON
/// Of a polygon: with more corners a run would be slower than real time.
inline constexpr std::size_t kMaxCorners = 5000;

/// Returns the profile of the thermal camera of the simulated or the real rig; empty if it has none.
std::optional<ThermalProfile> thermalProfile(const Experiment& experiment, bool simulated);
/// Returns how that camera was calibrated; empty values without one.
ThermalCalibration thermalCalibration(const Experiment& experiment, bool simulated);
/// Calibrates the camera of the real rig, or of the simulated one if the experiment has no rig.
void calibrateThermalCamera(Experiment& experiment, const ThermalCalibration& calibration);
/// Returns whether an object is read by a thermal camera.
bool readsByCamera(const Experiment& experiment);
/// Returns the number of objects with a sensor on them.
std::size_t contactSensors(const std::vector<ObjectSpec>& objects);

/// Returns the set point of the source at a run time, K.
double sourceSetPoint_K(const SourceSpec& source, double time_s);

/// Returns the highest set point of the whole run, K.
double highestSetPoint_K(const SourceSpec& source);

/// Returns the warning limit of an object, K: its own limit or that of all objects.
double warningLimit_K(const Experiment& experiment, const ObjectSpec& object);
double tripLimit_K(const Experiment& experiment, const ObjectSpec& object);
double sourceTripLimit_K(const Experiment& experiment);
/// Refuses a target above its object's warning limit, because every run would pause there, and one that the
/// thermal camera alone would have to tell and cannot. Such an experiment can be edited, not run.
Result<void> checkTargets(const Experiment& experiment);

/// Checks every range and the relations between parts: N <= free coordinates, unique names, start inside the
/// workspace and away from the source and all shields, shields over the source's plane, a source that can
/// heat. The error's `where` is a JSON path such as "objects[1].target_degC".
Result<void> validate(const Experiment& experiment);

/// Replaces all targets. Refuses a wrong number of them.
Result<void> setTargets(Experiment& experiment, const std::vector<double>& targets_K);

} // namespace bask
