// bask isosurface: the end-effector's positions, or angles, at which an object has a view factor or a steady
// temperature, as surfaces for ParaView.

#include "app/commands/command_line.h"
#include "app/commands/experiment_arguments.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/field_axes.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/exchange/field_file.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/model/experiment_rig.h"
#include "engine/model/uneven_source.h"

#include <QCommandLineParser>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <new>

namespace bask {
namespace {

constexpr double kMinStep = 0.01; ///< cm or degrees

/// Everything asked for on the command line, checked.
struct IsosurfaceArguments {
    TargetGeometry geometry;
    HeatRates rates;
    SurfaceSet set;             ///< without its surfaces
    std::vector<double> values; ///< view factors
    std::string path;           ///< empty: nothing is written
    double maxViewFactor = 1.0; ///< no pose has more
};

Result<Experiment> experimentAsked(const QCommandLineParser& parser, const std::string& path) {
    auto experiment = readExperiment(path);
    if (!experiment)
        return experiment;
    if (const auto replaced = replaceSourceModel(parser, *experiment); !replaced)
        return replaced.error();
    if (auto valid = validate(*experiment); !valid)
        return valid.error();
    return experiment;
}

Error outOfRange(const std::string& where, double value, double min, double max, const char* unit) {
    return {MessageCode::ValueOutOfRange,
            where,
            {formatNumber(value), formatNumber(min), formatNumber(max), unit}};
}

/// "F=0.3" or "T=50" (degrees Celsius) as a view factor, with its steady temperature.
Result<void> readValue(const QString& text, IsosurfaceArguments& request) {
    const std::string where = "--value " + text.toStdString();
    if (!text.startsWith("F=") && !text.startsWith("T="))
        return badValue("value", text, "F=0.3 or T=50 (degrees Celsius)");
    const auto number = finiteNumber(text.mid(2), where);
    if (!number)
        return number.error();
    const HeatRates& rates = request.rates;
    const bool isFactor = text.startsWith('F');
    const double min = isFactor ? 0.0 : celsiusFromKelvin(rates.steadyTemperature_K(0.0));
    const double maxF = request.maxViewFactor;
    const double max = isFactor ? maxF : celsiusFromKelvin(rates.steadyTemperature_K(maxF));
    if (*number < min || *number > max)
        return outOfRange(where, *number, min, max, isFactor ? "" : "degC");
    const double F = isFactor ? *number : rates.steadyViewFactor(kelvinFromCelsius(*number));
    request.values.push_back(F);
    request.set.steadyTemperatures_K.push_back(rates.steadyTemperature_K(F));
    return {};
}

/// Those of --value, or the object's target.
Result<void> readValues(const QCommandLineParser& parser, const ObjectSpec& object,
                        IsosurfaceArguments& request) {
    QStringList values = parser.values("value");
    if (values.isEmpty())
        values = {"T=" + QString::number(celsiusFromKelvin(object.target_K), 'g', 12)};
    for (const QString& value : values)
        if (auto read = readValue(value, request); !read)
            return read;
    return {};
}

Result<void> readGrid(const QCommandLineParser& parser, const Experiment& experiment,
                      TargetGeometry& geometry) {
    const QString name = parser.value("subset");
    if (name != "translation" && name != "rotation")
        return Error(MessageCode::ValueUnknown, "--subset", {name.toStdString(), "translation, rotation"});
    const bool moves = name == "translation";
    double step = moves ? kSurfaceStep_m : kSurfaceStep_rad;
    if (parser.isSet("step")) {
        const auto asked = finiteNumber(parser.value("step"), "--step");
        if (!asked)
            return asked.error();
        if (*asked < kMinStep || *asked > 90.0)
            return outOfRange("--step", *asked, kMinStep, 90.0, moves ? "cm" : "degrees");
        step = moves ? *asked / 100.0 : radFromDeg(*asked);
    }
    geometry.axes =
        surfaceAxes(moves ? PoseSubset::Translation : PoseSubset::Rotation, experiment.robot, step);
    geometry.fixed = experiment.start;
    geometry.clearance_m = experiment.robot.clearance_m;
    if (!parser.isSet("held"))
        return {};
    Vector6d typed; // cm and degrees
    typed << 100.0 * geometry.fixed.head<3>(), geometry.fixed.tail<3>().unaryExpr(&degFromRad);
    if (auto fixed = parseFixed(parser.value("held").toStdString(), geometry.axes, typed, "--held"); !fixed)
        return fixed;
    geometry.fixed << 0.01 * typed.head<3>(), typed.tail<3>().unaryExpr(&radFromDeg);
    return {};
}

Result<std::string> outputPath(const QCommandLineParser& parser, const std::string& input) {
    if (!parser.isSet("o"))
        return std::string();
    const std::string path = parser.value("o").toStdString();
    if (const std::string extension = std::filesystem::path(path).extension(); extension != ".vtp")
        return Error(MessageCode::ValueUnknown, "-o " + path, {extension, ".vtp"});
    if (auto place = checkOutputs({input}, {{path}}); !place)
        return place.error();
    if (auto file = checkSurfaceFile(path); !file)
        return file.error();
    return path;
}

Result<IsosurfaceArguments> readIsosurfaceArguments(const QCommandLineParser& parser) {
    const std::string input = parser.positionalArguments().value(0).toStdString();
    const auto experiment = experimentAsked(parser, input);
    if (!experiment)
        return experiment.error();
    const auto chosen = chosenObject(parser, *experiment);
    if (!chosen)
        return chosen.error();
    const ObjectSpec& object = **chosen;
    const SourceSpec& source = experiment->source;
    IsosurfaceArguments request{{radiatingSource(*experiment),
                                 poseFromCoordinates(source.pose),
                                 mountedContours(*experiment),
                                 screensOf(*experiment),
                                 {}},
                                {},
                                {},
                                {},
                                {}};
    request.geometry.only = static_cast<std::size_t>(&object - experiment->objects.data());
    request.rates = heatRates(object, surroundingsOf(*experiment));
    request.maxViewFactor = emissionWithoutRings(*experiment).maxWeight(experiment->source.temperature_K);
    request.set.title = "end-effector where object \"" + object.name +
                        "\" has the view factors over the source of " +
                        std::filesystem::path(input).filename().string();
    if (auto values = readValues(parser, object, request); !values)
        return values.error();
    if (auto grid = readGrid(parser, *experiment, request.geometry); !grid)
        return grid.error();
    auto path = outputPath(parser, input);
    if (!path)
        return path.error();
    request.path = *path;
    return request;
}

/// One line a surface; whether there is any.
bool printSurfaces(const IsosurfaceArguments& request, const Field& field) {
    double min = INFINITY;
    double max = -INFINITY;
    for (const double F : field.values) // comparisons with NaN are false
        min = F < min ? F : min, max = F > max ? F : max;
    bool any = false;
    for (std::size_t i = 0; i < request.values.size(); ++i) {
        const Isosurface& surface = request.set.surfaces[i];
        const std::string F = formatNumber(surface.value, 6);
        const std::string t_degC = formatNumber(celsiusFromKelvin(request.set.steadyTemperatures_K[i]), 6);
        any |= !surface.empty();
        if (surface.empty())
            std::fprintf(
                stderr,
                "bask isosurface: F = %s (%s degC) is nowhere on the grid, where F goes from %s to %s\n",
                F.c_str(), t_degC.c_str(), formatNumber(min).c_str(), formatNumber(max).c_str());
        else
            std::printf("F = %s (%s degC): %zu points, %zu triangles\n", F.c_str(), t_degC.c_str(),
                        surface.points.size(), surface.triangles.size());
    }
    return any;
}

Result<std::vector<std::shared_ptr<const Field>>> surfaceFields(const TargetGeometry& geometry) {
    Progress progress(1.0);
    return targetFields(geometry, {}, progress.share());
}

int cutAndWrite(IsosurfaceArguments& request) {
    const auto fields = surfaceFields(request.geometry);
    if (!fields)
        return refuse("isosurface", fields.error());
    const Field& field = *fields->front();
    request.set.surfaces = isosurfaces(field, request.values);
    if (!printSurfaces(request, field))
        return kExitNegative;
    if (!request.path.empty())
        if (const auto written = writeSurfaces(field, request.set, request.path); !written)
            return refuse("isosurface", written.error());
    return kExitDone;
}

} // namespace

int isosurfaceCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Writes the surfaces on which the end-effector gives an object a view factor or a steady "
        "temperature,\n"
        "in the robot's axes (m or rad), as VTK poly data for ParaView. Prints a line for each surface.\n"
        "The other objects stand in its light where they are mounted so; this shade is rough "
        "(docs/model.md).\n"
        "Without -o nothing is written. Exit code 3: the object has none of the values on the grid.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("EXPERIMENT.json", "Source, objects and robot.");
    parser.addOptions(
        {{"object", "The experiment's object; may be left out when there is one only.", "NAME"},
         {"value",
          "F=0.3, a view factor, or T=50, a steady temperature in degrees Celsius; may be given several "
          "times. The object's target unless given.",
          "VALUE"},
         {"subset",
          "translation: over the robot's workspace, the angles held; rotation: over -90 to 90 degrees "
          "about each axis, the position held.",
          "SUBSET", "translation"},
         {"held",
          "The other coordinates, in cm and degrees: theta_x=10,theta_z=5. Those of the experiment's start "
          "unless given.",
          "VALUES"},
         {"step", "Of the grid, in cm or degrees; 1 cm or 5 degrees unless given.", "STEP"},
         {"source-model", "gray or paper, instead of the experiment's.", "MODEL"},
         {{"o", "output"}, "The file to write.", "FILE.vtp"}});
    if (const auto code = parseCommand(parser, "isosurface", arguments, 1, {"value"}))
        return *code;
    try {
        auto request = readIsosurfaceArguments(parser);
        return request ? cutAndWrite(*request) : refuse("isosurface", request.error());
    } catch (const std::bad_alloc&) {
        std::fputs("bask isosurface: there is not enough memory for that many samples\n", stderr);
        return kExitBadInput;
    }
}

} // namespace bask
