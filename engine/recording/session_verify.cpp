#include "engine/recording/session_verify.h"

#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/recording/chain_walk.h"
#include "engine/recording/session_facts.h"
#include "engine/recording/session_names.h"
#include "engine/recording/session_tables.h"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
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

constexpr auto kFirstTable = static_cast<int>(ChainTable::Schema);

class Verifier {
public:
    Verifier(const SessionStore& store, bool isDamaged, const std::string& expectedHead,
             const ShareDone& done, const std::stop_token& stop)
        : m_store(store), m_expectedHead(expectedHead), m_done(done), m_stop(stop) {
        m_verdict.isDamaged = isDamaged;
    }

    Result<SessionVerdict> verdict() {
        bool isOfChained = false;
        auto done = m_store.select("SELECT type, name, sql FROM sqlite_master", [&](Row row) {
            const std::string sql = textOf(row[2]);
            isOfChained = isOfChained || isOfChainingBask(sql);
            if (textOf(row[0]) == "table" && SessionStore::isPlainTable(sql))
                m_tables.push_back(textOf(row[1]));
        });
        if (!done && !isDamage(done))
            return done.error();
        m_isListWhole = done.ok();
        m_verdict.hasChain = has("chain") || (isOfChained && !m_verdict.isDamaged && m_store.version() > 1);
        if (!m_verdict.hasChain && !m_verdict.isDamaged)
            return m_verdict;
        for (const auto part : {&Verifier::readLinks, &Verifier::readRows}) {
            if (done = (this->*part)(); !done)
                return done.error();
            if (m_stop.stop_requested()) // rows that were not read would be told as removed
                return m_verdict;
        }
        if (m_verdict.isDamaged)
            tellMissing();
        tellHeader();
        if (m_verdict.hasChain && !has("chain") && !m_verdict.isDamaged)
            tellNamed(Kind::Removed, ChainTable::Schema, 0, {"table", "chain"});
        else if (m_verdict.hasChain && isReadable("chain"))
            compareAll();
        m_verdict.links = static_cast<std::int64_t>(m_links.size());
        for (const FileLink& each : m_links)
            if (each.link) {
                m_verdict.head = hexOf(each.link->hash);
                if (m_verdict.head == m_expectedHead)
                    m_verdict.expectedLink = each.number;
            }
        return m_verdict;
    }

private:
    bool has(const char* table) const { return std::ranges::find(m_tables, table) != m_tables.end(); }
    bool isReadable(const char* table) const {
        return std::ranges::find(m_verdict.damages, table, &TableDamage::table) == m_verdict.damages.end();
    }
    FileRows& rowsOf(ChainTable table) { return m_rows[tableIndex(table)]; }

    static std::optional<double> known(double time_s) {
        return std::isnan(time_s) ? std::nullopt : std::optional(time_s);
    }

    void tell(SessionFinding finding) {
        ++m_verdict.allFindings;
        if (m_verdict.findings.size() < kMaxFindings)
            m_verdict.findings.push_back(std::move(finding));
    }
    void tell(Kind kind, ChainTable table, std::size_t row, double time_s, std::size_t lastRow = 0) {
        tell({.kind = kind,
              .table = tableName(table),
              .row = static_cast<std::int64_t>(row),
              .time_s = known(time_s),
              .lastRow = lastRow > row ? static_cast<std::int64_t>(lastRow) : 0});
    }
    void tellNamed(Kind kind, ChainTable table, std::size_t row, const RowName& name) {
        tell({.kind = kind,
              .table = tableName(table),
              .row = static_cast<std::int64_t>(row),
              .type = name.type,
              .name = name.name});
    }
    /// Rows after which there is none in the table; `expected`: what the chain knows of the first of them.
    void tellCut(ChainTable table, std::size_t row, std::size_t lastRow, const ChainedRow& expected) {
        const std::vector<double>& times_s = rowsOf(table).times_s;
        double time_s = times_s.empty() ? NAN : times_s.back();
        for (std::size_t k = expected.link + 1; k-- > 0 && std::isnan(time_s) && hasTimes(table);)
            time_s = m_chain.times_s[k];
        tell({.kind = Kind::Removed,
              .table = tableName(table),
              .row = static_cast<std::int64_t>(row),
              .time_s = known(time_s),
              .isAfter = !std::isnan(time_s),
              .lastRow = lastRow > row ? static_cast<std::int64_t>(lastRow) : 0});
    }

