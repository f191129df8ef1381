#include "engine/calibration/camera_file.h"

#include "engine/base/message_code.h"
#include "engine/calibration/plain_yaml.h"
#include "engine/shape/contour_file.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace bask {
namespace {

constexpr std::uintmax_t kLargestFile = 1U << 20;
constexpr int kMaxSide_px = 65'535;

std::string number(double value) {
    std::array<char, 40> buffer{};
    const std::string text(buffer.data(),
                           std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
    return text.find_first_of(".e") == std::string::npos ? text + "."
                                                         : text; // OpenCV tells reals by the point
}

std::string list(const std::vector<double>& values) {
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : ", ") + number(value);
    return "[ " + text + " ]";
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text)
        if (c != '"' && c != '\\' && static_cast<unsigned char>(c) >= ' ')
            result += c;
    return result + '"';
}

std::vector<double> matrixOf(const CameraModel& camera) {
    return {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
}

std::string matrix(const char* name, int rows, int columns, const std::vector<double>& values,
                   bool tagged = true) {
    return std::string(name) + (tagged ? ": !!opencv-matrix\n" : ":\n") + "   rows: " + std::to_string(rows) +
           "\n   cols: " + std::to_string(columns) + (tagged ? "\n   dt: d" : "") +
           "\n   data: " + list(values) + "\n";
}

/// A lens without distortion has coefficients of 0: other programs refuse an empty matrix.
std::string distortion(const CameraModel& camera, bool tagged) {
    const std::vector<double> values =
        camera.distortion.empty() ? std::vector<double>(5, 0.0) : camera.distortion;
    return matrix("distortion_coefficients", 1, static_cast<int>(values.size()), values, tagged);
}

Result<void> readMatrix(const PlainYaml& yaml, const std::string& where, CameraModel& camera) {
    const auto values = yaml.numbers("camera_matrix/data", where);
    if (!values)
        return values.error();
    if (values->size() != 9)
        return Error{MessageCode::CameraMatrixUnusable, where};
    const std::vector<double>& m = *values;
    const bool isPinhole =
        m[0] > 0.0 && m[4] > 0.0 && m[1] == 0.0 && m[3] == 0.0 && m[6] == 0.0 && m[7] == 0.0 && m[8] == 1.0;
    if (!isPinhole)
        return Error{MessageCode::CameraMatrixUnusable, where};
    camera.fx = m[0];
    camera.fy = m[4];
    camera.cx = m[2];
    camera.cy = m[5];
    return {};
}

Result<void> readDistortion(const PlainYaml& yaml, const std::string& where, CameraModel& camera) {
    if (const std::string model = yaml.text("distortion_model");
        !model.empty() && model != "plumb_bob" && model != "rational_polynomial")
        return Error{MessageCode::ValueUnknown, where, {model, "plumb_bob, rational_polynomial"}};
    const auto values = yaml.numbers("distortion_coefficients/data", where);
    if (!values)
        return values.error();
    camera.distortion = *values;
    const std::size_t count = camera.distortion.size();
    if (count != 4 && count != 5 && count != 8)
        return Error{MessageCode::DistortionUnusable, where, {std::to_string(count)}};
    if (count == 4)
        camera.distortion.push_back(0.0);
    return {};
}

// What a file may leave out; left out as well when it does not fit the rest.
void readOrigin(const PlainYaml& yaml, const std::string& where, CameraModel& camera) {
    for (const char* key : {"rms", "avg_reprojection_error"})
        if (const auto rms = yaml.numbers(key, where); rms && rms->size() == 1)
            camera.rms_px = rms->front();
    if (const auto values = yaml.numbers("standard_deviations/data", where);
        values && values->size() == 4 + camera.distortion.size())
        camera.deviations = *values;
    const auto residuals = yaml.numbers("per_view_reprojection_errors", where);
    if (residuals)
        for (const double residual : *residuals)
            camera.views.push_back({yaml.text("views", camera.views.size()), residual});
    camera.board = yaml.text("board");
}

} // namespace

Result<CameraModel> cameraFromYaml(const std::string& text, const std::string& where) {
    const PlainYaml yaml(text);
    CameraModel camera;
    for (const auto& read : {readMatrix(yaml, where, camera), readDistortion(yaml, where, camera)})
        if (!read)
            return read.error();
    for (const auto& [key, side] :
         {std::pair{"image_width", &camera.width}, std::pair{"image_height", &camera.height}}) {
        if (!yaml.has(key))
            continue;
        const auto value = yaml.whole(key, 1, kMaxSide_px, where);
        if (!value)
            return value.error();
        *side = *value;
    }
    readOrigin(yaml, where, camera);
    return camera;
}

Result<CameraModel> readCamera(const std::string& path) {
    const auto text = readFileBytes(path, kLargestFile);
    return text ? cameraFromYaml(*text, path) : Result<CameraModel>(text.error());
}

std::string openCvYaml(const CameraModel& camera) {
    std::string text = "%YAML:1.0\n---\n";
    text += matrix(kCameraFirstKey, 3, 3, matrixOf(camera));
    text += distortion(camera, true);
    if (camera.rms_px)
        text += "rms: " + number(*camera.rms_px) + "\n";
    if (camera.width > 0 && camera.height > 0)
        text += "image_width: " + std::to_string(camera.width) +
                "\nimage_height: " + std::to_string(camera.height) + "\n";
    if (!camera.deviations.empty())
        text +=
            matrix("standard_deviations", static_cast<int>(camera.deviations.size()), 1, camera.deviations);
    if (!camera.views.empty()) {
        std::vector<double> residuals;
        std::string names;
        for (const ViewResidual& view : camera.views) {
            residuals.push_back(view.rms_px);
            names += (names.empty() ? "" : ",\n   ") + quoted(view.name);
        }
        text += "per_view_reprojection_errors: " + list(residuals) + "\nviews: [ " + names + " ]\n";
    }
    if (!camera.board.empty())
        text += "board: " + quoted(camera.board) + "\n";
    return text;
}

std::string rosYaml(const CameraModel& camera, const std::string& name) {
    const bool isRational = camera.distortion.size() == 8;
    return "image_width: " + std::to_string(camera.width) +
           "\nimage_height: " + std::to_string(camera.height) + "\ncamera_name: " + name + "\n" +
           matrix("camera_matrix", 3, 3, matrixOf(camera), false) +
           "distortion_model: " + (isRational ? "rational_polynomial" : "plumb_bob") + "\n" +
           distortion(camera, false) +
           matrix("rectification_matrix", 3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}, false) +
           matrix("projection_matrix", 3, 4,
                  {camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0}, false);
}

} // namespace bask
