#include "engine/experiment/vision_json.h"

#include "engine/experiment/json_quantities.h"
#include "engine/experiment/parameter_json.h"
#include "engine/model/experiment_parameters.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

const std::map<std::string, Part> kParts{
    {"source", Part::Source}, {"end_effector", Part::EndEffector}, {"base", Part::Base}};

void readModelFields(Fields& fields, CameraModel& out) {
    readParameters(fields, cameraModelParameters(), out);
    fields.read("distortion", out.distortion);
}

void putModel(Json& j, const CameraModel& camera) {
    putParameters(j, cameraModelParameters(), camera);
    j["distortion"] = camera.distortion;
}

void readCalibrationFields(Fields& fields, CameraModel& out) {
    readModelFields(fields, out);
    if (fields.find("rms_px") != nullptr)
        fields.read("rms_px", out.rms_px.emplace());
    fields.read("deviations", out.deviations);
    fields.read("board", out.board);
}

void readCamera(const json& j, const std::string& path, Failure& failure, VisionSpec& out) {
    Fields fields(j, path, failure);
    readCalibrationFields(fields, out.camera.emplace());
    fields.read("date", out.cameraDate);
    fields.close();
}

MarkerSpec readMarker(const json& j, const std::string& path, Failure& failure) {
    Fields fields(j, path, failure);
    MarkerSpec marker;
    fields.readWord("part", kParts, marker.part, true);
    fields.read("id", marker.id, true);
    readParameters(fields, markerParameters(), marker);
    readPart(fields, "pose", true, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, marker.pose);
    });
    fields.close();
    return marker;
}

Json markerJson(const MarkerSpec& marker) {
    Json j;
    for (const auto& [word, part] : kParts)
        if (part == marker.part)
            j["part"] = word;
    j["id"] = marker.id;
    putParameters(j, markerParameters(), marker);
    j["pose"] = coordinatesJson(marker.pose);
    return j;
}

Json cameraJson(const VisionSpec& vision) {
    Json j = calibratedCameraJson(*vision.camera);
    if (!vision.cameraDate.empty())
        j["date"] = vision.cameraDate;
    return j;
}

} // namespace

void readCalibratedCamera(const json& j, const std::string& path, Failure& failure, CameraModel& out) {
    Fields fields(j, path, failure);
    readCalibrationFields(fields, out);
    fields.close();
}

Json calibratedCameraJson(const CameraModel& camera) {
    Json j;
    putModel(j, camera);
    if (camera.rms_px)
        j["rms_px"] = *camera.rms_px;
    if (!camera.deviations.empty())
        j["deviations"] = camera.deviations;
    if (!camera.board.empty())
        j["board"] = camera.board;
    return j;
}

void readVision(const json& j, const std::string& path, Failure& failure, VisionSpec& out) {
    Fields fields(j, path, failure);
    fields.read("dictionary", out.dictionary);
    readEach(fields, "markers", false, [&](const json& part, const std::string& where) {
        out.markers.push_back(readMarker(part, where, failure));
    });
    readPart(fields, "camera", false,
             [&](const json& part, const std::string& where) { readCamera(part, where, failure, out); });
    readPart(fields, "camera_pose", false, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, out.cameraPose.emplace(Vector6d::Zero()));
    });
    fields.read("camera_pose_date", out.cameraPoseDate);
    fields.read("source_pose_date", out.sourcePoseDate);
    fields.close();
}

void readSimulatedCamera(const json& j, const std::string& path, Failure& failure, SimulatedCameraSpec& out) {
    Fields fields(j, path, failure);
    readPart(fields, "model", false, [&](const json& part, const std::string& where) {
        Fields model(part, where, failure);
        readModelFields(model, out.model.emplace());
        model.close();
    });
    readPart(fields, "pose", false, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, out.pose.emplace(Vector6d::Zero()));
    });
    readParameters(fields, simulatedCameraParameters(), out);
    fields.close();
}

void readSimulatedThermalCamera(const json& j, const std::string& path, Failure& failure,
                                SimulatedThermalCameraSpec& out) {
    Fields fields(j, path, failure);
    fields.read("profile", out.profile);
    readPart(fields, "pose", false, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, out.pose.emplace(Vector6d::Zero()));
    });
    readParameters(fields, simulatedThermalCameraParameters(), out);
    readPart(fields, "calibration", false, [&](const json& part, const std::string& where) {
        Fields calibration(part, where, failure);
        readThermalCalibration(calibration, failure, out.calibration);
        calibration.close();
    });
    fields.close();
}

void readThermalCalibration(Fields& fields, Failure& failure, ThermalCalibration& out) {
    readPart(fields, "lens", false, [&](const json& part, const std::string& where) {
        readCalibratedCamera(part, where, failure, out.lens.emplace());
    });
    fields.read("lens_date", out.lensDate);
    double uncertainty_m = std::numeric_limits<double>::quiet_NaN();
    fields.read("pose_uncertainty", EdgeUnit::LengthMm, uncertainty_m);
    if (!std::isnan(uncertainty_m))
        out.poseUncertainty_m = uncertainty_m;
    readPart(fields, "pose", out.poseUncertainty_m.has_value(),
             [&](const json& part, const std::string& where) {
                 readCoordinates(part, where, failure, out.pose.emplace(Vector6d::Zero()));
             });
    fields.read("pose_date", out.poseDate);
}

void putThermalCalibration(Json& j, const ThermalCalibration& calibration) {
    if (calibration.lens)
        j["lens"] = calibratedCameraJson(*calibration.lens);
    if (!calibration.lensDate.empty())
        j["lens_date"] = calibration.lensDate;
    if (calibration.pose)
        j["pose"] = coordinatesJson(*calibration.pose);
    if (!calibration.poseDate.empty())
        j["pose_date"] = calibration.poseDate;
    if (calibration.poseUncertainty_m)
        putQuantity(j, "pose_uncertainty", EdgeUnit::LengthMm, *calibration.poseUncertainty_m);
}

Json visionJson(const VisionSpec& vision) {
    Json j;
    j["dictionary"] = vision.dictionary;
    j["markers"] = Json::array();
    for (const MarkerSpec& marker : vision.markers)
        j["markers"].push_back(markerJson(marker));
    if (vision.camera)
        j["camera"] = cameraJson(vision);
    if (vision.cameraPose)
        j["camera_pose"] = coordinatesJson(*vision.cameraPose);
    if (!vision.cameraPoseDate.empty())
        j["camera_pose_date"] = vision.cameraPoseDate;
    if (!vision.sourcePoseDate.empty())
        j["source_pose_date"] = vision.sourcePoseDate;
    return j;
}

Json simulatedCameraJson(const SimulatedCameraSpec& camera) {
    Json j;
    if (camera.model)
        putModel(j["model"], *camera.model);
    if (camera.pose)
        j["pose"] = coordinatesJson(*camera.pose);
    putParameters(j, simulatedCameraParameters(), camera);
    return j;
}

Json simulatedThermalCameraJson(const SimulatedThermalCameraSpec& camera) {
    Json j;
    j["profile"] = camera.profile;
    if (camera.pose)
        j["pose"] = coordinatesJson(*camera.pose);
    putParameters(j, simulatedThermalCameraParameters(), camera);
    if (camera.calibration != ThermalCalibration())
        putThermalCalibration(j["calibration"], camera.calibration);
    return j;
}

} // namespace bask
