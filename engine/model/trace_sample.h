#pragma once
// One row of a run, and the tables of its values. Code that records, shows or exports samples uses the
// tables: a new value needs a member and a line here, and code that measures it.

#include "engine/base/pose.h"
#include "engine/base/translated.h"
#include "engine/base/unit.h"
#include "engine/control/robot_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace bask {

/// What a thermal camera tells of one object; NaN: it cannot read it, or there is no camera.
struct CameraSample {
    double T_K = std::numeric_limits<double>::quiet_NaN();
    double uncertainty_K = std::numeric_limits<double>::quiet_NaN(); ///< standard uncertainty of T_K
    double spread_K = std::numeric_limits<double>::quiet_NaN();      ///< largest difference across its face
    double pixels = std::numeric_limits<double>::quiet_NaN();        ///< number of them that were read
    bool isPartlyOutside = false; ///< a part of it is not in the picture; shown, not recorded
};

/// One object at one sample. A value that is unknown or invalid is NaN (NULL in the file).
struct ObjectSample {
    double measured_K = 0.0;
    double estimated_K = 0.0;
    double rate_K_s = 0.0;
    double target_K = 0.0;
    double viewFactor = 0.0;         ///< with the shade of the other objects
    double unshadedViewFactor = 0.0; ///< without it
    double lambda1 = 0.0;            ///< the controller's present estimate, K/s; NaN if it has none
    double lambda2 = 0.0;            ///< 1/(K3 s)
    double true_K = 0.0;             ///< the simulated plant's own temperature; NaN on a real rig
    bool valid = false;              ///< measured_K is a fresh, plausible reading
    CameraSample camera;             ///< what the thermal camera tells of it
};

/// Returns the share of its light from the source that other objects and screens take from an object, in
/// [0, 1]; NaN if it is not known, or without them no light would come.
inline double shadedShare(const ObjectSample& object) {
    if (!(object.unshadedViewFactor > 0.0) || !std::isfinite(object.viewFactor))
        return std::numeric_limits<double>::quiet_NaN();
    return std::clamp(1.0 - object.viewFactor / object.unshadedViewFactor, 0.0, 1.0);
}

/// Returns the temperature for judging a result: the plant's own temperature if it is known, else the
/// estimate.
inline double judgedTemperature_K(const ObjectSample& object) {
    return std::isfinite(object.true_K) ? object.true_K : object.estimated_K;
}

/// One sample of a run.
struct TraceSample {
    double time_s = 0.0;                     ///< since Start
    std::vector<ObjectSample> objects;       ///< in the experiment's order
    Vector6d coordinates = Vector6d::Zero(); ///< end-effector in R, m and rad
    Vector6d twist = Vector6d::Zero();       ///< commanded, R axes, m/s and rad/s
    double source_K = 0.0;                   ///< measured
    Vector6d source = Vector6d::Zero();      ///< coordinates of X_RS that the controllers use, m and rad
    double smallestSingularValue = 0.0;      ///< of the interaction matrix, rotation scaled
    ActiveLimits limits;                     ///< limits that restricted the command
};

/// Quantities that plots show against time, in the order of a session file's overview: add a new one at the
/// end.
enum class Quantity : std::uint8_t {
    Temperature, ///< measured, with target and tolerance band
    Error,       ///< measured minus target
    ViewFactor,
    Rate,     ///< dT/dt
    Strength, ///< the controller's estimate of lambda1, K/s
    Speed,    ///< commanded; of the run, two series: translation and rotation
    Shade,    ///< share of the view factor that the other objects take
};

/// What a rig needs to have a value.
enum class Needs : std::uint8_t { Nothing, Plant, ThermalCamera }; ///< Plant: a simulated rig

/// What the rig of a recording had.
struct RecordedRig {
    bool isSimulated = false;
    bool hasThermalCamera = false;

    bool has(Needs needs) const {
        return needs == Needs::Nothing || (needs == Needs::Plant ? isSimulated : hasThermalCamera);
    }
};

/// How a value is displayed: temperatures and their differences are in the unit that the person chose.
enum class ShownAs : std::uint8_t { Number, Temperature, Difference, RatePerMinute };

/// How a value is read from a row and written into it, in SI. A flag is 1 or 0; NaN is an unknown flag.
template <class Row> struct ColumnValue {
    double (*get)(const Row&) = nullptr;
    void (*set)(Row&, double) = nullptr; ///< null if it follows from other columns
};

/// The position of a value in the session file.
struct StoredAs {
    /// Position in a row, from 1. Files depend on it, so it never changes; a new one is last.
    int place = 0;
    const char* view = nullptr; ///< table for people that shows it
    const char* name = nullptr; ///< name of its column there, if it is not the key
    bool isLater = false;       ///< whether older files lack it: they are read with NaN
};

