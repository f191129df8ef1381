#pragma once
// Imports outlines from files of all supported formats: silhouettes in an image, a list of points in a CSV.
// OpenCV stays in the .cpp.

#include "engine/shape/marker.h"
#include "engine/shape/outline_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Unit of length in a file.
enum class LengthUnit { Metre, Centimetre, Millimetre, Inch };
double metresPer(LengthUnit unit);
const char* lengthUnitName(LengthUnit unit); ///< "m", "cm", "mm", "in"
std::optional<LengthUnit> lengthUnitFromName(const std::string& name);

/// Two points of a picture (px from its upper left corner) and the distance between them.
struct KnownLength {
    Eigen::Vector2d from_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d to_px = Eigen::Vector2d::Zero();
    double length_m = 0.0;
};

/// An ArUco marker that is visible in the picture, beside the objects and in their plane.
struct ReferenceMarker {
    double side_m = 0.0;               ///< of its black square
    std::string dictionary = "4X4_50"; ///< as in marker.h
};

/// Colour of the objects in a picture.
struct PickedColour {
    std::array<std::uint8_t, 3> rgb{};
    std::optional<double> tolerance; ///< distance in CIE Lab; if empty, Otsu's threshold is used
};

/// Options of an import. A picture needs exactly one of the three scales.
struct ContourImportOptions {
    /// Unit of a number or pixel, for a list, or a drawing that names no unit.
    std::optional<LengthUnit> unit = {};
    double factor = 1.0;                         ///< for a list or drawing: scales the outline
    std::optional<double> scale_px_per_mm = {};  ///< for a picture taken straight from the front
    std::optional<KnownLength> knownLength = {}; ///< for a picture taken straight from the front
    std::optional<ReferenceMarker> marker = {};  ///< for a picture in any perspective
    /// For a picture; if empty, its opacity is used, or else its brightness.
    std::optional<PickedColour> colour = {};
    bool leaveOutBorder = false; ///< for a picture: ignore silhouettes at its border, even the largest
};

/// Reads the outline of a CSV of x,y. Separators are comma, semicolon, tab or blanks; a decimal comma is
/// accepted unless the comma separates values. A BOM is accepted, and lines that start with # are comments.
/// If there is a header, its columns x and y are used (otherwise the first two columns), and its unit
/// ("x_mm", "x (mm)", "x[mm]") if `unit` is not given. The first point may be repeated at the end. The
/// outline is open if the last edge, which closes it, is longer than 20 times the median edge, 5 % of the
/// perimeter and twice the longest other edge. The limits are 64 MiB and a million lines.
Result<OutlineFile> readCsvOutlines(const std::string& path, std::optional<LengthUnit> unit);
/// Like readCsvOutlines, from the bytes of a file; `where` names them in errors.
Result<OutlineFile> csvOutlines(const std::string& bytes, const std::string& where,
                                std::optional<LengthUnit> unit);
Result<Contour> readContourCsv(const std::string& path, std::optional<LengthUnit> unit);

/// Finds all silhouettes in an image (8 or 16 bit; a photograph is turned as its EXIF says) and the holes in
/// them. Objects are separated from the ground by the picked colour; without one, by opacity if the frame is
/// transparent, otherwise by brightness with Otsu's threshold, and the majority of the frame is ground. Edges
/// are traced between the pixels at half the step from ground to object (in Lab for a colour) and simplified
/// to 0.1 px or 0.01 mm; y points up. The origin is the lower left corner of the picture, or of the marker,
/// with x along its lower side.
///
/// A marker's corners give scale and perspective. The outline's points are transformed, so nothing is
/// resampled; markers are not silhouettes. In a sharp picture, a 40 mm marker 120 px wide gives an outline up
/// to three sides away to 0.1 mm and its area to 0.2 %, at slants up to 45 degrees; errors grow as 1/px and
/// with the square of the distance. Lens distortion is not corrected, and an edge at height h above the
/// marker's plane looks larger by h over the camera's distance.
///
/// Refuses a picture without a clear silhouette, one whose largest silhouette touches the border (unless
/// `leaveOutBorder`), a truncated JPEG, more than 64 megapixels, and a scale that is missing, not positive or
/// given twice.
Result<OutlineFile> readImageOutlines(const std::string& path, const ContourImportOptions& options);

/// Colours of a picture, row by row, as red, green and blue.
struct ColourPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Reads a picture to show it: turned as in readImageOutlines, on white where it is transparent.
Result<ColourPicture> readPicture(const std::string& path);

/// Reads the brightness of a picture, turned likewise, for markers and calibration boards. Refuses the same
/// files as readImageOutlines.
Result<GreyPicture> readGreyPicture(const std::string& path);

/// Reads and arranges every outline of a file, with the reader for its ending (outline_formats.h).
Result<OutlineFile> readOutlines(const std::string& path, const ContourImportOptions& options);

/// One outline of a file with its holes, checked.
struct PickedOutline {
    Contour contour;
    std::vector<Contour> holes;    ///< those that pass checkHoles, simplified if they have many corners
    std::vector<Message> warnings; ///< says what was left out: other outlines, holes, corners of holes
};

/// Returns the outline with this index in an arranged file, or without an index the largest closed one that
/// is not a hole.
Result<PickedOutline> pickOutline(const OutlineFile& file, std::optional<std::size_t> index,
                                  const std::string& where);

/// Reads the largest closed outline of a file that is not a hole, with its holes.
Result<PickedOutline> readPicked(const std::string& path, const ContourImportOptions& options);
/// Like readPicked, without holes.
Result<Contour> readContour(const std::string& path, const ContourImportOptions& options);

} // namespace bask
