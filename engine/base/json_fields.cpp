#include "engine/base/json_fields.h"

#include "engine/base/plain_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace bask {

using nlohmann::json;

const char* typeName(const json& j) {
    switch (j.type()) {
    case json::value_t::null:
        return "null";
    case json::value_t::object:
        return "an object";
    case json::value_t::array:
        return "an array";
    case json::value_t::string:
        return "text";
    case json::value_t::boolean:
        return "true or false";
    case json::value_t::number_float:
        return "a number";
    default:
        return "a whole number";
    }
}

Fields::Fields(const json& j, std::string path, Failure& failure)
    : m_path(std::move(path)), m_failure(failure) {
    if (j.is_object())
        m_json = &j;
    else
        fail(MessageCode::JsonWrongType, m_path, {"an object", typeName(j)});
}

const json* Fields::find(const std::string& key, bool required) {
    m_asked.insert(key);
    if (m_json != nullptr) {
        if (const auto it = m_json->find(key); it != m_json->end())
            return &*it;
    }
    if (required && m_missing.empty())
        m_missing = key;
    return nullptr;
}

void Fields::read(const std::string& key, double& out, bool required) {
    if (const json* j = find(key, required))
        number(*j, key, out);
}

void Fields::read(const std::string& key, int& out, bool required) {
    const json* j = find(key, required);
    if (j == nullptr)
        return;
    constexpr int kMax = std::numeric_limits<int>::max();
    if (!j->is_number_integer())
        return fail(MessageCode::JsonWrongType, pathOf(key), {"a whole number", typeName(*j)});
    const auto value = j->get<double>();
    if (std::abs(value) > kMax)
        return fail(MessageCode::ValueOutOfRange, pathOf(key), {j->dump(), "0", std::to_string(kMax), ""});
    out = static_cast<int>(value);
}

void Fields::read(const std::string& key, std::uint64_t& out) {
    const json* j = find(key);
    if (j == nullptr)
        return;
    if (j->is_number_integer() && !j->is_number_unsigned())
        return fail(MessageCode::ValueOutOfRange, pathOf(key), {j->dump(), "0", "18446744073709551615", ""});
    if (!j->is_number_unsigned())
        return fail(MessageCode::JsonWrongType, pathOf(key), {"a whole number", typeName(*j)});
    out = j->get<std::uint64_t>();
}

void Fields::read(const std::string& key, bool& out) {
    const json* j = find(key);
    if (j == nullptr)
        return;
    if (!j->is_boolean())
        return fail(MessageCode::JsonWrongType, pathOf(key), {"true or false", typeName(*j)});
    out = j->get<bool>();
}

void Fields::read(const std::string& key, std::string& out, bool required) {
    const json* j = find(key, required);
    if (j == nullptr)
        return;
    if (!j->is_string())
        return fail(MessageCode::JsonWrongType, pathOf(key), {"text", typeName(*j)});
    out = j->get<std::string>();
}

void Fields::readName(const std::string& key, std::string& out, bool required) {
    read(key, out, required);
    if (!isOneLine(out) || hasInvisible(out))
        fail(MessageCode::NameNotPlain, pathOf(key));
}

void Fields::readTitle(const std::string& key, std::string& out) {
    read(key, out);
    if (printable(out) != out)
        fail(MessageCode::NameNotPlain, pathOf(key));
}

void Fields::read(const std::string& key, std::vector<double>& out) {
    const json* j = find(key);
    if (j == nullptr)
        return;
    if (!j->is_array())
        return fail(MessageCode::JsonWrongType, pathOf(key), {"an array", typeName(*j)});
    out.clear();
    for (std::size_t i = 0; i < j->size(); ++i)
        number((*j)[i], key + '[' + std::to_string(i) + ']', out.emplace_back());
}

void Fields::read(const std::string& name, EdgeUnit unit, double& out, bool required) {
    const std::string readable = readableKey(name, unit);
    const std::string si = siKey(name, unit);
    const json* inSi = find(si);
    const json* inReadable = find(readable, required && inSi == nullptr);
    if (inReadable != nullptr && inSi != nullptr)
        return fail(MessageCode::JsonTwoSpellings, m_path, {readable, si});
    double value = 0.0;
    if (inSi != nullptr)
        number(*inSi, si, out);
    else if (inReadable != nullptr && number(*inReadable, readable, value))
        out = toSi(value, unit);
}

void Fields::close(Unknown keys) {
    if (m_json == nullptr || m_failure)
        return;
    for (const auto& item : m_json->items()) {
        if (keys == Unknown::Ignored || m_asked.contains(item.key()))
            continue;
        std::map<std::string, int> known;
        for (const std::string& key : m_asked)
            known[key] = 0;
        return fail(MessageCode::JsonUnknownKey, m_path, {plainWords(item.key()), joined(known)});
    }
    if (!m_missing.empty())
        fail(MessageCode::JsonMissingKey, m_path, {m_missing});
}

bool Fields::number(const json& j, const std::string& key, double& out) {
    if (!j.is_number()) {
        fail(MessageCode::JsonWrongType, pathOf(key), {"a number", typeName(j)});
        return false;
    }
    out = j.get<double>();
    return true;
}

void readEach(Fields& parent, const std::string& key, bool required,
              const std::function<void(const json&, const std::string&)>& read) {
    const json* j = parent.find(key, required);
    if (j == nullptr || parent.failure())
        return;
    const std::string path = parent.pathOf(key);
    if (!j->is_array())
        return parent.fail(MessageCode::JsonWrongType, path, {"an array", typeName(*j)});
    for (std::size_t i = 0; i < j->size() && !parent.failure(); ++i)
        read((*j)[i], path + '[' + std::to_string(i) + ']');
}

void readHeader(Fields& root, const std::string& format, int version) {
    std::string given;
    int number = 0;
    root.read("format", given, true);
    root.read("version", number, true);
    if (!given.empty() && given != format)
        root.fail(MessageCode::ValueUnknown, "format", {plainWords(given), format});
    else if (number > version)
        root.fail(MessageCode::VersionTooNew, "version", {std::to_string(number), std::to_string(version)});
    else if (root.find("version") != nullptr && number < 1)
        root.fail(MessageCode::ValueOutOfRange, "version",
                  {std::to_string(number), "1", std::to_string(version), ""});
}

void readCoordinateFields(Fields& fields, Vector6d& out) {
    for (int k = 0; k < 6; ++k)
        fields.read(kCoordinateNames[static_cast<std::size_t>(k)], coordinateUnit(k), out[k]);
}

void readCoordinates(const json& j, const std::string& path, Failure& failure, Vector6d& out) {
    Fields fields(j, path, failure);
    readCoordinateFields(fields, out);
    fields.close();
}

} // namespace bask
