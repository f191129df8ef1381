#pragma once
// The camera, its calibration and its markers in an experiment's file.

#include "engine/base/json_fields.h"
#include "engine/model/thermal_camera_spec.h"
#include "engine/model/vision_spec.h"

namespace bask {

void readVision(const nlohmann::json& j, const std::string& path, Failure& failure, VisionSpec& out);
void readSimulatedCamera(const nlohmann::json& j, const std::string& path, Failure& failure,
                         SimulatedCameraSpec& out);

/// A camera's calibration without its date.
void readCalibratedCamera(const nlohmann::json& j, const std::string& path, Failure& failure,
                          CameraModel& out);
nlohmann::ordered_json calibratedCameraJson(const CameraModel& camera);

/// Members of a part of a file: lens, pose and their dates.
void readThermalCalibration(Fields& fields, Failure& failure, ThermalCalibration& out);
void putThermalCalibration(nlohmann::ordered_json& j, const ThermalCalibration& calibration);

nlohmann::ordered_json visionJson(const VisionSpec& vision);
void readSimulatedThermalCamera(const nlohmann::json& j, const std::string& path, Failure& failure,
                                SimulatedThermalCameraSpec& out);
nlohmann::ordered_json simulatedThermalCameraJson(const SimulatedThermalCameraSpec& camera);
nlohmann::ordered_json simulatedCameraJson(const SimulatedCameraSpec& camera);

} // namespace bask
