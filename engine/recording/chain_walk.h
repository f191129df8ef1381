#pragma once
// The hash chain of a session held against its rows, link by link: which rows it knows, and which of its
// links are not as they were written themselves.

#include "engine/recording/row_chain.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What a row of the schema or of meta is called: {"view", "sample"}, {"key", "outcome"}.
struct RowName {
    std::string type, name;
    bool operator==(const RowName&) const = default;
};

/// The rows of a table as they are in the file.
struct FileRows {
    std::vector<Digest> digests;
    std::vector<double> times_s;       ///< NaN: none
    std::vector<std::int64_t> numbers; ///< of samples, which have their own; ascending
    std::vector<RowName> names;        ///< of the schema's and of meta
    bool isThere = false;              ///< the table
};
using FileTables = std::array<FileRows, kChainTables>;

/// Returns the place of a sample in its table; empty if there is none of this number.
std::optional<std::size_t> placeOfSample(const FileRows& samples, std::int64_t number);

/// A link as it is in the file.
struct FileLink {
    std::int64_t number = 0;
    std::optional<ChainLink> link; ///< empty: it is none
};

/// A row that the chain knows of.
struct ChainedRow {
    std::uint32_t check = 0;
    std::uint32_t link = 0; ///< index
    bool isAny = false;     ///< of a link that is lost: whatever row there is
};

/// Links that are not as they were written.
struct LinkFault {
    std::int64_t first = 0, last = 0; ///< their numbers
    bool isLost = false;              ///< they are not there
    std::optional<double> time_s{};   ///< of a row of theirs, else of one before
};

struct WalkedChain {
    std::array<std::vector<ChainedRow>, kChainTables> rows;
    std::vector<double> times_s; ///< of each link: of its last row that is there, else of the link before
    std::vector<LinkFault> faults;
    bool hasLost = false;     ///< rows of the schema and of meta that it does not know may be of a lost link
    bool isComparable = true; ///< false: too much of it is lost to say anything about rows
};

/// Holds the links, in the order of their numbers, against the rows. Where a hash only holds with the rows
/// of the file and not with the checks beside it, the chain was altered, and the rows are believed.
/// `isClosed`: the recording says how it ended.
WalkedChain walkChain(const std::vector<FileLink>& links, const FileTables& tables, bool isClosed);

} // namespace bask
