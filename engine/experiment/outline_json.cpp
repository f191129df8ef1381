#include "engine/experiment/outline_json.h"

#include "engine/base/message_code.h"
#include "engine/shape/shape.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

using nlohmann::json;

/// Array of rows of `width` numbers each.
std::vector<std::array<double, 3>> readRows(const json& j, const std::string& path, Failure& failure,
                                            std::size_t width) {
    std::vector<std::array<double, 3>> rows;
    const auto refuse = [&](const std::string& place, const std::string& expected, const json& found) {
        if (!failure)
            failure = Error(MessageCode::JsonWrongType, place, {expected, typeName(found)});
    };
    if (!j.is_array())
        refuse(path, "an array", j);
    for (std::size_t i = 0; i < j.size() && !failure; ++i) {
        const json& row = j[i];
        if (!row.is_array() || row.size() != width ||
            !std::ranges::all_of(row, [](const json& v) { return v.is_number(); })) {
            refuse(path + '[' + std::to_string(i) + ']', "an array of " + std::to_string(width) + " numbers",
                   row);
            break;
        }
        rows.push_back({});
        for (std::size_t k = 0; k < width; ++k)
            rows.back()[k] = row[k].get<double>();
    }
    return rows;
}

Contour readRing(const json& j, const std::string& path, Failure& failure) {
    std::vector<Eigen::Vector2d> points;
    for (const auto& row : readRows(j, path, failure, 2))
        points.emplace_back(row[0], row[1]);
    if (failure)
        return {};
    Result<Contour> contour = makeContour(std::move(points), path);
    if (contour)
        return *contour;
    failure = contour.error();
    return {};
}

/// The input may be clockwise.
FourierContour counterClockwise(std::vector<std::complex<double>> coefficients) {
    FourierContour contour(coefficients);
    if (contour.area() >= 0.0)
        return contour;
    std::ranges::reverse(coefficients);
    return FourierContour(std::move(coefficients));
}

} // namespace

Contour readPoints(Fields& fields, const std::string& key) {
    const json* j = fields.find(key);
    return j != nullptr ? readRing(*j, fields.pathOf(key), fields.failure()) : Contour{};
}

std::vector<Contour> readHoles(Fields& fields, const std::string& key) {
    std::vector<Contour> holes;
    if (const json* j = fields.find(key); j != nullptr && j->is_array() && j->size() > kMaxHoles)
        fields.fail(MessageCode::HolesTooMany, fields.pathOf(key),
                    {std::to_string(j->size()), std::to_string(kMaxHoles)});
    readEach(fields, key, false, [&](const json& ring, const std::string& path) {
        holes.push_back(readRing(ring, path, fields.failure()));
    });
    return holes;
}

FourierContour readCoefficients(Fields& fields, const std::string& key) {
    const json* j = fields.find(key);
    if (j == nullptr)
        return {};
    std::map<int, std::complex<double>> given;
    int harmonics = 1;
    for (const auto& [order, re, im] : readRows(*j, fields.pathOf(key), fields.failure(), 3)) {
        if (order != std::floor(order) || std::abs(order) > kMaxHarmonics)
            fields.fail(MessageCode::HarmonicsOutOfRange, fields.pathOf(key),
                        {formatNumber(order), std::to_string(-kMaxHarmonics), std::to_string(kMaxHarmonics)});
        else if (!given.emplace(static_cast<int>(order), std::complex(re, im)).second)
            fields.fail(MessageCode::JsonDuplicateKey, fields.pathOf(key), {formatNumber(order)});
        else
            harmonics = std::max(harmonics, std::abs(static_cast<int>(order)));
    }
    if (fields.failure())
        return {};
    std::vector<std::complex<double>> coefficients(static_cast<std::size_t>(2 * harmonics + 1));
    for (const auto& [order, value] : given) {
        const int place = order + harmonics;
        coefficients[static_cast<std::size_t>(place)] = value;
    }
    return counterClockwise(std::move(coefficients));
}

} // namespace bask
