// bask thermal-frame: one frame of a thermal camera as temperatures, with the statistics of regions.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/thermal_input.h"
#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_model.h"
#include "engine/thermography/frame_file.h"
#include "engine/thermography/region_statistics.h"

#include <QCommandLineParser>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

constexpr const char* kThermalFrame = "thermal-frame";
constexpr std::uintmax_t kLargestRegions = 1 << 20;
constexpr std::size_t kMaxRegions = 100, kMaxCorners = 1000;

struct Region {
    std::string name;
    std::vector<Eigen::Vector2d> polygon_px;
};

struct MeasuredRegion {
    std::string name;
    Result<RegionStatistics> statistics;
    bool isPartlyOutside = false; ///< of the picture
};

/// Which frame of a file, counted from 1, and how many there are.
struct ChosenFrame {
    std::size_t number = 1, count = 1;
};

Region readRegion(const json& j, const std::string& path, Failure& failure) {
    Region out;
    Fields fields(j, path, failure);
    fields.readName("name", out.name, true);
    if (const json* points = fields.find("polygon_px", true); points && !failure) {
        const std::string place = fields.pathOf("polygon_px");
        if (!points->is_array() || points->size() < 3 || points->size() > kMaxCorners)
            fields.fail(MessageCode::JsonWrongType, place,
                        {"a list of 3 to 1000 corners", typeName(*points)});
        for (std::size_t k = 0; points->is_array() && k < points->size() && !failure; ++k) {
            const json& p = (*points)[k];
            if (p.is_array() && p.size() == 2 && p[0].is_number() && p[1].is_number())
                out.polygon_px.emplace_back(p[0].get<double>(), p[1].get<double>());
            else
                fields.fail(MessageCode::JsonWrongType, place + '[' + std::to_string(k) + ']',
                            {"[column, row]", typeName(p)});
        }
    }
    fields.close();
    if (out.name.empty())
        fields.fail(MessageCode::JsonWrongType, fields.pathOf("name"), {"a name", "nothing"});
    return out;
}

Result<std::vector<Region>> readRegions(const std::string& path) {
    const auto text = readTextFile(path, kLargestRegions);
    if (!text)
        return text.error();
    return readJsonText<std::vector<Region>>(
        *text, path, [](const json& j, Failure& failure, std::vector<Region>& out) {
            Fields root(j, {}, failure);
            readEach(root, "regions", true, [&](const json& one, const std::string& place) {
                out.push_back(readRegion(one, place, failure));
                for (std::size_t k = 0; k + 1 < out.size(); ++k)
                    if (out[k].name == out.back().name)
                        root.fail(MessageCode::ThermalRegionTwice, place + ".name",
                                  {plainWords(out[k].name)});
                if (out.size() > kMaxRegions)
                    root.fail(MessageCode::FileTooLarge, "regions",
                              {"more regions", std::to_string(kMaxRegions)});
            });
            root.close();
            if (out.empty())
                root.fail(MessageCode::JsonMissingKey, "regions", {"regions[0]"});
        });
}

Result<RegionStatistics> measured(const ThermalPicture& picture, const Region& region) {
    const std::vector<int> pixels = pixelsIn(region.polygon_px, picture.width, picture.height);
    if (pixels.empty())
        return Error{MessageCode::ThermalFaceOutside, {}};
    return regionStatistics(picture, pixels);
}

bool isPartlyOutside(const ThermalPicture& picture, const Region& region) {
    constexpr double kEdge = -0.5; // of the first pixel
    return std::ranges::any_of(region.polygon_px, [&](const Eigen::Vector2d& corner) {
        return corner.x() < kEdge || corner.y() < kEdge || corner.x() > picture.width + kEdge ||
               corner.y() > picture.height + kEdge;
    });
}

/// Without the last digits, which are those of the conversion: 20, not 20.00000000000003.
double shown(double value) {
    constexpr double kSteps = 1e9;
    return std::round(value * kSteps) / kSteps + 0.0;
}

double degC(double T_K) {
    return shown(celsiusFromKelvin(T_K));
}

Json regionJson(const MeasuredRegion& region) {
    Json out{{"name", region.name}};
    if (!region.statistics) {
        out["invalid"] = describe(region.statistics.error());
        return out;
    }
    const RegionStatistics& found = *region.statistics;
    out["pixels"] = found.pixels;
    out["partly_outside"] = region.isPartlyOutside;
    out["mean_degC"] = degC(found.mean_K);
    out["standard_error_K"] = shown(found.standardError_K);
    out["spread_K"] = shown(found.spread_K);
    out["noise_K"] = shown(found.noise_K);
    out["min_degC"] = degC(found.min_K);
    out["max_degC"] = degC(found.max_K);
    if (found.difference)
        out["largest_difference_K"] = {
            {"value", shown(found.difference->value_K)},
            {"standard_uncertainty", shown(found.difference->standardUncertainty_K)},
            {"by_noise", shown(found.difference->byNoise_K)}};
    return out;
}

