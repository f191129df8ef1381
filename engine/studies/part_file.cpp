#include "engine/studies/part_file.h"

#include "engine/base/message_code.h"

#include <nlohmann/json.hpp>
#include <zlib.h>

#include <array>
#include <bit>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bask {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "parts are little-endian");

constexpr int kPartVersion = 1;
constexpr std::size_t kMaxHeader = 1 << 20;
constexpr std::uint32_t kMaxRecord = 1U << 30;
constexpr std::int64_t kMaxCases = 10'000'000;

/// In front of each record's bytes.
struct RecordHead {
    std::uint32_t check = 0; ///< CRC-32 of all that follows, the record's bytes with it
    std::uint32_t length = 0;
    std::int64_t index = 0;
    double took_s = 0.0;
};
static_assert(sizeof(RecordHead) == 24);

std::uint32_t checkOf(const RecordHead& head, std::string_view record) {
    RecordHead rest = head;
    std::array<unsigned char, sizeof rest> bytes;
    std::memcpy(bytes.data(), &rest, sizeof rest);
    const uLong first = crc32(0, bytes.data() + sizeof rest.check, sizeof rest - sizeof rest.check);
    return static_cast<std::uint32_t>(
        crc32_z(first, reinterpret_cast<const Bytef*>(record.data()), record.size()));
}

std::string headerLine(const PartHeader& header) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const Json json{{"bask_part", kPartVersion},
                    {"shard", header.shard.number},
                    {"of", header.shard.of},
                    {"cases", header.cases},
                    {"begun_ms", std::chrono::duration_cast<std::chrono::milliseconds>(now).count()},
                    {"work", Json::parse(header.work)}};
    return json.dump() + '\n';
}

/// The header without its line's end.
Result<void> readHeader(const std::string& line, ShardPart& part) {
    const Error foreign(MessageCode::NotAPart, part.path);
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("bask_part"))
        return foreign;
    try {
        if (const int version = json.at("bask_part"); version > kPartVersion)
            return Error(MessageCode::VersionTooNew, part.path,
                         {std::to_string(version), std::to_string(kPartVersion)});
        part.header = {json.at("work").dump(), json.at("cases"), {json.at("shard"), json.at("of")}};
        part.begun_ms = json.at("begun_ms");
    } catch (const Json::exception&) {
        return foreign;
    }
    const auto& [number, of] = part.header.shard;
    if (!json.at("work").is_object() || part.header.cases < 1 || part.header.cases > kMaxCases || of < 1 ||
        of > kMaxShards || number < 1 || number > of)
        return foreign;
    return {};
}

/// Reads records as long as they are whole.
void readRecords(std::istream& in, std::int64_t size, ShardPart& part) {
    std::string bytes;
    for (;;) {
        RecordHead head;
        const std::int64_t begin = part.wholeBytes + static_cast<std::int64_t>(sizeof head);
        if (begin > size || !in.read(reinterpret_cast<char*>(&head), sizeof head))
            return;
        const bool isPossible = head.length <= kMaxRecord && head.index >= 0 &&
                                head.index < part.header.cases && part.header.shard.has(head.index);
        if (isPossible && begin + head.length > size)
            return;
        bytes.resize(isPossible ? head.length : 0);
        if (isPossible && !in.read(bytes.data(), head.length))
            return;
        if (!isPossible || checkOf(head, bytes) != head.check) {
            part.isDamaged = true;
            return;
        }
        part.records.push_back({head.index, head.took_s, begin, head.length});
        part.wholeBytes = begin + head.length;
    }
}

bool isLocked(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    const bool locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(file);
    return locked;
}

std::string shown(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_null() ? "not given" : value.dump();
}

std::vector<std::int64_t> missingOf(const Shard& shard, std::int64_t cases,
                                    const std::vector<PartRecord>& records) {
    std::vector<bool> has(static_cast<std::size_t>(shard.share(cases)), false);
    for (const PartRecord& record : records)
        has[static_cast<std::size_t>(record.index / shard.of)] = true;
    std::vector<std::int64_t> missing;
    for (std::size_t k = 0; k < has.size(); ++k)
        if (!has[k])
            missing.push_back(static_cast<std::int64_t>(k) * shard.of + shard.number - 1);
    return missing;
}

