#pragma once
// What a file of outlines holds, before one of them is taken as an object's contour.

#include "engine/shape/contour.h"
#include "engine/shape/picture_plane.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// One outline as it stands in its file: flattened, not yet checked.
struct FileOutline {
    std::vector<Eigen::Vector2d> points_m; ///< y up; the first point of a closed one is not repeated
    bool closed = true;
    int region = 0;    ///< outlines of one region are seen together: one in another is its hole
    bool hole = false; ///< set by arrange()
    std::optional<std::size_t> holeIn = {}; ///< index of the outline that it is a hole in; set by arrange()

    double area_m2() const;     ///< not negative; 0 where open
    double perimeter_m() const; ///< of an open one, its length
};

/// All outlines of a file, and what its reader had to assume.
struct OutlineFile {
    std::vector<FileOutline> outlines;
    std::string unit;                       ///< "mm", "px", ... as the file has it
    std::vector<Message> warnings;          ///< for the operator
    std::optional<PicturePlane> plane = {}; ///< of a picture: from its pixels to the outlines' lengths

    void enlarge(double factor);

    /// Puts closed ones first and the largest of them first of all, open ones behind by their length, and
    /// marks holes: closed outlines within an odd number of closed outlines of their region.
    void arrange();
};

/// The outline as a checked contour. Refuses open and crossing ones; `where` goes into the error.
Result<Contour> contourOf(const FileOutline& outline, const std::string& where = {});

} // namespace bask
