#pragma once
// Finds ArUco markers in a picture with subpixel corners. One wrapper for OpenCV's two interfaces.

#include "engine/base/share_done.h"

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
    /// Clockwise from the marker's upper left; pixel centres are at whole numbers. A corner is where the
    /// lines of two sides meet; each line is fitted halfway between black and white. Accurate to some
    /// hundredths of a pixel in a sharp picture.
    std::array<Eigen::Vector2d, 4> corners_px;

    double side_px() const; ///< mean of the four
};

/// Returns whether the name is a known dictionary: "4X4_50" to "7X7_1000", "ARUCO_ORIGINAL", with or without
/// "DICT_" in front, in any case.
bool isMarkerDictionary(const std::string& name);
const std::string& markerDictionaries(); ///< the known names, for a sentence

/// A known dictionary, or a custom one that lists its bits.
struct MarkerDictionary {
    std::string name;
    int side_bits = 0;                  ///< without the border; 0 for a dictionary known by name
    std::vector<std::string> bits = {}; ///< of each marker row by row, '1' white
    int correctableBits = 0;
};

int markerCount(const MarkerDictionary& dictionary);

/// Returns the rows of a marker from its upper left, border included: '1' white, '0' black. `id` is from 0 to
/// markerCount - 1.
std::vector<std::string> markerCells(const MarkerDictionary& dictionary, int id);

/// Finds all markers of a dictionary, the largest in the picture first. They need a light margin. A
/// dictionary without bits must be known by name. Returns none if the picture is too small for any marker, or
/// crowded. A picture above 16 megapixels is searched at that size, and the corners are refined at full size.
std::vector<FoundMarker> findMarkers(const GreyPicture& picture, const MarkerDictionary& dictionary);

/// Returns whether a picture has more quadrangles than any picture of markers, as a fine chessboard, or
/// changes from nearly each pixel to the next. The search takes time with the square of their number.
bool isCrowded(const GreyPicture& picture);

/// Like findMarkers, but also searches the picture at twice its size, which takes five times as long: finds
/// markers down to about 20 px. A picture above 4 megapixels is searched once. `done` is told of each step.
std::vector<FoundMarker> findSmallMarkersToo(const GreyPicture& picture, const MarkerDictionary& dictionary,
                                             const ShareDone& done = {});

} // namespace bask