std::string jsonText(const ThermalPicture& picture, const Result<PictureRange>& range,
                     const std::vector<MeasuredRegion>& regions, const std::optional<ChosenFrame>& chosen) {
    Json out{{"width", picture.width}, {"height", picture.height}};
    if (chosen) {
        out["frame"] = chosen->number;
        out["frames"] = chosen->count;
    }
    out["min_degC"] = range ? Json(degC(range->min_K)) : Json();
    out["max_degC"] = range ? Json(degC(range->max_K)) : Json();
    out["mean_degC"] = range ? Json(degC(range->mean_K)) : Json();
    for (const MeasuredRegion& region : regions)
        out["regions"].push_back(regionJson(region));
    return out.dump(regions.empty() ? -1 : 1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string words(double T_K) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", celsiusFromKelvin(T_K) + 0.0);
    return text.data();
}

std::string sentences(const ThermalPicture& picture, const Result<PictureRange>& range,
                      const std::vector<MeasuredRegion>& regions, const std::optional<ChosenFrame>& chosen) {
    std::string out;
    if (chosen)
        out = "frame " + std::to_string(chosen->number) + " of " + std::to_string(chosen->count) + ": ";
    out += pixelsText(picture.width, picture.height) + " pixels";
    out += range ? ", " + words(range->min_K) + " to " + words(range->max_K) + " degC, mean " +
                       words(range->mean_K) + " degC\n"
                 : "; of the whole picture: " + describe(range.error()) + "\n";
    for (const MeasuredRegion& region : regions) {
        out += printable(region.name) + ": ";
        if (const auto& found = region.statistics)
            out += words(found->mean_K) + " degC, standard error " + formatNumber(found->standardError_K, 2) +
                   " K, spread " + formatNumber(found->spread_K, 2) + " K, " + words(found->min_K) + " to " +
                   words(found->max_K) + " degC in " + std::to_string(found->pixels) + " pixels";
        else
            out += describe(found.error());
        if (region.statistics && region.statistics->difference)
            out += "; largest difference across it " +
                   formatNumber(region.statistics->difference->value_K, 2) + " K (" +
                   formatNumber(region.statistics->difference->byNoise_K, 2) + " K by noise alone)";
        if (region.statistics && region.isPartlyOutside)
            out += "; a part of it is outside of the picture";
        out += "\n";
    }
    return out;
}

void addThermalFrameOptions(QCommandLineParser& parser) {
    QString names;
    for (const ThermalProfile& profile : shippedThermalProfiles())
        names += QString::fromStdString(profile.name) + QStringLiteral(", ");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"profile",
          QStringLiteral(
              "The camera: %1or a profile as a file (docs/thermal-cameras.md). Only a CSV tells its size "
              "without it.")
              .arg(names),
          "NAME|FILE.json"},
         {"frame",
          "Which frame of a file that holds several, the camera's bytes one after another or a TIFF of "
          "several pictures; counted from 1.",
          "K"},
         {"json", "Prints width, height, min_degC, max_degC and mean_degC as JSON; with --frame also frame "
                  "and frames, how many there are."},
         {"regions",
          "Polygons whose statistics are told, too: {\"regions\": [{\"name\", \"polygon_px\": [[column, "
          "row], "
          "...]}]}, pixel centres at whole numbers from the upper left.",
          "REGIONS.json"}});
    parser.addPositionalArgument("FILE", "The frame; at most 64 MiB, the camera's bytes with --frame more.");
}

/// Empty without the option.
Result<std::optional<ChosenFrame>> frameOption(const QCommandLineParser& parser, const std::string& path,
                                               const std::optional<ThermalProfile>& profile) {
    if (!parser.isSet("frame"))
        return std::optional<ChosenFrame>();
    const auto count = frameCount(path, profile);
    if (!count)
        return count.error();
    bool isNumber = false;
    const qulonglong number = parser.value("frame").toULongLong(&isNumber);
    if (!isNumber || number < 1 || number > *count)
        return Error{MessageCode::ThermalFrameNone,
                     path,
                     {plainWords(parser.value("frame").toStdString()), std::to_string(*count)}};
    return std::optional(ChosenFrame{static_cast<std::size_t>(number), *count});
}

} // namespace

int thermalFrameCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Reads one frame of a thermal camera and tells its size and its apparent temperatures, those of "
        "black\n"
        "bodies that look the same. A frame is the camera's own bytes (.raw .bin .y16 .yuyv), a PNG or TIFF "
        "of\n"
        "16 bits with the camera's numbers, or a table in degC (.csv .txt .tsv); a file with another ending "
        "is\n"
        "told by its content. Of a file with several frames, --frame chooses one. A size, a format or a "
        "value\n"
        "that does not fit is refused, not guessed.\n"
        "Exit code: 0 done, 2 a frame that does not fit, or another bad input, 3 a region without a "
        "temperature.");
    addThermalFrameOptions(parser);
    if (const auto code = parseCommand(parser, kThermalFrame, arguments, 1))
        return *code;
    const auto profile = profileOption(parser);
    if (!profile)
        return refuse(kThermalFrame, profile.error());
    std::vector<Region> asked;
    if (parser.isSet("regions")) {
        auto read = readRegions(parser.value("regions").toStdString());
        if (!read)
            return refuse(kThermalFrame, read.error());
        asked = std::move(*read);
    }
    const std::string path = parser.positionalArguments().front().toStdString();
    const auto chosen = frameOption(parser, path, *profile);
    if (!chosen)
        return refuse(kThermalFrame, chosen.error());
    const auto frame =
        readFrame(path, *profile, *chosen ? std::optional((*chosen)->number - 1) : std::nullopt);
    if (!frame)
        return refuse(kThermalFrame, frame.error());
    const auto range = pictureRange(frame->picture);
    if (!range && asked.empty())
        return refuse(kThermalFrame, located(range.error(), path));
    tellWarnings(kThermalFrame, path, *frame);
    std::vector<MeasuredRegion> regions;
    bool areAllKnown = true;
    for (const Region& region : asked) {
        regions.push_back(
            {region.name, measured(frame->picture, region), isPartlyOutside(frame->picture, region)});
        areAllKnown = areAllKnown && regions.back().statistics.ok();
    }
    const std::string text = parser.isSet("json") ? jsonText(frame->picture, range, regions, *chosen)
                                                  : sentences(frame->picture, range, regions, *chosen);
    std::fputs(text.c_str(), stdout);
    return areAllKnown ? kExitDone : kExitNegative;
}

} // namespace bask
