#include "engine/recording/session_verify.h"

#include "engine/base/message_code.h"
#include "engine/recording/row_chain.h"
#include "engine/recording/session_facts.h"
#include "engine/recording/session_tables.h"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace bask {
namespace {

using Kind = SessionFinding::Kind;
using Row = SessionStore::Row;

constexpr int kTriesToVerify = 3;
constexpr std::size_t kLookAhead = 64;        // rows, once there are many findings
constexpr std::size_t kMaxUnordered = 10'000; // rows of the schema, and of meta
constexpr std::int64_t kMinCheckBytes = 64 << 20;
// How far the parts of the work go, of a run of a day.
constexpr double kAfterSeal = 0.08, kAfterStructure = 0.16, kAfterRows = 0.95;

/// The rows of a table as they are in the file.
struct TableRows {
    std::vector<Digest> digests;
    std::vector<double> times_s;       ///< NaN: none
    std::vector<std::int64_t> numbers; ///< of samples, which have their own
};

constexpr bool isUnordered(ChainTable table) {
    return table == ChainTable::Schema || table == ChainTable::Meta;
}

class Verifier {
public:
    Verifier(const SessionStore& store, bool isDamaged, const std::string& expectedHead,
             const ShareDone& done, const std::stop_token& stop)
        : m_store(store), m_expectedHead(expectedHead), m_done(done), m_stop(stop) {
        m_verdict.isDamaged = isDamaged;
    }

    Result<SessionVerdict> verdict() {
        auto done = m_store.select("SELECT name FROM sqlite_master WHERE type = 'table'",
                                   [&](Row row) { m_tables.push_back(textOf(row[0])); });
        if (!done && !isDamage(done))
            return done.error();
        m_isListWhole = done.ok();
        m_verdict.hasChain = has("chain");
        if (!m_verdict.hasChain && !m_verdict.isDamaged)
            return m_verdict;
        for (const auto part : {&Verifier::readRows, &Verifier::readLinks}) {
            if (done = (this->*part)(); !done)
                return done.error();
            if (m_stop.stop_requested()) // rows that were not read would be told as removed
                return m_verdict;
        }
        if (m_verdict.isDamaged)
            tellMissing();
        const bool canCompare = m_verdict.hasChain && isReadable("chain");
        for (int k = 1; k < kChainTables && canCompare; ++k)
            if (const auto table = static_cast<ChainTable>(k); isReadable(tableName(table)))
                compare(table);
        if (m_verdict.allFindings == 0 && m_verdict.damages.empty())
            checkHashes();
        if (!m_links.empty())
            m_verdict.head = hexOf(m_links.back().hash);
        m_verdict.links = static_cast<std::int64_t>(m_links.size());
        for (const ChainLink& link : m_links)
            if (hexOf(link.hash) == m_expectedHead)
                m_verdict.expectedLink = link.number;
        return m_verdict;
    }

private:
    bool has(const char* table) const { return std::ranges::find(m_tables, table) != m_tables.end(); }
    bool isReadable(const char* table) const {
        return std::ranges::find(m_verdict.damages, table, &TableDamage::table) == m_verdict.damages.end();
    }
    TableRows& rowsOf(ChainTable table) { return m_rows[static_cast<std::size_t>(table)]; }

    void tell(Kind kind, const char* table, std::size_t row, double time_s) {
        ++m_verdict.allFindings;
        if (m_verdict.findings.size() < kMaxFindings)
            m_verdict.findings.push_back({kind, table, static_cast<std::int64_t>(row),
                                          std::isnan(time_s) ? std::nullopt : std::optional(time_s)});
    }

    static bool isDamage(const Result<void>& read) {
        return !read && read.error().code() == MessageCode::SessionDamaged;
    }
    void tellDamage(const char* table, std::size_t rows, double time_s) {
        m_verdict.isDamaged = true;
        m_verdict.damages.push_back({table, static_cast<std::int64_t>(rows),
                                     std::isnan(time_s) ? std::nullopt : std::optional(time_s)});
    }

    double rowsToRead() const {
        double rows = 0.0;
        for (int k = 1; k < kChainTables; ++k)
            if (const auto table = static_cast<ChainTable>(k); !isUnordered(table) && has(tableName(table)))
                rows += roughRows(m_store, tableName(table));
        return rows;
    }

