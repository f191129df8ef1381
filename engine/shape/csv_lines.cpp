#include "engine/shape/csv_lines.h"

#include "engine/base/message_code.h"
#include "engine/shape/contour_file.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>

namespace bask {
namespace {

constexpr char kSpaces = ' '; // "delimiter" of columns separated by white space

std::string_view unquoted(std::string_view field) {
    field = trimmed(field);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
        field = trimmed(field.substr(1, field.size() - 2));
    return field;
}

bool separates(char c, char delimiter) {
    return c == delimiter || (delimiter == kSpaces && c == '\t');
}

/// Where the first field ends; npos for the last one. A quote that is not closed before a delimiter, or at
/// the line's end, is a character as any other.
std::size_t fieldEnd(std::string_view line, char delimiter) {
    const std::size_t plain = delimiter == kSpaces ? line.find_first_of(" \t") : line.find(delimiter);
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string_view::npos || line[first] != '"')
        return plain;
    std::size_t at = first + 1;
    while (at < line.size() && (line[at] != '"' || line.substr(at, 2) == "\"\""))
        at += line[at] == '"' ? 2 : 1;
    for (at += 1; at < line.size() && !separates(line[at], delimiter); ++at)
        if (line[at] != ' ')
            return plain;
    return at < line.size() ? at : at == line.size() ? std::string_view::npos : plain;
}

/// Whether commas of this line are decimal: they leave values with blanks in them, and blanks leave numbers.
bool hasDecimalCommas(std::string_view line) {
    const auto hasBlank = [](std::string_view field) {
        return field.find_first_of(" \t") != std::string_view::npos;
    };
    return std::ranges::any_of(csvFields(line, ','), hasBlank) &&
           std::ranges::all_of(csvFields(line, kSpaces),
                               [](std::string_view field) { return csvNumber(field, true).has_value(); });
}

} // namespace

Result<void> checkCsvText(std::string_view text, const std::string& path) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return Error{MessageCode::FileUnreadable, path, {"it is UTF-16 text; save it as UTF-8"}};
    const auto isControl = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
    };
    if (std::ranges::any_of(text, isControl))
        return Error{MessageCode::FileUnreadable, path, {"it is not a text file"}};
    return {};
}

std::vector<CsvLine> csvLines(std::string_view text, bool keepTabs) {
    std::vector<CsvLine> lines;
    std::size_t number = 0;
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        const bool pair = text.substr(end, 2) == "\r\n";
        text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
        ++number;
        const std::string_view inner = trimmed(line);
        const bool isBlank = inner.empty() && !(keepTabs && line.find('\t') != std::string_view::npos);
        if (!isBlank && !inner.starts_with('#'))
            lines.push_back({line, number});
    }
    return lines;
}

char csvDelimiter(const std::vector<CsvLine>& lines) {
    constexpr std::size_t kLooked = 50;
    const std::span<const CsvLine> looked(lines.data(), std::min(kLooked, lines.size()));
    for (const char c : {';', '\t', ','}) {
        const auto has = std::ranges::count_if(looked, [&](const CsvLine& line) {
            return trimmed(line.text).find(c) != std::string_view::npos;
        });
        if (2 * static_cast<std::size_t>(has) <= looked.size())
            continue;
        const auto decimal = c == ',' ? std::ranges::count_if(looked, hasDecimalCommas, &CsvLine::text) : 0;
        return 2 * decimal > has ? kSpaces : c;
    }
    return kSpaces;
}

std::vector<std::string_view> csvFields(std::string_view line, char delimiter) {
    std::vector<std::string_view> fields;
    line = delimiter == '\t' ? line : trimmed(line);
    for (;;) {
        const std::size_t end = fieldEnd(line, delimiter);
        fields.push_back(unquoted(line.substr(0, end)));
        if (end == std::string_view::npos)
            return fields;
        line.remove_prefix(end + 1);
        if (delimiter == kSpaces)
            line = trimmed(line);
    }
}

std::optional<double> csvNumber(std::string_view field, bool decimalComma) {
    std::string text(field);
    if (decimalComma && text.find('.') == std::string::npos)
        if (const std::size_t comma = text.find(','); comma != std::string::npos)
            text[comma] = '.';
    const char* first = text.c_str();
    const char* last = first + text.size();
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        ++first;
    double value = 0.0;
    const auto [end, code] = std::from_chars(first, last, value);
    if (end != last || code == std::errc::invalid_argument)
        return std::nullopt;
    return code == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

} // namespace bask
