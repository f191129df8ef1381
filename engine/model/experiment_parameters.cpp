#include "engine/model/experiment_parameters.h"

#include "engine/base/translated.h"
#include "engine/calibration/marker_layout.h"
#include "engine/thermal/source_emission.h"

namespace bask {
namespace {

using namespace unit;
using enum Loosens;

constexpr double kMaxRate_K_s = 1e5;       // a foil of 10 um before a source of 2000 degC
constexpr double kMaxLambda2_1_K3s = 1e-7; // and what it radiates
constexpr ValidRange kAnyTemperature{kMinTemperature_degC, kMaxTemperature_degC};
constexpr ValidRange kShare{0.0, 1.0};
constexpr ValidRange kPositiveShare{0.0, 1.0, true};

// Each line: name, unit, valid range, direction that allows more, label, help, decimals; where the value is.
// clang-format off
constexpr Parameter<SafetySpec> kSafety[]{
    {{"warning", kCelsius, kAnyTemperature, Up, QT_TRANSLATE_NOOP("Parameter", "Objects: warning"),
      QT_TRANSLATE_NOOP("Parameter", "A run holds, and a priority 2 alarm is given"), 1}, &SafetySpec::warning_K},
    {{"trip", kCelsius, kAnyTemperature, Up, QT_TRANSLATE_NOOP("Parameter", "Objects: trip"),
      QT_TRANSLATE_NOOP("Parameter", "Heat off and retreat. What object, paint and sensor bear."), 1}, &SafetySpec::trip_K},
    {{"source_trip", kCelsius, kAnyTemperature, InCode, QT_TRANSLATE_NOOP("Parameter", "Source: trip"),
      QT_TRANSLATE_NOOP("Parameter", "Heat off and retreat. Automatic: 50 K over the highest set point."), 1}, &SafetySpec::sourceTrip_K},
    {{"stale_periods", kNone, {1.0, 1000.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Periods a reading is good for"),
      QT_TRANSLATE_NOOP("Parameter", "A sensor without a newer one is lost; also the source and its place"), 1}, &SafetySpec::stalePeriods},
    {{"held_limit", kSeconds, {0.0, 3600.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Longest hold"),
      QT_TRANSLATE_NOOP("Parameter", "A lost sensor or source holds the run so long, then it ends with a retreat"), 1}, &SafetySpec::pauseLimit_s},
    {{"largest_rate", kKelvinPerSecond, {0.0, kMaxRate_K_s, true}, InCode, QT_TRANSLATE_NOOP("Parameter", "Fastest plausible change"),
      QT_TRANSLATE_NOOP("Parameter", "Faster readings are a jump, and no heat. Automatic: three times what the source can do to the object, 2 K/s at least.")}, &SafetySpec::largestRate_K_s},
    {{"jumps", kNone, {1.0, 100.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Jumps in a row"),
      QT_TRANSLATE_NOOP("Parameter", "So many readings that are too fast are a sensor fault"), 0}, &SafetySpec::jumps},
    {{"frozen", kSeconds, {1.0, 3600.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Frozen sensor after"),
      QT_TRANSLATE_NOOP("Parameter", "The very same reading for so long, though the object must have changed"), 1}, &SafetySpec::frozen_s},
    {{"warming", kKelvin, {0.5, 1000.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Change that must be seen"),
      QT_TRANSLATE_NOOP("Parameter", "An object that must have changed by so much and did not does not follow its heat"), 1}, &SafetySpec::warming_K},
    {{"cross_check", kKelvin, {0.5, 1000.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Sensors apart when cold"),
      QT_TRANSLATE_NOOP("Parameter", "Sensors of a cold rig that differ by more are told"), 1}, &SafetySpec::crossCheck_K},
    {{"source_heating", kSeconds, {10.0, 36000.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Source: time to gain 2 K"),
      QT_TRANSLATE_NOOP("Parameter", "A source that is too cold and no nearer after so long does not heat"), 0}, &SafetySpec::sourceHeating_s},
    {{"source_band", kKelvin, {1.0, 1000.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Source: near its set point"),
      QT_TRANSLATE_NOOP("Parameter", "Within this the source is not too cold"), 1}, &SafetySpec::sourceBand_K},
    {{"source_unasked", kKelvin, {1.0, 1000.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Source: warming unasked"),
      QT_TRANSLATE_NOOP("Parameter", "More warming with the heat off is an alarm"), 1}, &SafetySpec::sourceUnasked_K},
    {{"least_disk", kMegabytes, {0.0, 1e6}, Down, QT_TRANSLATE_NOOP("Parameter", "Least room on the disk"),
      QT_TRANSLATE_NOOP("Parameter", "With less no recording is begun"), 0}, &SafetySpec::minDisk_MB},
};

constexpr Parameter<ObjectSpec> kObjectLimits[]{
    {{"warning", kCelsius, kAnyTemperature, InCode, QT_TRANSLATE_NOOP("Parameter", "Warning"), "", 1}, &ObjectSpec::warning_K},
    {{"trip", kCelsius, kAnyTemperature, InCode, QT_TRANSLATE_NOOP("Parameter", "Trip"), "", 1}, &ObjectSpec::trip_K},
};

constexpr bool kRequired = true;
constexpr Parameter<Material> kMaterial[]{
    {{"emittance", kNone, kPositiveShare, Never, QT_TRANSLATE_NOOP("Parameter", "Emittance"), "", 3, kRequired}, &Material::emittance},
    {{"absorptance", kNone, kPositiveShare, Never, QT_TRANSLATE_NOOP("Parameter", "Absorptance"), "", 3, kRequired}, &Material::absorptance},
    {{"specific_heat", kSpecificHeat, {0.0, 1e5, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Specific heat"), "", 1, kRequired}, &Material::specificHeat_J_kgK},
    {{"density", kDensity, {0.0, 3e4, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Density"), "", 1, kRequired}, &Material::density_kg_m3},
    {{"thickness", kMillimetres, {0.0, 100.0, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Thickness"), "", 2, kRequired}, &Material::thickness_m},
    {{"infill", kShareInPercent, kPositiveShare, Never, QT_TRANSLATE_NOOP("Parameter", "Infill"), "", 1}, &Material::infill},
};

constexpr Parameter<HeatRates> kHeatRates[]{
    {{"lambda1", kKelvinPerSecond, {0.0, kMaxRate_K_s, true}, Never, "", "", 4, kRequired, "\u03bb\u2081"}, &HeatRates::lambda1},
    {{"lambda2", kPerKelvin3Second, {0.0, kMaxLambda2_1_K3s, true}, Never, "", "", 4, kRequired, "\u03bb\u2082"}, &HeatRates::lambda2},
    {{"lambda3", kKelvinPerSecond, {0.0, kMaxRate_K_s, true}, Never, "", "", 4, kRequired, "\u03bb\u2083"}, &HeatRates::lambda3},
};

constexpr ValidRange kConvectionRange{0.0, 1000.0};
constexpr Parameter<Air> kAir[]{
    {{"convection", kConvection, kConvectionRange, Never, QT_TRANSLATE_NOOP("Parameter", "Convection h"),
      QT_TRANSLATE_NOOP("Parameter", "What the air takes from an object's face, by its temperature above the room"), 1}, &Air::convection_W_m2K},
};

constexpr Parameter<SourceSpec> kSource[]{
    {{"temperature", kCelsius, kAnyTemperature, Never, "", "", 1, kRequired}, &SourceSpec::temperature_K},
    {{"emittance", kNone, kPositiveShare, Never, "", "", 3, kRequired}, &SourceSpec::emittance},
    {{"emittance_uncertainty", kNone, {0.0, 1.0}, Never, "", "", 3}, &SourceSpec::emittanceUncertainty},
};

constexpr Parameter<MarkerSpec> kMarker[]{
    {{"side", kMillimetres, {kMinMarkerSide_mm, kMaxMarkerSide_mm}, Never, "", "", 2, kRequired}, &MarkerSpec::side_m},
};

constexpr ValidRange kPartRatio{0.0, kMaxPartRatio};
constexpr ValidRange kPartOffset{-1000.0, 1000.0};
constexpr Parameter<SourcePartSpec> kSourcePart[]{
    {{"emittance", kNone, kPositiveShare}, &SourcePartSpec::emittance},
    {{"temperature_ratio", kNone, kPartRatio}, &SourcePartSpec::temperatureRatio},
    {{"temperature_offset", kKelvin, kPartOffset}, &SourcePartSpec::temperatureOffset_K},
};
constexpr Parameter<ProfilePoint> kProfilePoint[]{
    {{"radius", kMillimetres, {0.0, 1e4}, Never, "", "", 2, kRequired}, &ProfilePoint::radius_m},
    {{"temperature_ratio", kNone, kPartRatio}, &ProfilePoint::temperatureRatio},
    {{"temperature_offset", kKelvin, kPartOffset}, &ProfilePoint::temperatureOffset_K},
};

constexpr Parameter<RobotLimits> kRobot[]{
    {{"max_speed", kCentimetresPerSecond, {0.0, 100.0, true}, Up, QT_TRANSLATE_NOOP("Parameter", "Largest speed")}, &RobotLimits::maxSpeed_m_s},
    {{"max_rotation", kRadiansPerSecond, {0.0, 10.0, true}, Up, QT_TRANSLATE_NOOP("Parameter", "Largest turning speed")}, &RobotLimits::maxRotation_rad_s},
    {{"max_acceleration", kCentimetresPerSecond2, {0.0, 1000.0}, UpOrZero, QT_TRANSLATE_NOOP("Parameter", "Largest acceleration")}, &RobotLimits::maxAcceleration_m_s2},
    {{"max_angular_acceleration", kRadiansPerSecond2, {0.0, 100.0}, UpOrZero, QT_TRANSLATE_NOOP("Parameter", "Largest turning acceleration")}, &RobotLimits::maxAngularAcceleration_rad_s2},
    {{"clearance", kCentimetres, {0.0, 100.0}, Down, QT_TRANSLATE_NOOP("Parameter", "Clearance to the source"),
      QT_TRANSLATE_NOOP("Parameter", "Least distance of any point of an object from the source's plane")}, &RobotLimits::clearance_m},
    {{"max_mounting_radius", kCentimetres, {0.0, 1000.0}, Never, QT_TRANSLATE_NOOP("Parameter", "Largest mounting radius")}, &RobotLimits::maxMountingRadius_m},
};

constexpr Parameter<ControllerSettings> kController[]{
    {{"rotation_length", kCentimetres, {0.0, 1000.0, true}}, &ControllerSettings::rotationLength_m},
    {{"damping", kNone, kShare}, &ControllerSettings::damping},
    {{"believed_rate_error_factor", kNone, {1.0, 8.0}}, &ControllerSettings::estimatedRateErrorFactor}, // identification is bounded at 10
};

constexpr Parameter<SamplingSpec> kSampling[]{
    {{"period", kSeconds, {0.01, 60.0}}, &SamplingSpec::period_s},
    {{"window", kNone, {2.0, 1000.0}}, &SamplingSpec::window}, // and more than the order
    {{"order", kNone, {1.0, 5.0}}, &SamplingSpec::order},
    {{"thermal_frame_period", kSeconds, {0.1, 3600.0}}, &SamplingSpec::thermalFramePeriod_s},
};

constexpr Parameter<SimulationSpec> kSimulation[]{
    {{"sensor_noise", kKelvin, {0.0, 10.0}}, &SimulationSpec::sensorNoise_K},
    {{"sensor_resolution", kKelvin, {0.0, 10.0}}, &SimulationSpec::sensorResolution_K},
    {{"sensor_delay", kSeconds, {0.0, 60.0}}, &SimulationSpec::sensorDelay_s},
    {{"sensor_offset", kKelvin, {0.0, 10.0}}, &SimulationSpec::sensorOffset_K},
    {{"convection", kConvection, kConvectionRange}, &SimulationSpec::convection_W_m2K},
    {{"robot_step", kMillimetres, {0.0, 10.0}}, &SimulationSpec::robotStep_m},
    {{"robot_step", kRadians, {0.0, 0.1}}, &SimulationSpec::robotStep_rad},
    {{"duration_limit", kSeconds, {0.0, kMaxRunTime_s, true}}, &SimulationSpec::durationLimit_s}, // and one period at least
    {{"sensor_lag", kSeconds, {0.0, 600.0}}, &SimulationSpec::sensorLag_s},
    {{"sensor_dropout", kNone, {0.0, 0.5}}, &SimulationSpec::sensorDropout},
    {{"robot_latency", kSeconds, {0.0, 10.0}}, &SimulationSpec::robotLatency_s},
    {{"tracking_noise", kMillimetres, {0.0, 100.0}}, &SimulationSpec::trackingNoise_m},
    {{"tracking_noise", kDegrees, {0.0, 10.0}}, &SimulationSpec::trackingNoise_rad},
    {{"tracking_delay", kSeconds, {0.0, 2.0}}, &SimulationSpec::trackingDelay_s},
};

constexpr Parameter<CameraModel> kCameraModel[]{
    {{"width", kPixels, {16.0, 16384.0}, Never, "", "", 0, kRequired}, &CameraModel::width},
    {{"height", kPixels, {16.0, 16384.0}, Never, "", "", 0, kRequired}, &CameraModel::height},
    {{"fx", kPixels, {0.0, 1e6, true}, Never, "", "", 2, kRequired}, &CameraModel::fx},
    {{"fy", kPixels, {0.0, 1e6, true}, Never, "", "", 2, kRequired}, &CameraModel::fy},
    {{"cx", kPixels, {-1e5, 1e5}, Never, "", "", 2, kRequired}, &CameraModel::cx},
    {{"cy", kPixels, {-1e5, 1e5}, Never, "", "", 2, kRequired}, &CameraModel::cy},
};

constexpr Parameter<SimulatedCameraSpec> kSimulatedCamera[]{
    {{"rate", kHertz, {1.0, 120.0}}, &SimulatedCameraSpec::rate_Hz},
    {{"noise", kGrey, {0.0, 64.0}}, &SimulatedCameraSpec::noise_grey},
    {{"blur", kPixels, {0.0, 5.0}}, &SimulatedCameraSpec::blur_px},
    {{"light_fall", kNone, kShare}, &SimulatedCameraSpec::lightFall},
    {{"delay", kSeconds, {0.0, 1.0}}, &SimulatedCameraSpec::delay_s},
};

constexpr Parameter<SimulatedThermalCameraSpec> kSimulatedThermalCamera[]{
    {{"noise", kKelvin, {0.0, 5.0}}, &SimulatedThermalCameraSpec::noise_K},
    {{"gain", kNone, {0.0, 0.2}}, &SimulatedThermalCameraSpec::gain},
    {{"offset", kKelvin, {0.0, 2.0}}, &SimulatedThermalCameraSpec::offset_K},
};
// clang-format on

} // namespace

ParameterTable<SafetySpec> safetyParameters() {
    return kSafety;
}
ParameterTable<ObjectSpec> objectLimitParameters() {
    return kObjectLimits;
}
ParameterTable<Material> materialParameters() {
    return kMaterial;
}
ParameterTable<HeatRates> heatRateParameters() {
    return kHeatRates;
}
ParameterTable<Air> airParameters() {
    return kAir;
}
ParameterTable<SourceSpec> sourceParameters() {
    return kSource;
}
ParameterTable<MarkerSpec> markerParameters() {
    return kMarker;
}
ParameterTable<SourcePartSpec> sourcePartParameters() {
    return kSourcePart;
}
ParameterTable<ProfilePoint> profilePointParameters() {
    return kProfilePoint;
}
ParameterTable<RobotLimits> robotParameters() {
    return kRobot;
}
ParameterTable<ControllerSettings> controllerParameters() {
    return kController;
}
ParameterTable<SamplingSpec> samplingParameters() {
    return kSampling;
}
ParameterTable<SimulationSpec> simulationParameters() {
    return kSimulation;
}
ParameterTable<CameraModel> cameraModelParameters() {
    return kCameraModel;
}
ParameterTable<SimulatedCameraSpec> simulatedCameraParameters() {
    return kSimulatedCamera;
}
ParameterTable<SimulatedThermalCameraSpec> simulatedThermalCameraParameters() {
    return kSimulatedThermalCamera;
}

} // namespace bask
