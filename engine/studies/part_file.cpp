#include "engine/studies/part_file.h"

#include "engine/base/json_text.h"
#include "engine/base/message_code.h"

#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <optional>

#include <fcntl.h>
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

/// In front of each record's bytes. Both checks go on from that of the header's line, so that a record
/// belongs to it.
struct RecordHead {
    std::uint32_t length = 0;
    std::uint32_t bytesCheck = 0; ///< CRC-32 of the record's bytes
    std::int64_t index = 0;
    double took_s = 0.0;
    std::uint32_t unused = 0;
    std::uint32_t headCheck = 0; ///< CRC-32 of what is above
};
static_assert(sizeof(RecordHead) == 32);

std::uint32_t checkOf(std::uint32_t before, std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint32_t headCheckOf(std::uint32_t line, const RecordHead& head) {
    return checkOf(line, {reinterpret_cast<const char*>(&head), offsetof(RecordHead, headCheck)});
}

std::string headerLine(const PartHeader& header) {
    const Json json{{"bask_part", kPartVersion}, {"shard", header.shard.number},
                    {"of", header.shard.of},     {"cases", header.cases},
                    {"threads", header.threads}, {"work", Json::parse(header.work)}};
    return json.dump() + '\n';
}

/// The header without its line's end.
Result<void> readHeader(const std::string& line, ShardPart& part) {
    const Error foreign(MessageCode::NotAPart, part.path);
    std::int64_t version = 0, shard = 0, of = 0, threads = 0;
    const Failure failed = readJsonTree(line, part.path, [&](const Json& json, Failure&) {
        const auto whole = [&](const char* key) {
            const Json& value = json.at(key);
            return value.is_number_integer() ? value.get<std::int64_t>() : -1;
        };
        version = whole("bask_part");
        shard = whole("shard");
        of = whole("of");
        threads = whole("threads");
        part.header.cases = json.at("work").is_object() ? whole("cases") : -1;
        part.header.work = json.at("work").dump();
    });
    if (version > kPartVersion)
        return Error(MessageCode::VersionTooNew, part.path,
                     {std::to_string(version), std::to_string(kPartVersion)});
    if (failed || version < 1 || part.header.cases < 1 || part.header.cases > kMaxCases || of < 1 ||
        of > kMaxShards || shard < 1 || shard > of || threads < 1 || threads > kMaxShards)
        return foreign;
    part.header.shard = {static_cast<int>(shard), static_cast<int>(of)};
    part.header.threads = static_cast<int>(threads);
    return {};
}

/// Reads records as long as they are whole; their bytes too, if they are to be checked.
void readRecords(std::istream& in, std::int64_t size, bool checksBytes, const ShareDone& done,
                 ShardPart& part) {
    std::string bytes;
    ShareCount count(done, static_cast<double>(size));
    count.add(static_cast<double>(part.wholeBytes));
    for (;;) {
        RecordHead head;
        const std::int64_t begin = part.wholeBytes + static_cast<std::int64_t>(sizeof head);
        if (begin > size || !in.read(reinterpret_cast<char*>(&head), sizeof head))
            return;
        part.isDamaged = headCheckOf(part.check, head) != head.headCheck || head.length > kMaxRecord ||
                         head.index < 0 || head.index >= part.header.cases ||
                         !part.header.shard.has(head.index);
        if (part.isDamaged || begin + head.length > size)
            return; // the last one was cut off by a kill
        if (checksBytes) {
            bytes.resize(head.length);
            if (!in.read(bytes.data(), head.length))
                return;
            part.isDamaged = checkOf(part.check, bytes) != head.bytesCheck;
        } else {
            in.seekg(head.length, std::ios::cur);
        }
        if (part.isDamaged)
            return;
        part.records.push_back({head.index, head.took_s, begin, head.length, head.bytesCheck});
        part.wholeBytes = begin + head.length;
        count.add(static_cast<double>(sizeof head) + head.length);
    }
}

/// Locks of open file descriptions: they are of a process's own descriptor, and file systems over a network
/// have them.
bool lockPart(int file) {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return ::fcntl(file, F_OFD_SETLK, &lock) == 0 ||
           (errno != EAGAIN && errno != EACCES); // some have no locks
}

/// Asks without taking it.
bool isLocked(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    struct flock lock {};
    lock.l_type = F_RDLCK;
    lock.l_whence = SEEK_SET;
    const bool locked = ::fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
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
bool writeAll(int file, std::string_view bytes, std::int64_t offset) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
        offset += written;
    }
    return true;
}

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

} // namespace

Result<void> checkSameParts(const std::string& where, const PartHeader& there, const PartHeader& here) {
    auto same = checkSameWork(where, there.work, here.work);
    const auto differs = [&](const char* what, std::int64_t ofHere, std::int64_t ofThere) {
        return Error(MessageCode::PartOfAnother, where,
                     {what, std::to_string(ofHere), std::to_string(ofThere)});
    };
    if (same && there.cases != here.cases)
        return differs("cases", here.cases, there.cases);
    if (same && there.shard.of != here.shard.of)
        return differs("of", here.shard.of, there.shard.of);
    return same;
}

Result<std::unique_ptr<PartWriter>> PartWriter::open(const std::string& path, const PartHeader& header,
                                                     bool resumes) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
        return Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
    std::unique_ptr<PartWriter> writer(new PartWriter(path, file));
    if (!lockPart(file))
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
    m_check = checkOf(0, line);
    if (!writeAll(m_file, line, 0)) {
        const Error error = unwritable();
        (void)::ftruncate(m_file, 0);
        return error;
    }
    m_size = static_cast<std::int64_t>(line.size());
    m_missing = missingOf(header.shard, header.cases, {});
    return {};
}

