#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"

#include "engine/shape/contour_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace bask {
namespace {

constexpr std::uintmax_t kLargestCsv = std::uintmax_t{64} << 20;
constexpr std::size_t kMaxRows = 1'000'000;
constexpr std::size_t kMinPoints = 3;
constexpr char kSpaces = ' '; // "delimiter" of columns set apart by white space

struct CsvLine {
    std::string_view text;
    std::size_t number = 0; // counted from 1
};

struct Columns {
    std::size_t x = 0;
    std::size_t y = 1;
    std::optional<LengthUnit> unit;
};

// Lines that say something: neither blank nor a comment (#). Ends of line are LF, CR LF or CR.
std::vector<CsvLine> linesOf(std::string_view text) {
    std::vector<CsvLine> lines;
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        const bool pair = text.substr(end, 2) == "\r\n";
        text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
        ++number;
        if (const std::string_view inner = trimmed(line); !inner.empty() && inner.front() != '#')
            lines.push_back({line, number});
    }
    return lines;
}

// The delimiter that most of the first lines have; a semicolon or a tab goes before a comma, which may be
// decimal.
char delimiterOf(const std::vector<CsvLine>& lines) {
    constexpr std::size_t kLooked = 50;
    const std::size_t looked = std::min(kLooked, lines.size());
    for (const char c : {';', '\t', ','}) {
        const auto has = std::count_if(
            lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(looked),
            [&](const CsvLine& l) { return trimmed(l.text).find(c) != std::string_view::npos; });
        if (2 * static_cast<std::size_t>(has) > looked)
            return c;
    }
    return kSpaces;
}

std::string_view unquoted(std::string_view field) {
    field = trimmed(field);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
        field = trimmed(field.substr(1, field.size() - 2));
    return field;
}

std::vector<std::string_view> fieldsOf(std::string_view line, char delimiter) {
    std::vector<std::string_view> fields;
    line = delimiter == '\t' ? line : trimmed(line);
    for (;;) {
        const std::size_t end = delimiter == kSpaces ? line.find_first_of(" \t") : line.find(delimiter);
        fields.push_back(unquoted(line.substr(0, end)));
        if (end == std::string_view::npos)
            return fields;
        line.remove_prefix(end + 1);
        if (delimiter == kSpaces)
            line = trimmed(line);
    }
}

// A number whatever the locale; NaN when it is too large to be held; nothing when it is not a number.
std::optional<double> numberOf(std::string_view field, bool decimalComma) {
    std::string text(field);
    if (decimalComma && text.find('.') == std::string::npos)
        if (const std::size_t comma = text.find(','); comma != std::string::npos)
            text[comma] = '.';
    const char* first = text.c_str();
    const char* last = first + text.size();
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        ++first;
    double value = 0.0;
    const auto [end, code] = std::from_chars(first, last, value);
    if (end != last || code == std::errc::invalid_argument)
        return std::nullopt;
    return code == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

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
                                [&](std::string_view f) { return numberOf(f, decimalComma).has_value(); });
}

Result<double> coordinate(std::string_view field, const CsvLine& line, bool decimalComma,
                          const std::string& path) {
    constexpr std::size_t kShown = 40;
    const auto value = numberOf(field, decimalComma);
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
        const auto fields = fieldsOf(lines[k].text, delimiter);
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

Result<void> checkText(std::string_view text, const std::string& path) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return Error{MessageCode::FileUnreadable, path, {"it is UTF-16 text; save it as UTF-8"}};
    const auto isControl = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
    };
    if (std::ranges::any_of(text, isControl))
        return Error{MessageCode::FileUnreadable, path, {"it is not a text file"}};
    return {};
}

} // namespace

Result<OutlineFile> readCsvOutlines(const std::string& path, std::optional<LengthUnit> unit) {
    const auto bytes = readFileBytes(path, kLargestCsv);
    return bytes ? csvOutlines(*bytes, path, unit) : bytes.error();
}

Result<OutlineFile> csvOutlines(const std::string& bytes, const std::string& path,
                                std::optional<LengthUnit> unit) {
    if (const auto checked = checkText(bytes, path); !checked)
        return checked.error();
    std::string_view text = bytes;
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const std::vector<CsvLine> lines = linesOf(text);
    if (lines.empty())
        return Error{MessageCode::FileEmpty, path};
    if (lines.size() > kMaxRows)
        return Error{MessageCode::FileTooLarge,
                     path,
                     {std::to_string(lines.size()) + " lines", std::to_string(kMaxRows)}};

    const char delimiter = delimiterOf(lines);
    const auto header = fieldsOf(lines.front().text, delimiter);
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
