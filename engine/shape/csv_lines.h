#pragma once
// Lines, fields and numbers of CSV files as programs of many countries write them.

#include "engine/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// A line with content; valid as long as the text.
struct CsvLine {
    std::string_view text;
    std::size_t number = 0; ///< counted from 1
};

/// Refuses UTF-16 and what is no text. Error: FileUnreadable.
Result<void> checkCsvText(std::string_view text, const std::string& path);
/// Returns the lines that are neither blank nor a comment (#). Ends of line are LF, CR LF or CR; a BOM is
/// left out. With `keepTabs` a line of nothing but tabs is not blank: a row of empty values.
std::vector<CsvLine> csvLines(std::string_view text, bool keepTabs = false);
/// Returns the delimiter that most of the first lines have. A semicolon or a tab is preferred to a comma,
/// which may be decimal; a space means that white space separates. It is preferred to a comma where that
/// would leave blanks within a value, and between blanks there are numbers.
char csvDelimiter(const std::vector<CsvLine>& lines);
/// Returns the fields of a line, without quotes and spaces around them. Within quotes nothing separates.
std::vector<std::string_view> csvFields(std::string_view line, char delimiter);
/// Returns a number in any locale; NaN if it is too large for a double; empty if it is not a number.
std::optional<double> csvNumber(std::string_view field, bool decimalComma);

} // namespace bask
