#pragma once
// What `bask fit-contour` says of a file's outlines and of a fit: JSON and a picture.

#include "engine/shape/contour_import.h"
#include "engine/shape/fourier_contour.h"

#include <nlohmann/json_fwd.hpp>

#include <QByteArray>

#include <string>
#include <vector>

namespace bask {

/// Stands near the beginning of every preview, so that nothing else is replaced by one.
inline constexpr const char* kPreviewMark = "bask fit-contour";

/// An array of the outlines as they are arranged.
nlohmann::ordered_json outlineList(const OutlineFile& file);

/// A contour that Bask reads ("type", "coefficients" and "holes_m" in metres about the series' centroid) with
/// its figures, and "outline" and "holes" in mm, in the file's coordinates. Area and perimeter are the
/// series', holes are counted off in "net_area_mm2" only.
nlohmann::ordered_json fitReport(const PickedOutline& picked, const FourierFit& fit, const std::string& unit);

/// PNG of the outline with its holes (grey area) and the fit (red line) over a grid of 10 mm, or of as many
/// powers of ten as the outline needs. Needs no application and no display.
QByteArray fitPreview(const PickedOutline& picked, const FourierFit& fit);

} // namespace bask
