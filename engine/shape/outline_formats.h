#pragma once
// All file formats that outlines are read from. Readers, dialogs and sentences use this list.

#include "engine/shape/contour_import.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// The kind of an outline file, which decides what else must be given: the unit for a list and some drawings,
/// the scale for a picture.
enum class OutlineKind { Drawing, List, Picture };

struct OutlineFormat {
    OutlineKind kind;
    const char* name;                      ///< "JPEG"
    std::vector<std::string_view> endings; ///< lower case, the usual one first
    Result<OutlineFile> (*read)(const std::string& path, const ContourImportOptions& options);
};

/// Returns the formats: drawings first, then lists, then pictures.
std::span<const OutlineFormat> outlineFormats();
/// Returns the format for the file's ending; null if there is none.
const OutlineFormat* outlineFormatOf(const std::string& path);
/// Returns the names of a kind's formats: "SVG, DXF".
std::string outlineFormatNames(OutlineKind kind);
/// Returns the endings of a kind's formats, or of all: "svg, dxf".
std::string outlineEndings(OutlineKind kind, const std::string& before = "",
                           const std::string& between = ", ");
std::string outlineEndings(const std::string& before = "", const std::string& between = ", ");

} // namespace bask
