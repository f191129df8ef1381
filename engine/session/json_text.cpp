#include "engine/session/json_text.h"

#include "engine/base/message_code.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

namespace bask {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxDepth = 32;

/// First pass over a text: syntax, depth and repeated keys, before a tree is built of it.
class TextCheck final : public nlohmann::json_sax<json> {
public:
    const std::optional<Message>& message() const { return m_message; }

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool key(string_t& name) override {
        return m_keys.back().insert(name).second ||
               refuse({MessageCode::JsonDuplicateKey, {plainWords(name)}});
    }
    bool parse_error(std::size_t, const std::string&, const json::exception& e) override {
        return refuse({MessageCode::JsonSyntax, {plainWords(e.what())}});
    }

private:
    bool enter() {
        m_keys.emplace_back();
        return m_keys.size() <= kMaxDepth || refuse({MessageCode::JsonTooDeep, {std::to_string(kMaxDepth)}});
    }
    bool leave() {
        m_keys.pop_back();
        return true;
    }
    bool refuse(Message message) {
        m_message = std::move(message);
        return false;
    }
    std::vector<std::set<std::string>> m_keys;
    std::optional<Message> m_message;
};

} // namespace

std::string plainWords(const std::string& words) {
    const std::size_t id = words.find("] ");
    std::string text = words.starts_with('[') && id != std::string::npos ? words.substr(id + 2) : words;
    for (char& c : text) {
        if (c < ' ' || c > '~')
            c = '?';
    }
    constexpr std::size_t kLongest = 300;
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + " ...";
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

std::optional<Message> checkJsonText(const std::string& text) {
    TextCheck check;
    if (json::sax_parse(text, &check))
        return std::nullopt;
    return check.message().value_or(Message{MessageCode::JsonSyntax, {}});
}

Result<std::string> readTextFile(const std::string& path, std::uintmax_t most) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status))
        return Error(MessageCode::FileNotFound, path);
    if (!fs::is_regular_file(status))
        return Error(MessageCode::FileUnreadable, path, {"not a file"});
    const std::uintmax_t size = fs::file_size(path, code);
    if (!code && size > most)
        return Error(MessageCode::FileTooLarge, path,
                     {std::to_string(size >> 20) + " MiB", std::to_string(most >> 20) + " MiB"});
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error(MessageCode::FileUnreadable, path, {"access refused"});
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!file.read(text.data(), static_cast<std::streamsize>(text.size())))
        return Error(MessageCode::FileUnreadable, path, {"it ended early"});
    return text;
}

} // namespace bask