    Result<void> readRows() {
        ShareCount count(partOf(m_done, kAfterStructure, kAfterRows), rowsToRead());
        for (int k = 1; k < kChainTables; ++k) {
            const auto table = static_cast<ChainTable>(k);
            const bool isListed = table == ChainTable::Schema || has(tableName(table));
            if (!isListed && !m_verdict.isDamaged)
                continue;
            const int time = timeColumn(table);
            const auto at = static_cast<std::size_t>(std::max(time, 0));
            TableRows& rows = rowsOf(table);
            const std::size_t max = isUnordered(table) ? kMaxUnordered : SIZE_MAX;
            const std::string limit = isUnordered(table) ? " LIMIT " + std::to_string(kMaxUnordered + 1) : "";
            auto done = m_store.select(
                selectRows(table) + limit,
                [&](Row row) {
                    count.add();
                    rows.digests.push_back(digestOf(table, row));
                    rows.times_s.push_back(time >= 0 && at < row.size() ? numberOf(row[at]) : NAN);
                    if (table == ChainTable::Step)
                        rows.numbers.push_back(SessionTables::numberOfStep(row));
                    if (table == ChainTable::Meta && textOf(row[0]) == "finished")
                        m_verdict.isClosed = true;
                },
                m_stop);
            const bool isCut = isDamage(done);
            if (isCut && !isListed)
                continue; // tellMissing()
            if (!isListed)
                m_tables.emplace_back(tableName(table)); // SQLite knows one more than it lists
            if (isCut)
                tellDamage(tableName(table), rows.digests.size(),
                           rows.times_s.empty() ? NAN : rows.times_s.back());
            if ((done || isCut) && rows.digests.size() > max)
                return Error(MessageCode::SessionDamaged, m_store.path(),
                             {std::string("more rows in ") + tableName(table) + " than Bask makes"});
            if (!done && !isCut)
                return done;
            m_verdict.rows += static_cast<std::int64_t>(rows.digests.size());
        }
        tellShare(m_done, kAfterRows);
        return {};
    }

    /// Column of time_s; negative: none.
    static int timeColumn(ChainTable table) {
        switch (table) {
        case ChainTable::Schema:
        case ChainTable::Meta:
        case ChainTable::Experiment:
        case ChainTable::Object:
        case ChainTable::Overview:
            return -1;
        case ChainTable::Step:
            return 1;
        default:
            return 0;
        }
    }

    Result<void> readLinks() {
        bool isWhole = true;
        std::int64_t bytes = 0; // a file from elsewhere may have any
        auto done = m_store.select("SELECT total(length(row_checks)) FROM chain",
                                   [&](Row row) { bytes = static_cast<std::int64_t>(numberOf(row[0])); });
        if (done && bytes > std::max(kMinCheckBytes, 20 * m_verdict.rows))
            return Error(MessageCode::SessionDamaged, m_store.path(), {"more checks than rows"});
        std::size_t links = 0;
        if (isDamage(done))
            (void)m_store.select("SELECT number FROM chain", [&](Row) { ++links; });
        if (done)
            done = m_store.select(kSelectLinks, [&](Row row) {
                ++links;
                auto link = linkOf(row);
                isWhole = isWhole && link && link->number == static_cast<std::int64_t>(m_links.size()) + 1;
                if (isWhole)
                    m_links.push_back(std::move(*link));
            });
        if (isDamage(done) || (done && !isWhole && m_verdict.isDamaged)) { // it would tell rows as added
            tellDamage("chain", isWhole ? links : m_links.size(), NAN);
            m_links.clear();
            return {};
        }
        if (done && !isWhole)
            tell(Kind::Changed, "chain", m_links.size() + 1, NAN);
        for (const ChainLink& link : m_links)
            for (const ChainLink::Entry& entry : link.rows)
                m_checks[static_cast<std::size_t>(entry.table)].push_back(entry.check);
        return done;
    }

    /// Names the tables that damage has taken from the list of tables: those of which the chain has rows;
    /// without a chain, all that a run may have.
    void tellMissing() {
        const bool isChainRead = m_verdict.hasChain && isReadable("chain");
        bool isMissing = false;
        for (int k = 1; k < kChainTables; ++k) {
            const char* const name = tableName(static_cast<ChainTable>(k));
            const bool hadRows =
                isChainRead ? !m_checks[static_cast<std::size_t>(k)].empty() : !m_isListWhole;
            if (static_cast<ChainTable>(k) == ChainTable::Schema || has(name) || !hadRows)
                continue;
            tellDamage(name, 0, NAN);
            isMissing = true;
        }
        const char* const list = tableName(ChainTable::Schema);
        if (isMissing && isReadable(list))
            tellDamage(list, rowsOf(ChainTable::Schema).digests.size(), NAN);
    }

