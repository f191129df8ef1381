#pragma once
// All kinds of files that outlines are read from. Readers, dialogs and sentences walk this list.

#include "engine/shape/contour_import.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// What a file of outlines is, and so what must be known besides: of a list and of some drawings the unit, of
/// a picture its scale.
enum class OutlineKind { Drawing, List, Picture };

struct OutlineFormat {
    OutlineKind kind;
    const char* name;                      ///< "JPEG"
    std::vector<std::string_view> endings; ///< lower case, the usual one first
    Result<OutlineFile> (*read)(const std::string& path, const ContourImportOptions& options);
};

/// Drawings first, then lists, then pictures.
std::span<const OutlineFormat> outlineFormats();
/// By the file's ending; null: there is none for it.
const OutlineFormat* outlineFormatOf(const std::string& path);
/// Names of a kind's formats: "SVG, DXF".
std::string outlineFormatNames(OutlineKind kind);
/// Endings of a kind's formats, or of all: "svg, dxf".
std::string outlineEndings(OutlineKind kind, const std::string& before = "",
                           const std::string& between = ", ");
std::string outlineEndings(const std::string& before = "", const std::string& between = ", ");

} // namespace bask
