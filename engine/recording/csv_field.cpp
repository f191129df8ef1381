#include "engine/recording/csv_field.h"

namespace bask {

std::string csvField(const std::string& text) {
    const bool isQuoted = text.find_first_of(",\"\r\n") != std::string::npos;
    std::string field;
    for (const char c : text) {
        field += c;
        if (isQuoted && c == '"')
            field += c;
    }
    if (text.find_first_of("=+-@\t\r") == 0)
        field.insert(0, 1, '\'');
    return isQuoted ? '"' + field + '"' : field;
}

} // namespace bask
