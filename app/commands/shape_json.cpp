#include "app/commands/shape_json.h"

#include "engine/base/message_code.h"
#include "engine/experiment/outline_json.h"
#include "engine/model/checker.h"
#include "engine/shape/winding.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace bask {
namespace {

using nlohmann::json;

constexpr double kMaxLength_m = 1e6;
constexpr double kMinRadius_m = 1e-9;
constexpr double kMaxAngle_rad = 1e6;
constexpr double kMaxPoints = 100000;
constexpr double kMinAreaRatio = 1e-12; // of the square of the size: less is rounding

void checkSeries(Checker& check, const std::string& path, const FourierContour& contour) {
    double square_m2 = 0.0;
    for (int j = -contour.harmonics(); j <= contour.harmonics(); ++j) {
        const std::complex<double> c = contour.coefficient(j);
        check.range(path + ".coefficients", std::max(std::abs(c.real()), std::abs(c.imag())), 0.0,
                    kMaxLength_m, "m");
        square_m2 += j == 0 ? 0.0 : std::norm(c);
    }
    const double area_m2 = contour.area();
    if (!std::isfinite(area_m2) || !(area_m2 > kMinAreaRatio * square_m2))
        check.fail(MessageCode::ContourZeroArea, path);
    else if (const double uneven = unevenShare(contour); uneven > kMaxUneven)
        check.fail(MessageCode::SeriesUneven, path + ".coefficients", {formatNumber(100.0 * uneven, 2)});
}

Result<void> checkShape(const Shape& shape, const std::string& path) {
    Checker check;
    if (const auto* disk = outlineAs<Disk>(shape)) {
        check.positive(path + ".radius_m", disk->radius_m, kMaxLength_m, "m");
        check.range(path + ".radius_m", disk->radius_m, kMinRadius_m, kMaxLength_m, "m");
    } else if (const auto* series = outlineAs<FourierContour>(shape)) {
        checkSeries(check, path, *series);
    } else {
        const auto points = static_cast<double>(outlineAs<Contour>(shape)->points_m.size());
        check.range(path + ".points_m", points, 3.0, kMaxPoints, "points");
    }
    if (!check.failed())
        check.take(checkHoles(shape, path + ".holes_m"));
    return check.result();
}

Eigen::Vector3d readVector(Fields& fields, const std::string& key, double max, const char* unit) {
    Eigen::Vector3d out = Eigen::Vector3d::Zero();
    std::vector<double> values;
    if (fields.find(key, true) == nullptr)
        return out;
    fields.read(key, values);
    if (values.size() != 3)
        fields.fail(MessageCode::JsonWrongType, fields.pathOf(key),
                    {"an array of 3 numbers", std::to_string(values.size())});
    Checker check;
    for (int i = 0; i < 3 && !fields.failure(); ++i) {
        out[i] = values[static_cast<std::size_t>(i)];
        check.range(fields.pathOf(key) + '[' + std::to_string(i) + ']', out[i], -max, max, unit);
        fields.failure() = check.error();
    }
    return out;
}

} // namespace

Shape readCaseShape(const json& j, const std::string& path, Failure& failure) {
    enum class Form { Disk, Fourier, Polygon };
    Form form = Form::Disk;
    Shape shape;
    Fields fields(j, path, failure);
    fields.readWord("type", {{"disk", Form::Disk}, {"fourier", Form::Fourier}, {"polygon", Form::Polygon}},
                    form, true);
    if (form == Form::Disk) {
        Disk disk;
        fields.read("radius_m", disk.radius_m, true);
        shape = disk;
    } else if (form == Form::Fourier) {
        fields.find("coefficients", true);
        shape = readCoefficients(fields, "coefficients");
    } else {
        fields.find("points_m", true);
        shape = readPoints(fields, "points_m");
    }
    shape = withHoles(shape, readHoles(fields, "holes_m"));
    fields.close(Fields::Unknown::Ignored);
    if (!failure)
        failure = failureOf(checkShape(shape, path));
    return shape;
}

Pose readCasePose(const json& j, const std::string& path, Failure& failure) {
    Fields fields(j, path, failure);
    const Eigen::Vector3d translation_m = readVector(fields, "translation_m", kMaxLength_m, "m");
    const Eigen::Vector3d rotation_rad = readVector(fields, "rotation_vector_rad", kMaxAngle_rad, "rad");
    fields.close(Fields::Unknown::Ignored);
    return poseFromRotationVector(translation_m, rotation_rad);
}

} // namespace bask