    /// A session is what its header says: the numbers were changed where the rest tells otherwise.
    void tellHeader() {
        const auto add = [&](const char* name) {
            tell({.kind = Kind::Changed, .table = kHeaderTable, .type = "number", .name = name});
        };
        if (!m_store.isMarked())
            add("application_id");
        if (m_verdict.hasChain && m_store.version() != kSessionVersion)
            add("user_version");
    }

    static bool isDamage(const Result<void>& read) {
        return !read && read.error().code() == MessageCode::SessionDamaged;
    }
    void tellDamage(const char* table, std::size_t rows, double time_s) {
        m_verdict.isDamaged = true;
        m_verdict.damages.push_back({table, static_cast<std::int64_t>(rows), known(time_s)});
    }

    double rowsToRead() const {
        double rows = 0.0;
        for (int k = kFirstTable; k < kChainTables; ++k)
            if (const auto table = static_cast<ChainTable>(k); !isUnordered(table) && has(tableName(table)))
                rows += roughRows(m_store, tableName(table));
        return rows;
    }

    Result<void> readRows() {
        const std::map<ChainTable, std::vector<std::uint32_t>> firsts = firstChecks();
        ShareCount count(partOf(m_done, kAfterStructure, kAfterRows), rowsToRead());
        for (int k = kFirstTable; k < kChainTables; ++k) {
            const auto table = static_cast<ChainTable>(k);
            const bool isListed = table == ChainTable::Schema || has(tableName(table));
            if (!isListed && !m_verdict.isDamaged)
                continue;
            FileRows& rows = rowsOf(table);
            const std::size_t max = isUnordered(table) ? kMaxUnordered : SIZE_MAX;
            const std::string limit = isUnordered(table) ? " LIMIT " + std::to_string(kMaxUnordered + 1) : "";
            std::size_t width = SIZE_MAX;
            const auto known = firsts.find(table);
            auto done = m_store.select(
                selectRows(table) + limit,
                [&](Row row) {
                    count.add();
                    if (known != firsts.end() && width > row.size() && rows.digests.size() < kWidthTries)
                        width = widthOf(table, row, known->second);
                    add(table, row.first(std::min(width, row.size())));
                },
                m_stop);
            const bool isCut = isDamage(done);
            if (isCut && !isListed)
                continue; // tellMissing()
            rows.isThere = true;
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

    static constexpr std::size_t kWidthTries = 8; // rows

    /// Columns that were added to a table stand behind the recorded ones: of a table that was made
    /// otherwise, the checks of its first rows tell how many these are.
    std::map<ChainTable, std::vector<std::uint32_t>> firstChecks() const {
        std::map<ChainTable, std::vector<std::uint32_t>> out;
        for (const FileLink& each : m_links)
            if (each.link)
                for (const ChainLink::Entry& entry : each.link->rows)
                    if (!isUnordered(entry.table) && out[entry.table].size() < kWidthTries)
                        out[entry.table].push_back(entry.check);
        return out;
    }
    static std::size_t widthOf(ChainTable table, Row row, const std::vector<std::uint32_t>& checks) {
        for (std::size_t width = row.size(); width > 0; --width)
            if (std::ranges::find(checks, checkOf(digestOf(table, row.first(width)))) != checks.end())
                return width;
        return SIZE_MAX;
    }

    void add(ChainTable table, Row row) {
        FileRows& rows = rowsOf(table);
        rows.digests.push_back(digestOf(table, row));
        rows.times_s.push_back(timeOf(table, row));
        if (table == ChainTable::Step)
            rows.numbers.push_back(SessionTables::numberOfStep(row));
        if (table == ChainTable::Schema && row.size() > 1)
            rows.names.push_back({textOf(row[0]), textOf(row[1])});
        if (table == ChainTable::Meta) {
            const std::string key = textOf(row[0]);
            rows.names.push_back({"key", key});
            m_verdict.isClosed = m_verdict.isClosed || key == "finished";
            m_hasEnd = m_hasEnd || key == "finished" || key == "outcome";
        }
    }

    static bool hasTimes(ChainTable table) {
        return !isUnordered(table) && table != ChainTable::Experiment && table != ChainTable::Object;
    }
    /// NaN: none.
    double timeOf(ChainTable table, Row row) {
        if (!hasTimes(table) || row.empty())
            return NAN;
        if (table != ChainTable::Overview) {
            const std::size_t column = table == ChainTable::Step ? 1 : 0;
            return column < row.size() ? numberOf(row[column]) : NAN;
        }
        const FileRows& samples = rowsOf(ChainTable::Step); // of the last one that it sums up
        const auto place = placeOfSample(samples, SessionTables::numberOfStep(row));
        return place ? samples.times_s[*place] : NAN;
    }

    Result<void> readLinks() {
        if (!has("chain") && !m_verdict.isDamaged)
            return {};
        std::int64_t bytes = 0; // a file from elsewhere may have any
        auto done = m_store.select("SELECT total(length(row_checks)) FROM chain",
                                   [&](Row row) { bytes = static_cast<std::int64_t>(numberOf(row[0])); });
        if (done && bytes > std::max(kMinCheckBytes, 20 * static_cast<std::int64_t>(rowsToRead())))
            return Error(MessageCode::SessionDamaged, m_store.path(), {"more checks than rows"});
        bool isWhole = true;
        std::size_t links = 0;
        if (isDamage(done))
            (void)m_store.select("SELECT number FROM chain", [&](Row) { ++links; });
        if (done)
            done = m_store.select(kSelectLinks, [&](Row row) {
                ++links;
                auto link = linkOf(row);
                const std::int64_t number = SessionTables::numberOfStep(row);
                isWhole = isWhole && link && number == static_cast<std::int64_t>(links) &&
                          std::ranges::all_of(link->rows, isKnown, &ChainLink::Entry::table);
                if (link)
                    link->number = number;
                m_links.push_back({number, std::move(link)});
            });
        if (isDamage(done) || (done && !isWhole && m_verdict.isDamaged)) { // it would tell rows as added
            tellDamage("chain", links, NAN);
            m_links.clear();
            return {};
        }
        return done;
    }

    /// Names the tables that damage has taken from the list of tables: those of which the chain has rows;
    /// without a chain, all that a run may have.
    void tellMissing() {
        const bool isChainRead = m_verdict.hasChain && isReadable("chain");
        std::set<ChainTable> chained;
        for (const FileLink& each : m_links)
            if (each.link)
                for (const ChainLink::Entry& entry : each.link->rows)
                    chained.insert(entry.table);
        bool isMissing = false;
        for (int k = kFirstTable; k < kChainTables; ++k) {
            const auto table = static_cast<ChainTable>(k);
            const char* const name = tableName(table);
            const bool hadRows = isChainRead ? chained.contains(table) : !m_isListWhole;
            if (table == ChainTable::Schema || has(name) || !hadRows)
                continue;
            tellDamage(name, 0, NAN);
            isMissing = true;
        }
        const char* const list = tableName(ChainTable::Schema);
        if (isMissing && isReadable(list))
            tellDamage(list, rowsOf(ChainTable::Schema).digests.size(), NAN);
    }

    void compareAll() {
        m_chain = walkChain(m_links, m_rows, m_hasEnd);
        for (const LinkFault& fault : m_chain.faults)
            tell({.kind = fault.isLost ? Kind::Removed : Kind::Changed,
                  .table = "chain",
                  .row = fault.first,
                  .time_s = fault.time_s,
                  .isAfter = fault.isLost && fault.time_s,
                  .lastRow = fault.last > fault.first ? fault.last : 0});
        if (!m_chain.isComparable)
            return;
        for (int k = kFirstTable; k < kChainTables; ++k)
            if (const auto table = static_cast<ChainTable>(k); isReadable(tableName(table)))
                compare(table);
    }

    void compare(ChainTable table) {
        if (isUnordered(table))
            compareSets(table);
        else if (table == ChainTable::Step)
            compareSteps();
        else
            compareInOrder(table);
    }

    static bool isSame(const ChainedRow& expected, const Digest& digest) {
        return expected.isAny || expected.check == checkOf(digest);
    }

    /// Samples have numbers, from 1 without a gap.
    void compareSteps() {
        const auto& expected = m_chain.rows[tableIndex(ChainTable::Step)];
        const FileRows& rows = rowsOf(ChainTable::Step);
        std::int64_t due = 1;
        for (std::size_t k = 0; k < rows.numbers.size(); ++k) {
            const std::int64_t number = rows.numbers[k];
            if (number > due)
                tell(Kind::Removed, ChainTable::Step, static_cast<std::size_t>(due), rows.times_s[k],
                     static_cast<std::size_t>(number - 1));
            if (number < 1 || number > static_cast<std::int64_t>(expected.size()))
                tell(Kind::Added, ChainTable::Step, k + 1, rows.times_s[k]);
            else if (!isSame(expected[static_cast<std::size_t>(number - 1)], rows.digests[k]))
                tell(Kind::Changed, ChainTable::Step, static_cast<std::size_t>(number), rows.times_s[k]);
            due = std::max(due, number + 1);
        }
        if (due <= static_cast<std::int64_t>(expected.size()))
            tellCut(ChainTable::Step, static_cast<std::size_t>(due), expected.size(),
                    expected[static_cast<std::size_t>(due - 1)]);
    }

    /// How far rows that the file has, and rows that the chain has, are from the next ones that fit: what is
    /// wrong in between.
    struct Gap {
        std::size_t removed, added, changed;
        bool isRemoved, isAdded, isChanged;
    };
    Gap gapAt(const std::vector<ChainedRow>& expected, const std::vector<Digest>& found, std::size_t e,
              std::size_t a) const {
        const std::size_t left = expected.size() - e, there = found.size() - a;
        // How far to look for the next row that is known; nobody reads thousands of findings.
        const std::size_t ahead =
            m_verdict.findings.size() < kMaxFindings ? std::max(left, there) + 1 : kLookAhead;
        const auto fits = [](const ChainedRow& row, const Digest& digest) {
            return !row.isAny && row.check == checkOf(digest);
        };
        Gap gap{1, 1, 1, false, false, false};
        for (; gap.removed < std::min(ahead, left) && !gap.isRemoved; ++gap.removed)
            gap.isRemoved = fits(expected[e + gap.removed], found[a]);
        for (; gap.added < std::min(ahead, there) && !gap.isAdded; ++gap.added)
            gap.isAdded = fits(expected[e], found[a + gap.added]);
        for (; gap.changed < std::min(ahead, std::min(left, there)) && !gap.isChanged; ++gap.changed)
            gap.isChanged = fits(expected[e + gap.changed], found[a + gap.changed]);
        gap.removed -= gap.isRemoved ? 1 : 0;
        gap.added -= gap.isAdded ? 1 : 0;
        gap.changed -= gap.isChanged ? 1 : 0;
        return gap;
    }

    void compareInOrder(ChainTable table) {
        const std::vector<ChainedRow>& expected = m_chain.rows[tableIndex(table)];
        const FileRows& rows = rowsOf(table);
        const std::size_t found = rows.digests.size();
        std::size_t e = 0, a = 0;
        while (e < expected.size() && a < found) {
            if (isSame(expected[e], rows.digests[a])) {
                ++e, ++a;
                continue;
            }
            const Gap gap = gapAt(expected, rows.digests, e, a);
            const std::size_t moved = (gap.isRemoved ? gap.removed : 0) + (gap.isAdded ? gap.added : 0);
            const bool isMoved = gap.isRemoved || gap.isAdded;
            if (isMoved && !(gap.isChanged && gap.changed <= moved)) {
                if (gap.isRemoved && (!gap.isAdded || gap.removed <= gap.added)) {
                    tell(Kind::Removed, table, e + 1, rows.times_s[a], e + gap.removed);
                    e += gap.removed;
                } else {
                    tell(Kind::Added, table, a + 1, rows.times_s[a], a + gap.added);
                    a += gap.added;
                }
                continue;
            }
            tell(Kind::Changed, table, a + 1, rows.times_s[a]);
            ++e, ++a;
        }
        if (e < expected.size())
            tellCut(table, e + 1, expected.size(), expected[e]);
        if (a < found)
            tell(Kind::Added, table, a + 1, rows.times_s[a], found);
    }

    /// Rows of the schema and of meta have names, and no order. Of those that are not there, the chain has
    /// no name: they are among those that a session has.
    void compareSets(ChainTable table) {
        const FileRows& rows = rowsOf(table);
        if (!rows.isThere)
            return;
        std::unordered_map<std::uint32_t, std::int64_t> expected;
        for (const ChainedRow& row : m_chain.rows[tableIndex(table)])
            ++expected[row.check];
        std::vector<std::size_t> unknown;
        for (std::size_t k = 0; k < rows.digests.size(); ++k)
            if (const auto there = expected.find(checkOf(rows.digests[k]));
                there == expected.end() || there->second-- < 1)
                unknown.push_back(k);
        std::size_t missing = 0;
        for (const auto& [check, count] : expected)
            missing += count > 0 ? static_cast<std::size_t>(count) : 0;
        if (m_chain.hasLost && missing == 0) // they may have been in what is lost
            return;
        const NamesInSession made = table == ChainTable::Meta ? namesOfFacts() : namesOfTables();
        for (const std::size_t k : unknown) {
            const bool isChanged = missing > 0 && made.has(rows.names[k].name);
            missing -= isChanged ? 1 : 0;
            tellNamed(isChanged ? Kind::Changed : Kind::Added, table, k + 1, rows.names[k]);
        }
        const auto absent = [&](std::vector<std::string> names) {
            std::erase_if(names, [&](const std::string& name) {
                return std::ranges::find(rows.names, name, &RowName::name) != rows.names.end();
            });
            return names;
        };
        const auto typeOf = [&](const std::string& name) {
            return table == ChainTable::Meta ? "key" : isTableName(name) ? "table" : "view";
        };
        std::vector<std::string> surely = absent(made.always), maybe = absent(made.sometimes);
        std::erase_if(maybe, [&](const std::string& name) { // of what the chain has rows, it was there
            const bool isSure = table == ChainTable::Schema && hasChained(name);
            if (isSure)
                surely.push_back(name);
            return isSure;
        });
        for (std::size_t k = 0; k < std::min(missing, surely.size()); ++k)
            tellNamed(Kind::Removed, table, 0, {typeOf(surely[k]), surely[k]});
        const std::size_t unsure = missing - std::min(missing, surely.size());
        for (std::size_t k = 0; k < unsure; ++k)
            if (maybe.size() <= unsure && k < maybe.size())
                tellNamed(Kind::Removed, table, 0, {typeOf(maybe[k]), maybe[k]});
            else
                tellNamed(Kind::Removed, table, 0, {table == ChainTable::Meta ? "key" : "", eitherOf(maybe)});
    }

    bool hasChained(const std::string& name) const {
        for (int k = kFirstTable; k < kChainTables; ++k)
            if (name == tableName(static_cast<ChainTable>(k)))
                return !m_chain.rows[static_cast<std::size_t>(k)].empty();
        return false;
    }

    const SessionStore& m_store;
    const std::string& m_expectedHead;
    const ShareDone& m_done;
    const std::stop_token& m_stop;
    std::vector<std::string> m_tables; ///< that compute nothing
    bool m_isListWhole = true;         ///< m_tables could be read to its end
    bool m_hasEnd = false;             ///< the recording says how it ended
    FileTables m_rows;
    std::vector<FileLink> m_links;
    WalkedChain m_chain;
    SessionVerdict m_verdict;
};

/// "0.2.0" as numbers.
std::array<int, 3> versionOf(const std::string& text) {
    std::array<int, 3> numbers{};
    const char* const end = text.data() + text.size();
    const char* from = text.data();
    for (int& number : numbers) {
        const auto read = std::from_chars(from, end, number);
        if (read.ec != std::errc() || read.ptr == end)
            break;
        from = read.ptr + 1;
    }
    return numbers;
}

/// Whether a file that is not as Bask makes it, by its header or its tables, was a session with a chain: then
/// that is told with the rest. A version to come stays refused.
bool isAlteredSession(const SessionStore& store) {
    bool hasChain = false, hasMeta = false;
    std::string software;
    auto done = store.select("SELECT name, sql FROM sqlite_master WHERE type = 'table'", [&](Row row) {
        hasChain = hasChain || textOf(row[1]) == kCreateChain;
        hasMeta = hasMeta || (textOf(row[0]) == "meta" && SessionStore::isPlainTable(textOf(row[1])));
    });
    if (done && hasMeta)
        done = store.select("SELECT value FROM meta WHERE key = 'software'",
                            [&](Row row) { software = textOf(row[0]); });
    constexpr std::string_view kName = "Bask ";
    return done && hasChain && software.starts_with(kName) &&
           (store.version() <= kSessionVersion ||
            versionOf(software.substr(kName.size())) <= versionOf(BASK_VERSION));
}

/// The file, for looking at all of it, whatever was done to it.
Result<std::unique_ptr<SessionStore>> openAny(const std::string& path, bool isDamaged) {
    if (isDamaged)
        return SessionStore::openDamaged(path);
    auto plain = SessionStore::open(path);
    if (plain)
        return plain;
    auto altered = SessionStore::openAltered(path);
    return altered && isAlteredSession(**altered) ? std::move(altered) : std::move(plain);
}

Result<SessionVerdict> verified(const std::string& path, const std::string& expectedHead, bool isAlone,
                                const ShareDone& told, const std::stop_token& stop) {
    const auto seal = lookAtSeal(path, isAlone, partOf(told, 0.0, kAfterSeal));
    bool isDamaged = !seal && seal.error().code() == MessageCode::SessionDamaged;
    if (!seal && !isDamaged)
        return seal.error();
    tellShare(told, kAfterSeal);
    auto store = openAny(path, isDamaged);
    if (!store && store.error().code() == MessageCode::SessionDamaged && !isDamaged) {
        isDamaged = true;
        store = openAny(path, isDamaged);
    }
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
