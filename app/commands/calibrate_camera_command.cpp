// bask calibrate-camera: a camera's intrinsics from pictures of a board.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/base/whole_file.h"
#include "engine/calibration/camera_calibration.h"
#include "engine/calibration/camera_file.h"
#include "engine/shape/contour_import.h"

#include <QCommandLineParser>
#include <QFile>

#include <algorithm>
#include <cstdio>

namespace bask {
namespace {

constexpr const char* kCalibrateCamera = "calibrate-camera";

struct CalibrateCameraArguments {
    Board board;
    std::vector<std::string> images;
    std::string outputPath, rosPath; ///< rosPath may be empty
    int coefficients = 5;
    double distance_m = 0.0;
};

void tell(const Error& error) {
    std::fprintf(stderr, "bask %s: %s\n", kCalibrateCamera, describe(error).c_str());
}

int negative(const Error& error) {
    tell(error);
    return kExitNegative;
}

// An earlier camera file names the camera matrix near its beginning, in either kind.
Result<void> checkPlaces(const CalibrateCameraArguments& request) {
    std::vector<OutputFile> outputs{{request.outputPath}};
    if (!request.rosPath.empty())
        outputs.push_back({request.rosPath});
    if (auto place = checkOutputs(request.images, outputs); !place)
        return place;
    for (const OutputFile& output : outputs) {
        QFile old(QString::fromStdString(output.path));
        if (old.exists() && old.size() > 0 &&
            (!old.open(QIODevice::ReadOnly) || !old.read(1024).contains(kCameraFirstKey)))
            return Error{MessageCode::OutputForeign, output.path, {"a camera file"}};
    }
    return {};
}

Result<CalibrateCameraArguments> readCalibrateCameraArguments(const QCommandLineParser& parser) {
    const auto board = parseBoard(parser.value("board").toStdString());
    if (!board)
        return board.error();
    CalibrateCameraArguments request{
        *board, {}, parser.value("output").toStdString(), parser.value("ros").toStdString()};
    for (const QString& image : parser.positionalArguments())
        request.images.push_back(image.toStdString());
    const std::string coefficients = parser.value("coefficients").toStdString();
    if (coefficients != "5" && coefficients != "8")
        return Error{MessageCode::ValueUnknown, "--coefficients", {coefficients, "5, 8"}};
    request.coefficients = coefficients == "5" ? 5 : 8;
    bool isNumber = false;
    request.distance_m = parser.value("distance").toDouble(&isNumber);
    if (!isNumber || !(request.distance_m > 0.0 && request.distance_m <= 100.0))
        return Error{MessageCode::ValueOutOfRange,
                     "--distance",
                     {parser.value("distance").toStdString(), "0", "100", "m"}};
    if (const auto places = checkPlaces(request); !places)
        return places.error();
    return request;
}

struct Size {
    int width = 0, height = 0;

