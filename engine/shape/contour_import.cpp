#include "engine/shape/contour_import.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace bask {
namespace {

constexpr std::array kTextEndings{"csv", "txt", "dat"};
constexpr std::array kImageEndings{"png", "jpg", "jpeg", "bmp", "tif", "tiff"};
constexpr const char* kKnownEndings = "csv, txt, dat, png, jpg, jpeg, bmp, tif, tiff";

std::string lowered(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
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

Result<Contour> readContour(const std::string& path, const ContourImportOptions& options) {
    std::string ending = lowered(std::filesystem::path(path).extension().string());
    if (!ending.empty())
        ending.erase(0, 1);
    const auto isEnding = [&](const char* known) { return ending == known; };
    if (std::ranges::any_of(kTextEndings, isEnding))
        return readContourCsv(path, options.unit);
    if (!std::ranges::any_of(kImageEndings, isEnding))
        return Error{MessageCode::FormatUnknown, path, {ending, kKnownEndings}};
    if (!options.scale_px_per_mm)
        return Error{MessageCode::ScaleMissing, path};
    return readContourImage(path, *options.scale_px_per_mm);
}

} // namespace bask