/// Writes all bytes, or returns false with errno.
bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

} // namespace

Result<void> checkSameWork(const std::string& where, const std::string& there, const std::string& here) {
    const Json a = Json::parse(here), b = Json::parse(there);
    if (a == b)
        return {};
    Json keys = a;
    keys.update(b);
    for (const auto& [key, value] : keys.items()) {
        const Json& ofA = a.contains(key) ? a.at(key) : Json();
        const Json& ofB = b.contains(key) ? b.at(key) : Json();
        if (ofA != ofB)
            return Error(MessageCode::PartOfAnother, where, {key, shown(ofA), shown(ofB)});
    }
    return {};
}

Result<std::unique_ptr<PartWriter>> PartWriter::open(const std::string& path, const PartHeader& header,
                                                     bool resumes) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
        return Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
    std::unique_ptr<PartWriter> writer(new PartWriter(path, file));
    // Where a file system has no locks it goes without.
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return Error(MessageCode::PartBusy, path);
    struct stat info {};
    if (::fstat(file, &info) != 0)
        return writer->unwritable();
    if (!S_ISREG(info.st_mode))
        return Error(MessageCode::OutputNotAFile, path);
    if (info.st_size > 0 && !resumes)
        return Error(MessageCode::PartThere, path);
    auto done = info.st_size > 0 ? writer->goOn(header) : writer->begin(header);
    if (!done)
        return done.error();
    return writer;
}

PartWriter::~PartWriter() {
    ::close(m_file);
}

Error PartWriter::unwritable() const {
    return {MessageCode::FileUnwritable, m_path, {std::strerror(errno)}};
}

Result<void> PartWriter::begin(const PartHeader& header) {
    const std::string line = headerLine(header);
    if (!writeAll(m_file, line)) {
        const Error error = unwritable();
        (void)::ftruncate(m_file, 0);
        return error;
    }
    m_size = static_cast<std::int64_t>(line.size());
    m_missing = missingOf(header.shard, header.cases, {});
    return {};
}

Result<void> PartWriter::goOn(const PartHeader& header) {
    auto part = readPart(m_path);
    // A header that was cut off: nothing was computed.
    if (!part && part.error().code() == MessageCode::FileEmpty)
        return ::ftruncate(m_file, 0) == 0 ? begin(header) : Result<void>(unwritable());
    if (!part)
        return part.error();
    if (auto same = checkSameWork(m_path, part->header.work, header.work); !same)
        return same;
    const auto differs = [&](const char* what, std::int64_t here, std::int64_t there) {
        return Error(MessageCode::PartOfAnother, m_path, {what, std::to_string(here), std::to_string(there)});
    };
    if (part->header.cases != header.cases)
        return differs("cases", header.cases, part->header.cases);
    if (part->header.shard.of != header.shard.of)
        return differs("of", header.shard.of, part->header.shard.of);
    if (part->header.shard.number != header.shard.number)
        return differs("shard", header.shard.number, part->header.shard.number);
    m_size = part->wholeBytes;
    if (::ftruncate(m_file, m_size) != 0)
        return unwritable();
    if (::lseek(m_file, m_size, SEEK_SET) < 0)
        return unwritable();
    m_missing = missingOf(header.shard, header.cases, part->records);
    return {};
}

