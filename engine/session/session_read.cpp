#include "engine/base/message_code.h"
#include "engine/session/session_file.h"
#include "engine/session/session_store.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <map>

#include <unistd.h>

namespace bask {
namespace {

using Row = SessionStore::Row;

constexpr const char* kPoseColumns = "x_m, y_m, z_m, qw, qx, qy, qz";

/// Reads the tables of one session into a record; the first failure ends it.
class Reader {
public:
    Reader(const SessionStore& store, SessionRecord& record) : m_store(store), m_record(record) {}

    Result<void> all() {
        for (const auto part : {&Reader::integrity, &Reader::meta, &Reader::experiment, &Reader::poses,
                                &Reader::objects, &Reader::rig, &Reader::log}) {
            if (auto done = (this->*part)(); !done)
                return done;
        }
        return {};
    }

private:
    Error damaged(const std::string& words) const {
        return Error(MessageCode::SessionDamaged, m_record.path, {words});
    }

    Result<void> integrity() {
        std::string verdict;
        const auto done = m_store.select("PRAGMA quick_check(1)", [&](Row row) { verdict = textOf(row[0]); });
        if (done && verdict != "ok")
            return damaged(verdict);
        return done;
    }

    Result<void> meta() {
        std::map<std::string, std::string> facts;
        const auto done = m_store.select("SELECT key, value FROM meta",
                                         [&](Row row) { facts[textOf(row[0])] = textOf(row[1]); });
        m_record.created = facts["created"];
        m_record.software = facts["software"];
        m_record.simulated = facts["simulated"] == "true";
        m_record.outcome = facts["outcome"];
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

    /// Coordinates of a row's columns kPoseColumns.
    static Vector6d coordinatesOf(Row row) {
        Pose X = Pose::Identity();
        X.translation() << numberOf(row[0]), numberOf(row[1]), numberOf(row[2]);
        const Eigen::Quaterniond q(numberOf(row[3]), numberOf(row[4]), numberOf(row[5]), numberOf(row[6]));
        X.linear() = q.normalized().toRotationMatrix();
        return coordinatesFromPose(X);
    }

    /// One pose a sample: they make the samples that the other tables fill.
    Result<void> poses() {
        return m_store.select(std::string("SELECT time_s, ") + kPoseColumns + " FROM pose ORDER BY rowid",
                              [&](Row row) {
                                  TraceSample sample;
                                  sample.time_s = numberOf(row[0]);
                                  sample.coordinates = coordinatesOf(row.subspan(1));
                                  sample.source = m_record.experiment.source.pose;
                                  sample.objects.resize(m_record.experiment.objects.size());
                                  for (ObjectSample& object : sample.objects)
                                      object.true_K = std::numeric_limits<double>::quiet_NaN();
                                  m_record.samples.push_back(std::move(sample));
                              });
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
            if (matches)
                fill(m_record.samples[k].objects[i], row.subspan(2));
        });
        if (done && (!matches || count != m_record.samples.size() * objects.size()))
            return damaged("the rows of table " + table + " do not go with the poses");
        return done;
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
            if (matches)
                fill(m_record.samples[k], row.subspan(1));
        });
        if (done && (!matches || count != m_record.samples.size()))
            return damaged("the rows of table " + table + " do not go with the poses");
        return done;
    }

    Result<void> objects() {
        auto done = eachObject("sample", "measured_K, estimated_K, rate_K_s, target_K, view_factor",
                               [](ObjectSample& object, Row row) {
                                   object.measured_K = numberOf(row[0]);
                                   object.estimated_K = numberOf(row[1]);
                                   object.rate_K_s = numberOf(row[2]);
                                   object.target_K = numberOf(row[3]);
                                   object.viewFactor = numberOf(row[4]);
                               });
        if (done)
            done = eachObject("object_state", "lambda1_K_s, lambda2_1_K3s, reading_valid",
                              [](ObjectSample& object, Row row) {
                                  object.lambda1 = numberOf(row[0]);
                                  object.lambda2 = numberOf(row[1]);
                                  object.valid = numberOf(row[2]) == 1.0;
                              });
        if (done && m_record.simulated)
            done = eachObject("truth", "temperature_K",
                              [](ObjectSample& object, Row row) { object.true_K = numberOf(row[0]); });
        return done;
    }

    Result<void> rig() {
        auto done = eachSample(
            "motion",
            "vx_m_s, vy_m_s, vz_m_s, wx_rad_s, wy_rad_s, wz_rad_s, smallest_singular_value, limited",
            [](TraceSample& sample, Row row) {
                for (int k = 0; k < 6; ++k)
                    sample.twist[k] = numberOf(row[static_cast<std::size_t>(k)]);
                sample.smallestSingularValue = numberOf(row[6]);
                const double bits = numberOf(row[7]);
                sample.limits.bits = bits >= 0.0 && bits < 4096.0 ? static_cast<unsigned>(bits) : 0U;
            });
        if (done)
            done = eachSample("source", "temperature_K",
                              [](TraceSample& sample, Row row) { sample.source_K = numberOf(row[0]); });
        const auto tables = m_store.tables();
        if (!tables)
            return tables.error();
        if (done && std::ranges::find(*tables, "source_pose") != tables->end()) // later than the first files
            done = eachSample("source_pose", kPoseColumns,
                              [](TraceSample& sample, Row row) { sample.source = coordinatesOf(row); });
        return done;
    }

    Result<void> log() {
        auto done = m_store.select("SELECT time_s, code, args FROM event ORDER BY rowid", [&](Row row) {
            TraceEvent event{numberOf(row[0]), {messageCodeFromName(textOf(row[1])), {}}};
            const auto args = nlohmann::json::parse(textOf(row[2]), nullptr, false);
            for (const auto& arg : args) {
                if (arg.is_string())
                    event.message.args.push_back(arg.get<std::string>());
            }
            m_record.events.push_back(std::move(event));
        });
        if (done)
            done = m_store.select("SELECT time_s, text FROM note ORDER BY rowid", [&](Row row) {
                m_record.notes.push_back({numberOf(row[0]), textOf(row[1])});
            });
        if (done)
            done = m_store.select("SELECT time_s, name, value FROM command ORDER BY rowid", [&](Row row) {
                m_record.commands.push_back({numberOf(row[0]), textOf(row[1]), textOf(row[2])});
            });
        return done;
    }

    const SessionStore& m_store;
    SessionRecord& m_record;
};

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

