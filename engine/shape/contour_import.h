#pragma once
// Outlines from files: the silhouette in an image, or a list of points in a CSV. OpenCV stays in the .cpp.

#include "engine/shape/contour.h"

#include <optional>
#include <string>

namespace bask {

/// Unit of length in a file.
enum class LengthUnit { Metre, Centimetre, Millimetre, Inch };
double metresPer(LengthUnit unit);
const char* lengthUnitName(LengthUnit unit); ///< "m", "cm", "mm", "in"
std::optional<LengthUnit> lengthUnitFromName(const std::string& name);

/// Outline from a CSV of x,y: comma, semicolon, tab or blanks; decimal comma unless the comma delimits; BOM;
/// lines that start with # are comments; optional header, whose columns x and y are taken (else the first
/// two) and whose unit
/// ("x_mm", "x (mm)", "x[mm]") is used when `unit` is not given. The first point may be repeated at the end
/// or not. Refused as open when the last edge, left out, is longer than 20 times the median edge, 5 % of the
/// perimeter and twice the longest other edge. At most 64 MiB and a million lines.
Result<Contour> readContourCsv(const std::string& path, std::optional<LengthUnit> unit);

/// The same from a file's bytes; `where` names them in errors.
Result<Contour> contourFromCsv(const std::string& bytes, const std::string& where,
                               std::optional<LengthUnit> unit);

/// Largest silhouette in an image (8 or 16 bit): its opacity where the frame is transparent, else its
/// brightness cut by Otsu's split, with the frame's majority as ground. Traced between the pixels at half the
/// step from ground to object, thinned by 0.1 px or 0.01 mm; origin at the picture's lower left corner, y up.
/// `scale_px_per_mm` > 0. Refuses a picture with no clear silhouette, one whose silhouette touches the
/// border, a cut JPEG, and more than 64 megapixels.
Result<Contour> readContourImage(const std::string& path, double scale_px_per_mm);

/// What an import needs to know beyond the file.
struct ContourImportOptions {
    std::optional<LengthUnit> unit;        ///< CSV
    std::optional<double> scale_px_per_mm; ///< images
};

/// Chooses the reader by the file's extension (csv, txt, dat; png, jpg, jpeg, bmp, tif, tiff).
Result<Contour> readContour(const std::string& path, const ContourImportOptions& options);

} // namespace bask
