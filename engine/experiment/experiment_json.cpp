#include "engine/base/edge_units.h"
#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/control/controller_catalogue.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/faults_json.h"
#include "engine/experiment/material_json.h"
#include "engine/experiment/outline_json.h"
#include "engine/experiment/parameter_json.h"
#include "engine/experiment/radial_profile_file.h"
#include "engine/experiment/rig_json.h"
#include "engine/experiment/vision_json.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/uneven_source.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <type_traits>

namespace bask {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxFileSize = 32u << 20; // bytes
constexpr double kCentredTolerance_m = 1e-9;

FourierContour shifted(const FourierContour& contour, const Eigen::Vector2d& by_m) {
    auto coefficients = contour.coefficients();
    coefficients.at(coefficients.size() / 2) += std::complex(by_m.x(), by_m.y());
    return FourierContour(std::move(coefficients));
}

Eigen::Vector2d centroidOf(const FourierContour& contour) {
    const std::complex<double> centroid = contour.area() > 0.0 ? contour.centroid() : 0.0;
    return {centroid.real(), centroid.imag()};
}

Eigen::Vector2d centroidOf(const Contour& polygon) {
    return contourCentroid(polygon);
}

/// Whether an outline that is off its centroid is moved there: where it has a pose of its own, it stays.
enum class Centring { Moved, AsGiven };

/// The holes move with the outline.
template <class Outline>
Shape placedShape(const Outline& outline, std::vector<Contour> holes, Centring centring) {
    const Eigen::Vector2d centroid = centroidOf(outline);
    if (centring == Centring::AsGiven || !(centroid.norm() > kCentredTolerance_m))
        return withHoles(outline, std::move(holes));
    for (Contour& hole : holes)
        hole = shifted(hole, -centroid);
    return withHoles(shifted(outline, -centroid), std::move(holes));
}

/// An outline in a file beside the experiment, read and fitted now.
void readImport(Fields& fields, const std::string& folder, Shape& shape, ContourOrigin& origin) {
    ContourImportOptions options;
    fields.read("file", origin.file, true);
    fields.read("harmonics", origin.harmonics);
    if (fields.find("scale_px_per_mm") != nullptr)
        fields.read("scale_px_per_mm", options.scale_px_per_mm.emplace());
    if (fields.find("unit") != nullptr)
        fields.readWord("unit",
                        {{"m", LengthUnit::Metre},
                         {"cm", LengthUnit::Centimetre},
                         {"mm", LengthUnit::Millimetre},
                         {"in", LengthUnit::Inch}},
                        options.unit.emplace());
    fields.close();
    if (fields.failure())
        return;
    const std::filesystem::path file = std::filesystem::path(folder) / origin.file;
    const Result<PickedOutline> picked = readPicked(file.string(), options);
    if (!picked)
        return void(fields.failure() = located(picked.error(), fields.pathOf("file")));
    const std::string name = origin.file;
    Result<OriginalShape> made = shapeFromOutline(picked->contour, picked->holes, origin.harmonics);
    if (!made)
        return void(fields.failure() = located(made.error(), fields.pathOf("harmonics")));
    shape = std::move(made->shape);
    origin = std::move(made->origin);
    origin.file = name;
}

void readContourForm(const json& j, const std::string& path, const std::string& folder, Failure& failure,
                     Shape& shape, ContourOrigin& origin, Centring centring = Centring::Moved) {
    enum class Form { Disk, Fourier, Polygon, Import };
    Fields fields(j, path, failure);
    Form form = Form::Disk;
    fields.readWord("type",
                    {{"disk", Form::Disk},
                     {"fourier", Form::Fourier},
                     {"polygon", Form::Polygon},
                     {"import", Form::Import}},
                    form, true);
    if (failure)
        return;
    if (form == Form::Import)
        return readImport(fields, folder, shape, origin);
    if (form == Form::Disk) {
        Disk disk;
        fields.read("radius_m", disk.radius_m, true);
        shape = withHoles(disk, readHoles(fields, "holes_m"));
    } else if (form == Form::Fourier) {
        fields.find("coefficients", true);
        const FourierContour series = readCoefficients(fields, "coefficients");
        shape = placedShape(series, readHoles(fields, "holes_m"), centring);
        for (const char* figure :
             {"area_mm2", "net_area_mm2", "perimeter_mm", "rms_mm", "max_mm", "hausdorff_mm", "area_error",
              "centre_mm", "unit", "warnings", "outline", "holes"})
            fields.find(figure); // what bask fit-contour says of a fit is no part of the shape
    } else {
        fields.find("points_m", true);
        const Contour polygon = readPoints(fields, "points_m");
        shape = placedShape(polygon, readHoles(fields, "holes_m"), centring);
    }
    fields.read("file", origin.file);
    fields.read("harmonics", origin.harmonics);
    origin.outline = readPoints(fields, "outline_m");
    origin.holes = readHoles(fields, "outline_holes_m");
    fields.close();
}

/// An array of objects of a time and a value, which readValue(fields, value) reads.
template <class T, class ReadValue>
void readTimeTable(Fields& parent, const std::string& key, TimeTable<T>& out, ReadValue readValue) {
    readEach(parent, key, false, [&](const json& j, const std::string& path) {
        Fields fields(j, path, parent.failure());
        TimePoint<T> point;
        if constexpr (std::is_same_v<T, Vector6d>)
            point.value.setZero();
        fields.read("time_s", point.time_s, true);
        readValue(fields, point.value);
        fields.close();
        out.push_back(point);
    });
}

void readMaterial(const json& j, const std::string& path, Failure& failure, Material& out) {
    Fields fields(j, path, failure);
    readMaterialFields(fields, out);
    fields.close();
}

ObjectSpec readObject(const json& j, const std::string& path, const std::string& folder, Failure& failure) {
    ObjectSpec object;
    Fields fields(j, path, failure);
    fields.read("name", object.name, true);
    fields.read("target", EdgeUnit::Temperature, object.target_K, true);
    readPart(fields, "contour", true, [&](const json& part, const std::string& where) {
        readContourForm(part, where, folder, failure, object.shape, object.origin);
    });
    readPart(fields, "material", true, [&](const json& part, const std::string& where) {
        readMaterial(part, where, failure, object.material);
    });
    readPart(fields, "mounting", true, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, object.mounting);
    });
    readPart(fields, "believed_rates", false, [&](const json& part, const std::string& where) {
        readParameters(part, where, failure, heatRateParameters(), object.estimatedRates.emplace());
    });
    readPart(fields, "simulated_material", false, [&](const json& part, const std::string& where) {
        readMaterial(part, where, failure, object.simulatedMaterial.emplace());
    });
    readParameters(fields, objectLimitParameters(), object);
    std::map<std::string, ReadBy> readings;
    for (const ReadBy each : {ReadBy::Contact, ReadBy::Camera, ReadBy::Both})
        readings[readByName(each)] = each;
    fields.readWord("read_by", readings, object.readBy);
    fields.close();
    return object;
}

