#include "engine/base/plain_text.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace bask {

std::string plainWords(const std::string& words) {
    const std::size_t id = words.find("] ");
    std::string text = words.starts_with('[') && id != std::string::npos ? words.substr(id + 2) : words;
    for (char& c : text) {
        if (c < ' ' || c > '~')
            c = '?';
    }
    constexpr std::size_t kLongest = 300;
    if (text.size() > kLongest) {
        text.resize(kLongest);
        text += " ...";
    }
    return text;
}

std::string printable(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
        if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f)
            text[i] = ' ';
        else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) // U+0080 to U+009F
            text.replace(i, 2, "  ");
    }
    return text;
}

namespace {

/// The character that begins at `at`, which is moved behind it; what is no UTF-8 counts byte by byte.
char32_t nextCharacter(const std::string& text, std::size_t& at) {
    const auto first = static_cast<unsigned char>(text[at++]);
    const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    char32_t character = more == 0 ? first : first & (0x3fU >> more);
    for (int k = 0; k < more && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;
         ++k)
        character = character << 6U | (static_cast<unsigned char>(text[at++]) & 0x3fU);
    return character;
}

struct Range {
    char32_t first, last;
};

template <std::size_t n> bool isIn(const std::array<Range, n>& ranges, char32_t character) {
    return std::ranges::any_of(ranges, [character](const Range& range) {
        return character >= range.first && character <= range.last;
    });
}

/// Unicode's Default_Ignorable_Code_Point but for what chooses a variant, and what separates lines or
/// annotates.
constexpr std::array kInvisible{
    Range{0xad, 0xad},       // soft hyphen
    Range{0x34f, 0x34f},     // grapheme joiner
    Range{0x61c, 0x61c},     // Arabic letter mark
    Range{0x115f, 0x1160},   // Hangul fillers
    Range{0x17b4, 0x17b5},   // Khmer vowels that are not written
    Range{0x180e, 0x180e},   // Mongolian vowel separator
    Range{0x200b, 0x200f},   // zero width, marks of direction
    Range{0x2028, 0x202e},   // separators of lines and paragraphs, embeddings and overrides
    Range{0x2060, 0x206f},   // word joiner to isolates
    Range{0x3164, 0x3164},   // Hangul filler
    Range{0xfeff, 0xfeff},   // byte order mark
    Range{0xffa0, 0xffa0},   // Hangul filler of half width
    Range{0xfff0, 0xfffb},   // not assigned, and interlinear annotation
    Range{0x1bca0, 0x1bca3}, // shorthand
    Range{0x1d173, 0x1d17a}, // musical notation
    Range{0xe0000, 0xe00ff}, // tags
    Range{0xe01f0, 0xe0fff}, // not assigned
};
constexpr std::array kVariants{Range{0x180b, 0x180d}, Range{0x180f, 0x180f}, Range{0xfe00, 0xfe0f},
                               Range{0xe0100, 0xe01ef}};

} // namespace

bool hasInvisible(const std::string& text, Variants variants) {
    char32_t before = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t character = nextCharacter(text, at);
        const bool isVariant = isIn(kVariants, character);
        const bool mayVary = variants == Variants::Kept && before >= 0x80 && !isIn(kVariants, before);
        if (isIn(kInvisible, character) || (isVariant && !mayVary))
            return true;
        before = character;
    }
    return false;
}

bool isOneLine(const std::string& text) {
    return (text.empty() || (text.front() != ' ' && text.back() != ' ')) &&
           text.find_first_of("\n\t") == std::string::npos && printable(text) == text;
}

std::string plainFileName(const std::string& name) {
    std::string out;
    for (const char c : name) {
        const bool isPlain =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-';
        out += isPlain ? c : '_';
    }
    return out;
}

std::size_t characterCount(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

Result<std::string> readTextFile(const std::string& path, std::uintmax_t max) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status))
        return Error(MessageCode::FileNotFound, path);
    if (!fs::is_regular_file(status))
        return Error(MessageCode::FileUnreadable, path, {"not a file"});
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file)
        return Error(MessageCode::FileUnreadable, path, {"access refused"});
    // Of the file that is open: another may be put in its place meanwhile.
    const auto size = static_cast<std::uintmax_t>(file.tellg());
    if (size > max)
        return Error(MessageCode::FileTooLarge, path,
                     {std::to_string(size >> 20) + " MiB", std::to_string(max >> 20) + " MiB"});
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!file.seekg(0).read(text.data(), static_cast<std::streamsize>(text.size())))
        return Error(MessageCode::FileUnreadable, path, {"it ended early"});
    return text;
}

} // namespace bask
