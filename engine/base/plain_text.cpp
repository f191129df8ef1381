#include "engine/base/plain_text.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

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

bool hasInvisible(const std::string& text) {
    // Soft hyphen, Arabic letter mark, Mongolian vowel separator; zero width and marks of direction; line and
    // paragraph separators, embeddings and overrides; word joiner to isolates; byte order mark.
    struct Range {
        std::string_view first, last;
    };
    constexpr std::array kRanges{Range{"\u00ad", "\u00ad"}, Range{"\u061c", "\u061c"},
                                 Range{"\u180e", "\u180e"}, Range{"\u200b", "\u200f"},
                                 Range{"\u2028", "\u202e"}, Range{"\u2060", "\u206f"},
                                 Range{"\ufeff", "\ufeff"}};
    for (std::size_t i = 0; i < text.size(); ++i)
        for (const auto& [first, last] : kRanges)
            if (const std::string_view here = std::string_view(text).substr(i, first.size());
                here.size() == first.size() && here >= first && here <= last)
                return true;
    return false;
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
