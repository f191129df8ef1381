#include "engine/shape/outline_formats.h"

#include "engine/shape/dxf_outlines.h"
#include "engine/shape/svg_outlines.h"

#include <algorithm>
#include <filesystem>

namespace bask {
namespace {

constexpr double kFlattening_m = 1e-5; ///< of curves

Result<OutlineFile> readSvg(const std::string& path, const ContourImportOptions&) {
    return readSvgOutlines(path, kFlattening_m);
}
Result<OutlineFile> readDxf(const std::string& path, const ContourImportOptions&) {
    return readDxfOutlines(path, kFlattening_m);
}
Result<OutlineFile> readList(const std::string& path, const ContourImportOptions& options) {
    return readCsvOutlines(path, options.unit);
}

std::string joined(const std::vector<std::string_view>& words, const std::string& before,
                   const std::string& between) {
    std::string out;
    for (const std::string_view word : words)
        out += (out.empty() ? "" : between) + before + std::string(word);
    return out;
}

} // namespace

std::span<const OutlineFormat> outlineFormats() {
    static const std::vector<OutlineFormat> formats{
        {OutlineKind::Drawing, "SVG", {"svg"}, readSvg},
        {OutlineKind::Drawing, "DXF", {"dxf"}, readDxf},
        {OutlineKind::List, "CSV", {"csv", "txt", "dat"}, readList},
        {OutlineKind::Picture, "PNG", {"png"}, readImageOutlines},
        {OutlineKind::Picture, "JPEG", {"jpg", "jpeg"}, readImageOutlines},
        {OutlineKind::Picture, "BMP", {"bmp"}, readImageOutlines},
        {OutlineKind::Picture, "TIFF", {"tif", "tiff"}, readImageOutlines},
    };
    return formats;
}

const OutlineFormat* outlineFormatOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (!ending.empty())
        ending.erase(0, 1);
    for (const OutlineFormat& format : outlineFormats())
        if (std::ranges::find(format.endings, ending) != format.endings.end())
            return &format;
    return nullptr;
}

std::string outlineFormatNames(OutlineKind kind) {
    std::vector<std::string_view> names;
    for (const OutlineFormat& format : outlineFormats())
        if (format.kind == kind)
            names.emplace_back(format.name);
    return joined(names, "", ", ");
}

std::string outlineEndings(OutlineKind kind, const std::string& before, const std::string& between) {
    std::vector<std::string_view> endings;
    for (const OutlineFormat& format : outlineFormats())
        if (format.kind == kind)
            endings.insert(endings.end(), format.endings.begin(), format.endings.end());
    return joined(endings, before, between);
}

std::string outlineEndings(const std::string& before, const std::string& between) {
    return outlineEndings(OutlineKind::Drawing, before, between) + between +
           outlineEndings(OutlineKind::List, before, between) + between +
           outlineEndings(OutlineKind::Picture, before, between);
}

} // namespace bask