Result<void> PartWriter::goOn(const PartHeader& header) {
    auto part = readPart(m_path, true);
    // A header that was cut off: nothing was computed.
    if (!part && part.error().code() == MessageCode::FileEmpty)
        return ::ftruncate(m_file, 0) == 0 ? begin(header) : Result<void>(unwritable());
    if (!part)
        return part.error();
    if (auto same = checkSameParts(m_path, part->header, header); !same)
        return same;
    if (part->header.shard.number != header.shard.number)
        return Error(
            MessageCode::PartOfAnother, m_path,
            {"shard", std::to_string(header.shard.number), std::to_string(part->header.shard.number)});
    m_size = part->wholeBytes;
    m_check = part->check;
    if (::ftruncate(m_file, m_size) != 0)
        return unwritable();
    m_missing = missingOf(header.shard, header.cases, part->records);
    return {};
}

Result<void> PartWriter::add(std::int64_t index, std::string_view record, double took_s) {
    RecordHead head{static_cast<std::uint32_t>(record.size()), checkOf(m_check, record), index, took_s, 0, 0};
    head.headCheck = headCheckOf(m_check, head);
    std::string bytes(sizeof head + record.size(), '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, record.data(), record.size());
    if (!writeAll(m_file, bytes, m_size)) {
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

Result<ShardPart> readPart(const std::string& path, bool checksBytes, const ShareDone& done) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0)
        return Error(MessageCode::FileUnreadable, path, {std::strerror(errno)});
    if (!S_ISREG(info.st_mode))
        return Error(MessageCode::NotAPart, path);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return Error(MessageCode::FileUnreadable, path, {std::strerror(errno)});
    ShardPart part;
    part.path = path;
    part.changed_ms = info.st_mtim.tv_sec * 1000 + info.st_mtim.tv_nsec / 1'000'000;
    std::string line;
    for (char c = 0; line.size() < kMaxHeader && in.get(c) && c != '\n';)
        line += c;
    constexpr std::string_view kBegin = "{\"bask_part\"";
    if (!in && (line.starts_with(kBegin) || kBegin.starts_with(line)))
        return Error(MessageCode::FileEmpty, path);
    if (auto header = readHeader(line, part); !header)
        return header.error();
    line += '\n';
    part.check = checkOf(0, line);
    part.wholeBytes = static_cast<std::int64_t>(line.size());
    readRecords(in, info.st_size, checksBytes, done, part);
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

/// The bytes of a record, whose CRC goes on from `check`.
Result<std::string> bytesAt(const std::string& path, std::int64_t offset, std::uint32_t length,
                            std::uint32_t check, std::uint32_t bytesCheck, std::int64_t index) {
    std::ifstream in(path, std::ios::binary);
    std::string bytes(length, '\0');
    if (!in.seekg(offset) || !in.read(bytes.data(), length))
        return Error(MessageCode::FileUnreadable, path, {std::strerror(errno)});
    if (checkOf(check, bytes) != bytesCheck)
        return Error(MessageCode::PartDamaged, path, {std::to_string(index)});
    return bytes;
}

} // namespace

Result<void> MergedParts::add(const ShardPart& part) {
    m_parts.push_back({part.path, part.check});
    const auto number = static_cast<std::int32_t>(m_parts.size()) - 1;
    for (const PartRecord& record : part.records) {
        Place& place = m_places[static_cast<std::size_t>(record.index)];
        if (place.part >= 0) { // a shard was computed twice, or a part copied
            const auto there = this->record(record.index);
            if (!there)
                return there.error();
            const auto here =
                bytesAt(part.path, record.offset, record.length, part.check, record.bytesCheck, record.index);
            if (!here)
                return here.error();
            if (*there != *here)
                return Error(
                    MessageCode::PartsDisagree, part.path,
                    {std::to_string(record.index + 1), m_parts[static_cast<std::size_t>(place.part)].first});
            continue;
        }
        place = {number, record.length, record.bytesCheck, record.offset};
    }
    return {};
}

Result<MergedParts> MergedParts::of(const std::vector<std::string>& paths, const ShareDone& done) {
    MergedParts merged;
    std::optional<PartHeader> first;
    std::vector<double> until{0.0}; // bytes, for the share
    for (const std::string& path : paths) {
        struct stat info {};
        until.push_back(until.back() +
                        (::stat(path.c_str(), &info) == 0 ? static_cast<double>(info.st_size) : 0.0));
    }
    const double all = std::max(until.back(), 1.0);
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const std::string& path = paths[k];
        auto part = readPart(path, true, partOf(done, until[k] / all, until[k + 1] / all));
        if (!part && part.error().code() == MessageCode::FileEmpty)
            continue; // its process was ended before it had a result
        if (!part)
            return part.error();
        if (part->isDamaged)
            return Error(MessageCode::PartDamaged, path, {std::to_string(part->records.size())});
        if (!first) {
            first = part->header;
            merged.m_work = first->work;
            merged.m_places.resize(static_cast<std::size_t>(first->cases));
        }
        if (auto same = checkSameParts(path, part->header, *first); !same)
            return same.error();
        if (auto added = merged.add(*part); !added)
            return added.error();
    }
    if (!first)
        return Error(MessageCode::FileEmpty, paths.empty() ? "" : paths.front());
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
    const auto& [path, check] = m_parts[static_cast<std::size_t>(place.part)];
    return bytesAt(path, place.offset, place.length, check, place.bytesCheck, index);
}

} // namespace bask
