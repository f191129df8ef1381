#pragma once
// The parameters of an experiment: one line each in experiment_parameters.cpp.

#include "engine/base/parameter.h"
#include "engine/model/experiment.h"

namespace bask {

inline constexpr double kMaxRunTime_s = 1e7;

ParameterTable<SafetySpec> safetyParameters();
/// Returns an object's own limits.
ParameterTable<ObjectSpec> objectLimitParameters();
ParameterTable<Material> materialParameters();
ParameterTable<HeatRates> heatRateParameters();
ParameterTable<Air> airParameters();
ParameterTable<SourceSpec> sourceParameters();
ParameterTable<MarkerSpec> markerParameters();
ParameterTable<SourcePartSpec> sourcePartParameters();
ParameterTable<ProfilePoint> profilePointParameters();
ParameterTable<RobotLimits> robotParameters();
/// Returns the parameters that all controllers have; their gains are in the catalogue.
ParameterTable<ControllerSettings> controllerParameters();
ParameterTable<SamplingSpec> samplingParameters();
ParameterTable<SimulationSpec> simulationParameters();
/// What every camera has, the rig's and the simulated one.
ParameterTable<CameraModel> cameraModelParameters();
ParameterTable<SimulatedCameraSpec> simulatedCameraParameters();
ParameterTable<SimulatedThermalCameraSpec> simulatedThermalCameraParameters();

} // namespace bask
