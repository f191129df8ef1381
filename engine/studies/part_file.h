#pragma once
// A shard's results on disk. A study or field is divided into cases, and a shard of several processes
// computes every n-th of them into a part: a file that only grows, one record a case. A process may be killed
// at any moment; what is not whole is computed anew, and never counted.

#include "engine/base/result.h"
#include "engine/base/share_done.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bask {

/// One of several processes that share the cases of a study.
struct Shard {
    int number = 1; ///< 1 to `of`
    int of = 1;

    bool has(std::int64_t index) const { return index % of == number - 1; }
    /// Returns how many of the cases 0 to `cases` - 1 it has.
    std::int64_t share(std::int64_t cases) const { return (cases - number + of) / of; }
    bool operator==(const Shard&) const = default;
};
inline constexpr int kMaxShards = 100'000;

/// The first line of a part, as JSON.
struct PartHeader {
    /// What all parts of one work have in common, as a JSON object: the study with its options, the program's
    /// version, the kind of processor.
    std::string work;
    std::int64_t cases = 0; ///< of the whole work
    Shard shard;
    int threads = 1; ///< of the process that began it
};

/// Writes a part. Nobody else can while it lives. Not thread-safe.
class PartWriter {
public:
    /// Begins a part, or goes on with it if it `resumes`: a record that is not whole is cut off. Errors:
    /// PartThere, PartBusy, PartOfAnother, NotAPart, FileUnwritable.
    static Result<std::unique_ptr<PartWriter>> open(const std::string& path, const PartHeader& header,
                                                    bool resumes);
    ~PartWriter();
    PartWriter(const PartWriter&) = delete;
    PartWriter& operator=(const PartWriter&) = delete;

    /// Returns the shard's cases that have no record yet, ascending.
    const std::vector<std::int64_t>& missing() const { return m_missing; }
    /// Adds a case's record, wholly or not at all. `took_s` of computing time.
    Result<void> add(std::int64_t index, std::string_view record, double took_s);
    /// Waits until everything is on the disk.
    Result<void> finish();

private:
    PartWriter(std::string path, int file) : m_path(std::move(path)), m_file(file) {}
    Result<void> begin(const PartHeader& header);
    Result<void> goOn(const PartHeader& header);
    Error unwritable() const;

    std::string m_path;
    int m_file;
    std::int64_t m_size = 0;   ///< bytes of whole records
    std::uint32_t m_check = 0; ///< of the header's line
    std::vector<std::int64_t> m_missing;
};

/// Where a record is in its part.
struct PartRecord {
    std::int64_t index = 0; ///< of the case
    double took_s = 0.0;
    std::int64_t offset = 0; ///< of its bytes in the file
    std::uint32_t length = 0;
    std::uint32_t bytesCheck = 0; ///< CRC-32 of the header's line and of these bytes
};

/// A part that was read: its header, and what records it has.
struct ShardPart {
    std::string path;
    PartHeader header;
    std::vector<PartRecord> records; ///< whole ones, in the order of the file
    /// A record that has all its bytes, but not those that were written. (A last one that is cut off is no
    /// damage: its process was killed.)
    bool isDamaged = false;
    std::int64_t wholeBytes = 0; ///< from the beginning
    std::uint32_t check = 0;     ///< of the header's line
    std::int64_t changed_ms = 0; ///< since 1970: when the file was changed last
    bool isBeingWritten = false; ///< by a process whose lock the file system shows
};

/// Reads a part. `checksBytes`: every byte of it; else the records' heads, which have a check of their own,
/// as for a look at how far it is. Errors: NotAPart, FileUnreadable, FileEmpty for one that was ended before
/// its header was whole. `done` is told of the share of its bytes.
Result<ShardPart> readPart(const std::string& path, bool checksBytes, const ShareDone& done = {});

/// The results of all cases of a work, from its parts.
class MergedParts {
public:
    /// `done` is told of the share of bytes that were read. A case may be in several parts, with the same
    /// bytes. Errors: those of readPart, PartOfAnother, PartDamaged, PartsDisagree, PartsMissing.
    static Result<MergedParts> of(const std::vector<std::string>& paths, const ShareDone& done = {});

    const std::string& work() const { return m_work; }
    std::int64_t cases() const { return static_cast<std::int64_t>(m_places.size()); }
    /// Returns the bytes of a case. Errors: FileUnreadable, PartDamaged.
    Result<std::string> record(std::int64_t index) const;

private:
    struct Place {
        std::int32_t part = -1;
        std::uint32_t length = 0, bytesCheck = 0;
        std::int64_t offset = 0;
    };

    Result<void> add(const ShardPart& part);

    std::string m_work;
    std::vector<std::pair<std::string, std::uint32_t>> m_parts; ///< path, and check of the header's line
    std::vector<Place> m_places;                                ///< by case
};

/// Success if two parts are of the same work, divided alike; else an error that names the first difference.
Result<void> checkSameParts(const std::string& where, const PartHeader& there, const PartHeader& here);

} // namespace bask
