// bask plate-profile: the temperature of a source over its radius, from frames of the bare plate.

#include "app/commands/command_line.h"
#include "app/commands/experiment_arguments.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/commands/thermal_input.h"
#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/text_file.h"
#include "engine/thermography/frame_file.h"
#include "engine/thermography/plate_profile.h"

#include <QCommandLineParser>
#include <QFile>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

constexpr const char* kPlateProfile = "plate-profile";
constexpr std::uintmax_t kLargestPose = 1 << 20;
constexpr qsizetype kMaxPlateFrames = 200;
constexpr double kReading = 0.5; // the share of reading the frames
constexpr const char* kFirstColumns = "radius_mm,temperature_ratio";

/// What is known of the plate and the camera, which is not zeroed: docs/thermal-cameras.md.
ReadingUncertainty uncertaintyAbout(const Experiment& experiment, const ThermalProfile& camera) {
    constexpr double kNotZeroed_K = 1.0;
    ReadingUncertainty out;
    out.gain = camera.uncertainty.gain;
    out.gainAbout_K = experiment.environment_K;
    out.offset_K = std::max(kNotZeroed_K, camera.uncertainty.offset_K);
    out.emittance = experiment.source.emittanceUncertainty;
    out.T_env_K = 0.3;
    return out;
}

/// X_RC. Other keys are left alone: `bask thermal-pose --json` writes them.
Result<Pose> readPose(const std::string& path) {
    const auto text = readTextFile(path, kLargestPose);
    if (!text)
        return text.error();
    const auto pose = readJsonText<Vector6d>(*text, path, [](const json& j, Failure& failure, Vector6d& out) {
        out.setZero();
        Fields root(j, {}, failure);
        readPart(root, "camera_pose", true, [&](const json& part, const std::string& place) {
            readCoordinates(part, place, failure, out);
        });
        root.close(Fields::Unknown::Ignored);
    });
    return pose ? Result<Pose>(poseFromCoordinates(*pose)) : pose.error();
}

Result<void> checkPlace(const std::vector<std::string>& inputs, const std::string& path) {
    if (auto place = checkOutputs(inputs, {{path}}); !place)
        return place;
    QFile old(QString::fromStdString(path));
    if (old.exists() && old.size() > 0 &&
        (!old.open(QIODevice::ReadOnly) || !old.readLine(kLargestPose).startsWith(kFirstColumns)))
        return Error{MessageCode::OutputForeign, path, {"a profile of a source"}};
    return {};
}

/// A lens of another tool's file takes the pictures' size.
Result<std::vector<PlateView>> readViews(const std::vector<std::string>& paths,
                                         const std::optional<ThermalProfile>& profile,
                                         const Experiment& experiment, CameraModel& lens, Progress& progress,
                                         const ShareDone& done) {
    std::vector<PlacedPlate> covers;
    for (const PlateSpec& shield : experiment.shields)
        covers.push_back({shield.shape, poseFromCoordinates(shield.pose)});
    std::vector<PlateView> views;
    for (const std::string& path : paths) {
        auto frame = readFrame(path, profile);
        if (!frame)
            return frame.error();
        if (!frame->warnings.empty())
            progress.makeRoom();
        tellWarnings(kPlateProfile, path, *frame);
        if (lens.width == 0) {
            lens.width = frame->picture.width;
            lens.height = frame->picture.height;
        }
        if (const auto size = checkSize(lens, frame->picture.width, frame->picture.height); !size)
            return located(size.error(), path);
        views.push_back({std::move(frame->picture), covers});
        tellShare(done, static_cast<double>(views.size()) / static_cast<double>(paths.size()));
    }
    return views;
}

/// The source's own temperature while the frames were taken.
Result<double> ownTemperature_K(const QCommandLineParser& parser, const Experiment& experiment) {
    const QString text = parser.value("temperature");
    bool isNumber = !parser.isSet("temperature");
    const double own_K =
        isNumber ? experiment.source.temperature_K : kelvinFromCelsius(text.toDouble(&isNumber));
    if (!isNumber || !(own_K > experiment.environment_K) || !(own_K < kMaxBand_K))
        return badValue("temperature", parser.isSet("temperature") ? text : QStringLiteral("the set point"),
                        "degC, above the experiment's environment");
    return own_K;
}

