#pragma once
// The experiment as one value: source, environment, objects, robot, controller, sampling, simulation, seed.

#include "engine/base/result.h"
#include "engine/base/time_table.h"
#include "engine/control/controller_settings.h"
#include "engine/control/robot_limits.h"
#include "engine/model/rig_spec.h"
#include "engine/model/safety_spec.h"
#include "engine/model/vision_spec.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/shape.h"
#include "engine/thermal/heat_balance.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Targets and source temperatures that are taken.
inline constexpr double kMinTemperature_degC = -50.0;
inline constexpr double kMaxTemperature_degC = 2000.0;

/// Where a shape came from, kept so that it can be fitted again with other harmonics.
struct ContourOrigin {
    std::string file;  ///< as given; informative once the outline is embedded
    Contour outline;   ///< raw outline, centred as imported; empty for a disk or plain coefficients
    int harmonics = 0; ///< of the fit in use; 0: none
    std::vector<Contour> holes{}; ///< in the raw outline, in its coordinates
    bool operator==(const ContourOrigin&) const = default;
};

/// A shape and what it was made of.
struct OriginalShape {
    Shape shape;
    ContourOrigin origin; ///< without a file
};

/// The fit of so many harmonics (0: the polygon itself) of an outline with holes, as imported or as an origin
/// has them, centred; ready to be fitted again. Errors: fitFourier's, and checkHoles' with "holes[k]" as
/// place, where the fit cuts a hole: more harmonics help.
Result<OriginalShape> shapeFromOutline(const Contour& outline, const std::vector<Contour>& holes,
                                       int harmonics);

/// Heat source: a shape about S's origin, emitting along +z.
struct SourceSpec {
    Shape shape = Disk{0.10};
    /// Set point, and what believed rates and verdicts stand for; control uses the measured one.
    double temperature_K = 473.15;
    double emittance = 0.25;
    SourceModel model = SourceModel::Gray;
    ContourOrigin origin{};
    Vector6d pose = Vector6d::Zero(); ///< coordinates of X_RS, S in the robot's base R (m, rad)
    /// Set point by run time, K; empty: temperature_K throughout.
    TimeTable<double> temperatureProfile{};
    /// Its pose is measured during the run, and the controllers use it: by the camera where it has markers
    /// (VisionSpec::followsSource), else by a tracker that gives poses.
    bool tracked = false;
    bool operator==(const SourceSpec&) const = default;
};

struct ObjectSpec {
    std::string name;
    Shape shape;
    ContourOrigin origin;
    Material material; ///< as believed
    Vector6d mounting =
        Vector6d::Zero(); ///< coordinates of O in E (m, rad): X_EO = poseFromCoordinates(mounting)
    double target_K = 313.15;
    /// Where a controller starts, at the source's set temperature; empty: from the material.
    std::optional<HeatRates> believedRates;
    /// What the simulated object truly is; empty: as believed.
    std::optional<Material> simulatedMaterial;
    /// What it bears; empty: as all objects (SafetySpec).
    std::optional<double> warning_K{};
    std::optional<double> trip_K{};
    bool operator==(const ObjectSpec&) const = default;
};

struct SamplingSpec {
    double period_s = 1.0;
    int window = 10; ///< samples of the rate estimator
    int order = 3;   ///< of its polynomial
    bool operator==(const SamplingSpec&) const = default;
};

/// The simulated rig and the run's length.
struct SimulationSpec {
    std::uint64_t seed = 1;
    double sensorNoise_K = 0.02;
    double sensorResolution_K = 0.1;
    double sensorDelay_s = 0.0;
    double sensorOffset_K = 0.0; ///< each sensor's constant error is drawn from +- this
    double convection_W_m2K = 0.0;
    double robotStep_m = 0.0001; ///< position resolution; 0: none
    double robotStep_rad = 0.0005;
    double durationLimit_s = 1800.0; ///< a run without --duration ends here at the latest
    double sensorLag_s = 0.0;        ///< time constant, first order
    double sensorDropout = 0.0;      ///< probability that a channel gives no reading
    double robotLatency_s = 0.0;     ///< a command takes effect this late
    double trackingNoise_m = 0.0;    ///< standard deviation of the tracked source's pose, each axis
    double trackingNoise_rad = 0.0;
    double trackingDelay_s = 0.0;
    /// Coordinates of X_RS by run time, linear in between; empty: the source lies still.
    TimeTable<Vector6d> sourceMotion{};
    std::optional<double> sourceEmittance{}; ///< what the source truly has; empty: as believed
    std::optional<Vector6d> sourcePose{};    ///< where it truly lies at first; empty: as believed
    SimulatedCameraSpec camera{};
    std::vector<ScriptedFault> faults{};
    bool operator==(const SimulationSpec&) const = default;
};

struct Experiment {
    std::string title;
    SourceSpec source;
    double environment_K = 298.15;
    std::vector<ObjectSpec> objects;
    RobotLimits robot;
    Vector6d start{0.0, 0.0, 0.15, 0.0, 0.0, 0.0}; ///< end-effector's coordinates in R at the start
    ControllerSettings controller;
    SamplingSpec sampling;
    SimulationSpec simulation;
    VisionSpec vision;
    std::optional<RigSpec> rig; ///< the real devices; empty: it runs on the simulated rig
    SafetySpec safety;

    bool operator==(const Experiment&) const = default;
};

inline constexpr double kMaxObjectRadius_m = 1.0; ///< about the outline's centroid
inline constexpr int kExperimentFormat = 1;       ///< version written to and accepted from JSON
inline constexpr std::size_t kMaxCorners = 5000;  ///< of a polygon: more would make a run slower than life

/// Set point of the source at a run time, K.
double sourceSetPoint_K(const SourceSpec& source, double time_s);

/// Of the whole run, K.
double highestSetPoint_K(const SourceSpec& source);

/// What is watched, K: the object's own limit or that of all.
double warningLimit_K(const Experiment& experiment, const ObjectSpec& object);
double tripLimit_K(const Experiment& experiment, const ObjectSpec& object);
double sourceTripLimit_K(const Experiment& experiment);
/// Refuses a target above its object's warning limit, where every run would hold.
Result<void> checkTargets(const Experiment& experiment);

/// Checks every range and the relations between parts: N <= free coordinates, unique names, start inside the
/// workspace and clear of the source, a source that can heat. The error's `where` is a JSON path such as
/// "objects[1].target_degC".
Result<void> validate(const Experiment& experiment);

/// One number a reader of the file can type: replaces all targets. Refuses a wrong count.
Result<void> setTargets(Experiment& experiment, const std::vector<double>& targets_K);

} // namespace bask
