#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_model.h"
#include "engine/shape/contour_file.h"
#include "engine/shape/csv_lines.h"
#include "engine/thermography/band_radiance.h"
#include "engine/thermography/frame_decoder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

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

/// Where commas separate, one in a value is decimal as well: such a value is in quotes.
std::optional<double> numberOf(std::string_view cell) {
    return csvNumber(cell, true);
}

/// "1,234" in quotes between commas: in one country a little more than one, in another more than a thousand.
bool isAmbiguous(std::string_view cell, char delimiter) {
    constexpr std::size_t kThousands = 5;
    return delimiter == ',' && cell.size() == kThousands && cell[1] == ',' &&
           (cell[0] == '1' || cell[0] == '2') &&
           cell.substr(2).find_first_not_of("0123456789") == std::string_view::npos;
}

bool hasNumber(const TableLine& line) {
    return std::ranges::any_of(line.cells, [](auto cell) { return numberOf(cell).has_value(); });
}

/// Whether the cells from `first` on count up by one.
bool countUp(const std::vector<std::string_view>& cells, std::size_t first) {
    if (cells.size() < first + kMinTableSide)
        return false;
    std::optional<double> before;
    for (std::size_t k = first; k < cells.size(); ++k) {
        const auto number = numberOf(cells[k]);
        if (!number || (before && *number != *before + 1.0))
            return false;
        before = number;
    }
    return true;
}

/// Whether the cells from `first` on are 0, 1, 2 ... or 1, 2, 3 ...
bool counts(const std::vector<std::string_view>& cells, std::size_t first) {
    return countUp(cells, first) && (numberOf(cells[first]) == 0.0 || numberOf(cells[first]) == 1.0);
}

std::vector<std::string_view> columnOf(const std::vector<TableLine>& lines, std::size_t column,
                                       std::size_t from) {
    std::vector<std::string_view> out;
    for (std::size_t k = from; k < lines.size(); ++k)
        out.push_back(column < lines[k].cells.size() ? lines[k].cells[column] : std::string_view());
    return out;
}

std::string lettersOf(std::string_view cell) {
    std::string out;
    std::ranges::copy_if(cell, std::back_inserter(out), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
    });
    return out;
}

/// Whether words name columns: each has letters and is another, but for a corner without a name; or each is
/// the unit. Words of masks repeat.
bool areNames(const std::vector<std::string_view>& cells) {
    const auto isUnit = [](std::string_view cell) {
        const std::string letters = lettersOf(cell);
        return letters == "C" || letters == "degC" || letters == "\u00b0C";
    };
    if (std::ranges::all_of(cells, isUnit))
        return true;
    std::set<std::string_view> known;
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (!(k == 0 && cells[k].empty()) && (lettersOf(cells[k]).empty() || !known.insert(cells[k]).second))
            return false;
    return true;
}

/// Whether this line above the table, without a number, is a row of masked pixels: then it stays, and is
/// refused. The profile's height tells; else that it is as wide as the table, and of no names.
bool isMaskedRow(const std::vector<TableLine>& lines, std::size_t above, std::size_t width,
                 const std::optional<ThermalProfile>& profile) {
    const std::vector<std::string_view>& cells = lines[above].cells;
    const bool isEmpty = std::ranges::all_of(cells, [](auto cell) { return cell.empty(); });
    // Of empty cells the last is taken for a separator at the line's end; and as a line below others they
    // are the gap between these and the table.
    if (cells.size() != width && !(isEmpty && cells.size() + 1 == width))
        return false;
    if (profile)
        return lines.size() - above == static_cast<std::size_t>(profile->height);
    return isEmpty ? above == 0 : !areNames(cells);
}

/// Leaves out the lines before the table, and the line and the column that only count. Temperatures can
/// count, too: so a counting line or column goes where the profile's size says that it is one too many, or
/// where both are there with a corner that is no number. Without a profile a single one is refused, unless
/// what is beside it counts as well.
Result<void> keepTable(std::vector<TableLine>& lines, const std::optional<ThermalProfile>& profile,
                       const std::string& where) {
    const std::size_t width = lines.empty() ? 0 : lines.back().cells.size();
    const auto first = std::ranges::find_if(
        lines, [&](const TableLine& line) { return line.cells.size() == width && hasNumber(line); });
    auto from = static_cast<std::size_t>(first - lines.begin());
    if (from > 0 && from < lines.size() && isMaskedRow(lines, from - 1, width, profile))
        lines[--from].cells.resize(width);
    lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(from));
    if (lines.size() < 2)
        return {};
    const bool hasCorner = !numberOf(lines[0].cells[0]);
    const bool isLine = counts(lines[0].cells, hasCorner ? 1 : 0);
    const bool isColumn = counts(columnOf(lines, 0, isLine ? 1 : 0), 0);
    const bool isBoth = hasCorner && isLine && isColumn;
    if (!profile && !isBoth && (isLine || counts(lines[0].cells, 1)) && !countUp(lines[1].cells, 0))
        return Error{MessageCode::ThermalLineCounts, where, {std::to_string(lines[0].number)}};
    if (!profile && !isBoth && isColumn && !countUp(columnOf(lines, 1, isLine ? 1 : 0), 0))
        return Error{MessageCode::ThermalColumnCounts, where};
    const auto isOneOver = [&](std::size_t found, int wanted) {
        return profile ? found == static_cast<std::size_t>(wanted) + 1 : isBoth;
    };
    if (isLine && isOneOver(lines.size(), profile ? profile->height : 0))
        lines.erase(lines.begin());
    if (isColumn && isOneOver(width, profile ? profile->width : 0))
        for (TableLine& line : lines)
            line.cells.erase(line.cells.begin());
    return {};
}

} // namespace

Result<ThermalFrame> frameOfCsv(std::string_view text, const std::optional<ThermalProfile>& profile,
                                const std::string& where) {
    if (const auto checked = checkCsvText(text, where); !checked)
        return checked.error();
    std::vector<CsvLine> all = csvLines(text);
    if (all.empty())
        return Error{MessageCode::FileEmpty, where};
    const char delimiter = csvDelimiter(all);
    if (delimiter == '\t')
        all = csvLines(text, true);
    while (trimmed(all.back().text).empty()) // there is one that is not
        all.pop_back();
    std::vector<TableLine> lines = tableLines(all, delimiter);
    if (const auto kept = keepTable(lines, profile, where); !kept)
        return kept.error();
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
            const auto value_degC = numberOf(line.cells[k]);
            const double T_K = value_degC ? kelvinFromCelsius(*value_degC) : 0.0;
            if (isAmbiguous(line.cells[k], delimiter) || !(T_K > 0.0 && T_K <= kMaxBand_K))
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
