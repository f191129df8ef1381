#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"

#include "engine/shape/contour_file.h"
#include "engine/shape/csv_lines.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace bask {
namespace {

constexpr std::uintmax_t kLargestCsv = std::uintmax_t{64} << 20;
constexpr std::size_t kMaxRows = 1'000'000;
constexpr std::size_t kMinPoints = 3;

struct Columns {
    std::size_t x = 0;
    std::size_t y = 1;
    std::optional<LengthUnit> unit;
};

// "x_mm", "x (mm)", "X [mm]", "x / mm": is it the name of `axis`, and with which unit's name?
std::optional<std::string> unitAfter(std::string_view name, char axis) {
    if (name.empty() || (name[0] | 0x20) != axis)
        return std::nullopt;
    name.remove_prefix(1);
    if (!name.empty() && std::isalnum(static_cast<unsigned char>(name[0])))
        return std::nullopt;
    std::string unit;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            unit += c;
    return unit;
}

Columns columnsOf(const std::vector<std::string_view>& header) {
    Columns columns;
    std::optional<std::string> x, y;
    for (std::size_t k = 0; k < header.size(); ++k) {
        if (auto unit = unitAfter(header[k], 'x'); unit && !x)
            x = unit, columns.x = k;
        if (auto unit = unitAfter(header[k], 'y'); unit && !y)
            y = unit, columns.y = k;
    }
    if (!x || !y)
        return {};
    if (*x == *y || y->empty())
        columns.unit = lengthUnitFromName(*x);
    return columns;
}

bool isHeader(const std::vector<std::string_view>& fields, bool decimalComma) {
    return std::ranges::none_of(fields,
                                [&](std::string_view f) { return csvNumber(f, decimalComma).has_value(); });
}

Result<double> coordinate(std::string_view field, const CsvLine& line, bool decimalComma,
                          const std::string& path) {
    constexpr std::size_t kShown = 40;
    const auto value = csvNumber(field, decimalComma);
    if (!value)
        return Error{MessageCode::ContourNotANumber,
                     path,
                     {std::string(field.substr(0, kShown)), std::to_string(line.number)}};
    if (!std::isfinite(*value))
        return Error{MessageCode::ContourNotFinite, path, {"line " + std::to_string(line.number)}};
    return *value;
}

Result<std::vector<Eigen::Vector2d>> pointsOf(const std::vector<CsvLine>& lines, std::size_t first,
                                              char delimiter, const Columns& columns,
                                              const std::string& path) {
    const bool decimalComma = delimiter != ',';
    std::vector<Eigen::Vector2d> points;
    for (std::size_t k = first; k < lines.size(); ++k) {
        const auto fields = csvFields(lines[k].text, delimiter);
        if (fields.size() <= std::max(columns.x, columns.y))
            return Error{MessageCode::ContourColumnMissing,
                         path,
                         {std::to_string(lines[k].number), std::to_string(fields.size())}};
        const auto x = coordinate(fields[columns.x], lines[k], decimalComma, path);
        if (!x)
            return x.error();
        const auto y = coordinate(fields[columns.y], lines[k], decimalComma, path);
        if (!y)
            return y.error();
        points.emplace_back(*x, *y);
    }
    return points;
}

// Files seldom repeat the first point, so a missing last edge is no fault in itself: a rectangle has four
// points. It is one when that edge stands out from all others: more than 20 times their median, more than 5 %
// of the way round, and more than twice the longest of them.
bool isClosed(const std::vector<Eigen::Vector2d>& points_m) {
    std::vector<double> edges;
    for (std::size_t k = 0; k + 1 < points_m.size(); ++k)
        if (const double edge = (points_m[k + 1] - points_m[k]).norm(); edge > 0.0)
            edges.push_back(edge);
    if (edges.empty())
        return true;
    const double gap = (points_m.back() - points_m.front()).norm();
    double perimeter = gap;
    for (const double edge : edges)
        perimeter += edge;
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::ranges::nth_element(edges, middle);
    return gap <= std::max({20.0 * *middle, 0.05 * perimeter, 2.0 * *std::ranges::max_element(edges)});
}

} // namespace

Result<OutlineFile> readCsvOutlines(const std::string& path, std::optional<LengthUnit> unit) {
    const auto bytes = readFileBytes(path, kLargestCsv);
    return bytes ? csvOutlines(*bytes, path, unit) : bytes.error();
}

Result<OutlineFile> csvOutlines(const std::string& bytes, const std::string& path,
                                std::optional<LengthUnit> unit) {
    if (const auto checked = checkCsvText(bytes, path); !checked)
        return checked.error();
    const std::vector<CsvLine> lines = csvLines(bytes);
    if (lines.empty())
        return Error{MessageCode::FileEmpty, path};
    if (lines.size() > kMaxRows)
        return Error{MessageCode::FileTooLarge,
                     path,
                     {std::to_string(lines.size()) + " lines", std::to_string(kMaxRows)}};

    const char delimiter = csvDelimiter(lines);
    const auto header = csvFields(lines.front().text, delimiter);
    const bool hasHeader = isHeader(header, delimiter != ',');
    const Columns columns = hasHeader ? columnsOf(header) : Columns{};
    auto points = pointsOf(lines, hasHeader ? 1 : 0, delimiter, columns, path);
    if (!points)
        return points.error();
    if (!unit)
        unit = columns.unit;
    if (!unit)
        return Error{MessageCode::ContourUnitMissing, path};
    for (Eigen::Vector2d& p : *points)
        p *= metresPer(*unit);
    FileOutline outline{.points_m = std::move(*points)};
    outline.closed = isClosed(outline.points_m);
    while (outline.points_m.size() > 1 && outline.points_m.front() == outline.points_m.back())
        outline.points_m.pop_back();
    if (outline.points_m.size() < kMinPoints)
        return Error{MessageCode::ContourTooFewPoints,
                     path,
                     {std::to_string(outline.points_m.size()), std::to_string(kMinPoints)}};
    OutlineFile file;
    file.outlines.push_back(std::move(outline));
    file.unit = lengthUnitName(*unit);
    return file;
}

Result<Contour> readContourCsv(const std::string& path, std::optional<LengthUnit> unit) {
    const auto file = readCsvOutlines(path, unit);
    if (!file)
        return file.error();
    return contourOf(file->outlines.front(), path);
}

} // namespace bask
