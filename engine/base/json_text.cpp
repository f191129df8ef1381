#include "engine/base/json_text.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"

#include <nlohmann/json.hpp>

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

/// Empty: the text is sound.
std::optional<Message> complaintAbout(const std::string& text) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        return Message{MessageCode::FileEmpty, {}};
    TextCheck check;
    if (json::sax_parse(text, &check))
        return std::nullopt;
    return check.message().value_or(Message{MessageCode::JsonSyntax, {}});
}

} // namespace

Error located(Error error, const std::string& place) {
    if (!place.empty())
        error.where = error.where.empty() ? place : place + ": " + error.where;
    return error;
}

Failure readJsonTree(const std::string& text, const std::string& place,
                     const std::function<void(const json&, Failure&)>& read) {
    try {
        if (const auto complaint = complaintAbout(text))
            return Error(complaint->code, place, complaint->args);
        Failure failure;
        read(json::parse(text), failure);
        return failure ? located(*failure, place) : failure;
    } catch (const json::exception& e) {
        return Error(MessageCode::JsonSyntax, place, {plainWords(e.what())});
    } catch (const std::bad_alloc&) {
        return Error(MessageCode::FileUnreadable, place, {"not enough memory"});
    }
}

} // namespace bask
