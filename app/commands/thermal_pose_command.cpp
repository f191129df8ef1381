// bask thermal-pose: where a thermal camera is, from frames of the held objects at known poses of the robot.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/commands/thermal_input.h"
#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/thermography/frame_file.h"
#include "engine/thermography/silhouette_pose.h"

#include <QCommandLineParser>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

constexpr const char* kThermalPose = "thermal-pose";
constexpr std::uintmax_t kLargestList = 1 << 20;
constexpr double kReading = 0.1; // the share of reading the frames
constexpr std::size_t kMaxPoseFrames = 200;

struct ListedFrame {
    std::string file;
    Vector6d pose = Vector6d::Zero(); ///< coordinates of X_RE
};

struct FrameList {
    Vector6d cameraPose = Vector6d::Zero(); ///< coordinates of X_RC, roughly
    std::vector<ListedFrame> frames;
};

Result<FrameList> readList(const std::string& path) {
    const auto text = readTextFile(path, kLargestList);
    if (!text)
        return text.error();
    return readJsonText<FrameList>(*text, path, [](const json& j, Failure& failure, FrameList& out) {
        Fields root(j, {}, failure);
        readPart(root, "camera_pose", true, [&](const json& pose, const std::string& place) {
            readCoordinates(pose, place, failure, out.cameraPose);
        });
        readEach(root, "frames", true, [&](const json& one, const std::string& place) {
            Fields fields(one, place, failure);
            ListedFrame frame;
            fields.read("file", frame.file, true);
            readPart(fields, "pose", true, [&](const json& pose, const std::string& where) {
                readCoordinates(pose, where, failure, frame.pose);
            });
            fields.close();
            out.frames.push_back(std::move(frame));
            if (out.frames.size() > kMaxPoseFrames)
                root.fail(MessageCode::FileTooLarge, "frames",
                          {"more frames", std::to_string(kMaxPoseFrames)});
        });
        root.close();
    });
}

Result<std::vector<SilhouetteView>> readViews(const std::string& listPath, const FrameList& list,
                                              const std::optional<ThermalProfile>& profile,
                                              Progress& progress, const ShareDone& done) {
    std::vector<SilhouetteView> views;
    const std::filesystem::path folder = std::filesystem::path(listPath).parent_path();
    for (const ListedFrame& listed : list.frames) {
        const std::string path = (folder / listed.file).string();
        auto frame = readFrame(path, profile);
        if (!frame)
            return frame.error();
        if (!frame->warnings.empty())
            progress.makeRoom();
        tellWarnings(kThermalPose, path, *frame);
        views.push_back({std::move(frame->picture), poseFromCoordinates(listed.pose)});
        tellShare(done, static_cast<double>(views.size()) / static_cast<double>(list.frames.size()));
    }
    return views;
}

const char* wordFor(Verdict verdict) {
    return verdict == Verdict::Good ? "good" : verdict == Verdict::Usable ? "usable" : "redo";
}

Json coordinatesJson(const Pose& X) {
    const Vector6d q = coordinatesFromPose(X);
    Json out;
    for (int k = 0; k < 6; ++k) {
        const EdgeUnit unit = coordinateUnit(k);
        out[readableKey(kCoordinateNames[static_cast<std::size_t>(k)], unit)] = fromSi(q[k], unit).value;
    }
    return out;
}

std::string jsonText(const SilhouettePose& found) {
    Json out{{"camera_pose", coordinatesJson(found.X_RC)}};
    for (int row = 0; row < 6; ++row) {
        Json line;
        for (int column = 0; column < 6; ++column)
            line.push_back(found.covariance(row, column));
        out["covariance"].push_back(std::move(line));
    }
    const Judgement judgement = judged(found);
    out["verdict"] = wordFor(judgement.verdict);
    out["verdict_mm"] = 1e3 * found.atObjects.position_m;
    out["verdict_across_mm"] = 1e3 * found.across_m;
    out["verdict_deg"] = degFromRad(found.atObjects.angle_rad);
    out["rms_px"] = found.rms_px;
    out["blur_px"] = found.blur_px;
    out["points"] = found.points;
    out["effective_points"] = found.effectivePoints;
    out["found_share"] = found.foundShare;
    out["robot_mm"] = 1e3 * found.robot_m;
    out["robot_deg"] = degFromRad(found.robot_rad);
    out["remarks"] = Json::array();
    for (const Message& remark : found.remarks)
        out["remarks"].push_back(describe(remark));
    return out.dump(1) + "\n";
}