Result<void> PartWriter::add(std::int64_t index, std::string_view record, double took_s) {
    RecordHead head{0, static_cast<std::uint32_t>(record.size()), index, took_s};
    head.check = checkOf(head, record);
    std::string bytes(sizeof head + record.size(), '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, record.data(), record.size());
    if (!writeAll(m_file, bytes)) {
        const Error error = unwritable();
        (void)::ftruncate(m_file, m_size); // of a full disk; else it is cut off when it is read
        return error;
    }
    m_size += static_cast<std::int64_t>(bytes.size());
    return {};
}

Result<void> PartWriter::finish() {
    return ::fsync(m_file) == 0 || errno == EINVAL ? Result<void>() : unwritable();
}

Result<ShardPart> readPart(const std::string& path) {
    struct stat info {};
    std::ifstream in(path, std::ios::binary);
    if (!in || ::stat(path.c_str(), &info) != 0)
        return Error(MessageCode::FileUnreadable, path, {std::strerror(errno)});
    ShardPart part;
    part.path = path;
    part.changed_ms = info.st_mtim.tv_sec * 1000 + info.st_mtim.tv_nsec / 1'000'000;
    std::string line;
    for (char c = 0; line.size() < kMaxHeader && in.get(c) && c != '\n';)
        line += c;
    if (!in && (line.empty() || line.starts_with("{\"bask_part\"") ||
                std::string("{\"bask_part\"").starts_with(line)))
        return Error(MessageCode::FileEmpty, path);
    if (auto header = readHeader(line, part); !header)
        return header.error();
    part.wholeBytes = static_cast<std::int64_t>(line.size()) + 1;
    readRecords(in, info.st_size, part);
    part.isBeingWritten = isLocked(path);
    return part;
}

namespace {

/// "3, 7 to 9 and 5 more": shards of `of` that lack cases.
std::string shardsOf(const std::vector<std::int64_t>& missing, int of) {
    constexpr std::size_t kShown = 8;
    std::vector<bool> lacks(static_cast<std::size_t>(of), false);
    for (const std::int64_t index : missing)
        lacks[static_cast<std::size_t>(index % of)] = true;
    std::string text;
    std::size_t count = 0;
    for (std::size_t k = 0; k < lacks.size(); ++k)
        if (lacks[k] && ++count <= kShown)
            text += (text.empty() ? "" : ", ") + std::to_string(k + 1) + '/' + std::to_string(of);
    return count > kShown ? text + " and " + std::to_string(count - kShown) + " more" : text;
}

} // namespace

Result<MergedParts> MergedParts::of(const std::vector<std::string>& paths) {
    MergedParts merged;
    std::optional<PartHeader> first;
    for (const std::string& path : paths) {
        auto part = readPart(path);
        if (!part)
            return part.error();
        if (part->isDamaged)
            return Error(MessageCode::PartDamaged, path, {std::to_string(part->records.size())});
        if (!first) {
            first = part->header;
            merged.m_work = first->work;
            merged.m_places.resize(static_cast<std::size_t>(first->cases));
        }
        if (auto same = checkSameWork(path, part->header.work, first->work); !same)
            return same.error();
        if (part->header.cases != first->cases)
            return Error(MessageCode::PartOfAnother, path,
                         {"cases", std::to_string(first->cases), std::to_string(part->header.cases)});
        for (const PartRecord& record : part->records)
            merged.m_places[static_cast<std::size_t>(record.index)] = {
                static_cast<std::int32_t>(merged.m_paths.size()), record.length, record.offset};
        merged.m_paths.push_back(path);
    }
    std::vector<std::int64_t> missing;
    for (std::size_t k = 0; k < merged.m_places.size(); ++k)
        if (merged.m_places[k].part < 0)
            missing.push_back(static_cast<std::int64_t>(k));
    if (!missing.empty())
        return Error(MessageCode::PartsMissing, "",
                     {std::to_string(missing.size()), std::to_string(merged.m_places.size()),
                      shardsOf(missing, first->shard.of)});
    return merged;
}

Result<std::string> MergedParts::record(std::int64_t index) const {
    const Place& place = m_places.at(static_cast<std::size_t>(index));
    const std::string& path = m_paths[static_cast<std::size_t>(place.part)];
    std::ifstream in(path, std::ios::binary);
    std::string bytes(place.length, '\0');
    if (!in.seekg(place.offset) || !in.read(bytes.data(), place.length))
        return Error(MessageCode::FileUnreadable, path, {std::strerror(errno)});
    return bytes;
}

} // namespace bask
