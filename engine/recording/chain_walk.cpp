#include "engine/recording/chain_walk.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

namespace bask {
namespace {

constexpr std::size_t kMaxLinkFaults = 100; // of a chain of which the rest is compared

/// Rows that each table has had in the links so far.
using RowCounts = std::array<std::size_t, kChainTables>;

/// The rows of a link as the file has them.
struct LinkRows {
    struct Row {
        ChainTable table;
        std::size_t place;
    };
    std::vector<std::optional<Row>> rows; ///< empty: there is none
    std::size_t strangers = 0;            ///< that do not have the check beside the hash
    std::size_t firstStranger = 0;
    RowCounts after{};
};

class ChainWalker {
public:
    ChainWalker(const std::vector<FileLink>& links, const FileTables& tables)
        : m_links(links), m_tables(tables) {
        for (const ChainTable table : kChainedTables)
            if (isUnordered(table))
                claimRows(table);
    }

    WalkedChain walked(bool isClosed) {
        std::int64_t due = 1;
        for (std::size_t k = 0; k < m_links.size() && m_out.isComparable; ++k) {
            const std::int64_t number = m_links[k].number;
            if (number > due)
                lose(k, {due, number - 1, true});
            if (m_links[k].link)
                look(*m_links[k].link);
            else
                lose(k + 1, {number, number, false});
            due = number + 1;
        }
        if (m_links.empty() || (isClosed && m_links.back().link && isEndUnknown()))
            lose(m_links.size(), {due, due, true});
        return std::move(m_out);
    }

private:
    const FileRows& rowsOf(ChainTable table) const { return m_tables[tableIndex(table)]; }
    const Digest& digestOf(const LinkRows::Row& row) const { return rowsOf(row.table).digests[row.place]; }

    /// Finds the rows of the schema or of meta that a link names, and those that none does.
    void claimRows(ChainTable table) {
        auto& places = m_places[tableIndex(table)];
        const FileRows& rows = rowsOf(table);
        for (std::size_t k = 0; k < rows.digests.size(); ++k)
            places[checkOf(rows.digests[k])] = k;
        std::vector<bool> isNamed(rows.digests.size(), false);
        for (const FileLink& each : m_links)
            if (each.link)
                for (const ChainLink::Entry& entry : each.link->rows)
                    if (entry.table == table) {
                        const auto found = places.find(entry.check);
                        if (found != places.end())
                            isNamed[found->second] = true;
                        else
                            ++m_missing[tableIndex(table)];
                    }
        for (std::size_t k = 0; k < isNamed.size(); ++k)
            if (!isNamed[k])
                m_unnamed[tableIndex(table)].push_back(k);
    }

    /// Whether the rows that end a recording are in no link, as after the last ones were removed.
    bool isEndUnknown() const {
        const auto& unnamed = m_unnamed[tableIndex(ChainTable::Meta)];
        return m_missing[tableIndex(ChainTable::Meta)] == 0 &&
               std::ranges::any_of(unnamed, [&](std::size_t place) {
                   const std::string& key = rowsOf(ChainTable::Meta).names[place].name;
                   return key == "outcome" || key == "finished";
               });
    }

    /// The place of the next row of a table.
    std::optional<std::size_t> placeAfter(const RowCounts& counts, ChainTable table) const {
        const std::size_t count = counts[tableIndex(table)];
        if (table == ChainTable::Step)
            return placeOfSample(rowsOf(table), static_cast<std::int64_t>(count) + 1);
        return count < rowsOf(table).digests.size() ? std::optional(count) : std::nullopt;
    }

    bool hasCheck(ChainTable table, std::optional<std::size_t> place, std::uint32_t check) const {
        return place && checkOf(rowsOf(table).digests[*place]) == check;
    }

    LinkRows rowsOf(const ChainLink& link) const {
        LinkRows out;
        out.after = m_counts;
        std::array<std::size_t, kChainTables> strange{};
        for (const ChainLink::Entry& entry : link.rows) {
            std::optional<std::size_t> place;
            bool isIt = false;
            if (isKnown(entry.table) && isUnordered(entry.table)) {
                const auto& places = m_places[tableIndex(entry.table)];
                const auto& unnamed = m_unnamed[tableIndex(entry.table)];
                if (const auto found = places.find(entry.check); found != places.end())
                    place = found->second;
                isIt = place.has_value();
                if (std::size_t& next = strange[tableIndex(entry.table)]; !isIt && next < unnamed.size())
                    place = unnamed[next++];
            } else if (isKnown(entry.table)) {
                place = placeAfter(out.after, entry.table);
                isIt = hasCheck(entry.table, place, entry.check);
                ++out.after[tableIndex(entry.table)];
            }
            if (!isIt && out.strangers++ == 0)
                out.firstStranger = out.rows.size();
            out.rows.push_back(place ? std::optional(LinkRows::Row{entry.table, *place}) : std::nullopt);
        }
        return out;
    }

    /// The hash of these rows after one of the hashes that the link before may have; empty if one is not
    /// there.
    bool holds(const LinkRows& found, const Digest& hash) const {
        std::vector<Digest> digests;
        for (const auto& row : found.rows) {
            if (!row)
                return false;
            digests.push_back(digestOf(*row));
        }
        return std::ranges::any_of(m_before,
                                   [&](const Digest& before) { return chained(before, digests) == hash; });
    }

