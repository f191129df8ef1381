#pragma once
// Outlines from files of every kind that is read: silhouettes in an image, a list of points in a CSV. OpenCV
// stays in the .cpp.

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

/// Two points of a picture (px from its upper left corner) and how far apart they are.
struct KnownLength {
    Eigen::Vector2d from_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d to_px = Eigen::Vector2d::Zero();
    double length_m = 0.0;
};

/// An ArUco marker that lies in a picture in the plane of the objects, beside them.
struct ReferenceMarker {
    double side_m = 0.0;               ///< of its black square
    std::string dictionary = "4X4_50"; ///< as in marker.h
};

/// Colour of the objects in a picture.
struct PickedColour {
    std::array<std::uint8_t, 3> rgb{};
    std::optional<double> tolerance; ///< distance in CIE Lab; none: split by Otsu
};

/// What an import needs to know beyond the file. A picture needs one of the three scales.
struct ContourImportOptions {
    std::optional<LengthUnit> unit = {};         ///< list, or drawing that names none: of a number or pixel
    double factor = 1.0;                         ///< list or drawing: makes it so many times as large
    std::optional<double> scale_px_per_mm = {};  ///< picture seen straight on
    std::optional<KnownLength> knownLength = {}; ///< picture seen straight on
    std::optional<ReferenceMarker> marker = {};  ///< picture in any perspective
    std::optional<PickedColour> colour = {};     ///< picture; none: opacity, else brightness
    bool leaveOutBorder = false; ///< picture: silhouettes at its border are left out, even the largest
};

/// The outline of a CSV of x,y: comma, semicolon, tab or blanks; decimal comma unless the comma delimits;
/// BOM; lines that start with # are comments; optional header, whose columns x and y are taken (else the
/// first two) and whose unit ("x_mm", "x (mm)", "x[mm]") is used when `unit` is not given. The first point
/// may be repeated at the end or not. Open when the last edge, left out, is longer than 20 times the median
/// edge, 5 % of the perimeter and twice the longest other edge. At most 64 MiB and a million lines.
Result<OutlineFile> readCsvOutlines(const std::string& path, std::optional<LengthUnit> unit);
/// The same from a file's bytes; `where` names them in errors.
Result<OutlineFile> csvOutlines(const std::string& bytes, const std::string& where,
                                std::optional<LengthUnit> unit);
Result<Contour> readContourCsv(const std::string& path, std::optional<LengthUnit> unit);

/// All silhouettes in an image (8 or 16 bit; a photograph turned as its EXIF says) and the holes in them: by
/// the colour picked, else by its opacity where the frame is transparent, else by its brightness cut by
/// Otsu's split, with the frame's majority as ground. Traced between the pixels at half the step from ground
/// to object (in Lab for a colour), thinned by 0.1 px or 0.01 mm; y up. Origin at the picture's lower left
/// corner, or the marker's, x along its lower side.
///
/// A marker's corners give scale and perspective, and the outline's points are moved, so that nothing is
/// resampled; markers themselves are no silhouettes. A sharp picture of a 40 mm marker 120 px wide tells an
/// outline up to three sides away to 0.1 mm and its area to 0.2 %, at slants up to 45 degrees; errors go as
/// 1/px and grow with the square of the distance. What the lens bends is not undone, and what lies h above
/// the marker's plane looks larger by h over the camera's distance.
///
/// Refuses a picture with no clear silhouette, one whose largest silhouette touches the border (unless those
/// are to be left out), a cut JPEG,
/// more than 64 megapixels, and a scale that is missing, not positive or given twice.
Result<OutlineFile> readImageOutlines(const std::string& path, const ContourImportOptions& options);

/// A picture's colours, row by row, red, green and blue.
struct ColourPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// A picture turned as readImageOutlines takes it, on white where it is transparent, to be shown.
Result<ColourPicture> readPicture(const std::string& path);

/// Its brightness, turned likewise, for markers and calibration boards. Refuses of files what
/// readImageOutlines does.
Result<GreyPicture> readGreyPicture(const std::string& path);

/// Every outline of a file, arranged, by the reader that its ending names (outline_formats.h).
Result<OutlineFile> readOutlines(const std::string& path, const ContourImportOptions& options);

/// One outline of a file with the holes in it, checked.
struct PickedOutline {
    Contour contour;
    std::vector<Contour> holes;    ///< those that checkHoles takes, thinned where they have many corners
    std::vector<Message> warnings; ///< what was left out: other outlines, holes, corners of holes
};

/// The outline with this index in an arranged file; without one the largest that is closed and no hole.
Result<PickedOutline> pickOutline(const OutlineFile& file, std::optional<std::size_t> index,
                                  const std::string& where);

/// The largest outline of a file that is closed and no hole, with its holes.
Result<PickedOutline> readPicked(const std::string& path, const ContourImportOptions& options);
/// The same without its holes.
Result<Contour> readContour(const std::string& path, const ContourImportOptions& options);

} // namespace bask
