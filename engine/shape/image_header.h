#pragma once
// Reads the header of a picture, before a decoder opens the file.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bask {

/// Returns width times height as the header of a PNG, JPEG, BMP or TIFF states them; empty if the header is
/// of another kind or damaged.
std::optional<std::uint64_t> announcedPixels(std::string_view bytes);

/// What a PNG or a TIFF states of one of its pictures.
struct PictureHeader {
    std::uint64_t width = 0, height = 0;
    std::uint64_t bits = 0;     ///< of a channel
    std::uint64_t channels = 0; ///< 0 if the pixels are numbers of a palette
    bool isWhole = false;       ///< numbers without a sign or a fraction
    std::size_t pictures = 0;   ///< in the file
    std::size_t at = 0;         ///< of a TIFF: where the picture's directory begins
    bool isComplete = false;    ///< all bytes that the header tells of are there
};
/// Returns the header of a picture of a PNG or TIFF, counted from 0; empty for anything else, if it is
/// damaged, and if there is no such picture. A BigTIFF has none.
std::optional<PictureHeader> pictureHeader(std::string_view bytes, std::size_t picture = 0);
/// Returns whether the file is a TIFF with offsets of 64 bits.
bool isBigTiff(std::string_view bytes);
/// Returns the bytes of a TIFF whose first picture is the one with this directory.
std::string tiffFrom(std::string_view bytes, std::size_t directory);

bool isJpeg(std::string_view bytes);

/// Returns whether the JPEG's compressed data continue to its end marker; decoders fill the rest of a
/// truncated file with grey.
bool isCompleteJpeg(std::string_view bytes);

} // namespace bask