/// A log of the NeXus file: its path below the group of the object or the instrument, and its description.
struct NexusLog {
    const char* path;
    const char* description;
};

template <class Row> struct SampleColumn {
    const char* key; ///< with the unit in SI: "measured_K"
    Unit unit;
    ColumnValue<Row> value;
    StoredAs stored{};         ///< place 0: not stored
    const char* csv = nullptr; ///< name in traces.csv, without its unit
    std::optional<NexusLog> nexus{};
    const char* vtk = nullptr;      ///< name in the point data of trajectories
    std::optional<Quantity> plot{}; ///< the plot that shows it
    const char* label = "";         ///< label of its axis, English, context "Column"
    const char* title = "";         ///< title of the plot, in the same context
    /// Caption of its figure in the report, in the same context; null if it has none.
    const char* caption = nullptr;
    ShownAs shownAs = ShownAs::Number;
    int decimals = -1;    ///< decimals of a number on a screen; -1: three significant digits
    bool isWhole = false; ///< whether it is a flag or bits
    Needs needs = Needs::Nothing;
    bool isReading = false; ///< whether it is unknown if the sensor's reading is invalid

    const char* nameInView() const { return stored.name != nullptr ? stored.name : key; }
};

/// Returns the views that stored columns name, each once.
template <class Columns> std::vector<std::string> storedViews(const Columns& columns) {
    std::vector<std::string> out;
    for (const auto& column : columns)
        if (column.stored.place > 0 && std::ranges::find(out, column.stored.view) == out.end())
            out.emplace_back(column.stored.view);
    return out;
}

using ObjectColumn = SampleColumn<ObjectSample>;
using RunColumn = SampleColumn<TraceSample>;

/// Returns the limits of these bits; no limits if the number is not a valid set.
inline ActiveLimits limitsOfBits(double bits) {
    return {bits >= 0.0 && bits < 4096.0 ? static_cast<unsigned>(bits) : 0U};
}

/// A member as a column's value.
template <auto Member>
inline constexpr ColumnValue<ObjectSample> kOfObject{
    [](const ObjectSample& o) { return static_cast<double>(o.*Member); },
    [](ObjectSample& o, double value) {
        if constexpr (std::is_same_v<decltype(Member), bool ObjectSample::*>)
            o.*Member = value == 1.0;
        else
            o.*Member = value;
    }};
template <double CameraSample::*Member>
inline constexpr ColumnValue<ObjectSample> kOfCamera{
    [](const ObjectSample& o) { return o.camera.*Member; },
    [](ObjectSample& o, double value) { o.camera.*Member = value; }};
template <double TraceSample::*Member>
inline constexpr ColumnValue<TraceSample> kOfRun{[](const TraceSample& s) { return s.*Member; },
                                                 [](TraceSample& s, double value) { s.*Member = value; }};
template <int Part>
inline constexpr ColumnValue<TraceSample> kTwist{[](const TraceSample& s) { return s.twist[Part]; },
                                                 [](TraceSample& s, double value) { s.twist[Part] = value; }};

