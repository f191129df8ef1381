#pragma once
// Reads one JSON object: typed access by key, stores the first failure, refuses unknown keys.

#include "engine/base/edge_units.h"
#include "engine/base/json_text.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/pose.h"
#include "engine/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace bask {

const char* typeName(const nlohmann::json& j); ///< Returns the kind of a value in words: "a number".

/// Fields of an object.
class Fields {
public:
    Fields(const nlohmann::json& j, std::string path, Failure& failure);

    std::string pathOf(const std::string& key) const { return m_path.empty() ? key : m_path + '.' + key; }
    Failure& failure() const { return m_failure; }

    /// Returns the value of a key; null if it is missing, which is a failure if it is required.
    const nlohmann::json* find(const std::string& key, bool required = false);

    void read(const std::string& key, double& out, bool required = false);
    void read(const std::string& key, int& out, bool required = false);
    void read(const std::string& key, std::uint64_t& out);
    void read(const std::string& key, bool& out);
    void read(const std::string& key, std::string& out, bool required = false);
    /// Reads a name: one line without characters that nobody sees (NameNotPlain).
    void readName(const std::string& key, std::string& out, bool required = false);
    /// Reads a title: words without control characters (NameNotPlain).
    void readTitle(const std::string& key, std::string& out);
    /// Reads an array of numbers.
    void read(const std::string& key, std::vector<double>& out);
    /// Reads a quantity in either of its two spellings and converts it to SI.
    void read(const std::string& name, EdgeUnit unit, double& out, bool required = false);

    /// Reads a word of a table; `table` maps words to values.
    template <class T>
    void readWord(const std::string& key, const std::map<std::string, T>& table, T& out,
                  bool required = false) {
        std::string word;
        read(key, word, required);
        if (find(key) == nullptr || m_failure)
            return;
        if (const auto it = table.find(word); it != table.end())
            out = it->second;
        else
            fail(MessageCode::ValueUnknown, pathOf(key), {plainWords(word), joined(table)});
    }

    enum class Unknown { Refused, Ignored };
    /// Ends the reading of this object. Unknown keys are reported first, because a misspelt key is also a
    /// missing one.
    void close(Unknown keys = Unknown::Refused);

    void fail(MessageCode code, const std::string& path, std::vector<MessageArg> args = {}) const {
        if (!m_failure)
            m_failure = Error(code, path, std::move(args));
    }

    template <class T> static std::string joined(const std::map<std::string, T>& table) {
        std::string out;
        for (const auto& [word, unused] : table)
            out += (out.empty() ? "" : ", ") + word;
        return out;
    }

private:
    bool number(const nlohmann::json& j, const std::string& key, double& out);

    const nlohmann::json* m_json = nullptr;
    std::string m_path;
    Failure& m_failure;
    std::set<std::string> m_asked;
    std::string m_missing;
};

/// Calls read(json, path) with the object under `key`, if it exists.
template <class Read> void readPart(Fields& parent, const std::string& key, bool required, Read read) {
    if (const nlohmann::json* j = parent.find(key, required); j != nullptr && !parent.failure())
        read(*j, parent.pathOf(key));
}

/// Calls read(json, path) with each entry of the array under `key`, if there is one.
void readEach(Fields& parent, const std::string& key, bool required,
              const std::function<void(const nlohmann::json&, const std::string&)>& read);

/// Reads what a file says that it is. Comes first: a file of a newer version is refused as that, whatever
/// else is in it.
void readHeader(Fields& root, const std::string& format, int version);

/// Reads the six pose coordinates; missing ones are unchanged.
void readCoordinateFields(Fields& fields, Vector6d& out);
void readCoordinates(const nlohmann::json& j, const std::string& path, Failure& failure, Vector6d& out);

} // namespace bask