    bool operator==(const Size&) const = default;
};

std::string sizeText(const Size& size) {
    return pixelsText(size.width, size.height);
}

/// What the pictures show.
struct Survey {
    std::vector<CalibrationView> views;
    std::vector<Size> sizes; ///< of each view
    std::vector<Board> seen; ///< by some of the pictures
    int readable = 0;
};

// Tells of each picture that cannot be used why.
Survey surveyOf(const CalibrateCameraArguments& request) {
    constexpr std::size_t kEnoughJudged = 12; // asking what board it is takes longest
    Survey survey;
    Progress progress(static_cast<double>(request.images.size()), "pictures");
    double looked = 0.0;
    const auto leaveOut = [&](const Error& why) {
        progress.makeRoom();
        tell(why);
    };
    for (const std::string& path : request.images) {
        progress.tell(looked++);
        const auto picture = readGreyPicture(path);
        if (!picture) {
            leaveOut(picture.error());
            continue;
        }
        ++survey.readable;
        auto view = findBoard(*picture, request.board, path);
        if (survey.seen.size() < kEnoughJudged)
            if (const auto seen = boardSeen(*picture, request.board))
                survey.seen.push_back(*seen);
        if (!view) {
            leaveOut(view.error());
            continue;
        }
        survey.views.push_back({path, std::move(*view)});
        survey.sizes.push_back({picture->width, picture->height});
    }
    progress.tell(looked);
    return survey;
}

// Leaves views of the commonest size only, and tells which are left out. There must be one.
Size keepCommonSize(Survey& survey) {
    const Size common = *std::ranges::max_element(
        survey.sizes, {}, [&](const Size& size) { return std::ranges::count(survey.sizes, size); });
    std::vector<CalibrationView> kept;
    for (std::size_t k = 0; k < survey.views.size(); ++k) {
        if (survey.sizes[k] == common)
            kept.push_back(std::move(survey.views[k]));
        else
            tell(Error{MessageCode::ViewSizeOther,
                       survey.views[k].name,
                       {sizeText(survey.sizes[k]), sizeText(common)}});
    }
    survey.views = std::move(kept);
    return common;
}

void printFigures(const CalibrateCameraArguments& request, const CameraCalibration& result) {
    const auto print = [](const char* name, double value) { std::printf("%s %.9g\n", name, value); };
    const CameraModel& camera = result.camera;
    static constexpr const char* kParameters[] = {"fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2",
                                                  "p1",    "p2",    "k3",    "k4",    "k5", "k6"};
    std::vector<double> values{camera.fx, camera.fy, camera.cx, camera.cy};
    values.insert(values.end(), camera.distortion.begin(), camera.distortion.end());
    print("views", static_cast<double>(camera.views.size()));
    print("rms_px", *camera.rms_px);
    for (std::size_t k = 0; k < values.size(); ++k) {
        print(kParameters[k], values[k]);
        print((std::string(kParameters[k]) + "_deviation").c_str(), camera.deviations[k]);
    }
    print("largest_tilt_deg", degFromRad(result.tilt_rad));
    print("largest_turn_deg", degFromRad(result.turn_rad));
    if (result.heldOut_px) {
        print("held_out_px", *result.heldOut_px);
        print("held_out_mm", 1e3 * *result.heldOut_m(request.distance_m));
        print("at_distance_m", request.distance_m);
    }
    for (const ViewResidual& view : camera.views)
        std::printf("view_rms_px %.4g %s\n", view.rms_px, view.name.c_str());
}

Result<CameraCalibration> fitted(const std::vector<CalibrationView>& views, const Size& size,
                                 const CalibrateCameraArguments& request) {
    Progress progress(1.0);
    return calibrateCamera(views, request.board, size.width, size.height, request.coefficients, {},
                           [&](int done, int all) { progress.tell(static_cast<double>(done) / all); });
}

int calibrate(const CalibrateCameraArguments& request) {
    Survey survey = surveyOf(request);
    if (survey.readable == 0)
        return refuse(kCalibrateCamera,
                      Error{MessageCode::ViewsTooFew, "", {"0", std::to_string(kMinCalibrationViews)}});
    if (const Board seen = mostSeen(survey.seen, request.board); seen != request.board)
        return negative(Error{MessageCode::BoardOther, "", {boardText(seen), boardText(request.board)}});
    const Size size = survey.views.empty() ? Size() : keepCommonSize(survey);
    const auto result = fitted(survey.views, size, request);
    if (!result)
        return negative(result.error());
    printFigures(request, *result);
    if (const auto reason = result->reasonAgainst())
        return negative(Error{reason->code, request.outputPath + " is not written", reason->args});
    std::vector<WholeFile> files{{request.outputPath, openCvYaml(result->camera)}};
    if (!request.rosPath.empty())
        files.push_back({request.rosPath, rosYaml(result->camera, "camera")});
    if (const auto written = writeWholeFiles(files); !written)
        return refuse(kCalibrateCamera, written.error());
    return kExitDone;
}

} // namespace

int calibrateCameraCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Calibrates a camera by pictures of a board in different tilts and places. Prints the intrinsics "
        "with\n"
        "standard deviations, the residual of each picture, and that of pictures held out (five cameras, "
        "each\n"
        "made without a fifth of the pictures), also in mm at --distance. Pictures that cannot be used are "
        "named\n"
        "with the reason; so is a board that is not the one that was set.\n"
        "Exit code: 0 done, 2 bad input or unwritable output, 3 the pictures tell no camera.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"board",
          "chessboard:9x6:0.025 (inner corners, square in metres) or charuco:5x7:0.04:0.02:6X6_250 (squares, "
          "square and marker in metres, dictionary; \":legacy\" behind it for boards of OpenCV before 4.6 "
          "with "
          "even rows). Required.",
          "BOARD"},
         {{"o", "output"}, "The camera, as OpenCV's YAML. Required.", "CAM.yml"},
         {"ros", "The camera also as camera_info YAML of ROS.", "FILE.yaml"},
         {"coefficients", "Of the distortion: 5 (k1 k2 p1 p2 k3) or 8 (with k4 k5 k6, for wide lenses).", "N",
          "5"},
         {"distance", "From the camera, at which an error in mm is told.", "METRES", "0.6"}});
    parser.addPositionalArgument("IMAGES", "Three pictures or more of one size.", "IMAGES...");
    if (const auto code = parseCommand(parser, kCalibrateCamera, arguments, -1))
        return *code;
    if (!parser.isSet("board") || !parser.isSet("output"))
        return refuse(kCalibrateCamera, QStringLiteral("--board and -o are needed"));
    const auto request = readCalibrateCameraArguments(parser);
    return request ? calibrate(*request) : refuse(kCalibrateCamera, request.error());
}

} // namespace bask
