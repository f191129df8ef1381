// bask field: samples the view factor, or the steady temperature, on a grid of poses and writes it for
// ParaView.

#include "app/commands/command_line.h"
#include "app/commands/experiment_arguments.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/field_axes.h"
#include "app/drawing/field_blocks.h"
#include "app/studies/study_output.h"
#include "engine/base/message_code.h"
#include "engine/exchange/field_store.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/model/experiment_rig.h"
#include "engine/model/uneven_source.h"

#include <QCommandLineParser>
#include <QCryptographicHash>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>
#include <thread>

namespace bask {
namespace {

using SteadyTime = std::chrono::steady_clock;

constexpr double kBeforeProgress_s = 1.0; // before progress is shown

/// Everything asked for on the command line, checked.
struct FieldArguments {
    FieldRequest field;
    FieldFile file = {};
    ShardOptions shard = {};
    std::string besides =
        "{}"; ///< of a divided field: what the file does not say of how it was asked for, JSON object
};

Error refused(const std::string& option, const std::string& expected, const std::string& found) {
    return {MessageCode::JsonWrongType, option, {expected, found}};
}

FieldQuantity steadyTemperature(const Experiment& experiment, const ObjectSpec& object) {
    const HeatRates rates = heatRates(object, surroundingsOf(experiment));
    return {"steady_temperature", "K", [rates](double F) { return rates.steadyTemperature_K(F); }};
}

/// The experiment by its hash.
std::string besides(const std::string& experiment, const std::string& object, const QString& shade) {
    const QByteArray hash =
        QCryptographicHash::hash(QByteArray::fromStdString(experiment), QCryptographicHash::Sha256);
    const nlohmann::json json{{"experiment_sha256", hash.toHex().toStdString()},
                              {"object", object},
                              {"shade", shade.toStdString()}};
    return json.dump();
}

/// Source, object and quantity; axes, held values and tolerance are still those of the default.
Result<FieldArguments> readScene(const QCommandLineParser& parser, const std::string& path) {
    std::optional<Experiment> experiment;
    const ObjectSpec* object = nullptr;
    if (!path.empty()) {
        auto read = readExperiment(path);
        if (!read)
            return read.error();
        experiment = std::move(*read);
        if (parser.isSet("object") || !parser.isSet("preset")) { // which has one of its own
            const auto chosen = chosenObject(parser, *experiment);
            if (!chosen)
                return chosen.error();
            object = *chosen;
        }
    } else if (parser.isSet("object") || !parser.isSet("preset")) {
        return refused("EXPERIMENT.json", "an experiment (or a preset without --object)", "none");
    }
    const QString quantity = parser.value("quantity");
    if (quantity != "F" && quantity != "T")
        return Error(MessageCode::ValueUnknown, "--quantity", {quantity.toStdString(), "F, T"});
    if (quantity == "T" && object == nullptr)
        return refused("--quantity T", "an experiment with an object named by --object", "none");
    if ((object == nullptr || experiment->objects.size() < 2) && parser.isSet("shade"))
        return refused("--shade", "an object of an experiment, beside which others are", "none");
    const Shape shape = object ? object->shape : presetObject();
    FieldArguments request{{experiment ? radiatingSource(*experiment) : RadiatingContour(presetSource()),
                            RadiatingContour(shape),
                            {}},
                           {}};
    const QString shade = parser.value("shade");
    if (shade != "rough" && shade != "exact" && shade != "none")
        return Error(MessageCode::ValueUnknown, "--shade", {shade.toStdString(), "rough, exact, none"});
    request.field.isShadeRough = shade == "rough";
    if (object != nullptr &&
        shade != "none") { // the coordinates are the object's own; the others stand beside it
        const Pose X_OE = poseFromCoordinates(object->mounting).inverse();
        for (const ObjectSpec& other : experiment->objects)
            if (&other != object)
                request.field.others.push_back(
                    {RadiatingContour(other.shape), X_OE * poseFromCoordinates(other.mounting)});
    }
    if (quantity == "T")
        request.field.quantity = steadyTemperature(*experiment, *object);
    request.besides = besides(experiment ? experimentToJson(*experiment) : std::string(),
                              object ? object->name : std::string(), shade);
    request.file.title =
        (object ? "object \"" + object->name + '"' : "disk of 15 mm radius") +
        (experiment ? " over the source of " + std::filesystem::path(path).filename().string()
                    : " over a disk of 100 mm radius");
    return request;
}

Result<void> readGrid(const QCommandLineParser& parser, FieldRequest& field) {
    if (parser.isSet("axes") && parser.isSet("preset"))
        return Error(MessageCode::JsonTwoSpellings, "", {"--axes", "--preset"});
    if (!parser.isSet("axes") && !parser.isSet("preset"))
        return refused("--axes", "axes such as x=-0.2:0.2:0.01 (or a --preset)", "nothing");
    if (parser.isSet("preset")) {
        const auto preset = presetGrid(parser.value("preset").toStdString());
        if (!preset)
            return preset.error();
        field.axes = preset->axes;
        field.fixed = preset->fixed;
    } else {
        auto axes = parseFieldAxes(parser.value("axes").toStdString());
        if (!axes)
            return axes.error();
        field.axes = std::move(*axes);
    }
    if (parser.isSet("hold"))
        if (auto fixed = parseFixed(parser.value("hold").toStdString(), field.axes, field.fixed); !fixed)
            return fixed;
    field.withGradient = parser.isSet("gradient");
    if (parser.isSet("tolerance")) {
        bool ok = false;
        field.tolerance = parser.value("tolerance").toDouble(&ok);
        if (!ok)
            return refused("--tolerance", "a number", '"' + parser.value("tolerance").toStdString() + '"');
    }
    return {};
}

Result<FieldArguments> readFieldArguments(const QCommandLineParser& parser) {
    const std::string path = parser.positionalArguments().value(0).toStdString();
    auto request = readScene(parser, path);
    if (!request)
        return request.error();
    if (const auto grid = readGrid(parser, request->field); !grid)
        return grid.error();
    auto shard = readShardOptions(parser);
    if (!shard)
        return shard.error();
    request->shard = *shard;
    request->file.withGradient = request->field.withGradient;
    if (!parser.isSet("o"))
        return request->shard.shard
                   ? refused("--shard", "-o FILE with it, beside which the part is", "nothing")
                   : std::move(request);
    const std::string out = parser.value("o").toStdString();
    request->file.path = out;
    const std::vector<std::string> inputs = path.empty() ? std::vector<std::string>{} : std::vector{path};
    if (const auto place = checkOutputs(inputs, {{out}}); !place)
        return place.error();
    if (const auto file = checkFieldOutput(out, request->field.axes, request->field.withGradient); !file)
        return file.error();
    return request;
}

/// 1.5e7 where printf writes 1.5e+07.
std::string shortExponent(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", value);
    std::string out = text;
    const std::size_t e = out.find('e');
    return out.substr(0, e + 1) + std::to_string(std::stoi(out.substr(e + 1)));
}

/// Two significant digits, never with an exponent.
std::string plainSeconds(double time_s) {
    char text[64];
    std::snprintf(text, sizeof text, "%.1e", time_s);
    const int exponent = std::stoi(std::string(text).substr(std::string(text).find('e') + 1));
    std::snprintf(text, sizeof text, "%.*f", std::clamp(1 - exponent, 0, 12), time_s);
    return text;
}

void printRange(const Field& header, const FieldFigures& figures) {
    if (figures.min <= figures.max)
        std::printf("%s%s%s from %s to %s\n", header.quantity.c_str(), header.unit.empty() ? "" : "_",
                    header.unit.c_str(), formatNumber(figures.min, 9).c_str(),
                    formatNumber(figures.max, 9).c_str());
}

void printSpeed(std::size_t count, double time_s) {
    std::printf("%zu samples, %s s, %s samples/s\n", count, plainSeconds(time_s).c_str(),
                shortExponent(static_cast<double>(count) / time_s).c_str());
}

/// What a reader of the numbers has to know, on standard error.
void tellOf(const char* command, const Field& header, std::size_t count, const FieldTally& tally) {
    if (tally.undefined > 0)
        std::fprintf(stderr,
                     "bask %s: %zu of %zu samples %s no value (NaN): object and source overlap in one "
                     "plane there\n",
                     command, tally.undefined, count, count == 1 ? "has" : "have");
    if (tally.unreached > 0)
        std::fprintf(stderr,
                     "bask %s: %zu of %zu samples may err by more than the tolerance %s, by %s at most\n",
                     command, tally.unreached, count, formatNumber(header.tolerance).c_str(),
                     formatNumber(tally.largestError).c_str());
    if (header.isShadeRough)
        std::fprintf(stderr,
                     "bask %s: the shade of the other objects is rough, to about a hundredth of what they "
                     "take; see --shade\n",
                     command);
}

std::string roughBytes(double bytes) {
    constexpr std::array kUnits{"kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    for (bytes /= 1e3; bytes >= 999.5 && unit + 1 < kUnits.size(); ++unit)
        bytes /= 1e3;
    return formatNumber(bytes, bytes < 99.5 ? 2 : 3) + ' ' + kUnits[unit];
}

/// Before it begins: how large it will be, and about how long it takes, by some samples all over the grid.
void tellBefore(const FieldSampler& sampler, const FieldFile& file, const ShardOptions& shard) {
    constexpr std::size_t kProbes = 64, kTogether = 16;
    constexpr double kProbe_s = 0.5;
    const std::size_t samples = sampler.samples();
    std::array<double, 7 * kTogether> numbers;
    const SteadyTime::time_point start = SteadyTime::now();
    std::size_t probed = 0;
    double took_s = 0.0;
    for (std::size_t k = 0; k < kProbes && took_s < kProbe_s; ++k) {
        const std::size_t begin = samples / kProbes * k;
        const std::size_t end = std::min(begin + kTogether, samples);
        (void)sampler.sample(begin, end, numbers.data(),
                             file.withGradient ? numbers.data() + kTogether : nullptr);
        probed += end - begin;
        took_s = std::chrono::duration<double>(SteadyTime::now() - start).count();
    }
    const double threads =
        shard.threads > 0 ? shard.threads : std::max(1U, std::thread::hardware_concurrency());
    const double all_s = took_s * static_cast<double>(samples) / static_cast<double>(probed) / threads;
    const double share = shard.shard ? 1.0 / shard.shard->of : 1.0;
    if (all_s * share < kBeforeProgress_s)
        return;
    std::fprintf(stderr, "bask field: %zu samples", samples);
    if (!file.path.empty())
        std::fprintf(stderr, ", %s",
                     roughBytes(fieldStoreBytes(sampler.header(), file.withGradient)).c_str());
    std::fprintf(stderr, "; this takes about %s\n", roughDuration(all_s * share).c_str());
}

int sampleAndWrite(const FieldArguments& request) {
    const auto sampler = FieldSampler::of(request.field);
    if (!sampler)
        return refuse("field", sampler.error());
    tellBefore(*sampler, request.file, request.shard);
    if (request.shard.shard)
        return runShard("field", request.file.path,
                        fieldWork(*sampler, request.file.withGradient,
                                  fieldAsked(request.file, sampler->header(), request.besides)),
                        request.shard);
    const SteadyTime::time_point start = SteadyTime::now();
    const auto figures = sampleInto(request.file, *sampler, request.shard.threads);
    const double time_s = std::chrono::duration<double>(SteadyTime::now() - start).count();
    if (!figures)
        return refuse("field", figures.error());
    tellOf("field", sampler->header(), sampler->samples(), figures->tally);
    printRange(sampler->header(), *figures);
    printSpeed(sampler->samples(), time_s);
    return kExitDone;
}

} // namespace

int fieldCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Samples the view factor of an object over the source on a grid of up to six of the coordinates\n"
        "x, y, z (m) and theta_x, theta_y, theta_z (rad, R = Rz Ry Rx) of the object's centre in the "
        "source's\n"
        "frame, on all cores, and writes a VTK image for ParaView (.vti, up to four axes) or an HDF5 file "
        "(.h5, also\n"
        "larger than memory; docs/fields.md). The other objects of the experiment go "
        "along and "
        "shade\n"
        "it where they stand in its light. The last line printed says how many samples were computed and how "
        "fast.\n"
        "Without -o nothing is written.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("EXPERIMENT.json", "Source and objects; a preset needs none.",
                                 "[EXPERIMENT.json]");
    parser.addOptions(
        {{"object", "The experiment's object; may be left out when there is one only.", "NAME"},
         {"axes",
          "name=first:last:step, with commas between: x=-0.2:0.2:0.01,z=0.01:0.3:0.01. The first "
          "axis runs fastest; in a .vti a fourth becomes one array a step.",
          "AXES"},
         {"hold", "The other coordinates, 0 unless given: z=0.05,theta_x=0.1.", "VALUES"},
         {"preset",
          "paper-translation (x, y, z; 48000 samples) or paper-rotation (three angles at z = 5 cm; 729000): "
          "a disk of 1.5 cm over a disk of 10 cm, unless EXPERIMENT and --object say otherwise.",
          "NAME"},
         {"quantity", "F, the view factor, or T, the steady temperature in K (needs an object).", "F|T", "F"},
         {"shade",
          "rough, exact or none: of the experiment's other objects. Rough is right to about a hundredth of "
          "what they take; exact goes to 1e-5 and takes some ten to a hundred times as long.",
          "SHADE", "rough"},
         {"gradient", "Also the derivatives of F by the six coordinates."},
         {"tolerance", "Of F, absolute; 1e-9 unless given. The shade has its own.", "NUMBER"},
         {{"o", "output"}, "The file to write.", "FILE"}});
    addShardOptions(parser);
    const bool parsed = parser.parse(QStringList{"bask"} + arguments);
    const auto given = parser.positionalArguments().size();
    if (const auto code = parseCommand(parser, "field", arguments, parsed && given == 0 ? 0 : 1))
        return *code;
    try {
        const auto request = readFieldArguments(parser);
        return request ? sampleAndWrite(*request) : refuse("field", request.error());
    } catch (const std::bad_alloc&) {
        std::fputs("bask field: there is not enough memory for that many samples\n", stderr);
        return kExitBadInput;
    }
}

int mergeField(const MergedParts& parts, const nlohmann::json& work, const QString& path) {
    const auto place = checkOutputs({}, {{path.toStdString()}});
    if (!place)
        return refuse("merge", place.error());
    const auto merged = mergeFieldInto(parts, work, path.toStdString());
    if (!merged)
        return refuse("merge", merged.error());
    tellOf("merge", merged->header, sampleCount(merged->header.axes), merged->figures.tally);
    printRange(merged->header, merged->figures);
    return kExitDone;
}

} // namespace bask