    /// Mends a link of which other rows than those that it names have its hash. False: there are none.
    bool mend(ChainLink& link, LinkRows& found) const {
        if (m_before.empty())
            return false;
        if (holds(found, link.hash)) { // other checks
            for (std::size_t k = 0; k < link.rows.size(); ++k)
                link.rows[k].check = checkOf(digestOf(*found.rows[k]));
            return true;
        }
        for (const ChainTable table : kChainedTables) { // another table
            ChainLink other = link;
            other.rows[found.firstStranger].table = table;
            LinkRows rows = rowsOf(other);
            if (rows.strangers == 0 && holds(rows, link.hash)) {
                link = std::move(other);
                found = std::move(rows);
                return true;
            }
        }
        return false;
    }

    void look(ChainLink link) {
        LinkRows found = rowsOf(link);
        const auto index = static_cast<std::uint32_t>(m_out.times_s.size());
        bool isAltered = false;
        if (found.strangers > 0)
            isAltered = mend(link, found);
        else
            isAltered = !m_before.empty() && !holds(found, link.hash);
        std::vector<Digest> digests;
        std::optional<double> first_s;
        double last_s = m_out.times_s.empty() ? NAN : m_out.times_s.back();
        for (std::size_t k = 0; k < link.rows.size(); ++k) {
            const ChainTable table = link.rows[k].table;
            if (isKnown(table))
                m_out.rows[tableIndex(table)].push_back({link.rows[k].check, index, false});
            const auto& row = found.rows[k];
            if (!row || !hasCheck(table, row->place, link.rows[k].check))
                continue;
            digests.push_back(digestOf(*row));
            if (const double time_s = rowsOf(table).times_s[row->place]; !std::isnan(time_s)) {
                first_s = first_s.value_or(time_s);
                last_s = time_s;
            }
        }
        m_out.times_s.push_back(last_s);
        if (isAltered)
            tell({link.number, link.number, false, first_s});
        m_counts = found.after;
        // The next one hangs on the hash that is there, or on the one that was.
        std::vector<Digest> before{link.hash};
        if (isAltered && digests.size() == link.rows.size() && !m_before.empty())
            before.push_back(chained(m_before.front(), digests));
        m_before = std::move(before);
    }

    void tell(LinkFault fault) {
        if (!fault.time_s && !m_out.times_s.empty() && !std::isnan(m_out.times_s.back()))
            fault.time_s = m_out.times_s.back();
        m_out.faults.push_back(fault);
        m_out.isComparable = m_out.faults.size() < kMaxLinkFaults;
    }

    /// Links of unknown rows: of each table, those until the next that is known. `next`: index of the first
    /// link after them.
    void lose(std::size_t next, const LinkFault& fault) {
        tell(fault);
        m_out.hasLost = true;
        m_before.clear();
        const auto index = static_cast<std::uint32_t>(m_out.times_s.size());
        m_out.times_s.push_back(m_out.times_s.empty() ? NAN : m_out.times_s.back());
        for (const ChainTable table : kChainedTables) {
            if (isUnordered(table))
                continue;
            const std::size_t unknown = unknownUntil(nextCheck(next, table), table);
            m_out.rows[tableIndex(table)].insert(m_out.rows[tableIndex(table)].end(), unknown,
                                                 {0, index, true});
            m_counts[tableIndex(table)] += unknown;
        }
    }

    std::optional<std::uint32_t> nextCheck(std::size_t next, ChainTable table) const {
        for (std::size_t k = next; k < m_links.size(); ++k)
            if (m_links[k].link)
                for (const ChainLink::Entry& entry : m_links[k].link->rows)
                    if (entry.table == table)
                        return entry.check;
        return std::nullopt;
    }

    std::size_t unknownUntil(std::optional<std::uint32_t> check, ChainTable table) const {
        const FileRows& rows = rowsOf(table);
        const std::size_t count = m_counts[tableIndex(table)];
        const auto first =
            table == ChainTable::Step
                ? static_cast<std::size_t>(
                      std::ranges::upper_bound(rows.numbers, static_cast<std::int64_t>(count)) -
                      rows.numbers.begin())
                : std::min(count, rows.digests.size());
        const auto from = rows.digests.begin() + static_cast<std::ptrdiff_t>(first);
        if (!check)
            return static_cast<std::size_t>(rows.digests.end() - from);
        const auto found = std::find_if(from, rows.digests.end(),
                                        [&](const Digest& digest) { return checkOf(digest) == *check; });
        return found == rows.digests.end() ? 0 : static_cast<std::size_t>(found - from);
    }

    const std::vector<FileLink>& m_links;
    const FileTables& m_tables;
    std::array<std::unordered_map<std::uint32_t, std::size_t>, kChainTables> m_places; ///< of unordered rows
    std::array<std::vector<std::size_t>, kChainTables> m_unnamed;                      ///< of these
    std::array<std::size_t, kChainTables>
        m_missing{}; ///< rows of these that links name, and that are not there
    RowCounts m_counts{};
    std::vector<Digest> m_before{Digest{}}; ///< hashes that the link before may have; empty: not known
    WalkedChain m_out;
};

} // namespace

std::optional<std::size_t> placeOfSample(const FileRows& samples, std::int64_t number) {
    const auto& numbers = samples.numbers;
    const auto guess = static_cast<std::size_t>(number - 1); // without a gap
    if (number > 0 && guess < numbers.size() && numbers[guess] == number)
        return guess;
    const auto found = std::ranges::lower_bound(numbers, number);
    return found != numbers.end() && *found == number
               ? std::optional(static_cast<std::size_t>(found - numbers.begin()))
               : std::nullopt;
}

WalkedChain walkChain(const std::vector<FileLink>& links, const FileTables& tables, bool isClosed) {
    return ChainWalker(links, tables).walked(isClosed);
}

} // namespace bask