    void compare(ChainTable table) {
        if (isUnordered(table))
            compareSets(table);
        else if (table == ChainTable::Step)
            compareSteps();
        else
            compareInOrder(table);
    }

    /// Samples have numbers, from 1 without a gap.
    void compareSteps() {
        const auto& expected = m_checks[static_cast<std::size_t>(ChainTable::Step)];
        const TableRows& rows = rowsOf(ChainTable::Step);
        const char* const name = tableName(ChainTable::Step);
        std::int64_t due = 1;
        for (std::size_t k = 0; k < rows.numbers.size(); ++k) {
            const std::int64_t number = rows.numbers[k];
            if (number > due)
                tell(Kind::Removed, name, static_cast<std::size_t>(due), rows.times_s[k]);
            if (number < 1 || number > static_cast<std::int64_t>(expected.size()))
                tell(Kind::Added, name, k + 1, rows.times_s[k]);
            else if (expected[static_cast<std::size_t>(number - 1)] != checkOf(rows.digests[k]))
                tell(Kind::Changed, name, static_cast<std::size_t>(number), rows.times_s[k]);
            due = std::max(due, number + 1);
        }
        if (due <= static_cast<std::int64_t>(expected.size()))
            tell(Kind::Removed, name, static_cast<std::size_t>(due), NAN);
    }

    void compareInOrder(ChainTable table) {
        const std::vector<std::uint32_t>& expected = m_checks[static_cast<std::size_t>(table)];
        const TableRows& rows = rowsOf(table);
        const std::size_t found = rows.digests.size();
        const auto timeAt = [&](std::size_t row) { return row < found ? rows.times_s[row] : NAN; };
        const auto isSame = [&](std::size_t e, std::size_t a) {
            return expected[e] == checkOf(rows.digests[a]);
        };
        std::size_t e = 0, a = 0;
        while (e < expected.size() || a < found) {
            if (e < expected.size() && a < found && isSame(e, a)) {
                ++e, ++a;
                continue;
            }
            // How far to look for the next row that is known; nobody reads thousands of findings.
            const std::size_t ahead =
                m_verdict.findings.size() < kMaxFindings ? std::max(expected.size(), found) : kLookAhead;
            std::size_t removed = e < expected.size() ? 1 : 0, added = a < found ? 1 : 0;
            while (a < found && removed < ahead && e + removed < expected.size() && !isSame(e + removed, a))
                ++removed;
            while (e < expected.size() && added < ahead && a + added < found && !isSame(e, a + added))
                ++added;
            const bool isRemoved = a >= found || (e + removed < expected.size() && isSame(e + removed, a));
            const bool isAdded = e >= expected.size() || (a + added < found && isSame(e, a + added));
            if (isRemoved && (!isAdded || removed <= added)) {
                tell(Kind::Removed, tableName(table), e + 1, timeAt(a));
                e += a >= found ? 1 : removed;
            } else if (isAdded) {
                tell(Kind::Added, tableName(table), a + 1, timeAt(a));
                a += e >= expected.size() ? 1 : added;
            } else {
                tell(Kind::Changed, tableName(table), a + 1, timeAt(a));
                ++e, ++a;
            }
        }
    }

    void compareSets(ChainTable table) {
        std::unordered_map<std::uint32_t, std::int64_t> expected;
        for (const std::uint32_t check : m_checks[static_cast<std::size_t>(table)])
            ++expected[check];
        const TableRows& rows = rowsOf(table);
        std::vector<std::size_t> unknown;
        for (std::size_t k = 0; k < rows.digests.size(); ++k)
            if (const auto there = expected.find(checkOf(rows.digests[k]));
                there == expected.end() || there->second-- < 1)
                unknown.push_back(k);
        std::size_t missing = 0;
        for (const auto& [check, count] : expected)
            missing += count > 0 ? static_cast<std::size_t>(count) : 0;
        for (std::size_t k = 0; k < std::max(unknown.size(), missing); ++k)
            tell(k >= unknown.size() ? Kind::Removed
                 : k >= missing      ? Kind::Added
                                     : Kind::Changed,
                 tableName(table), k < unknown.size() ? unknown[k] + 1 : 0, NAN);
    }