/// Columns of each object.
inline constexpr std::array kObjectColumns{
    ObjectColumn{.key = "measured_K",
                 .unit = unit::kCelsius,
                 .value = kOfObject<&ObjectSample::measured_K>,
                 .stored = {1, "sample"},
                 .csv = "measured",
                 .nexus = NexusLog{"temperature_env/sensor/value_log", "measured temperature"},
                 .vtk = "measured_K",
                 .plot = Quantity::Temperature,
                 .label = QT_TRANSLATE_NOOP("Column", "Temperature"),
                 .title = QT_TRANSLATE_NOOP("Column", "Temperatures"),
                 .caption = QT_TRANSLATE_NOOP(
                     "Column",
                     "Measured temperatures. Dashed: targets; grey: the band of %1 about them. Gaps: no "
                     "valid reading. The numbers at dotted lines are those of the table of events."),
                 .shownAs = ShownAs::Temperature,
                 .isReading = true},
    ObjectColumn{.key = "estimated_K",
                 .unit = unit::kCelsius,
                 .value = kOfObject<&ObjectSample::estimated_K>,
                 .stored = {2, "sample"},
                 .csv = "estimate",
                 .nexus = NexusLog{"temperature_estimate", "temperature by the estimator"},
                 .vtk = "estimated_K"},
    ObjectColumn{.key = "target_K",
                 .unit = unit::kCelsius,
                 .value = kOfObject<&ObjectSample::target_K>,
                 .stored = {4, "sample"},
                 .csv = "target",
                 .nexus = NexusLog{"temperature_target", "target"},
                 .vtk = "target_K"},
    ObjectColumn{.key = "error_K",
                 .unit = unit::kKelvin,
                 .value = {[](const ObjectSample& o) { return o.measured_K - o.target_K; }},
                 .csv = "error",
                 .vtk = "error_K",
                 .plot = Quantity::Error,
                 .label = QT_TRANSLATE_NOOP("Column", "Error"),
                 .title = QT_TRANSLATE_NOOP("Column", "Errors"),
                 .caption = QT_TRANSLATE_NOOP(
                     "Column", "Measured temperature minus target, within %1; grey: the band."),
                 .shownAs = ShownAs::Difference,
                 .isReading = true},
    ObjectColumn{.key = "rate_K_s",
                 .unit = unit::kKelvinPerSecond,
                 .value = kOfObject<&ObjectSample::rate_K_s>,
                 .stored = {3, "sample"},
                 .csv = "rate",
                 .nexus = NexusLog{"temperature_env/sensor/value_deriv1_log", "rate by the estimator"},
                 .plot = Quantity::Rate,
                 .label = QT_TRANSLATE_NOOP("Column", "Rate"),
                 .title = QT_TRANSLATE_NOOP("Column", "Rates"),
                 .shownAs = ShownAs::RatePerMinute,
                 .isReading = true},
    ObjectColumn{.key = "view_factor",
                 .unit = unit::kNone,
                 .value = kOfObject<&ObjectSample::viewFactor>,
                 .stored = {5, "sample"},
                 .csv = "view factor",
                 .nexus = NexusLog{"view_factor", "view factor of the source from the object"},
                 .vtk = "view_factor",
                 .plot = Quantity::ViewFactor,
                 .label = QT_TRANSLATE_NOOP("Column", "View factor"),
                 .title = QT_TRANSLATE_NOOP("Column", "View factors"),
                 .caption = QT_TRANSLATE_NOOP("Column", "View factor of the source from each object."),
                 .decimals = 3},
    ObjectColumn{.key = "view_factor_unshaded",
                 .unit = unit::kNone,
                 .value = kOfObject<&ObjectSample::unshadedViewFactor>,
                 .stored = {.place = 10, .view = "sample", .isLater = true},
                 .csv = "view factor without shade",
                 .nexus = NexusLog{"view_factor_unshaded",
                                   "view factor of the source from the object, if no other object shaded it"},
                 .vtk = "view_factor_unshaded"},
    ObjectColumn{.key = "shade",
                 .unit = unit::kShareInPercent,
                 .value = {shadedShare},
                 .plot = Quantity::Shade,
                 .label = QT_TRANSLATE_NOOP("Column", "Shade"),
                 .title = QT_TRANSLATE_NOOP("Column", "Shade"),
                 .caption = QT_TRANSLATE_NOOP(
                     "Column", "Share of the source's light that other objects, fixtures and shields take "
                               "from each object."),
                 .decimals = 1},
    ObjectColumn{.key = "lambda1_K_s",
                 .unit = unit::kKelvinPerSecond,
                 .value = kOfObject<&ObjectSample::lambda1>,
                 .stored = {6, "object_state"},
                 .nexus = NexusLog{"lambda1", "the controller's estimate"},
                 .plot = Quantity::Strength,
                 .label = QT_TRANSLATE_NOOP("Column", "Estimated \u03bb\u2081"),
                 .title = QT_TRANSLATE_NOOP("Column", "Estimates")},
    ObjectColumn{.key = "lambda2_1_K3s",
                 .unit = unit::kPerKelvin3Second,
                 .value = kOfObject<&ObjectSample::lambda2>,
                 .stored = {7, "object_state"},
                 .nexus = NexusLog{"lambda2", "the controller's estimate"}},
    ObjectColumn{
        .key = "reading_valid",
        .unit = unit::kNone,
        .value = kOfObject<&ObjectSample::valid>,
        .stored = {8, "object_state"},
        .csv = "reading valid",
        .nexus = NexusLog{"temperature_env/sensor/valid_log", "1 where the reading is fresh and plausible"},
        .vtk = "reading_valid",
        .isWhole = true},
    ObjectColumn{.key = "true_K",
                 .unit = unit::kCelsius,
                 .value = kOfObject<&ObjectSample::true_K>,
                 .stored = {9, "truth", "temperature_K"},
                 .csv = "true",
                 .nexus = NexusLog{"temperature_true", "the simulated object's own temperature"},
                 .vtk = "true_K",
                 .needs = Needs::Plant},
    ObjectColumn{
        .key = "camera_K",
        .unit = unit::kCelsius,
        .value = kOfCamera<&CameraSample::T_K>,
        .stored = {.place = 11, .view = "camera", .isLater = true},
        .csv = "camera",
        .nexus = NexusLog{"temperature_env/thermal_camera/value_log", "temperature by the thermal camera"},
        .vtk = "camera_K",
        .needs = Needs::ThermalCamera},
    ObjectColumn{.key = "camera_uncertainty_K",
                 .unit = unit::kKelvin,
                 .value = kOfCamera<&CameraSample::uncertainty_K>,
                 .stored = {.place = 12, .view = "camera", .isLater = true},
                 .csv = "camera standard uncertainty",
                 .nexus = NexusLog{"temperature_env/thermal_camera/uncertainty_log",
                                   "standard uncertainty of value_log"},
                 .needs = Needs::ThermalCamera},
    ObjectColumn{
        .key = "camera_spread_K",
        .unit = unit::kKelvin,
        .value = kOfCamera<&CameraSample::spread_K>,
        .stored = {.place = 13, .view = "camera", .isLater = true},
        .csv = "camera spread",
        .nexus = NexusLog{"temperature_env/thermal_camera/spread_log", "largest difference across the face"},
        .needs = Needs::ThermalCamera},
    ObjectColumn{.key = "camera_pixels",
                 .unit = unit::kNone,
                 .value = kOfCamera<&CameraSample::pixels>,
                 .stored = {.place = 14, .view = "camera", .isLater = true},
                 .csv = "camera pixels",
                 .nexus =
                     NexusLog{"temperature_env/thermal_camera/pixels_log", "number of pixels that were read"},
                 .needs = Needs::ThermalCamera},
};

