#pragma once
// One SQLite connection to a session file, in plain values: opening for writing or reading, statements, rows.

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

/// Bytes as they are.
struct SqlBlob {
    std::string bytes;
};
/// NULL, number, whole number, text or bytes.
using SqlValue = std::variant<std::monostate, double, std::int64_t, std::string, SqlBlob>;

/// A number as stored: NaN is NULL.
SqlValue sqlNumber(double value);
/// The number of a column: NULL is NaN.
double numberOf(const SqlValue& value);
/// The text of a column; empty when it is not text.
std::string textOf(const SqlValue& value);

/// A text as SQL writes it.
std::string sqlText(const std::string& text);

/// Belongs to the thread that opened it.
class SessionStore {
public:
    /// Opens a file that is new or empty, for writing.
    static Result<std::unique_ptr<SessionStore>> create(const std::string& path);
    /// Opens an existing session for reading only: one that is being written, one left by a killed process,
    /// one in a folder that cannot be written. Refuses what is no session, is cut short, is newer than this
    /// program, or computes something when it is read.
    static Result<std::unique_ptr<SessionStore>> open(const std::string& path);
    ~SessionStore();

    Result<void> execute(const std::string& sql);
    /// Prepares a statement once; the number is for run().
    Result<std::size_t> prepare(const std::string& sql);
    Result<void> run(std::size_t statement, std::span<const SqlValue> values);

    using Row = std::span<const SqlValue>;
    /// Calls `row` for each row of a query, until it is asked to stop.
    Result<void> select(const std::string& sql, const std::function<void(Row)>& row,
                        const std::stop_token& stop = {}) const;
    /// Names of the columns of a table.
    Result<std::vector<std::string>> columns(const std::string& table) const;
    /// The file's own version.
    int version() const;
    /// Names of the tables and views that are for people and scripts, in the order in which they were made.
    Result<std::vector<std::string>> tables() const;

    SessionStore(const SessionStore&) = delete;
    SessionStore& operator=(const SessionStore&) = delete;

private:
    struct Impl;
    explicit SessionStore(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// May a session take the place of what is at `path`: nothing, an empty file or an older session. Refuses
/// anything else, and a folder that is not there.
Result<void> checkReplaceable(const std::string& path);

/// Folds the log of the session at `path` into it and removes it; refuses while a run is being recorded into
/// it.
Result<void> removeLog(const std::string& path);

} // namespace bask
