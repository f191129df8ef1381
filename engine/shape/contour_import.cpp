#include "engine/shape/contour_import.h"

#include "engine/base/message_code.h"
#include "engine/shape/outline_formats.h"
#include "engine/shape/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <utility>

namespace bask {
namespace {

constexpr double kFinest_m = 1e-5;            ///< to which holes are thinned first
constexpr std::size_t kMaxHoleCorners = 4000; ///< of all holes: an experiment takes 5000 with the outline's
constexpr double kCoarsest_m = 2e-4;

std::string lowered(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
}

// The holes in outline `at` that can be holes of a shape. Returns how many cannot.
int takeHoles(const std::vector<FileOutline>& outlines, std::size_t at, PickedOutline& picked) {
    int left = 0;
    for (const FileOutline& outline : outlines) {
        if (outline.holeIn != at)
            continue;
        auto hole = contourOf(outline);
        if (hole && picked.holes.size() < kMaxHoles &&
            checkHole(*hole, picked.contour.points_m, picked.holes))
            picked.holes.push_back(std::move(*hole));
        else
            ++left;
    }
    return left;
}

std::size_t cornersOf(const std::vector<Contour>& rings) {
    return std::accumulate(rings.begin(), rings.end(), std::size_t{0},
                           [](std::size_t sum, const Contour& ring) { return sum + ring.points_m.size(); });
}

// A sieve of fifty drilled holes has more corners than an experiment takes: no more are left than needed.
void thinHoles(PickedOutline& picked) {
    const std::vector<Contour> exact = picked.holes;
    const std::size_t before = cornersOf(exact);
    double within_m = 0.0;
    for (double next_m = kFinest_m; cornersOf(picked.holes) > kMaxHoleCorners && next_m <= kCoarsest_m;
         next_m *= 1.5) {
        within_m = next_m;
        std::ranges::transform(exact, picked.holes.begin(),
                               [=](const Contour& hole) { return simplified(hole, within_m); });
    }
    if (within_m > 0.0)
        picked.warnings.push_back({MessageCode::HolesThinned,
                                   {std::to_string(before), std::to_string(cornersOf(picked.holes)),
                                    formatNumber(within_m * 1e3, 2)}});
}

} // namespace

double metresPer(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::Centimetre:
        return 1e-2;
    case LengthUnit::Millimetre:
        return 1e-3;
    case LengthUnit::Inch:
        return 25.4e-3;
    case LengthUnit::Metre:
        break;
    }
    return 1.0;
}

const char* lengthUnitName(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::Centimetre:
        return "cm";
    case LengthUnit::Millimetre:
        return "mm";
    case LengthUnit::Inch:
        return "in";
    case LengthUnit::Metre:
        break;
    }
    return "m";
}

std::optional<LengthUnit> lengthUnitFromName(const std::string& name) {
    for (const LengthUnit unit :
         {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre, LengthUnit::Inch})
        if (lowered(name) == lengthUnitName(unit))
            return unit;
    return std::nullopt;
}

namespace {

// A drawing that names no unit was read in mm or in pixels of 1/96 in.
void useUnit(OutlineFile& file, LengthUnit unit) {
    constexpr double kPixel_m = 25.4e-3 / 96.0;
    const auto unitless = [](const Message& warning) { return warning.code == MessageCode::DxfUnitless; };
    if (std::erase_if(file.warnings, unitless) > 0)
        file.enlarge(metresPer(unit) / metresPer(LengthUnit::Millimetre));
    else if (file.unit == "px")
        file.enlarge(metresPer(unit) / kPixel_m);
    else
        return file.warnings.push_back({MessageCode::UnitNotUsed, {file.unit}});
    file.unit = lengthUnitName(unit);
}

} // namespace

Result<OutlineFile> readOutlines(const std::string& path, const ContourImportOptions& options) {
    if (!(options.factor > 0.0) || !std::isfinite(options.factor))
        return Error{MessageCode::ValueNotPositive, path, {formatNumber(options.factor)}};
    const OutlineFormat* format = outlineFormatOf(path);
    if (format == nullptr) {
        std::string ending = std::filesystem::path(path).extension().string();
        return Error{
            MessageCode::FormatUnknown, path, {ending.empty() ? ending : ending.substr(1), outlineEndings()}};
    }
    auto file = format->read(path, options);
    if (!file)
        return file;
    if (options.unit && format->kind == OutlineKind::Drawing)
        useUnit(*file, *options.unit);
    if (format->kind != OutlineKind::Picture)
        file->enlarge(options.factor);
    file->arrange();
    return file;
}

Result<PickedOutline> pickOutline(const OutlineFile& file, std::optional<std::size_t> index,
                                  const std::string& where) {
    const auto isWhole = [](const FileOutline& outline) { return outline.closed && !outline.hole; };
    const auto& outlines = file.outlines;
    if (outlines.empty())
        return Error{MessageCode::NoOutline, where};
    if (index && *index >= outlines.size())
        return Error{MessageCode::OutlineUnknown,
                     where,
                     {std::to_string(*index), std::to_string(outlines.size() - 1)}};
    const std::size_t at = index.value_or(0); // the largest closed one stands first and is no hole
    auto contour = contourOf(outlines[at], where);
    if (!contour)
        return contour.error();
    PickedOutline picked{std::move(*contour), {}, file.warnings};
    const auto whole = std::ranges::count_if(outlines, isWhole);
    if (!index && whole > 1)
        picked.warnings.push_back({MessageCode::OutlinesSeveral, {std::to_string(whole)}});
    const int left = takeHoles(outlines, at, picked);
    thinHoles(picked);
    if (left > 0)
        picked.warnings.push_back(
            {MessageCode::HolesLeftOut, {std::to_string(left), std::to_string(kMaxHoles)}});
    return picked;
}

Result<PickedOutline> readPicked(const std::string& path, const ContourImportOptions& options) {
    const auto file = readOutlines(path, options);
    if (!file)
        return file.error();
    return pickOutline(*file, std::nullopt, path);
}

Result<Contour> readContour(const std::string& path, const ContourImportOptions& options) {
    auto picked = readPicked(path, options);
    if (!picked)
        return picked.error();
    return std::move(picked->contour);
}

} // namespace bask
