#include "engine/shape/image_header.h"

namespace bask {
namespace {

// Unsigned integer of `size` bytes at `at`; 0 beyond the end.
std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size, bool bigEndian) {
    if (at > bytes.size() || size > bytes.size() - at)
        return 0;
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < size; ++k)
        value = value << 8 | static_cast<unsigned char>(bytes[at + (bigEndian ? k : size - 1 - k)]);
    return value;
}

struct JpegHeader {
    std::uint64_t pixels = 0;
    std::size_t scan = 0; // where the first scan's segment begins; 0 when there is none
};

// Walks the segments up to the first scan; thumbnails lie inside of segments and are stepped over.
JpegHeader walkJpeg(std::string_view bytes) {
    JpegHeader header;
    std::size_t at = 2;
    while (at + 4 <= bytes.size() && static_cast<unsigned char>(bytes[at]) == 0xFF) {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        if (marker == 0xFF) {
            ++at;
            continue;
        }
        const bool isFrame =
            marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (isFrame)
            header.pixels = number(bytes, at + 5, 2, true) * number(bytes, at + 7, 2, true);
        if (marker == 0xDA) {
            header.scan = at;
            return header;
        }
        at += 2 + static_cast<std::size_t>(number(bytes, at + 2, 2, true));
    }
    return header;
}

std::uint64_t tiffPixels(std::string_view bytes) {
    const bool big = bytes[0] == 'M';
    const auto directory = static_cast<std::size_t>(number(bytes, 4, 4, big));
    const auto entries = static_cast<std::size_t>(number(bytes, directory, 2, big));
    std::uint64_t width = 0, height = 0;
    for (std::size_t k = 0; k < entries; ++k) {
        const std::size_t at = directory + 2 + 12 * k;
        const std::uint64_t tag = number(bytes, at, 2, big), kind = number(bytes, at + 2, 2, big);
        const std::uint64_t value = number(bytes, at + 8, kind == 3 ? 2 : 4, big);
        if (tag == 256)
            width = value;
        if (tag == 257)
            height = value;
    }
    return width * height;
}

std::uint64_t magnitude(std::uint64_t value32) {
    return value32 >= 0x80000000U ? 0x100000000U - value32 : value32;
}

} // namespace

bool isJpeg(std::string_view bytes) {
    return bytes.starts_with("\xFF\xD8\xFF");
}

bool isCompleteJpeg(std::string_view bytes) {
    const std::size_t scan = walkJpeg(bytes).scan;
    return scan > 0 && bytes.find("\xFF\xD9", scan) != std::string_view::npos;
}

std::optional<std::uint64_t> announcedPixels(std::string_view bytes) {
    std::uint64_t pixels = 0;
    if (bytes.starts_with("\x89PNG"))
        pixels = number(bytes, 16, 4, true) * number(bytes, 20, 4, true);
    else if (isJpeg(bytes))
        pixels = walkJpeg(bytes).pixels;
    else if (bytes.starts_with("BM"))
        pixels = magnitude(number(bytes, 18, 4, false)) * magnitude(number(bytes, 22, 4, false));
    else if (bytes.starts_with("II*") || bytes.starts_with("MM"))
        pixels = tiffPixels(bytes);
    return pixels == 0 ? std::nullopt : std::optional(pixels);
}

} // namespace bask
