#pragma once
// The hash chain of a session: a SHA-256 over each row that was recorded, chained in their order, so that a
// change of any of them is found, and named, later.

#include "engine/recording/session_store.h"
#include "engine/recording/sha256.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Tables whose rows are chained; the numbers are in files and stay. Schema: what makes the tables and views.
enum class ChainTable : unsigned char {
    Schema = 1,
    Meta,
    Experiment,
    Object,
    Step,
    TargetStep,
    Overview,
    Command,
    Event,
    Note,
    ThermalFrame,
    Traffic,
    Prediction
};
inline constexpr int kChainTables = static_cast<int>(ChainTable::Prediction) + 1;
/// All of them, by their numbers.
inline constexpr auto kChainedTables = [] {
    std::array<ChainTable, kChainTables - 1> all{};
    for (int k = 1; k < kChainTables; ++k)
        all[static_cast<std::size_t>(k - 1)] = static_cast<ChainTable>(k);
    return all;
}();

constexpr std::size_t tableIndex(ChainTable table) {
    return static_cast<std::size_t>(table);
}
/// Whether the number is that of a table: one in a file may be any.
bool isKnown(ChainTable table);
/// Whether the rows are chained in no order that the file keeps.
constexpr bool isUnordered(ChainTable table) {
    return table == ChainTable::Schema || table == ChainTable::Meta;
}

/// The name in the file; sqlite_master for the schema.
const char* tableName(ChainTable table);
/// Returns the statement that reads the rows of a table as they are hashed, in the order of their making;
/// those of the schema and of meta by name. Tags are left out: they are a label, which may be changed at any
/// time.
std::string selectRows(ChainTable table);

/// SHA-256 of a row. What the database stores alike has the same hash: a whole number and its double, -0 and
/// 0, an unknown number, an empty text or no bytes and NULL.
Digest digestOf(ChainTable table, std::span<const SqlValue> row);

/// A row of the table `chain`: the rows that were committed together.
struct ChainLink {
    struct Entry {
        ChainTable table = ChainTable::Step;
        std::uint32_t check = 0; ///< first bytes of the row's digest: tells which row was changed
    };
    std::int64_t number = 0; ///< from 1
    std::vector<Entry> rows;
    Digest hash{}; ///< of the link before, and of the digests of the rows
};

std::uint32_t checkOf(const Digest& digest);
Digest chained(const Digest& before, std::span<const Digest> digests);
std::array<SqlValue, 3> rowOf(const ChainLink& link);
/// Empty if the row is none. Its tables may be unknown ones.
std::optional<ChainLink> linkOf(std::span<const SqlValue> row);

/// Returns the last link of a file; empty if it has no chain, or one that is damaged.
Result<std::optional<ChainLink>> lastLink(const SessionStore& store);

std::string hexOf(const Digest& digest);

inline constexpr const char* kCreateChain =
    "CREATE TABLE chain(number INTEGER PRIMARY KEY, row_checks BLOB NOT NULL, hash BLOB NOT NULL)";
inline constexpr const char* kInsertLink = "INSERT INTO chain VALUES(?, ?, ?)";
inline constexpr const char* kSelectLinks = "SELECT number, row_checks, hash FROM chain ORDER BY number";

/// The chain while it grows.
class RowChain {
public:
    RowChain() = default;
    /// Goes on after a link of a file.
    RowChain(std::int64_t number, const Digest& hash) : m_number(number), m_hash(hash) {}

    void add(ChainTable table, std::span<const SqlValue> row);
    bool hasRows() const { return !m_rows.empty(); }
    /// Ends the link of the rows that were added since the last one.
    ChainLink takeLink();

private:
    std::int64_t m_number = 0;
    Digest m_hash{};
    std::vector<ChainLink::Entry> m_rows;
    std::vector<Digest> m_digests;
};

} // namespace bask
