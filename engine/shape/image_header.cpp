#include "engine/shape/image_header.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

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

// Whether all chunks of a PNG are there, up to its end.
bool isCompletePng(std::string_view bytes) {
    std::size_t at = 8;
    while (at + 12 <= bytes.size()) {
        if (bytes.substr(at + 4, 4) == "IEND")
            return true;
        at += 12 + static_cast<std::size_t>(number(bytes, at, 4, true));
    }
    return false;
}

/// One field of a TIFF's directory.
struct TiffField {
    std::uint64_t count = 0;
    std::size_t at = 0, size = 0;

    std::uint64_t value(std::string_view bytes, std::uint64_t index, bool big) const {
        return number(bytes, at + static_cast<std::size_t>(index) * size, size, big);
    }
};

// Whether the strips or tiles end within the file.
bool isCompleteTiff(std::string_view bytes, const TiffField& offsets, const TiffField& lengths, bool big) {
    if (offsets.count == 0 || offsets.count != lengths.count || offsets.count > bytes.size())
        return false;
    for (std::uint64_t k = 0; k < offsets.count; ++k)
        if (offsets.value(bytes, k, big) + lengths.value(bytes, k, big) > bytes.size())
            return false;
    return true;
}

std::size_t tiffEntries(std::string_view bytes, std::size_t directory, bool big) {
    return static_cast<std::size_t>(number(bytes, directory, 2, big));
}

// Where the directories of a TIFF begin; none if they go round in a circle, or are too many to be true.
std::vector<std::size_t> tiffDirectories(std::string_view bytes) {
    constexpr std::size_t kMaxPictures = 1'000'000;
    const bool big = bytes[0] == 'M';
    std::vector<std::size_t> out;
    std::unordered_set<std::size_t> known;
    for (auto at = static_cast<std::size_t>(number(bytes, 4, 4, big)); at != 0;) {
        if (!known.insert(at).second || out.size() == kMaxPictures)
            return {};
        out.push_back(at);
        at = static_cast<std::size_t>(number(bytes, at + 2 + 12 * tiffEntries(bytes, at, big), 4, big));
    }
    return out;
}

PictureHeader tiffHeader(std::string_view bytes, std::size_t picture = 0) {
    const bool big = bytes[0] == 'M';
    const std::vector<std::size_t> directories = tiffDirectories(bytes);
    PictureHeader out;
    if (picture >= directories.size())
        return out;
    const std::size_t directory = directories[picture];
    const std::size_t entries = tiffEntries(bytes, directory, big);
    out.bits = out.channels = 1; // what TIFF 6.0 says where there is no tag
    out.isWhole = true;
    bool isPalette = false;
    TiffField offsets, lengths;
    for (std::size_t k = 0; k < entries; ++k) {
        const std::size_t at = directory + 2 + 12 * k;
        const std::uint64_t tag = number(bytes, at, 2, big), kind = number(bytes, at + 2, 2, big);
        const std::uint64_t count = number(bytes, at + 4, 4, big);
        const std::size_t size = kind == 3 ? 2 : 4;
        // Of several values the first: they stand elsewhere if they do not fit in here.
        const bool isElsewhere = count > 4 / size;
        const std::size_t place =
            isElsewhere ? static_cast<std::size_t>(number(bytes, at + 8, 4, big)) : at + 8;
        const TiffField field{count, place, size};
        const std::uint64_t value = field.value(bytes, 0, big);
        if (tag == 256)
            out.width = value;
        if (tag == 257)
            out.height = value;
        if (tag == 258)
            out.bits = value;
        if (tag == 262)
            isPalette = value == 3;
        if (tag == 273 || tag == 324)
            offsets = field;
        if (tag == 277)
            out.channels = value;
        if (tag == 279 || tag == 325)
            lengths = field;
        if (tag == 339)
            out.isWhole = value == 1;
    }
    if (isPalette)
        out.channels = 0;
    out.isComplete = isCompleteTiff(bytes, offsets, lengths, big);
    out.pictures = directories.size();
    out.at = directory;
    return out;
}

bool isTiff(std::string_view bytes) {
    return bytes.starts_with("II*") || (bytes.starts_with("MM") && !isBigTiff(bytes));
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

bool isBigTiff(std::string_view bytes) {
    return bytes.starts_with(std::string_view("II+\0", 4)) || bytes.starts_with(std::string_view("MM\0+", 4));
}

std::string tiffFrom(std::string_view bytes, std::size_t directory) {
    std::string out(bytes);
    const bool big = isTiff(bytes) && bytes[0] == 'M';
    for (std::size_t k = 0; k < 4 && out.size() >= 8; ++k)
        out[4 + k] = static_cast<char>(directory >> 8 * (big ? 3 - k : k) & 0xFF);
    return out;
}

std::optional<PictureHeader> pictureHeader(std::string_view bytes, std::size_t picture) {
    PictureHeader out;
    if (bytes.starts_with("\x89PNG") && picture == 0) {
        constexpr std::uint64_t kChannels[] = {1, 0, 3, 0, 2, 0, 4}; // by the type of colour
        out.width = number(bytes, 16, 4, true);
        out.height = number(bytes, 20, 4, true);
        out.bits = number(bytes, 24, 1, true);
        out.channels = kChannels[std::min<std::uint64_t>(number(bytes, 25, 1, true), 6)];
        out.isWhole = true;
        out.pictures = 1;
        out.isComplete = isCompletePng(bytes);
    } else if (isTiff(bytes)) {
        out = tiffHeader(bytes, picture);
    }
    return out.width == 0 || out.height == 0 ? std::nullopt : std::optional(out);
}

std::optional<std::uint64_t> announcedPixels(std::string_view bytes) {
    std::uint64_t pixels = 0;
    if (bytes.starts_with("\x89PNG"))
        pixels = number(bytes, 16, 4, true) * number(bytes, 20, 4, true);
    else if (isJpeg(bytes))
        pixels = walkJpeg(bytes).pixels;
    else if (bytes.starts_with("BM"))
        pixels = magnitude(number(bytes, 18, 4, false)) * magnitude(number(bytes, 22, 4, false));
    else if (isTiff(bytes)) {
        const PictureHeader header = tiffHeader(bytes);
        pixels = header.width * header.height;
    }
    return pixels == 0 ? std::nullopt : std::optional(pixels);
}

} // namespace bask
