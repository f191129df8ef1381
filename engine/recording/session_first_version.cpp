// Samples of files of version 1.

#include "engine/base/message_code.h"
#include "engine/recording/session_facts.h"

#include <algorithm>
#include <limits>

namespace bask {
namespace {

using Row = SessionStore::Row;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kPoseColumns = "x_m, y_m, z_m, qw, qx, qy, qz";

/// Reads the tables of one session into a record; the first failure ends it.
class Reader {
public:
    Reader(const SessionStore& store, SessionRecord& record) : m_store(store), m_record(record) {}

    Result<void> all() {
        for (const auto part : {&Reader::poses, &Reader::objects, &Reader::rig}) {
            if (auto done = (this->*part)(); !done)
                return done;
        }
        return {};
    }

private:
    Error damaged(const std::string& words) const {
        return Error(MessageCode::SessionDamaged, m_record.path, {words});
    }

    /// One pose a sample: they make the samples that the other tables fill.
    Result<void> poses() {
        SampleTimes times;
        const auto done = m_store.select(
            std::string("SELECT time_s, ") + kPoseColumns + " FROM pose ORDER BY rowid", [&](Row row) {
                const std::size_t number = m_record.samples.size() + 1;
                check(number, impossibleNumbers(row));
                check(number, impossiblePose(row.subspan(1)));
                TraceSample sample;
                sample.time_s = numberOf(row[0]);
                check(number, times.isPossible(sample.time_s) ? "" : "a time that is none");
                sample.coordinates = coordinatesOfColumns(row.subspan(1));
                sample.source = m_record.experiment.source.pose;
                sample.objects.resize(m_record.experiment.objects.size());
                forgetLater(kRunColumns, sample);
                for (ObjectSample& object : sample.objects)
                    forgetLater(kObjectColumns, object);
                m_record.samples.push_back(std::move(sample));
            });
        return afterChecks(done);
    }

    /// Keeps the first thing that no run records.
    void check(std::size_t sample, const std::string& impossible) {
        if (m_impossible.empty() && !impossible.empty())
            m_impossible = "sample " + std::to_string(sample) + " has " + impossible;
    }
    Result<void> afterChecks(const Result<void>& done) const {
        return done && !m_impossible.empty() ? Result<void>(damaged(m_impossible)) : done;
    }

    /// Makes unknown what this version does not have, or only of some rigs.
    template <class Sample, std::size_t N>
    static void forgetLater(const std::array<SampleColumn<Sample>, N>& columns, Sample& sample) {
        for (const SampleColumn<Sample>& column : columns)
            if (column.stored.isLater || column.needs != Needs::Nothing)
                column.value.set(sample, kUnknown);
    }

    /// Calls fill(sample, object, row) for each row of a table with one row a sample and object, in order.
    template <class Fill>
    Result<void> eachObject(const std::string& table, const std::string& columns, Fill fill) {
        const auto& objects = m_record.experiment.objects;
        std::size_t count = 0;
        bool matches = true;
        const std::string sql = "SELECT time_s, object, " + columns + " FROM " + table + " ORDER BY rowid";
        const auto done = m_store.select(sql, [&](Row row) {
            const std::size_t k = count / objects.size();
            const std::size_t i = count++ % objects.size();
            matches = matches && k < m_record.samples.size() &&
                      numberOf(row[0]) == m_record.samples[k].time_s && textOf(row[1]) == objects[i].name;
            check(k + 1, impossibleNumbers(row.subspan(2)));
            if (matches)
                fill(m_record.samples[k].objects[i], row.subspan(2));
        });
        if (done && (!matches || count != m_record.samples.size() * objects.size()))
            return damaged("the rows of table " + table + " do not go with the poses");
        return afterChecks(done);
    }

    /// Same for a table with one row a sample.
    template <class Fill>
    Result<void> eachSample(const std::string& table, const std::string& columns, Fill fill) {
        std::size_t count = 0;
        bool matches = true;
        const std::string sql = "SELECT time_s, " + columns + " FROM " + table + " ORDER BY rowid";
        const auto done = m_store.select(sql, [&](Row row) {
            const std::size_t k = count++;
            matches =
                matches && k < m_record.samples.size() && numberOf(row[0]) == m_record.samples[k].time_s;
            check(k + 1, impossibleNumbers(row.subspan(1)));
            if (matches)
                fill(m_record.samples[k], row.subspan(1));
        });
        if (done && (!matches || count != m_record.samples.size()))
            return damaged("the rows of table " + table + " do not go with the poses");
        return afterChecks(done);
    }

    /// Names of a table's columns, which were all there already, and what each fills.
    template <class Sample, std::size_t N>
    static std::string columnsOf(const std::string& table, const std::array<SampleColumn<Sample>, N>& all,
                                 std::vector<const SampleColumn<Sample>*>& out) {
        std::string names;
        for (const SampleColumn<Sample>& column : all)
            if (column.stored.place > 0 && column.stored.view == table && !column.stored.isLater) {
                names += std::string(names.empty() ? "" : ", ") + column.nameInView();
                out.push_back(&column);
            }
        return names;
    }
    template <class Sample>
    void fill(const std::vector<const SampleColumn<Sample>*>& columns, Sample& sample, Row row) {
        for (std::size_t k = 0; k < columns.size(); ++k) {
            columns[k]->value.set(sample, numberOf(row[k]));
            if (const std::string words = impossibleValue(*columns[k], numberOf(row[k])); !words.empty())
                m_impossible = m_impossible.empty() ? "a sample has " + words : m_impossible;
        }
    }

    Result<void> objects() {
        for (const std::string& table : storedViews(kObjectColumns)) {
            if (table == "truth" && !m_record.simulated)
                continue;
            std::vector<const ObjectColumn*> columns;
            const std::string names = columnsOf(table, kObjectColumns, columns);
            if (columns.empty()) // a table that came later
                continue;
            auto done =
                eachObject(table, names, [&](ObjectSample& object, Row row) { fill(columns, object, row); });
            if (!done)
                return done;
        }
        return {};
    }

    Result<void> rig() {
        for (const std::string& table : storedViews(kRunColumns)) {
            std::vector<const RunColumn*> columns;
            const std::string names = columnsOf(table, kRunColumns, columns);
            auto done =
                eachSample(table, names, [&](TraceSample& sample, Row row) { fill(columns, sample, row); });
            if (!done)
                return done;
        }
        Result<void> done;
        const auto tables = m_store.tables();
        if (!tables)
            return tables.error();
        if (std::ranges::find(*tables, "source_pose") != tables->end()) // later than the first files
            done = eachSample("source_pose", kPoseColumns, [&](TraceSample& sample, Row row) {
                if (m_impossible.empty() && !impossiblePose(row).empty())
                    m_impossible = "a sample has " + impossiblePose(row);
                sample.source = coordinatesOfColumns(row);
            });
        return done;
    }

    const SessionStore& m_store;
    SessionRecord& m_record;
    std::string m_impossible; ///< in words
};

} // namespace

Result<void> readFirstVersion(const SessionStore& store, SessionRecord& record) {
    return Reader(store, record).all();
}

} // namespace bask