/// Two at a time, since an outline in a picture takes a tenth of a second; told is what is wrong with the
/// first that cannot be read. A large picture takes a gigabyte meanwhile.
void readObjects(Fields& root, const std::string& folder, std::vector<ObjectSpec>& out) {
    struct Read {
        Failure failure;
        ObjectSpec object;
    };
    std::vector<std::future<Read>> reads;
    readEach(root, "objects", true, [&](const json& value, const std::string& where) {
        if (reads.size() >= 2)
            reads[reads.size() - 2].wait();
        reads.push_back(std::async(std::launch::async, [&value, where, &folder] {
            Read read;
            read.object = readObject(value, where, folder, read.failure);
            return read;
        }));
    });
    for (std::future<Read>& each : reads) {
        Read read = each.get();
        if (!root.failure())
            root.failure() = std::move(read.failure);
        out.push_back(std::move(read.object));
    }
}

/// A fixture or a shield, whose pose is under the key `pose`.
PlateSpec readPlate(const json& j, const std::string& path, const std::string& pose,
                    const std::string& folder, Failure& failure) {
    PlateSpec plate;
    Fields fields(j, path, failure);
    fields.read("name", plate.name, true);
    readPart(fields, "contour", true, [&](const json& part, const std::string& where) {
        readContourForm(part, where, folder, failure, plate.shape, plate.origin, Centring::AsGiven);
    });
    readPart(fields, pose, true, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, plate.pose);
    });
    fields.close();
    return plate;
}

void refuseLonger(Fields& fields, const std::string& key, std::size_t min, std::size_t max,
                  const std::string& unit) {
    if (const json* list = fields.find(key); list != nullptr && list->is_array() && list->size() > max)
        fields.fail(MessageCode::ValueOutOfRange, fields.pathOf(key),
                    {std::to_string(list->size()), std::to_string(min), std::to_string(max), unit});
}

void readPlates(Fields& root, const std::string& key, const std::string& pose, const std::string& folder,
                std::vector<PlateSpec>& out) {
    refuseLonger(root, key, 0, kMaxPlates, "");
    readEach(root, key, false, [&](const json& value, const std::string& where) {
        out.push_back(readPlate(value, where, pose, folder, root.failure()));
    });
}

