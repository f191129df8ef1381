#include "engine/calibration/plain_yaml.h"

#include "engine/base/message_code.h"
#include "engine/shape/contour_file.h"

#include <charconv>
#include <cmath>

namespace bask {
namespace {

/// A line without its comment; # counts in quotes and inside of words.
std::string_view withoutComment(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
            return line.substr(0, i);
    }
    return line;
}

std::string scalar(std::string_view text) {
    text = trimmed(text);
    const bool quoted =
        text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

/// Where a key ends in "key: value" or "key:"; npos when the line is no such thing.
std::size_t keyEnd(std::string_view line) {
    const auto colon = line.find(':');
    const bool ends = colon != std::string_view::npos && (colon + 1 == line.size() || line[colon + 1] == ' ');
    return ends && colon > 0 ? colon : std::string_view::npos;
}

/// Scalars between the commas of a flow list or a part of one; brackets and blanks fall away.
void appendFlow(std::string_view text, std::vector<std::string>& list) {
    std::string item;
    char quote = 0;
    const auto finish = [&] {
        if (std::string value = scalar(item); !value.empty())
            list.push_back(std::move(value));
        item.clear();
    };
    for (const char c : text) {
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        if (quote == 0 && (c == ',' || c == '[' || c == ']'))
            finish();
        else
            item += c;
    }
    finish();
}

struct Level {
    std::size_t indent = 0;
    std::string path;
};

} // namespace

PlainYaml::PlainYaml(std::string_view text) {
    std::vector<Level> levels; // keys that the line is inside of
    std::string flow;          // path of the flow list that is not closed yet
    while (!text.empty()) {
        const auto end = text.find('\n');
        std::string_view line = withoutComment(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::string_view content = trimmed(line);
        if (!flow.empty()) {
            appendFlow(content, m_scalars[flow]);
            if (content.ends_with(']'))
                flow.clear();
            continue;
        }
        if (content.empty() || content.starts_with("%") || content.starts_with("---"))
            continue;
        const std::size_t indent = line.find(content.front());
        if (content.starts_with("- ")) { // of the key above, which may be indented alike
            while (!levels.empty() && levels.back().indent > indent)
                levels.pop_back();
            if (!levels.empty())
                m_scalars[levels.back().path].push_back(scalar(content.substr(2)));
            continue;
        }
        const auto colon = keyEnd(content);
        if (colon == std::string_view::npos)
            continue;
        while (!levels.empty() && levels.back().indent >= indent)
            levels.pop_back();
        constexpr std::size_t kMaxLevels = 8;
        if (levels.size() == kMaxLevels)
            continue;
        const std::string path =
            (levels.empty() ? "" : levels.back().path + "/") + scalar(content.substr(0, colon));
        levels.push_back({indent, path});
        std::string_view value = trimmed(content.substr(colon + 1));
        if (value.starts_with("!!"))
            value = {};
        if (value.starts_with('[')) {
            appendFlow(value, m_scalars[path]);
            if (!value.ends_with(']'))
                flow = path;
        } else if (!value.empty()) {
            m_scalars[path].push_back(scalar(value));
        }
    }
}

std::string PlainYaml::text(const std::string& path, std::size_t index) const {
    const auto it = m_scalars.find(path);
    return it == m_scalars.end() || index >= it->second.size() ? std::string() : it->second[index];
}

Result<std::vector<double>> PlainYaml::numbers(const std::string& path, const std::string& where) const {
    const auto it = m_scalars.find(path);
    if (it == m_scalars.end())
        return Error{MessageCode::JsonMissingKey, where, {path}};
    std::vector<double> values;
    for (const std::string& word : it->second) {
        const char* const end = word.data() + word.size();
        const auto read = std::from_chars(word.data() + word.starts_with('+'), end, values.emplace_back());
        if (read.ec != std::errc() || read.ptr != end || !std::isfinite(values.back()))
            return Error{MessageCode::NumbersUnusable, where, {path}};
    }
    return values;
}

Result<int> PlainYaml::whole(const std::string& path, int min, int max, const std::string& where) const {
    const auto values = numbers(path, where);
    if (!values)
        return values.error();
    if (values->size() != 1 || values->front() != std::floor(values->front()))
        return Error{MessageCode::NumbersUnusable, where, {path}};
    if (!(values->front() >= min && values->front() <= max))
        return Error{MessageCode::ValueOutOfRange,
                     where,
                     {formatNumber(values->front()), std::to_string(min), std::to_string(max), ""}};
    return static_cast<int>(values->front());
}

} // namespace bask
