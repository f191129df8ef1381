#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_model.h"
#include "engine/shape/csv_lines.h"
#include "engine/thermography/band_radiance.h"
#include "engine/thermography/frame_decoder.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr std::size_t kMinTableSide = 8, kMaxTableSide = 4096;

struct TableLine {
    std::size_t number = 0; ///< of the line in the file
    std::vector<std::string_view> cells;
};

/// The cells of each line; a separator at the end of a line opens no cell of its own.
std::vector<TableLine> tableLines(const std::vector<CsvLine>& lines, char delimiter) {
    std::vector<TableLine> out;
    for (const CsvLine& line : lines) {
        out.push_back({line.number, csvFields(line.text, delimiter)});
        if (out.back().cells.size() > 1 && out.back().cells.back().empty())
            out.back().cells.pop_back();
    }
    return out;
}

bool hasNumber(const TableLine& line, bool decimalComma) {
    return std::ranges::any_of(line.cells,
                               [&](auto cell) { return csvNumber(cell, decimalComma).has_value(); });
}

/// Whether the cells from `first` on are 0, 1, 2 ... or 1, 2, 3 ...
bool counts(const std::vector<std::string_view>& cells, std::size_t first, bool decimalComma) {
    if (cells.size() < first + kMinTableSide)
        return false;
    std::optional<double> before;
    for (std::size_t k = first; k < cells.size(); ++k) {
        const auto number = csvNumber(cells[k], decimalComma);
        if (!number || (before ? *number != *before + 1.0 : *number != 0.0 && *number != 1.0))
            return false;
        before = number;
    }
    return true;
}

std::vector<std::string_view> firstColumn(const std::vector<TableLine>& lines, std::size_t from) {
    std::vector<std::string_view> out;
    for (std::size_t k = from; k < lines.size(); ++k)
        out.push_back(lines[k].cells[0]);
    return out;
}

/// Leaves out the lines before the table, and the line and the column that only count. Temperatures can
/// count, too: so a counting line or column goes where the profile's size says that it is one too many, or
/// where both are there with a corner that is no number.
void keepTable(std::vector<TableLine>& lines, const std::optional<ThermalProfile>& profile,
               bool decimalComma) {
    const std::size_t width = lines.empty() ? 0 : lines.back().cells.size();
    std::erase_if(lines, [&, isTable = false](const TableLine& line) mutable {
        isTable = isTable || (line.cells.size() == width && hasNumber(line, decimalComma));
        return !isTable;
    });
    if (lines.size() < 2)
        return;
    const bool hasCorner = !csvNumber(lines[0].cells[0], decimalComma);
    const bool isLine = counts(lines[0].cells, hasCorner ? 1 : 0, decimalComma);
    const bool isColumn = counts(firstColumn(lines, isLine ? 1 : 0), 0, decimalComma);
    const bool isBoth = hasCorner && isLine && isColumn;
    const auto isOneOver = [&](std::size_t found, int wanted) {
        return profile ? found == static_cast<std::size_t>(wanted) + 1 : isBoth;
    };
    if (isLine && isOneOver(lines.size(), profile ? profile->height : 0))
        lines.erase(lines.begin());
    if (isColumn && isOneOver(width, profile ? profile->width : 0))
        for (TableLine& line : lines)
            line.cells.erase(line.cells.begin());
}

} // namespace

Result<ThermalFrame> frameOfCsv(std::string_view text, const std::optional<ThermalProfile>& profile,
                                const std::string& where) {
    if (const auto checked = checkCsvText(text, where); !checked)
        return checked.error();
    const std::vector<CsvLine> all = csvLines(text);
    if (all.empty())
        return Error{MessageCode::FileEmpty, where};
    const char delimiter = csvDelimiter(all);
    const bool decimalComma = delimiter != ',';
    std::vector<TableLine> lines = tableLines(all, delimiter);
    keepTable(lines, profile, decimalComma);
    const std::size_t width = lines.empty() ? 0 : lines.front().cells.size(), height = lines.size();
    if (width < kMinTableSide || height < kMinTableSide)
        return Error{MessageCode::ThermalNoTable, where, {std::to_string(kMinTableSide)}};
    if (width > kMaxTableSide || height > kMaxTableSide)
        return Error{MessageCode::FileTooLarge,
                     where,
                     {pixelsText(static_cast<int>(width), static_cast<int>(height)) + " pixels",
                      pixelsText(kMaxTableSide, kMaxTableSide)}};
    ThermalPicture picture{static_cast<int>(width), static_cast<int>(height), {}};
    picture.T_K.reserve(width * height);
    for (const TableLine& line : lines) {
        if (line.cells.size() != width)
            return Error{
                MessageCode::ThermalRowLength,
                where,
                {std::to_string(line.number), std::to_string(line.cells.size()), std::to_string(width)}};
        for (std::size_t k = 0; k < width; ++k) {
            const auto value_degC = csvNumber(line.cells[k], decimalComma);
            const double T_K = value_degC ? kelvinFromCelsius(*value_degC) : 0.0;
            if (!(T_K > 0.0 && T_K <= kMaxBand_K))
                return Error{MessageCode::ThermalCellUnusable,
                             where,
                             {std::to_string(line.number), std::to_string(k + 1),
                              plainWords(std::string(line.cells[k].substr(0, 40)))}};
            picture.T_K.push_back(T_K);
        }
    }
    if (profile && (picture.width != profile->width || picture.height != profile->height))
        return Error{MessageCode::ThermalPictureSize,
                     where,
                     {profile->name, pixelsText(profile->width, profile->height),
                      pixelsText(picture.width, picture.height)}};
    return frameOfTemperatures(std::move(picture), profile, where);
}

} // namespace bask