SourcePartSpec readSourcePart(const json& j, const std::string& path, const std::string& folder,
                              Failure& failure) {
    SourcePartSpec part;
    Fields fields(j, path, failure);
    readPart(fields, "contour", true, [&](const json& contour, const std::string& where) {
        readContourForm(contour, where, folder, failure, part.shape, part.origin, Centring::AsGiven);
    });
    readPart(fields, "pose", false, [&](const json& pose, const std::string& where) {
        readCoordinates(pose, where, failure, part.pose);
    });
    readParameters(fields, sourcePartParameters(), part);
    fields.close();
    return part;
}

void refuseEmpty(Fields& fields, const std::string& key) {
    if (const json* list = fields.find(key); list != nullptr && list->is_array() && list->empty())
        fields.fail(MessageCode::SourcePartsNone, fields.pathOf(key));
}

/// Parts and profile under keys that begin with `prefix`.
void readUnevenness(Fields& fields, const std::string& prefix, const std::string& folder, Unevenness& out) {
    const std::string parts = prefix + "parts", profile = prefix + "profile", file = prefix + "profile_file";
    for (const std::string& key : {parts, profile})
        refuseEmpty(fields, key);
    refuseLonger(fields, parts, 1, kMaxSourceParts, "parts");
    readEach(fields, parts, false, [&](const json& part, const std::string& path) {
        out.parts.push_back(readSourcePart(part, path, folder, fields.failure()));
    });
    readEach(fields, profile, false, [&](const json& point, const std::string& path) {
        readParameters(point, path, fields.failure(), profilePointParameters(), out.profile.emplace_back());
    });
    std::string name;
    fields.read(file, name);
    if (name.empty() || fields.failure())
        return;
    if (!out.profile.empty())
        return fields.fail(MessageCode::JsonTwoSpellings, fields.pathOf(file), {profile, file});
    auto read = readRadialProfile((std::filesystem::path(folder) / name).string());
    if (read)
        out.profile = std::move(*read);
    else
        fields.failure() = located(read.error(), fields.pathOf(file));
}

void readSource(const json& j, const std::string& path, const std::string& folder, Failure& failure,
                SourceSpec& out) {
    Fields fields(j, path, failure);
    readPart(fields, "contour", true, [&](const json& part, const std::string& where) {
        readContourForm(part, where, folder, failure, out.shape, out.origin);
    });
    readParameters(fields, sourceParameters(), out);
    fields.readWord("source_model", {{"gray", SourceModel::Gray}, {"paper", SourceModel::Paper}}, out.model);
    readPart(fields, "pose", false, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, out.pose);
    });
    readTimeTable(fields, "temperature_profile", out.temperatureProfile, [](Fields& point, double& value_K) {
        point.read("temperature", EdgeUnit::Temperature, value_K, true);
    });
    fields.read("tracked", out.tracked);
    readUnevenness(fields, "", folder, out.uneven);
    fields.close();
}

void readFree(Fields& fields, RobotLimits& out) {
    if (fields.find("free") != nullptr)
        out.free.fill(false);
    readEach(fields, "free", false, [&](const json& axis, const std::string& where) {
        if (!axis.is_string())
            return fields.fail(MessageCode::JsonWrongType, where, {"text", typeName(axis)});
        const auto name = axis.get<std::string>();
        const auto it = std::ranges::find_if(kCoordinateNames, [&](const char* n) { return name == n; });
        if (it == kCoordinateNames.end())
            return fields.fail(MessageCode::ValueUnknown, where,
                               {plainWords(name), "x, y, z, theta_x, theta_y, theta_z"});
        bool& free = out.free[static_cast<std::size_t>(it - kCoordinateNames.begin())];
        if (free)
            return fields.fail(MessageCode::AxisTwice, where, {name});
        free = true;
    });
}

void readRobot(const json& j, const std::string& path, Failure& failure, Experiment& out) {
    Fields fields(j, path, failure);
    readFree(fields, out.robot);
    readParameters(fields, robotParameters(), out.robot);
    const auto coordinates = [&](const std::string& key, Vector6d& q) {
        readPart(fields, key, false, [&](const json& part, const std::string& where) {
            readCoordinates(part, where, failure, q);
        });
    };
    coordinates("lower", out.robot.lower);
    coordinates("upper", out.robot.upper);
    coordinates("start", out.start);
    fields.close();
}

void readController(const json& j, const std::string& path, Failure& failure, ControllerSettings& out) {
    Fields fields(j, path, failure);
    std::map<std::string, ControllerKind> kinds;
    for (const ControllerEntry& entry : controllerCatalogue())
        kinds.emplace(entry.kind.key(), entry.kind);
    fields.readWord("kind", kinds, out.kind);
    for (const ControllerEntry& entry : controllerCatalogue())
        readPart(fields, entry.group, false, [&](const json& part, const std::string& where) {
            Fields group(part, where, failure);
            for (const ControllerGain& gain : entry.gains)
                if (const auto si = readParameter(group, *gain.facts, false))
                    gain.set(out, *si);
            group.close();
        });
    readParameters(fields, controllerParameters(), out);
    fields.close();
}

