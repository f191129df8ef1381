#pragma once
// The content of an outline file, before one outline is used as an object's contour.

#include "engine/shape/contour.h"
#include "engine/shape/picture_plane.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// One outline as in its file: flattened, not yet checked.
struct FileOutline {
    std::vector<Eigen::Vector2d> points_m; ///< y up; the first point of a closed one is not repeated
    bool closed = true;
    int region = 0;    ///< an outline inside another one of the same region is its hole
    bool hole = false; ///< set by arrange()
    /// Index of the outline that contains this hole; set by arrange().
    std::optional<std::size_t> holeIn = {};

    double area_m2() const;     ///< not negative; 0 where open
    double perimeter_m() const; ///< the length, if it is open
};

/// All outlines of a file, and the assumptions of its reader.
struct OutlineFile {
    std::vector<FileOutline> outlines;
    std::string unit;                       ///< "mm", "px", ... as the file has it
    std::vector<Message> warnings;          ///< for the operator
    std::optional<PicturePlane> plane = {}; ///< for a picture: maps its pixels to the outlines' lengths

    void enlarge(double factor);

    /// Sorts the outlines: closed ones by area, largest first, then open ones by length. Marks holes: closed
    /// outlines inside an odd number of closed outlines of their region.
    void arrange();
};

/// Returns the outline as a checked contour. Refuses open and crossing ones; `where` is the place in the
/// error.
Result<Contour> contourOf(const FileOutline& outline, const std::string& where = {});

} // namespace bask