struct PlateProfileArguments {
    Experiment experiment;
    CameraModel lens;
    Pose X_RC = Pose::Identity();
    double own_K = 0.0;
    std::vector<PlateView> views;
    ThermalProfile profile; ///< of tables without one: a usual camera's band and uncertainty
};

Result<PlateProfileArguments> readPlateProfileArguments(const QCommandLineParser& parser, Progress& progress,
                                                        const ShareDone& done) {
    QStringList files = parser.positionalArguments();
    const std::string path = files.takeFirst().toStdString();
    auto experiment = readExperiment(path);
    if (!experiment)
        return experiment.error();
    auto lens = readCamera(parser.value("camera").toStdString());
    if (!lens)
        return lens.error();
    const auto X_RC = readPose(parser.value("pose").toStdString());
    if (!X_RC)
        return X_RC.error();
    const auto profile = profileOption(parser);
    if (!profile)
        return profile.error();
    const auto own_K = ownTemperature_K(parser, *experiment);
    if (!own_K)
        return own_K.error();
    std::vector<std::string> frames;
    for (const QString& file : files)
        frames.push_back(file.toStdString());
    if (parser.isSet("output")) {
        std::vector<std::string> inputs = inputsOf(path, *experiment);
        for (const char* option : {"camera", "pose"})
            inputs.push_back(parser.value(option).toStdString());
        inputs.insert(inputs.end(), frames.begin(), frames.end());
        if (const auto place = checkPlace(inputs, parser.value("output").toStdString()); !place)
            return place.error();
    }
    auto views = readViews(frames, *profile, *experiment, *lens, progress, done);
    if (!views)
        return views.error();
    if (!PixelRays::isUsable(*lens))
        return Error{MessageCode::LensNotInvertible, parser.value("camera").toStdString()};
    return PlateProfileArguments{std::move(*experiment),
                                 std::move(*lens),
                                 *X_RC,
                                 *own_K,
                                 std::move(*views),
                                 profile->value_or(ThermalProfile())};
}

double ratioOf(const PlateRing& ring, double own_K, double environment_K) {
    return (ring.T_K - environment_K) / (own_K - environment_K);
}

std::string jsonText(const PlateProfile& found, double own_K, double environment_K) {
    Json out{{"rings", Json::array()}, {"remarks", Json::array()}};
    for (const PlateRing& ring : found.rings)
        out["rings"].push_back({{"radius_mm", 1e3 * ring.radius_m},
                                {"temperature_degC", celsiusFromKelvin(ring.T_K)},
                                {"temperature_ratio", ratioOf(ring, own_K, environment_K)},
                                {"standard_uncertainty_K", ring.standardUncertainty_K},
                                {"own_uncertainty_K", ring.ownUncertainty_K},
                                {"pixels", ring.pixels}});
    for (const Message& remark : found.remarks)
        out["remarks"].push_back(describe(remark));
    return out.dump(1) + "\n";
}

std::string sentences(const PlateProfile& found, double own_K, double environment_K) {
    std::string out;
    for (const PlateRing& ring : found.rings)
        out += formatNumber(1e3 * ring.radius_m, 3) + " mm: " + formatNumber(celsiusFromKelvin(ring.T_K), 4) +
               " degC, standard uncertainty " + formatNumber(ring.standardUncertainty_K, 2) + " K (" +
               formatNumber(ring.ownUncertainty_K, 2) + " K of its own), ratio " +
               formatNumber(ratioOf(ring, own_K, environment_K), 4) + ", " + std::to_string(ring.pixels) +
               " pixels\n";
    for (const Message& remark : found.remarks)
        out += describe(remark) + "\n";
    return out;
}

bool isOfThePlatePictures(MessageCode code) {
    switch (code) {
    case MessageCode::ThermalFaceOutside:
    case MessageCode::ThermalFaceGrazing:
    case MessageCode::ThermalFaceHidden:
    case MessageCode::ThermalFaceSmall:
    case MessageCode::ThermalReflectionBrighter:
    case MessageCode::PlateProfilePixelsFew:
        return true;
    default:
        return false;
    }
}

