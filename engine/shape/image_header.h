#pragma once
// What the first bytes of a picture say, read before a decoder is trusted with it.

#include <cstdint>
#include <optional>
#include <string_view>

namespace bask {

/// Width times height as announced by a PNG, JPEG, BMP or TIFF; none when the header is of no such kind or
/// damaged.
std::optional<std::uint64_t> announcedPixels(std::string_view bytes);

bool isJpeg(std::string_view bytes);

/// True when the JPEG's compressed data run up to its end marker; decoders fill a cut one with grey.
bool isCompleteJpeg(std::string_view bytes);

} // namespace bask
