#pragma once
// One SQLite connection to a session file with plain values: opening for writing or reading, statements,
// rows.

#include "engine/base/result.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

namespace bask {

/// Unchanged bytes.
struct SqlBlob {
    std::string bytes;
};
/// NULL, number, whole number, text or bytes.
using SqlValue = std::variant<std::monostate, double, std::int64_t, std::string, SqlBlob>;

/// Returns a number as stored: NaN becomes NULL.
SqlValue sqlNumber(double value);
/// Returns the number of a column: NULL becomes NaN.
double numberOf(const SqlValue& value);
/// Returns a text as the database keeps it: without byte-order marks in front, U+FFFD for what is no
/// character.
std::string storedText(const std::string& text);
/// Returns the text of a column; empty if it is not text.
std::string textOf(const SqlValue& value);

/// What a file says that the database cannot read, as the argument of SessionDamaged.
inline constexpr const char* kNotWhole = "its database is not whole";
inline constexpr const char* kNoHeader = "the header of its database was written over";
inline constexpr const char* kNoVersion = "it has a format number that no version has";

/// Returns a text as an SQL literal.
std::string sqlText(const std::string& text);

/// Use it only on the thread that opened it.
class SessionStore {
public:
    /// Opens a new or empty file for writing.
    static Result<std::unique_ptr<SessionStore>> create(const std::string& path);
    /// Opens an existing session only for reading, even one that is being written, one left by a killed
    /// process, or one in a read-only folder. Refuses a file that is not a session, is cut short, is newer
    /// than this program, or computes something when it is read.
    static Result<std::unique_ptr<SessionStore>> open(const std::string& path);
    /// The same for a file that is damaged, to look for what of it can still be read: also one that is cut
    /// short.
    static Result<std::unique_ptr<SessionStore>> openDamaged(const std::string& path);
    /// The same for a file that may have been altered: of any version, with any tables, and without the mark
    /// of a session in its header. Select only from tables that are plain: others compute.
    static Result<std::unique_ptr<SessionStore>> openAltered(const std::string& path);
    /// Whether this statement makes a table that computes nothing when it is read.
    static bool isPlainTable(const std::string& sql);
    ~SessionStore();

    Result<void> execute(const std::string& sql);
    /// Prepares a statement once; returns its number for run().
    Result<std::size_t> prepare(const std::string& sql);
    Result<void> run(std::size_t statement, std::span<const SqlValue> values);

    using Row = std::span<const SqlValue>;
    /// Calls `row` for each row of a query, until `stop` is requested.
    Result<void> select(const std::string& sql, const std::function<void(Row)>& row,
                        const std::stop_token& stop = {}) const;
    Result<bool> hasTable(const std::string& name) const;
    /// Returns the column names of a table.
    Result<std::vector<std::string>> columns(const std::string& table) const;
    const std::string& path() const;
    /// Returns the version of the file.
    int version() const;
    /// Returns whether its header says that it is a session.
    bool isMarked() const;
    /// Returns the names of the tables and views that are for people and scripts, in the order of creation.
    Result<std::vector<std::string>> tables() const;

    SessionStore(const SessionStore&) = delete;
    SessionStore& operator=(const SessionStore&) = delete;

private:
    struct Impl;
    explicit SessionStore(std::unique_ptr<Impl> impl);
    enum class Looks { All, Damaged, Altered };
    static Result<std::unique_ptr<SessionStore>> open(const std::string& path, Looks looks);
    std::unique_ptr<Impl> m_impl;
};

/// Checks that a session may replace what is at `path`: nothing, an empty file or an older session. Refuses
/// anything else, and a folder that does not exist.
Result<void> checkReplaceable(const std::string& path);

/// Merges the log of the session at `path` into it and removes the log; refuses while a run is being
/// recorded.
Result<void> removeLog(const std::string& path);

} // namespace bask
