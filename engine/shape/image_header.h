#pragma once
// Reads the header of a picture, before a decoder opens the file.

#include <cstdint>
#include <optional>
#include <string_view>

namespace bask {

/// Returns width times height as the header of a PNG, JPEG, BMP or TIFF states them; empty if the header is
/// of another kind or damaged.
std::optional<std::uint64_t> announcedPixels(std::string_view bytes);

/// What a PNG or a TIFF states of its first picture.
struct PictureHeader {
    std::uint64_t width = 0, height = 0;
    std::uint64_t bits = 0;     ///< of a channel
    std::uint64_t channels = 0; ///< 0 if the pixels are numbers of a palette
    bool isWhole = false;       ///< numbers without a sign or a fraction
    int pictures = 0;           ///< in the file; counted up to 2
    bool isComplete = false;    ///< all bytes that the header tells of are there
};
/// Returns the header of a PNG or TIFF; empty for anything else, and if it is damaged.
std::optional<PictureHeader> pictureHeader(std::string_view bytes);

bool isJpeg(std::string_view bytes);

/// Returns whether the JPEG's compressed data continue to its end marker; decoders fill the rest of a
/// truncated file with grey.
bool isCompleteJpeg(std::string_view bytes);

} // namespace bask
