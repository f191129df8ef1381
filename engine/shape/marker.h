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

/// One of those, or one of somebody's own, which brings its bits.
struct MarkerDictionary {
    std::string name;
    int side_bits = 0;                  ///< without the border; 0: one of those known by name
    std::vector<std::string> bits = {}; ///< of each marker row by row, '1' white
    int correctableBits = 0;
};

int markerCount(const MarkerDictionary& dictionary);

/// Rows of a marker from its upper left, border included: '1' white, '0' black. `id` from 0 to markerCount
/// - 1.
std::vector<std::string> markerCells(const MarkerDictionary& dictionary, int id);

/// All markers of a dictionary, the largest in the picture first. They need a light margin. A dictionary
/// without bits must be one that is known by name. Nothing in a picture that is too small for any; one above
/// 16 megapixels is looked at that size, and the corners are refined in the whole.
std::vector<FoundMarker> findMarkers(const GreyPicture& picture, const MarkerDictionary& dictionary);

/// The same, and those that are found only in the picture at twice its size, which takes five times as long:
/// markers down to some 20 px. Pictures above 4 megapixels are looked at once.
std::vector<FoundMarker> findSmallMarkersToo(const GreyPicture& picture, const MarkerDictionary& dictionary);

} // namespace bask