/// Refuses a plate that the camera does not tell better than a thermometer has to.
Result<void> checkUsable(const PlateProfile& found, double emittance) {
    const PlateRing& worst = *std::ranges::max_element(found.rings, {}, &PlateRing::standardUncertainty_K);
    if (worst.standardUncertainty_K <= kMaxReadingUncertainty_K)
        return {};
    return Error{MessageCode::ThermalFaceUnusable,
                 {},
                 {formatNumber(emittance), differenceArg(2.0 * worst.standardUncertainty_K, 2),
                  differenceArg(2.0 * kMaxReadingUncertainty_K, 2)}};
}

void addPlateProfileOptions(QCommandLineParser& parser) {
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"camera", "The camera's intrinsics, as `bask calibrate-camera` writes them. Required.", "CAM.yml"},
         {"pose",
          "Where the camera is in the robot's base: {\"camera_pose\": {...}}, as `bask thermal-pose --json` "
          "tells it. Required.",
          "POSE.json"},
         {"profile", "The camera's profile: a name or a file, as of `bask thermal-frame`.", "NAME|FILE.json"},
         {"temperature",
          "What the source's own sensor told meanwhile; without it the experiment's set point.", "DEGC"},
         {{"o", "output"}, "The profile, for source.profile_file of an experiment.", "PROFILE.csv"},
         {"json", "Prints the rings with their uncertainties as JSON."}});
    parser.addPositionalArgument("EXPERIMENT.json", "The experiment.");
    parser.addPositionalArgument("FRAME", "Frames of the plate, at most 200.", "FRAME...");
}

} // namespace

int plateProfileCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Measures the temperature of a source's plate in rings about its middle, from frames of the bare "
        "plate\n"
        "that a fixed thermal camera took while it was hot: no object is between them. Outline, pose and\n"
        "emittance of the source, shields and the room are the experiment's; the source is a disk.\n"
        "Exit code: 0 done, 2 bad input or unwritable output, 3 the frames do not tell the profile.");
    addPlateProfileOptions(parser);
    if (const auto code = parseCommand(parser, kPlateProfile, arguments, -2))
        return *code;
    if (parser.positionalArguments().size() > kMaxPlateFrames + 1)
        return refuse(kPlateProfile, QStringLiteral("at most %1 frames").arg(kMaxPlateFrames));
    if (!parser.isSet("camera") || !parser.isSet("pose"))
        return refuse(kPlateProfile, QStringLiteral("--camera CAM.yml and --pose POSE.json are needed"));
    Progress progress(1.0);
    const ShareDone done = progress.share();
    const auto request = readPlateProfileArguments(parser, progress, partOf(done, 0.0, kReading));
    progress.makeRoom();
    if (!request)
        return refuse(kPlateProfile, request.error());
    const SourceSpec& source = request->experiment.source;
    const double room_K = request->experiment.environment_K, own_K = request->own_K;
    if (!std::holds_alternative<Disk>(source.shape) || !source.uneven.parts.empty())
        return refuse(kPlateProfile, QStringLiteral("only a source that is one disk has a profile"));
    const auto found = plateProfile(
        *bandOf(request->profile), PixelRays(request->lens), request->X_RC,
        {source.shape, poseFromCoordinates(source.pose)}, request->views, {source.emittance, {}, room_K},
        uncertaintyAbout(request->experiment, request->profile), {}, partOf(done, kReading, 1.0));
    progress.makeRoom();
    if (!found) {
        const int code = refuse(kPlateProfile, found.error());
        return isOfThePlatePictures(found.error().code()) ? kExitNegative : code;
    }
    std::fputs(
        (parser.isSet("json") ? jsonText(*found, own_K, room_K) : sentences(*found, own_K, room_K)).c_str(),
        stdout);
    if (const auto usable = checkUsable(*found, source.emittance); !usable) {
        refuse(kPlateProfile, usable.error());
        return kExitNegative;
    }
    if (parser.isSet("output"))
        if (const auto written =
                writeTextFile(parser.value("output").toStdString(), radialProfileCsv(*found, own_K, room_K));
            !written)
            return refuse(kPlateProfile, written.error());
    return kExitDone;
}

} // namespace bask
