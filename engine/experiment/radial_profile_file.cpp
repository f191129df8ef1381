#include "engine/experiment/radial_profile_file.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace bask {
namespace {

constexpr std::uintmax_t kMaxProfileFile = std::uintmax_t{1} << 20; // bytes

struct Column {
    const char* name;
    double ProfilePoint::*member;
    double toSi;
};
constexpr std::array kColumns{Column{"radius_mm", &ProfilePoint::radius_m, 1e-3},
                              Column{"radius_cm", &ProfilePoint::radius_m, 1e-2},
                              Column{"radius_m", &ProfilePoint::radius_m, 1.0},
                              Column{"temperature_ratio", &ProfilePoint::temperatureRatio, 1.0},
                              Column{"temperature_offset_K", &ProfilePoint::temperatureOffset_K, 1.0}};

std::string stripped(const std::string& text) {
    constexpr const char* kBlank = " \t\r\"";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string> cellsOf(const std::string& line, char separator) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, separator);)
        cells.push_back(stripped(cell));
    return cells;
}

char separatorOf(const std::string& header) {
    for (const char c : {';', '\t'})
        if (header.find(c) != std::string::npos)
            return c;
    return ',';
}

std::optional<double> finiteNumber(std::string cell, char separator) {
    if (separator != ',') // which may then be decimal
        std::ranges::replace(cell, ',', '.');
    double value = 0.0;
    const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// What stands in each column; null: something else.
using Columns = std::vector<const Column*>;

std::optional<Columns> columnsOf(const std::vector<std::string>& header) {
    Columns columns;
    int radii = 0, ratios = 0, offsets = 0;
    for (const std::string& name : header) {
        const auto* const found =
            std::ranges::find_if(kColumns, [&](const Column& c) { return name == c.name; });
        columns.push_back(found == kColumns.end() ? nullptr : found);
        if (columns.back() == nullptr)
            continue;
        const auto member = columns.back()->member;
        ++(member == &ProfilePoint::radius_m           ? radii
           : member == &ProfilePoint::temperatureRatio ? ratios
                                                       : offsets);
    }
    const bool isClear = radii == 1 && ratios <= 1 && offsets <= 1 && ratios + offsets > 0;
    return isClear ? std::optional(columns) : std::nullopt;
}

} // namespace

Result<std::vector<ProfilePoint>> radialProfile(const std::string& text, const std::string& where) {
    std::vector<ProfilePoint> profile;
    std::optional<Columns> columns;
    char separator = ',';
    std::istringstream in(text);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (number == 1 && line.starts_with("\xef\xbb\xbf"))
            line.erase(0, 3);
        if (const std::string inner = stripped(line); inner.empty() || inner.front() == '#')
            continue;
        if (!columns) {
            separator = separatorOf(line);
            columns = columnsOf(cellsOf(line, separator));
            if (!columns)
                return Error(MessageCode::ProfileHeader, where);
            continue;
        }
        const std::vector<std::string> cells = cellsOf(line, separator);
        ProfilePoint& point = profile.emplace_back();
        for (std::size_t k = 0; k < columns->size(); ++k) {
            const Column* column = (*columns)[k];
            if (column == nullptr)
                continue;
            const auto value = k < cells.size() ? finiteNumber(cells[k], separator) : std::nullopt;
            if (!value)
                return Error(MessageCode::ProfileLine, where, {std::to_string(number), plainWords(line)});
            point.*(column->member) = *value * column->toSi;
        }
    }
    if (!columns)
        return Error(MessageCode::ProfileHeader, where);
    if (profile.empty())
        return Error(MessageCode::SourcePartsNone, where);
    return profile;
}

Result<std::vector<ProfilePoint>> readRadialProfile(const std::string& path) {
    const auto text = readTextFile(path, kMaxProfileFile);
    return text ? radialProfile(*text, path) : text.error();
}

} // namespace bask
