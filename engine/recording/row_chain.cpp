#include "engine/recording/row_chain.h"

#include <QByteArray>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace bask {
namespace {

constexpr std::array<const char*, kChainTables> kNames{
    "",         "sqlite_master", "meta",  "experiment", "object",        "step",    "target_step",
    "overview", "command",       "event", "note",       "thermal_frame", "traffic", "prediction"};
constexpr std::size_t kEntryBytes = 5; // table and check

/// What a row's digest is of.
class RowBytes {
public:
    void clear() { m_size = 0; }
    void append(char kind, const void* bytes, std::size_t size) {
        const auto length = static_cast<std::uint64_t>(size);
        const std::size_t all = 1 + sizeof length + size;
        if (m_bytes.size() - m_size < all)
            m_bytes.resize(2 * m_bytes.size() + all);
        char* const to = m_bytes.data() + m_size;
        *to = kind;
        std::memcpy(to + 1, &length, sizeof length);
        if (size > 0)
            std::memcpy(to + 1 + sizeof length, bytes, size);
        m_size += all;
    }
    void append(const SqlValue& value) {
        const double number = numberOf(value);
        if (!std::isnan(number)) {
            const double positive = number == 0.0 ? 0.0 : number;
            append('d', &positive, sizeof positive);
        } else if (const auto* text = std::get_if<std::string>(&value); text != nullptr && !text->empty()) {
            const std::string stored = storedText(*text);
            append(stored.empty() ? 'n' : 't', stored.data(), stored.size());
        } else if (const auto* blob = std::get_if<SqlBlob>(&value); blob != nullptr && !blob->bytes.empty()) {
            append('b', blob->bytes.data(), blob->bytes.size());
        } else {
            append('n', nullptr, 0);
        }
    }
    Digest digest(Sha256& hash) const {
        hash.add(m_bytes.data(), m_size);
        return hash.take();
    }

private:
    std::vector<char> m_bytes; // of the longest so far
    std::size_t m_size = 0;
};

} // namespace

bool isKnown(ChainTable table) {
    return table >= ChainTable::Schema && static_cast<int>(table) < kChainTables;
}

const char* tableName(ChainTable table) {
    return kNames.at(static_cast<std::size_t>(table));
}

std::string selectRows(ChainTable table) {
    if (table == ChainTable::Schema)
        return "SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL AND name NOT IN ('chain', "
               "'seal') "
               "ORDER BY name";
    if (table == ChainTable::Meta)
        return "SELECT key, value FROM meta WHERE key <> 'tags' ORDER BY key";
    return std::string("SELECT * FROM ") + tableName(table) + " ORDER BY rowid";
}

Digest digestOf(ChainTable table, std::span<const SqlValue> row) {
    thread_local RowBytes bytes;
    thread_local Sha256 hash;
    bytes.clear();
    bytes.append('T', tableName(table), std::strlen(tableName(table)));
    for (const SqlValue& value : row)
        bytes.append(value);
    return bytes.digest(hash);
}

std::uint32_t checkOf(const Digest& digest) {
    std::uint32_t check = 0;
    std::memcpy(&check, digest.data(), sizeof check);
    return check;
}

Digest chained(const Digest& before, std::span<const Digest> digests) {
    thread_local Sha256 hash;
    hash.add(before.data(), before.size());
    hash.add(digests.data(), digests.size_bytes());
    return hash.take();
}

std::array<SqlValue, 3> rowOf(const ChainLink& link) {
    std::string checks;
    for (const ChainLink::Entry& entry : link.rows) {
        checks += static_cast<char>(entry.table);
        checks.append(reinterpret_cast<const char*>(&entry.check), sizeof entry.check);
    }
    return {link.number, SqlBlob{std::move(checks)},
            SqlBlob{std::string(reinterpret_cast<const char*>(link.hash.data()), link.hash.size())}};
}

std::optional<ChainLink> linkOf(std::span<const SqlValue> row) {
    const auto* number = std::get_if<std::int64_t>(&row[0]);
    const auto* checks = std::get_if<SqlBlob>(&row[1]);
    const auto* hash = std::get_if<SqlBlob>(&row[2]);
    if (number == nullptr || checks == nullptr || hash == nullptr ||
        checks->bytes.size() % kEntryBytes != 0 || hash->bytes.size() != Digest().size())
        return std::nullopt;
    ChainLink link;
    link.number = *number;
    for (std::size_t at = 0; at < checks->bytes.size(); at += kEntryBytes) {
        ChainLink::Entry& entry = link.rows.emplace_back();
        entry.table = static_cast<ChainTable>(checks->bytes[at]);
        std::memcpy(&entry.check, checks->bytes.data() + at + 1, sizeof entry.check);
    }
    std::memcpy(link.hash.data(), hash->bytes.data(), link.hash.size());
    return link;
}

Result<std::optional<ChainLink>> lastLink(const SessionStore& store) {
    const auto hasChain = store.hasTable("chain");
    if (!hasChain)
        return hasChain.error();
    std::optional<ChainLink> last;
    Result<void> done;
    if (*hasChain)
        done = store.select(std::string(kSelectLinks) + " DESC LIMIT 1",
                            [&](SessionStore::Row row) { last = linkOf(row); });
    if (!done)
        return done.error();
    return last;
}

std::string hexOf(const Digest& digest) {
    return QByteArray::fromRawData(reinterpret_cast<const char*>(digest.data()), digest.size())
        .toHex()
        .toStdString();
}

void RowChain::add(ChainTable table, std::span<const SqlValue> row) {
    m_digests.push_back(digestOf(table, row));
    m_rows.push_back({table, checkOf(m_digests.back())});
}

ChainLink RowChain::takeLink() {
    ChainLink link{++m_number, std::exchange(m_rows, {}), chained(m_hash, m_digests)};
    m_hash = link.hash;
    m_digests.clear();
    return link;
}

} // namespace bask
