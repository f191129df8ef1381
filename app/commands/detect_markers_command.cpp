// bask detect-markers: the ArUco markers in a picture, and where they are.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/calibration/camera_file.h"
#include "engine/calibration/dictionary_file.h"
#include "engine/calibration/marker_pose.h"
#include "engine/experiment/text_file.h"
#include "engine/shape/contour_import.h"

#include <QCommandLineParser>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDetectMarkers = "detect-markers";
constexpr double kMinSize_m = 1e-3, kMaxSize_m = 10.0;

/// What a pose takes besides the picture.
struct PoseRequest {
    double size_m = 0.0;
    CameraModel camera;
};

struct DetectMarkersArguments {
    std::string path, jsonPath;
    MarkerDictionary dictionary;
    std::optional<PoseRequest> pose;
};

Result<MarkerDictionary> dictionaryOf(const std::string& text) {
    if (isMarkerDictionary(text))
        return MarkerDictionary{text};
    if (text.ends_with(".yml") || text.ends_with(".yaml"))
        return readDictionary(text);
    return Error{
        MessageCode::ValueUnknown, "--dictionary", {text, markerDictionaries() + ", or a file .yml"}};
}

Result<std::optional<PoseRequest>> poseRequest(const QCommandLineParser& parser) {
    if (!parser.isSet("size"))
        return std::optional<PoseRequest>();
    bool isNumber = false;
    PoseRequest pose;
    pose.size_m = parser.value("size").toDouble(&isNumber);
    if (!isNumber || !(pose.size_m >= kMinSize_m && pose.size_m <= kMaxSize_m))
        return Error{
            MessageCode::ValueOutOfRange,
            "--size",
            {parser.value("size").toStdString(), formatNumber(kMinSize_m), formatNumber(kMaxSize_m), "m"}};
    auto camera = readCamera(parser.value("camera").toStdString());
    if (!camera)
        return camera.error();
    pose.camera = std::move(*camera);
    return std::optional(pose);
}

Result<DetectMarkersArguments> readDetectMarkersArguments(const QCommandLineParser& parser) {
    DetectMarkersArguments request;
    request.path = parser.positionalArguments().front().toStdString();
    request.jsonPath = parser.value("json").toStdString();
    std::vector<OutputFile> outputs;
    if (parser.isSet("json"))
        outputs = {{request.jsonPath, "markers", "a list of markers written by Bask"}};
    std::vector<std::string> inputs{request.path, parser.value("dictionary").toStdString()};
    if (parser.isSet("camera"))
        inputs.push_back(parser.value("camera").toStdString());
    if (const auto place = checkOutputs(inputs, outputs); !place)
        return place.error();
    auto dictionary = dictionaryOf(parser.value("dictionary").toStdString());
    if (!dictionary)
        return dictionary.error();
    request.dictionary = std::move(*dictionary);
    auto pose = poseRequest(parser);
    if (!pose)
        return pose.error();
    request.pose = std::move(*pose);
    return request;
}

Json markerJson(const FoundMarker& marker, const std::optional<PoseRequest>& request) {
    Json json;
    json["id"] = marker.id;
    json["corners"] = Json::array();
    for (const Eigen::Vector2d& corner : marker.corners_px)
        json["corners"].push_back({corner.x(), corner.y()});
    if (!request)
        return json;
    const auto poses = markerPoses(marker.corners_px, request->size_m, request->camera);
    if (!poses)
        return json;
    json["rvec"] = poses->best.rotation_rad;
    json["tvec"] = poses->best.translation_m;
    json["reprojection_px"] = poses->best.rms_px;
    if (poses->second) {
        json["second"] = {{"rvec", poses->second->rotation_rad},
                          {"tvec", poses->second->translation_m},
                          {"reprojection_px", poses->second->rms_px}};
    }
    json["ambiguous"] = poses->isAmbiguous;
    return json;
}

struct Search {
    std::vector<FoundMarker> markers;
    bool isCrowded = false; ///< it found none, for that reason
};

Result<Search> markersIn(const DetectMarkersArguments& request) {
    constexpr double kRead = 0.4; // of the time, of a large picture
    Progress progress(1.0);
    const ShareDone done = progress.share();
    const auto picture = readGreyPicture(request.path);
    if (!picture)
        return picture.error();
    tellShare(done, kRead);
    if (request.pose)
        if (const auto fits = checkSize(request.pose->camera, picture->width, picture->height); !fits)
            return Error{fits.error().code(), request.path, fits.error().message.args};
    Search search{findSmallMarkersToo(*picture, request.dictionary, partOf(done, kRead, 1.0))};
    tellShare(done, 1.0);
    std::ranges::stable_sort(search.markers, {}, &FoundMarker::id);
    search.isCrowded = search.markers.empty() && isCrowded(*picture);
    return search;
}

void addDetectMarkersOptions(QCommandLineParser& parser) {
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"dictionary", "6X6_250 and the like, or a dictionary file of OpenCV. Required.", "NAME|FILE.yml"},
         {"size", "Side of the markers, black border included, for their poses; with --camera.", "METRES"},
         {"camera", "The camera, as bask calibrate-camera, OpenCV or ROS write it.", "CAM.yml"},
         {"json", "Writes the markers there instead of to standard output.", "OUT.json"}});
    parser.addPositionalArgument("IMAGE", "PNG, JPEG, BMP or TIFF of at most 64 megapixels.");
}

} // namespace

int detectMarkersCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Finds the ArUco markers of a dictionary in a picture and tells, as JSON, the id and the corners of\n"
        "each (px, pixel centres at whole numbers, clockwise from the marker's upper left). With --size and\n"
        "--camera also rvec (rad) and tvec (m): the marker's axes x right, y up, z out of it from its "
        "middle,\n"
        "in the camera's x right, y down, z forward; how far the corners lie from there (px, root mean "
        "square);\n"
        "the second pose that a square allows, and whether the two can be told apart (\"ambiguous\").\n"
        "Exit code: 0 done, 2 bad input or unwritable output, 3 no marker is seen.");
    addDetectMarkersOptions(parser);
    if (const auto code = parseCommand(parser, kDetectMarkers, arguments, 1))
        return *code;
    if (!parser.isSet("dictionary"))
        return refuse(kDetectMarkers, QStringLiteral("--dictionary is needed"));
    if (parser.isSet("size") != parser.isSet("camera"))
        return refuse(kDetectMarkers, QStringLiteral("poses take both --size and --camera"));
    const auto request = readDetectMarkersArguments(parser);
    if (!request)
        return refuse(kDetectMarkers, request.error());
    const auto search = markersIn(*request);
    if (!search)
        return refuse(kDetectMarkers, search.error());
    if (search->isCrowded)
        return refuse(kDetectMarkers, Error{MessageCode::MarkersCrowded, request->path});
    Json json{{"markers", Json::array()}};
    for (const FoundMarker& marker : search->markers)
        json["markers"].push_back(markerJson(marker, request->pose));
    const std::string text = json.dump(1) + "\n";
    if (request->jsonPath.empty())
        std::fputs(text.c_str(), stdout);
    else if (const auto written = writeTextFile(request->jsonPath, text); !written)
        return refuse(kDetectMarkers, written.error());
    if (!search->markers.empty())
        return kExitDone;
    refuse(kDetectMarkers, Error{MessageCode::MarkerNotFound, request->path, {request->dictionary.name}});
    return kExitNegative;
}

} // namespace bask