/// The finished file `part` under its own name, in one step and on the disk.
Result<void> putInPlace(const QString& part, const std::string& path) {
    QFile file(part);
    if (!file.open(QIODevice::ReadWrite) || ::fsync(file.handle()) != 0)
        return Error(MessageCode::FileUnwritable, path, {file.errorString().toStdString()});
    file.close();
    if (auto log = removeLog(path); !log) // an old session's log must not be applied to the new file
        return log;
    std::error_code code;
    std::filesystem::rename(part.toStdString(), path, code);
    if (code)
        return Error(MessageCode::FileUnwritable, path, {code.message()});
    return {};
}

} // namespace

Result<SessionRecord> readSession(const std::string& path) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    SessionRecord record;
    record.path = path;
    // One transaction, so that all tables are seen at the same moment of a run that is still being recorded.
    if (auto begun = (*store)->execute("BEGIN"); !begun)
        return begun.error();
    if (auto done = Reader(**store, record).all(); !done)
        return done.error();
    return record;
}

Result<void> copySession(const std::string& from, const std::string& to) {
    const auto store = SessionStore::open(from);
    if (!store)
        return store.error();
    const QString target = QString::fromStdString(to);
    if (QFileInfo(target).canonicalFilePath() == QFileInfo(QString::fromStdString(from)).canonicalFilePath())
        return {};
    if (auto place = checkReplaceable(to); !place)
        return place;
    const QString part = target + QStringLiteral(".part");
    QFile::remove(part);
    auto copied = (*store)->execute("VACUUM INTO " + quoted(part.toStdString()));
    if (!copied)
        copied = Error(MessageCode::FileUnwritable, to, {describe(copied.error().message)});
    if (copied)
        copied = putInPlace(part, to);
    if (!copied)
        QFile::remove(part);
    return copied;
}

std::vector<TraceSample> SessionRecord::controlledSamples() const {
    const auto stop = std::ranges::find_if(events, [](const TraceEvent& event) {
        return event.message.code == MessageCode::EventStopped ||
               event.message.code == MessageCode::EventEmergencyStop;
    });
    std::vector<TraceSample> out = samples;
    if (stop != events.end())
        std::erase_if(out, [&](const TraceSample& sample) { return sample.time_s > stop->time_s; });
    return out;
}

} // namespace bask
