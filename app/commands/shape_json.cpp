#include "app/commands/shape_json.h"

#include "engine/base/message_code.h"
#include "engine/shape/winding.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace bask {
namespace {

using nlohmann::json;

constexpr double kMaxLength_m = 1e6;
constexpr double kMinRadius_m = 1e-9;
constexpr double kMaxAngle_rad = 1e6;
constexpr std::size_t kMaxPoints = 100000;
constexpr double kMinAreaRatio = 1e-12; // of the square of the size: less is rounding

std::string placeOf(const std::string& where, const std::string& key) {
    return where.empty() ? key : where + '.' + key;
}

Result<double> number(const json& j, double most, const char* unit, const std::string& where) {
    if (j.is_string()) // NaN and the like, too
        return Error{
            MessageCode::JsonWrongType, where, {"a number", '"' + j.get<std::string>().substr(0, 20) + '"'}};
    if (!j.is_number())
        return Error{MessageCode::JsonWrongType, where, {"a number", jsonTypeWords(j)}};
    const double value = j.get<double>();
    if (!(std::abs(value) <= most))
        return Error{MessageCode::ValueOutOfRange,
                     where,
                     {formatNumber(value), formatNumber(-most), formatNumber(most), unit}};
    return value;
}

// An array of exactly `count` numbers (0: any count).
Result<const json*> arrayMember(const json& object, const std::string& key, std::size_t count,
                                const std::string& where) {
    const auto member = memberOf(object, key, where);
    if (!member)
        return member;
    const json& array = **member;
    const std::string wanted = count == 0 ? "a list" : "a list of " + std::to_string(count) + " numbers";
    if (!array.is_array())
        return Error{MessageCode::JsonWrongType, placeOf(where, key), {wanted, jsonTypeWords(array)}};
    if (count != 0 && array.size() != count)
        return Error{MessageCode::JsonWrongType, placeOf(where, key), {wanted, std::to_string(array.size())}};
    return &array;
}

Result<Eigen::Vector3d> vectorMember(const json& object, const std::string& key, double most,
                                     const char* unit, const std::string& where) {
    const auto array = arrayMember(object, key, 3, where);
    if (!array)
        return array.error();
    Eigen::Vector3d result;
    for (int i = 0; i < 3; ++i) {
        const auto value = number((**array)[static_cast<std::size_t>(i)], most, unit,
                                  placeOf(where, key) + '[' + std::to_string(i) + ']');
        if (!value)
            return value.error();
        result[i] = *value;
    }
    return result;
}

Result<Shape> diskFromJson(const json& object, const std::string& where) {
    const auto member = memberOf(object, "radius_m", where);
    if (!member)
        return member.error();
    const std::string place = placeOf(where, "radius_m");
    const auto radius = number(**member, kMaxLength_m, "m", place);
    if (!radius)
        return radius.error();
    if (*radius <= 0.0)
        return Error{MessageCode::ValueNotPositive, place, {formatNumber(*radius)}};
    if (*radius < kMinRadius_m)
        return Error{MessageCode::ValueOutOfRange,
                     place,
                     {formatNumber(*radius), formatNumber(kMinRadius_m), formatNumber(kMaxLength_m), "m"}};
    return Shape{Disk{*radius}};
}

// Rows of `columns` numbers; the first may be a whole number (the order of a coefficient).
Result<std::vector<std::vector<double>>> rowsOf(const json& array, std::size_t columns,
                                                const std::string& where) {
    if (!array.is_array())
        return Error{MessageCode::JsonWrongType, where, {"a list", jsonTypeWords(array)}};
    if (array.size() > kMaxPoints)
        return Error{MessageCode::ValueOutOfRange,
                     where,
                     {std::to_string(array.size()), "1", std::to_string(kMaxPoints), "entries"}};
    std::vector<std::vector<double>> result;
    result.reserve(array.size());
    for (std::size_t i = 0; i < array.size(); ++i) {
        const json& row = array[i];
        const std::string place = where + '[' + std::to_string(i) + ']';
        if (!row.is_array() || row.size() != columns)
            return Error{MessageCode::JsonWrongType,
                         place,
                         {"a list of " + std::to_string(columns) + " numbers", jsonTypeWords(row)}};
        std::vector<double> values;
        for (const json& entry : row) {
            const auto value = number(entry, kMaxLength_m, "m", place);
            if (!value)
                return value.error();
            values.push_back(*value);
        }
        result.push_back(std::move(values));
    }
    return result;
}

Result<Shape> fourierFromJson(const json& object, const std::string& where) {
    const auto member = memberOf(object, "coefficients", where);
    if (!member)
        return member.error();
    const std::string place = placeOf(where, "coefficients");
    const auto entries = rowsOf(**member, 3, place);
    if (!entries)
        return entries.error();
    int harmonics = 0;
    std::set<int> seen;
    for (const auto& entry : *entries) {
        if (entry[0] != std::round(entry[0]))
            return Error{MessageCode::JsonWrongType, place, {"a whole number", formatNumber(entry[0])}};
        if (std::abs(entry[0]) > kMaxHarmonics)
            return Error{MessageCode::HarmonicsOutOfRange,
                         place,
                         {formatNumber(std::abs(entry[0]), 7), "1", std::to_string(kMaxHarmonics)}};
        const int order = static_cast<int>(entry[0]);
        if (!seen.insert(order).second)
            return Error{MessageCode::JsonDuplicateKey, place, {std::to_string(order)}};
        harmonics = std::max(harmonics, std::abs(order));
    }
    if (harmonics < 1)
        return Error{MessageCode::HarmonicsOutOfRange, place, {"0", "1", std::to_string(kMaxHarmonics)}};
    std::vector<std::complex<double>> coefficients(static_cast<std::size_t>(2 * harmonics + 1));
    for (const auto& entry : *entries)
        coefficients[static_cast<std::size_t>(static_cast<int>(entry[0]) + harmonics)] = {entry[1], entry[2]};
    FourierContour contour(coefficients);
    if (contour.area() < 0.0) {
        std::ranges::reverse(coefficients);
        contour = FourierContour(coefficients);
    }
    double square_m2 = 0.0;
    for (int j = -harmonics; j <= harmonics; ++j)
        square_m2 += j == 0 ? 0.0 : std::norm(contour.coefficient(j));
    const double area_m2 = contour.area();
    if (!std::isfinite(area_m2) || !(area_m2 > kMinAreaRatio * square_m2))
        return Error{MessageCode::ContourZeroArea, where};
    if (const double uneven = unevenShare(contour); uneven > kMaxUneven)
        return Error{MessageCode::SeriesUneven, place, {formatNumber(100.0 * uneven, 2)}};
    return Shape{contour};
}

Result<Contour> ringFromJson(const json& ring, const std::string& where) {
    const auto entries = rowsOf(ring, 2, where);
    if (!entries)
        return entries.error();
    std::vector<Eigen::Vector2d> points;
    for (const auto& entry : *entries)
        points.emplace_back(entry[0], entry[1]);
    return makeContour(std::move(points), where);
}

Result<Shape> polygonFromJson(const json& object, const std::string& where) {
    const auto member = memberOf(object, "points_m", where);
    if (!member)
        return member.error();
    const auto contour = ringFromJson(**member, placeOf(where, "points_m"));
    if (!contour)
        return contour.error();
    return Shape{*contour};
}

Result<Shape> outlineFromJson(const json& object, const std::string& where) {
    const auto member = memberOf(object, "type", where);
    if (!member)
        return member.error();
    if (!(*member)->is_string())
        return Error{MessageCode::JsonWrongType, placeOf(where, "type"), {"text", jsonTypeWords(**member)}};
    const auto type = (*member)->get<std::string>();
    if (type == "disk")
        return diskFromJson(object, where);
    if (type == "fourier")
        return fourierFromJson(object, where);
    if (type == "polygon")
        return polygonFromJson(object, where);
    return Error{MessageCode::ValueUnknown, placeOf(where, "type"), {type, "disk, fourier, polygon"}};
}

} // namespace

