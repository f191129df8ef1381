#pragma once
// The output of `bask fit-contour` for a file's outlines and a fit: JSON and a picture.

#include "engine/shape/contour_import.h"
#include "engine/shape/fourier_contour.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace bask {

/// Mark near the beginning of every preview, so that a preview replaces no other file.
inline constexpr const char* kPreviewMark = "bask fit-contour";

/// Returns an array of the outlines in their order.
nlohmann::ordered_json outlineList(const OutlineFile& file);

/// Returns a contour that Bask reads ("type", "coefficients" and "holes_m" in metres about the series'
/// centroid) with its figures, and "outline" and "holes" in mm in the file's coordinates. Area and perimeter
/// are those of the series; only "net_area_mm2" subtracts the holes.
nlohmann::ordered_json fitReport(const PickedOutline& picked, const FourierFit& fit, const std::string& unit);

/// PNG of the outline with its holes (grey area) and the fit (red line) over a grid of 10 mm, or of as many
/// powers of ten as the outline needs. Needs no application and no display.
std::string fitPreview(const PickedOutline& picked, const FourierFit& fit);

} // namespace bask