std::string sentences(const SilhouettePose& found) {
    std::string out;
    const Json pose = coordinatesJson(found.X_RC);
    for (const auto& [name, value] : pose.items())
        out += (out.empty() ? "" : ", ") + name + " " + formatNumber(value.get<double>(), 6);
    out += "\n" + describe(judged(found).reason) + "\n";
    out += "edges are " + formatNumber(found.rms_px, 2) + " px from the outlines (root mean square)\n";
    for (const Message& remark : found.remarks)
        out += describe(remark) + "\n";
    return out;
}

bool isOfTheSilhouettes(MessageCode code) {
    switch (code) {
    case MessageCode::SilhouetteViewsFew:
    case MessageCode::SilhouetteOutside:
    case MessageCode::SilhouetteNoContrast:
    case MessageCode::SilhouetteContradicts:
    case MessageCode::SilhouetteAmbiguous:
        return true;
    default:
        return false;
    }
}

} // namespace

int thermalPoseCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Finds where a thermal camera is in the robot's base from the silhouettes of the held objects, "
        "which\n"
        "are warmer or colder than what is behind them, in frames at three or more poses of the robot.\n"
        "FRAMES.json: {\"camera_pose\": {...}, \"frames\": [{\"file\": \"a.raw\", \"pose\": {...}}, ...]}, "
        "with the\n"
        "camera's pose to 5 cm and 5 degrees, the robot's poses (coordinates as in experiments, such as\n"
        "\"z_cm\" and \"theta_x_deg\") and files beside it. Outlines, mountings, fixtures, shields and the\n"
        "source are the experiment's.\n"
        "Exit code: 0 done, 2 bad input, 3 no pose, or one to be measured again.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"camera", "The camera's intrinsics, as `bask calibrate-camera` writes them.", "CAM.yml"},
         {"profile", "The camera's profile: a name or a file, as of `bask thermal-frame`.", "NAME|FILE.json"},
         {"json", "Prints pose, covariance, verdict and residuals as JSON."}});
    parser.addPositionalArgument("EXPERIMENT.json", "The experiment.");
    parser.addPositionalArgument("FRAMES.json", "The frames with the robot's poses.");
    if (const auto code = parseCommand(parser, kThermalPose, arguments, 2))
        return *code;
    const auto experiment = readExperiment(parser.positionalArguments().at(0).toStdString());
    if (!experiment)
        return refuse(kThermalPose, experiment.error());
    const std::string listPath = parser.positionalArguments().at(1).toStdString();
    const auto list = readList(listPath);
    if (!list)
        return refuse(kThermalPose, list.error());
    if (!parser.isSet("camera"))
        return refuse(kThermalPose, QStringLiteral("--camera CAM.yml is needed"));
    const auto camera = readCamera(parser.value("camera").toStdString());
    if (!camera)
        return refuse(kThermalPose, camera.error());
    const auto profile = profileOption(parser);
    if (!profile)
        return refuse(kThermalPose, profile.error());
    Progress progress(1.0);
    const ShareDone done = progress.share();
    const auto views = readViews(listPath, *list, *profile, progress, partOf(done, 0.0, kReading));
    if (!views)
        return refuse(kThermalPose, views.error());
    CameraModel lens = *camera;
    if (lens.width == 0 && !views->empty()) { // a file of another tool
        lens.width = views->front().picture.width;
        lens.height = views->front().picture.height;
    }
    if (experiment->objects.empty())
        return refuse(kThermalPose, QStringLiteral("the experiment has no objects"));
    const auto found = silhouettePose(lens, *views, silhouetteScene(*experiment),
                                      poseFromCoordinates(list->cameraPose), {}, partOf(done, kReading, 1.0));
    progress.makeRoom();
    if (!found) {
        const int code = refuse(kThermalPose, found.error());
        return isOfTheSilhouettes(found.error().code()) ? kExitNegative : code;
    }
    std::fputs((parser.isSet("json") ? jsonText(*found) : sentences(*found)).c_str(), stdout);
    return judged(*found).verdict == Verdict::Redo ? kExitNegative : kExitDone;
}

} // namespace bask