const char* jsonTypeWords(const json& j) {
    if (j.is_number())
        return j.is_number_float() ? "a number" : "a whole number";
    if (j.is_string())
        return "text";
    if (j.is_array())
        return "a list";
    if (j.is_object())
        return "an object";
    return j.is_boolean() ? "true or false" : "null";
}

Result<const json*> memberOf(const json& object, const std::string& key, const std::string& where) {
    if (!object.is_object())
        return Error{MessageCode::JsonWrongType, where, {"an object", jsonTypeWords(object)}};
    const auto found = object.find(key);
    if (found == object.end())
        return Error{MessageCode::JsonMissingKey, where, {key}};
    return &*found;
}

Result<Shape> shapeFromJson(const json& object, const std::string& where) {
    auto outline = outlineFromJson(object, where);
    if (!outline || !object.contains("holes_m"))
        return outline;
    const auto list = arrayMember(object, "holes_m", 0, where);
    if (!list)
        return list.error();
    const std::string place = placeOf(where, "holes_m");
    if ((*list)->size() > kMaxHoles)
        return Error{
            MessageCode::HolesTooMany, place, {std::to_string((*list)->size()), std::to_string(kMaxHoles)}};
    std::vector<Contour> holes;
    for (const json& ring : **list) {
        auto hole = ringFromJson(ring, place + '[' + std::to_string(holes.size()) + ']');
        if (!hole)
            return hole.error();
        holes.push_back(std::move(*hole));
    }
    const Shape shape = withHoles(*outline, std::move(holes));
    if (const auto fit = checkHoles(shape, place); !fit)
        return fit.error();
    return shape;
}

Result<Pose> poseFromJson(const json& object, const std::string& where) {
    const auto translation = vectorMember(object, "translation_m", kMaxLength_m, "m", where);
    if (!translation)
        return translation.error();
    const auto rotation = vectorMember(object, "rotation_vector_rad", kMaxAngle_rad, "rad", where);
    if (!rotation)
        return rotation.error();
    return poseFromRotationVector(*translation, *rotation);
}

} // namespace bask
