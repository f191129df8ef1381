#include "engine/recording/session_facts.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recording/recorded_prediction.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace bask {
namespace {

using Row = SessionStore::Row;

constexpr int kMaxEqualTimes = 10; // samples of one moment; no run has more than two

class FactsReader {
public:
    FactsReader(const SessionStore& store, SessionRecord& record) : m_store(store), m_record(record) {}

    Result<void> all() {
        for (const auto part : {&FactsReader::meta, &FactsReader::experiment, &FactsReader::objects,
                                &FactsReader::log, &FactsReader::prediction}) {
            if (auto done = (this->*part)(); !done)
                return done;
        }
        return {};
    }

private:
    Result<void> meta() {
        std::map<std::string, std::string> facts;
        const auto done = m_store.select("SELECT key, value FROM meta",
                                         [&](Row row) { facts[textOf(row[0])] = printable(textOf(row[1])); });
        m_record.created = facts["created"];
        m_record.finished = facts["finished"];
        m_record.software = facts["software"];
        m_record.simulated = facts["simulated"] == "true";
        m_record.labels = {facts["operator"], facts["sample"], facts["batch"]};
        m_record.outcome = facts["outcome"];
        if (done && !m_record.simulated && facts["simulated"] != "false")
            return Error(MessageCode::SessionDamaged, m_record.path,
                         {"it does not say whether the rig was simulated"});
        return done;
    }

    Result<void> experiment() {
        std::string json;
        if (auto done =
                m_store.select("SELECT json FROM experiment", [&](Row row) { json = textOf(row[0]); });
            !done)
            return done;
        const std::string folder = std::filesystem::path(m_record.path).parent_path().string();
        auto read = experimentFromJson(json, m_record.path + ": experiment", folder);
        if (!read)
            return read.error();
        m_record.experiment = std::move(*read);
        return {};
    }

    /// The rows of `object` are the experiment's objects.
    Result<void> objects() {
        if (m_store.version() < 2)
            return {};
        std::size_t count = 0;
        bool isSame = true;
        const auto& objects = m_record.experiment.objects;
        auto done = m_store.select("SELECT number, name FROM object ORDER BY number", [&](Row row) {
            isSame = isSame && count < objects.size() && numberOf(row[0]) == static_cast<double>(count + 1) &&
                     textOf(row[1]) == objects[count].name;
            ++count;
        });
        if (done && (!isSame || count != objects.size()))
            return Error(MessageCode::SessionDamaged, m_record.path,
                         {"its objects are not those of its experiment"});
        return done;
    }

    Result<void> log() {
        bool isPossible = true;
        const auto timeOf = [&](Row row) {
            const double time_s = numberOf(row[0]);
            isPossible = isPossible && std::isfinite(time_s);
            return time_s;
        };
        auto done = m_store.select("SELECT time_s, code, args FROM event ORDER BY rowid", [&](Row row) {
            (void)timeOf(row);
            m_record.events.push_back(eventOf(row));
        });
        if (done)
            done = select("time_s, text", "note", [&](Row row) {
                m_record.notes.push_back({timeOf(row), printable(textOf(row[1])), printable(textOf(row[2]))});
            });
        if (done)
            done = select("time_s, name, value", "command", [&](Row row) {
                m_record.commands.push_back({timeOf(row), printable(textOf(row[1])),
                                             printable(textOf(row[2])), printable(textOf(row[3]))});
            });
        if (done && !isPossible)
            return Error(MessageCode::SessionDamaged, m_record.path,
                         {"an event, a command or a note has a time that is none"});
        return done;
    }

    Result<void> prediction() {
        std::vector<std::string> names;
        for (const ObjectSpec& object : m_record.experiment.objects)
            names.push_back(object.name);
        auto read = readPrediction(m_store, names);
        if (!read)
            return read.error();
        m_record.prediction = std::move(*read);
        return {};
    }

    /// The columns, and then the operator, whom files did not name before.
    Result<void> select(const std::string& columns, const std::string& table,
                        const std::function<void(Row)>& take) const {
        const auto found = m_store.columns(table);
        if (!found)
            return found.error();
        const bool isNamed = std::ranges::find(*found, "operator") != found->end();
        return m_store.select("SELECT " + columns + (isNamed ? ", operator" : ", ''") + " FROM " + table +
                                  " ORDER BY rowid",
                              take);
    }

    const SessionStore& m_store;
    SessionRecord& m_record;
};

} // namespace

Result<SessionRecord> readFacts(const SessionStore& store, const std::string& path) {
    SessionRecord record;
    record.path = path;
    if (auto done = FactsReader(store, record).all(); !done)
        return done.error();
    return record;
}

TraceEvent eventOf(Row row) {
    TraceEvent event{numberOf(row[0]), {messageCodeFromName(textOf(row[1])), {}}};
    const auto args = nlohmann::json::parse(textOf(row[2]), nullptr, false);
    for (const auto& arg : args) {
        if (arg.is_string())
            event.message.args.push_back(printable(arg.get<std::string>()));
    }
    return event;
}

double roughRows(const SessionStore& store, const std::string& table) {
    double last = 0.0;
    const auto read =
        store.select("SELECT max(rowid) FROM \"" + table + '"', [&](Row row) { last = numberOf(row[0]); });
    return read && last > 0.0 ? last : 0.0;
}

Result<void> checkIntegrity(const SessionStore& store, const std::string& path) {
    std::string verdict;
    const auto done = store.select("PRAGMA quick_check(1)", [&](Row row) { verdict = textOf(row[0]); });
    if (done && verdict != "ok")
        return Error(MessageCode::SessionDamaged, path, {kNotWhole});
    return done;
}

bool SampleTimes::isPossible(double next_s) {
    m_equal = next_s == m_last_s ? m_equal + 1 : 0;
    const bool isPossible = std::isfinite(next_s) && next_s >= m_last_s && m_equal < kMaxEqualTimes;
    m_last_s = next_s;
    return isPossible;
}

Result<void> readSteps(const SessionStore& store, const SessionTables& tables, const std::string& path,
                       std::size_t first, std::size_t last,
                       const std::function<void(const TraceSample&)>& take, const std::stop_token& stop) {
    auto due = static_cast<std::int64_t>(first);
    SampleTimes times;
    bool isWhole = true;
    std::string impossible;
    const auto done = store.select(
        tables.selectSteps() + " WHERE number BETWEEN " + std::to_string(first) + " AND " +
            std::to_string(last) + " ORDER BY number",
        [&](Row row) {
            if (!isWhole || SessionTables::numberOfStep(row) != due) {
                isWhole = false;
                return;
            }
            if (impossible = tables.impossibleIn(row); !impossible.empty()) {
                isWhole = false;
                return;
            }
            const TraceSample sample = tables.sampleOf(row);
            isWhole = times.isPossible(sample.time_s);
            if (!isWhole)
                return;
            ++due;
            take(sample);
        },
        stop);
    if (done && !isWhole)
        return Error(MessageCode::SessionDamaged, path,
                     {"sample " + std::to_string(due) +
                      (impossible.empty() ? " is missing or in the wrong place" : " has " + impossible)});
    return done;
}

} // namespace bask
