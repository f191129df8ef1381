#include "engine/base/message_code.h"
#include "engine/control/controller_catalogue.h"
#include "engine/experiment/controller_json.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/faults_json.h"
#include "engine/experiment/json_quantities.h"
#include "engine/experiment/material_json.h"
#include "engine/experiment/parameter_json.h"
#include "engine/experiment/rig_json.h"
#include "engine/experiment/text_file.h"
#include "engine/experiment/vision_json.h"
#include "engine/model/experiment_parameters.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineWidth = 110;

Json pointsJson(const std::vector<Eigen::Vector2d>& points) {
    Json j = Json::array();
    for (const Eigen::Vector2d& p : points)
        j.push_back({p.x(), p.y()});
    return j;
}

Json holesJson(const std::vector<Contour>& holes) {
    Json j = Json::array();
    for (const Contour& hole : holes)
        j.push_back(pointsJson(hole.points_m));
    return j;
}

Json contourJson(const Shape& shape, const ContourOrigin& origin) {
    Json j;
    if (const auto* disk = outlineAs<Disk>(shape)) {
        j["type"] = "disk";
        j["radius_m"] = disk->radius_m;
    } else if (const auto* fourier = outlineAs<FourierContour>(shape)) {
        j["type"] = "fourier";
        j["coefficients"] = Json::array();
        for (int k = -fourier->harmonics(); k <= fourier->harmonics(); ++k)
            j["coefficients"].push_back({k, fourier->coefficient(k).real(), fourier->coefficient(k).imag()});
    } else {
        j["type"] = "polygon";
        j["points_m"] = pointsJson(outlineAs<Contour>(shape)->points_m);
    }
    if (!holesOf(shape).empty())
        j["holes_m"] = holesJson(holesOf(shape));
    if (!origin.file.empty())
        j["file"] = origin.file;
    if (origin.harmonics != 0)
        j["harmonics"] = origin.harmonics;
    if (!origin.outline.points_m.empty())
        j["outline_m"] = pointsJson(origin.outline.points_m);
    if (!origin.holes.empty())
        j["outline_holes_m"] = holesJson(origin.holes);
    return j;
}

Json setPointsJson(const TimeTable<double>& profile) {
    Json j = Json::array();
    for (const auto& [time_s, value_K] : profile) {
        Json point;
        point["time_s"] = time_s;
        putQuantity(point, "temperature", EdgeUnit::Temperature, value_K);
        j.push_back(std::move(point));
    }
    return j;
}

Json motionJson(const TimeTable<Vector6d>& motion) {
    Json j = Json::array();
    for (const auto& [time_s, coordinates] : motion) {
        Json point;
        point["time_s"] = time_s;
        point.update(coordinatesJson(coordinates));
        j.push_back(std::move(point));
    }
    return j;
}

Json objectJson(const ObjectSpec& object) {
    Json j;
    j["name"] = object.name;
    putQuantity(j, "target", EdgeUnit::Temperature, object.target_K);
    j["contour"] = contourJson(object.shape, object.origin);
    j["material"] = materialJson(object.material);
    j["mounting"] = coordinatesJson(object.mounting);
    if (object.estimatedRates)
        putParameters(j["believed_rates"], heatRateParameters(), *object.estimatedRates);
    if (object.simulatedMaterial)
        j["simulated_material"] = materialJson(*object.simulatedMaterial);
    putParameters(j, objectLimitParameters(), object);
    if (object.readBy != ReadBy::Contact)
        j["read_by"] = readByName(object.readBy);
    return j;
}

/// Under keys that begin with `prefix`.
void putUnevenness(Json& j, const std::string& prefix, const Unevenness& uneven) {
    for (const SourcePartSpec& part : uneven.parts) {
        Json& written = j[prefix + "parts"].emplace_back();
        written["contour"] = contourJson(part.shape, part.origin);
        written["pose"] = coordinatesJson(part.pose);
        putChangedParameters(written, sourcePartParameters(), part);
    }
    for (const ProfilePoint& point : uneven.profile)
        putParameters(j[prefix + "profile"].emplace_back(), profilePointParameters(), point);
}

Json sourceJson(const SourceSpec& source) {
    Json j;
    j["contour"] = contourJson(source.shape, source.origin);
    putParameters(j, sourceParameters().first(1), source);
    if (!source.temperatureProfile.empty()) // beside the set point
        j["temperature_profile"] = setPointsJson(source.temperatureProfile);
    putParameters(j, sourceParameters().subspan(1, 1), source);
    putChangedParameters(j, sourceParameters().subspan(2), source);
    j["source_model"] = source.model == SourceModel::Paper ? "paper" : "gray";
    j["pose"] = coordinatesJson(source.pose);
    j["tracked"] = source.tracked;
    putUnevenness(j, "", source.uneven);
    return j;
}

Json robotJson(const Experiment& e) {
    Json j;
    j["free"] = Json::array();
    for (std::size_t k = 0; k < 6; ++k) {
        if (e.robot.free[k])
            j["free"].push_back(kCoordinateNames[k]);
    }
    putParameters(j, robotParameters(), e.robot);
    j["lower"] = coordinatesJson(e.robot.lower);
    j["upper"] = coordinatesJson(e.robot.upper);
    j["start"] = coordinatesJson(e.start);
    return j;
}

