#pragma once
// A study or field that several processes share: the options of one of them, and its run.

#include "engine/base/message_code.h"
#include "engine/base/result.h"
#include "engine/studies/part_file.h"

#include <QCommandLineParser>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bask {

struct ShardOptions {
    std::optional<Shard> shard; ///< empty: one process does everything
    bool resumes = false;
    int threads = 0; ///< 0: one for each core
};

/// --shard, --resume, --threads and --processor.
void addShardOptions(QCommandLineParser& parser);
/// Reads them, and selects the kind of processor. Errors are of the command line.
Result<ShardOptions> readShardOptions(const QCommandLineParser& parser);

/// Work of independent cases: a case gives the same bytes in whatever process.
struct DividedWork {
    /// JSON object of what was asked for, as PartHeader::work; version and processor are added by fullWork().
    std::string asked;
    std::int64_t cases = 0;
    std::string caseWord;                                           ///< what a case is, in the plural: "runs"
    std::function<Result<std::string>(std::int64_t index)> compute; ///< thread-safe
};

/// Returns the program's version and build, as parts have it.
std::string ownSoftware();
/// Returns what was asked for with the program's version and the kind of processor.
std::string fullWork(const std::string& asked);

/// Returns the part's path: "STEM.003-of-064.part".
std::string partPath(const std::string& stem, const Shard& shard);

/// Computes what the shard's part does not have yet; returns an exit code.
int runShard(const char* command, const std::string& stem, const DividedWork& work,
             const ShardOptions& options);

/// Returns the rows of all `count` cases; `decode` returns an optional, empty for bytes that are no row.
template <class Row, class Decode>
Result<std::vector<Row>> mergedRows(const MergedParts& parts, std::int64_t count, Decode decode) {
    if (parts.cases() != count)
        return Error(MessageCode::NotAPart, "the parts");
    std::vector<Row> rows;
    for (std::int64_t index = 0; index < parts.cases(); ++index) {
        const auto bytes = parts.record(index);
        if (!bytes)
            return bytes.error();
        auto row = decode(*bytes);
        if (!row)
            return Error(MessageCode::NotAPart, "case " + std::to_string(index + 1));
        rows.push_back(std::move(*row));
    }
    return rows;
}

} // namespace bask
