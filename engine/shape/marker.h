#pragma once
// ArUco markers in a picture, with corners between the pixels. One wrapper for OpenCV's two interfaces.

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Brightness of a picture, row by row.
struct GreyPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> values;
};

struct FoundMarker {
    int id = 0;
    /// Clockwise from the marker's upper left; pixel centres at whole numbers. Lines through each side's edge
    /// halfway between black and white meet there: good to some hundredths of a pixel in a sharp picture.
    std::array<Eigen::Vector2d, 4> corners_px;

    double side_px() const; ///< mean of the four
};

/// "4X4_50" to "7X7_1000", "ARUCO_ORIGINAL", with or without "DICT_" in front, in any case.
bool isMarkerDictionary(const std::string& name);
const std::string& markerDictionaries(); ///< the names, for a sentence

/// All markers of a dictionary, the largest in the picture first. They need a light margin. `dictionary` must
/// be one.
std::vector<FoundMarker> findMarkers(const GreyPicture& picture, const std::string& dictionary);

} // namespace bask