    /// All rows are those of their checks: now the whole hashes, link by link.
    void checkHashes() {
        std::array<std::size_t, kChainTables> next{};
        std::array<std::unordered_map<std::uint32_t, Digest>, kChainTables> sets;
        for (const ChainTable table : {ChainTable::Schema, ChainTable::Meta})
            for (const Digest& digest : rowsOf(table).digests)
                sets[static_cast<std::size_t>(table)][checkOf(digest)] = digest;
        Digest before{};
        std::vector<Digest> digests;
        for (const ChainLink& link : m_links) {
            digests.clear();
            double time_s = NAN;
            for (const ChainLink::Entry& entry : link.rows) {
                const auto table = static_cast<std::size_t>(entry.table);
                if (isUnordered(entry.table)) {
                    digests.push_back(sets[table][entry.check]);
                    continue;
                }
                const TableRows& rows = m_rows[table];
                if (std::isnan(time_s))
                    time_s = rows.times_s[next[table]];
                digests.push_back(rows.digests[next[table]++]);
            }
            if (chained(before, digests) != link.hash) {
                tell(Kind::Changed, "chain", static_cast<std::size_t>(link.number), time_s);
                return; // what follows hangs on it
            }
            before = link.hash;
        }
    }

    const SessionStore& m_store;
    const std::string& m_expectedHead;
    const ShareDone& m_done;
    const std::stop_token& m_stop;
    std::vector<std::string> m_tables;
    bool m_isListWhole = true; ///< m_tables could be read to its end
    std::array<TableRows, kChainTables> m_rows;
    std::array<std::vector<std::uint32_t>, kChainTables> m_checks;
    std::vector<ChainLink> m_links;
    SessionVerdict m_verdict;
};

Result<SessionVerdict> verified(const std::string& path, const std::string& expectedHead, bool isAlone,
                                const ShareDone& told, const std::stop_token& stop) {
    const auto seal = lookAtSeal(path, isAlone, partOf(told, 0.0, kAfterSeal));
    bool isDamaged = !seal && seal.error().code() == MessageCode::SessionDamaged;
    if (!seal && !isDamaged)
        return seal.error();
    tellShare(told, kAfterSeal);
    const auto store = isDamaged ? SessionStore::openDamaged(path) : SessionStore::open(path);
    if (!store)
        return store.error();
    auto done = (*store)->execute("BEGIN"); // all of one moment
    if (done && !isDamaged)
        done = checkIntegrity(**store, path);
    isDamaged = isDamaged || (!done && done.error().code() == MessageCode::SessionDamaged);
    if (!done && !isDamaged)
        return done.error();
    tellShare(told, kAfterStructure);
    auto verdict = Verifier(**store, isDamaged, expectedHead, told, stop).verdict();
    if (verdict)
        verdict->seal = seal ? *seal : Seal::None;
    tellShare(told, 1.0);
    return verdict;
}

/// Size and time of a file without a log; empty for one with a log, of which SQLite keeps one moment.
std::string stampOf(const std::string& path) {
    const QFileInfo file(QString::fromStdString(path));
    if (QFileInfo::exists(file.canonicalFilePath() + QStringLiteral("-wal")))
        return {};
    return std::to_string(file.size()) + '@' + std::to_string(file.lastModified().toMSecsSinceEpoch());
}

} // namespace

Result<SessionVerdict> verifySession(const std::string& path, const std::string& expectedHead,
                                     const ShareDone& told) {
    return verified(path, expectedHead, true, told, {});
}

/// A file without a log is read without locks: what was written meanwhile, as tags are, would pass for
/// altered.
Result<SessionVerdict> verifyOpenSession(const std::string& path, const std::stop_token& stop) {
    for (int tries = 0; tries < kTriesToVerify; ++tries) {
        const std::string before = stampOf(path);
        auto verdict = verified(path, {}, false, {}, stop);
        if (stop.stop_requested() || before.empty() || before == stampOf(path))
            return verdict;
    }
    return Error(MessageCode::SessionBusy, path,
                 {QT_TRANSLATE_NOOP("Parameter", "it is written to again and again")});
}

const char* verificationWord(const SessionVerdict& verdict) {
    if (verdict.isDamaged)
        return "damaged";
    if (!verdict.hasChain)
        return "no hash chain";
    if (!verdict.isIntact())
        return "altered";
    return verdict.seal == Seal::Holds ? "intact" : "not sealed";
}

std::string verificationWords(const SessionVerdict& verdict) {
    const std::string word = verificationWord(verdict);
    return verdict.head.empty() ? word : word + " (head " + verdict.head + ')';
}

std::string verificationOf(const std::string& path) {
    const auto verdict = verifyOpenSession(path);
    return verdict ? verificationWords(*verdict) : "not verified";
}

Result<std::string> chainHead(const std::string& path) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    const auto last = lastLink(**store);
    if (!last)
        return last.error();
    return *last ? hexOf((*last)->hash) : std::string();
}

} // namespace bask