const char* const kConvectionWord = "convection"; ///< "natural", beside h as a number

const std::map<std::string, bool> kConvectionWords{{"natural", true}, {"unknown", false}};

void readAir(const json& j, const std::string& path, Failure& failure, Air& out) {
    Fields fields(j, path, failure);
    fields.readWord(kConvectionWord, kConvectionWords, out.isNatural);
    readParameters(fields, airParameters(), out);
    fields.close();
}

void readSimulation(const json& j, const std::string& path, const std::string& folder, Failure& failure,
                    SimulationSpec& out) {
    Fields fields(j, path, failure);
    fields.read("seed", out.seed);
    readParameters(fields, simulationParameters(), out);
    fields.readWord(kConvectionWord, {{"given", false}, {"natural", true}}, out.naturalConvection);
    readTimeTable(fields, "source_motion", out.sourceMotion, readCoordinateFields);
    if (fields.find("source_emittance") != nullptr)
        fields.read("source_emittance", out.sourceEmittance.emplace());
    readPart(fields, "source_pose", false, [&](const json& part, const std::string& where) {
        readCoordinates(part, where, failure, out.sourcePose.emplace(Vector6d::Zero()));
    });
    readPart(fields, "camera", false, [&](const json& part, const std::string& where) {
        readSimulatedCamera(part, where, failure, out.camera);
    });
    readPart(fields, "thermal_camera", false, [&](const json& part, const std::string& where) {
        readSimulatedThermalCamera(part, where, failure, out.thermalCamera.emplace());
    });
    readFaults(fields, "faults", out.faults);
    Unevenness uneven;
    readUnevenness(fields, "source_", folder, uneven);
    if (!uneven.isEven())
        out.sourceUneven = std::move(uneven);
    fields.close();
}

Experiment readRoot(const json& j, const std::string& folder, Failure& failure) {
    Experiment e;
    Fields root(j, "", failure);
    readHeader(root, "bask-experiment", kExperimentFormat);
    root.read("title", e.title);
    const auto part = [&](const std::string& key, bool required, auto read, auto& out) {
        readPart(root, key, required,
                 [&](const json& value, const std::string& where) { read(value, where, failure, out); });
    };
    readPart(root, "source", true, [&](const json& value, const std::string& where) {
        readSource(value, where, folder, failure, e.source);
    });
    readPart(root, "environment", true, [&](const json& value, const std::string& where) {
        Fields fields(value, where, failure);
        fields.read("temperature", EdgeUnit::Temperature, e.environment_K, true);
        fields.close();
    });
    part("air", false, readAir, e.air);
    part("robot", false, readRobot, e);
    part("controller", false, readController, e.controller);
    readPart(root, "sampling", false, [&](const json& value, const std::string& where) {
        readParameters(value, where, failure, samplingParameters(), e.sampling);
    });
    readPart(root, "simulation", false, [&](const json& value, const std::string& where) {
        readSimulation(value, where, folder, failure, e.simulation);
    });
    part("vision", false, readVision, e.vision);
    readPart(root, "rig", false, [&](const json& value, const std::string& where) {
        readRig(value, where, failure, e.rig.emplace());
    });
    readPart(root, "safety", false, [&](const json& value, const std::string& where) {
        readParameters(value, where, failure, safetyParameters(), e.safety);
    });
    const json* objects = root.find("objects", true);
    root.find("fixtures");
    root.find("shields");
    // Keys first: an import is only worth its time in a file that is otherwise right.
    root.close();
    if (objects != nullptr && objects->is_array() && objects->size() > 6)
        root.fail(MessageCode::TooManyObjects, "objects",
                  {std::to_string(objects->size()), std::to_string(e.robot.degreesOfFreedom())});
    readObjects(root, folder, e.objects);
    readPlates(root, "fixtures", "mounting", folder, e.fixtures);
    readPlates(root, "shields", "pose", folder, e.shields);
    return e;
}

} // namespace

Result<Experiment> experimentFromJson(const std::string& text, const std::string& where,
                                      const std::string& folder) {
    if (text.size() > kMaxFileSize)
        return Error(MessageCode::FileTooLarge, where,
                     {std::to_string(text.size() >> 20) + " MiB", "32 MiB"});
    return readJsonText<Experiment>(text, where, [&](const json& j, Failure& failure, Experiment& out) {
        out = readRoot(j, folder, failure);
        if (!failure)
            failure = failureOf(validate(out));
    });
}

Result<Experiment> readExperiment(const std::string& path) {
    const auto text = readTextFile(path, kMaxFileSize);
    if (!text)
        return text.error();
    return experimentFromJson(*text, path, std::filesystem::path(path).parent_path().string());
}

} // namespace bask