inline constexpr const char* kCommanded = "commanded, axes of the robot's base";

/// Columns of the run. Its time and the two poses are handled by code where they are written.
inline constexpr std::array kRunColumns{
    RunColumn{.key = "vx_m_s",
              .unit = unit::kCentimetresPerSecond,
              .value = kTwist<0>,
              .stored = {1, "motion"},
              .nexus = NexusLog{"robot/vx", kCommanded}},
    RunColumn{.key = "vy_m_s",
              .unit = unit::kCentimetresPerSecond,
              .value = kTwist<1>,
              .stored = {2, "motion"},
              .nexus = NexusLog{"robot/vy", kCommanded}},
    RunColumn{.key = "vz_m_s",
              .unit = unit::kCentimetresPerSecond,
              .value = kTwist<2>,
              .stored = {3, "motion"},
              .nexus = NexusLog{"robot/vz", kCommanded}},
    RunColumn{.key = "wx_rad_s",
              .unit = unit::kRadiansPerSecond,
              .value = kTwist<3>,
              .stored = {4, "motion"},
              .nexus = NexusLog{"robot/wx", kCommanded}},
    RunColumn{.key = "wy_rad_s",
              .unit = unit::kRadiansPerSecond,
              .value = kTwist<4>,
              .stored = {5, "motion"},
              .nexus = NexusLog{"robot/wy", kCommanded}},
    RunColumn{.key = "wz_rad_s",
              .unit = unit::kRadiansPerSecond,
              .value = kTwist<5>,
              .stored = {6, "motion"},
              .nexus = NexusLog{"robot/wz", kCommanded}},
    RunColumn{.key = "smallest_singular_value",
              .unit = unit::kNone,
              .value = kOfRun<&TraceSample::smallestSingularValue>,
              .stored = {7, "motion"},
              .nexus = NexusLog{"robot/smallest_singular_value", "of the interaction matrix"}},
    RunColumn{.key = "source_K",
              .unit = unit::kCelsius,
              .value = kOfRun<&TraceSample::source_K>,
              .stored = {9, "source", "temperature_K"},
              .csv = "source",
              .nexus = NexusLog{"heat_source_surface/value_log", "measured temperature of the source"},
              .vtk = "source_K"},
    RunColumn{.key = "limited",
              .unit = unit::kNone,
              .value = {[](const TraceSample& s) { return static_cast<double>(s.limits.bits); },
                        [](TraceSample& s, double value) { s.limits = limitsOfBits(value); }},
              .stored = {8, "motion"},
              .nexus = NexusLog{"robot/limits",
                                "that held the command back: 0 none, else 1 + 2 speed + 4 rotation + 8 "
                                "acceleration + 16 angular acceleration + 32 clearance + 64, 128 ... 2048 "
                                "workspace x, y ... theta_z"},
              .vtk = "limits",
              .isWhole = true},
};

} // namespace bask