Json controllerJson(const ControllerSettings& c) {
    Json j;
    j["kind"] = c.kind.key();
    for (const ControllerEntry& entry : controllerCatalogue())
        for (const ControllerGain& gain : entry.gains)
            putParameter(j[entry.group], *gain.facts, gain.get(c), false);
    putParameters(j, controllerParameters(), c);
    return j;
}

Json simulationJson(const SimulationSpec& s) {
    Json j;
    j["seed"] = s.seed;
    putParameters(j, simulationParameters(), s);
    if (s.naturalConvection)
        j["convection"] = "natural";
    if (!s.sourceMotion.empty())
        j["source_motion"] = motionJson(s.sourceMotion);
    if (s.sourceEmittance)
        j["source_emittance"] = *s.sourceEmittance;
    if (s.sourcePose)
        j["source_pose"] = coordinatesJson(*s.sourcePose);
    if (s.camera != SimulatedCameraSpec())
        j["camera"] = simulatedCameraJson(s.camera);
    if (s.thermalCamera)
        j["thermal_camera"] = simulatedThermalCameraJson(*s.thermalCamera);
    if (!s.faults.empty())
        j["faults"] = faultsJson(s.faults);
    if (s.sourceUneven)
        putUnevenness(j, "source_", *s.sourceUneven);
    return j;
}

void putPlates(Json& j, const char* key, const char* pose, const std::vector<PlateSpec>& plates) {
    for (const PlateSpec& plate : plates) {
        Json& written = j[key].emplace_back();
        written["name"] = plate.name;
        written["contour"] = contourJson(plate.shape, plate.origin);
        written[pose] = coordinatesJson(plate.pose);
    }
}

Json experimentJson(const Experiment& e) {
    Json j;
    j["format"] = "bask-experiment";
    j["version"] = kExperimentFormat;
    j["title"] = e.title;
    j["source"] = sourceJson(e.source);
    putQuantity(j["environment"], "temperature", EdgeUnit::Temperature, e.environment_K);
    if (e.air.isNatural)
        j["air"]["convection"] = "natural";
    putParameters(j["air"], airParameters(), e.air);
    if (j["air"].empty())
        j.erase("air");
    j["objects"] = Json::array();
    for (const ObjectSpec& object : e.objects)
        j["objects"].push_back(objectJson(object));
    putPlates(j, "fixtures", "mounting", e.fixtures);
    putPlates(j, "shields", "pose", e.shields);
    j["robot"] = robotJson(e);
    j["controller"] = controllerJson(e.controller);
    putParameters(j["sampling"], samplingParameters(), e.sampling);
    j["simulation"] = simulationJson(e.simulation);
    if (e.vision != VisionSpec())
        j["vision"] = visionJson(e.vision);
    if (e.rig)
        j["rig"] = rigJson(*e.rig);
    if (e.safety != SafetySpec())
        putChangedParameters(j["safety"], safetyParameters(), e.safety);
    return j;
}

/// Text that is not UTF-8 is written with replacement characters instead of being refused.
std::string scalar(const Json& j) {
    return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void print(const Json& j, std::size_t indent, std::string& out);

/// Items in as few lines as fit.
void printPacked(const Json& j, std::size_t indent, std::string& out) {
    std::string line;
    std::string block;
    for (std::size_t i = 0; i < j.size(); ++i) {
        const std::string item = scalar(j[i]) + (i + 1 < j.size() ? "," : "");
        if (!line.empty() && indent + 2 + line.size() + 1 + item.size() > kLineWidth) {
            block += std::string(indent + 2, ' ') + line + '\n';
            line.clear();
        }
        line += (line.empty() ? "" : " ") + item;
    }
    if (block.empty() && indent + line.size() + 2 <= kLineWidth)
        out += '[' + line + ']';
    else
        out += "[\n" + block + std::string(indent + 2, ' ') + line + '\n' + std::string(indent, ' ') + ']';
}

void printItems(const Json& j, std::size_t indent, std::string& out) {
    const bool isObject = j.is_object();
    const std::string margin(indent + 2, ' ');
    out += isObject ? "{" : "[";
    const char* separator = "\n";
    for (const auto& item : j.items()) {
        out += separator + margin;
        if (isObject)
            out += scalar(item.key()) + ": ";
        print(item.value(), indent + 2, out);
        separator = ",\n";
    }
    out += '\n' + std::string(indent, ' ') + (isObject ? '}' : ']');
}

void print(const Json& j, std::size_t indent, std::string& out) {
    if (j.empty() || !j.is_structured())
        out += scalar(j);
    else if (j.is_array() && !j.front().is_object())
        printPacked(j, indent, out);
    else
        printItems(j, indent, out);
}

} // namespace

std::string experimentToJson(const Experiment& experiment) {
    std::string out;
    print(experimentJson(experiment), 0, out);
    return out + '\n';
}

Result<void> writeExperiment(const Experiment& experiment, const std::string& path) {
    if (auto valid = validate(experiment); !valid)
        return valid.error();
    return writeTextFile(path, experimentToJson(experiment));
}

std::string controllerToJson(const ControllerSettings& settings) {
    return controllerJson(settings).dump();
}

} // namespace bask
