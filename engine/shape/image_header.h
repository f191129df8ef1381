#pragma once
// Reads the header of a picture, before a decoder opens the file.

#include <cstdint>
#include <optional>
#include <string_view>

namespace bask {

/// Returns width times height as the header of a PNG, JPEG, BMP or TIFF states them; empty if the header is
/// of another kind or damaged.
std::optional<std::uint64_t> announcedPixels(std::string_view bytes);

bool isJpeg(std::string_view bytes);

/// Returns whether the JPEG's compressed data continue to its end marker; decoders fill the rest of a
/// truncated file with grey.
bool isCompleteJpeg(std::string_view bytes);

} // namespace bask
