#include "engine/base/message_code.h"
#include "engine/session/session_file.h"
#include "engine/session/session_store.h"

#include <QAbstractEventDispatcher>
#include <QDateTime>
#include <QElapsedTimer>
#include <QFile>
#include <QTimer>

#include <nlohmann/json.hpp>

#include <array>
#include <stdexcept>

namespace bask {
namespace {

enum Statement : std::size_t {
    kInsertSample,
    kInsertObjectState,
    kInsertTruth,
    kInsertPose,
    kInsertMotion,
    kInsertSource,
    kInsertSourcePose,
    kInsertCommand,
    kInsertEvent,
    kInsertNote,
    kPutMeta,
};

constexpr std::array kTables{
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID",
    "CREATE TABLE experiment(json TEXT NOT NULL)",
    "CREATE TABLE sample(time_s REAL NOT NULL, object TEXT NOT NULL, measured_K REAL, estimated_K REAL, "
    "rate_K_s REAL, target_K REAL, view_factor REAL)",
    "CREATE TABLE object_state(time_s REAL NOT NULL, object TEXT NOT NULL, lambda1_K_s REAL, lambda2_1_K3s "
    "REAL, "
    "reading_valid INTEGER NOT NULL)",
    "CREATE TABLE truth(time_s REAL NOT NULL, object TEXT NOT NULL, temperature_K REAL)",
    "CREATE TABLE pose(time_s REAL NOT NULL, x_m REAL, y_m REAL, z_m REAL, qw REAL, qx REAL, qy REAL, qz "
    "REAL)",
    "CREATE TABLE motion(time_s REAL NOT NULL, vx_m_s REAL, vy_m_s REAL, vz_m_s REAL, wx_rad_s REAL, "
    "wy_rad_s REAL, "
    "wz_rad_s REAL, smallest_singular_value REAL, limited INTEGER NOT NULL)",
    "CREATE TABLE source(time_s REAL NOT NULL, temperature_K REAL)",
    "CREATE TABLE source_pose(time_s REAL NOT NULL, x_m REAL, y_m REAL, z_m REAL, qw REAL, qx REAL, qy REAL, "
    "qz REAL)",
    "CREATE TABLE command(time_s REAL NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL)",
    "CREATE TABLE event(time_s REAL NOT NULL, code TEXT NOT NULL, args TEXT NOT NULL, text TEXT NOT NULL)",
    "CREATE TABLE note(time_s REAL NOT NULL, text TEXT NOT NULL)",
};

/// In the order of Statement.
constexpr std::array kStatements{
    "INSERT INTO sample VALUES(?, ?, ?, ?, ?, ?, ?)",
    "INSERT INTO object_state VALUES(?, ?, ?, ?, ?)",
    "INSERT INTO truth VALUES(?, ?, ?)",
    "INSERT INTO pose VALUES(?, ?, ?, ?, ?, ?, ?, ?)",
    "INSERT INTO motion VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)",
    "INSERT INTO source VALUES(?, ?)",
    "INSERT INTO source_pose VALUES(?, ?, ?, ?, ?, ?, ?, ?)",
    "INSERT INTO command VALUES(?, ?, ?)",
    "INSERT INTO event VALUES(?, ?, ?, ?)",
    "INSERT INTO note VALUES(?, ?)",
    "INSERT OR REPLACE INTO meta VALUES(?, ?)",
};

std::string nowUtc() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

std::string argsJson(const std::vector<std::string>& args) {
    return nlohmann::json(args).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Tables, header and experiment come into being in one transaction, before the file is switched to its log:
/// what is found under the name is a whole session or none.
Result<void> makeTables(SessionStore& store) {
    std::vector<std::string> statements{
        "PRAGMA synchronous = FULL",
        "PRAGMA cache_size = -512", // it only appends: the usual 2 MB fill for minutes
        "BEGIN IMMEDIATE"};
    for (const char* table : kTables)
        statements.emplace_back(table);
    statements.emplace_back("PRAGMA application_id = ").append(std::to_string(kSessionApplicationId));
    statements.emplace_back("PRAGMA user_version = ").append(std::to_string(kSessionVersion));
    for (const std::string& sql : statements) {
        if (auto done = store.execute(sql); !done)
            return done;
    }
    for (const char* sql : kStatements) {
        if (auto prepared = store.prepare(sql); !prepared)
            return prepared.error();
    }
    return {};
}

Result<void> clearPlace(const std::string& path) {
    auto clear = checkReplaceable(path);
    if (clear)
        clear = removeLog(path);
    if (QFile old(QString::fromStdString(path)); clear && old.exists() && !old.remove())
        return Error(MessageCode::FileUnwritable, path, {old.errorString().toStdString()});
    return clear;
}

} // namespace

struct SessionWriter::Impl {
    std::string path;
    std::unique_ptr<SessionStore> store;
    std::vector<std::string> names;
    bool simulated = false;
    double commitInterval_s = 0.5;
    std::size_t samples = 0;
    bool pending = false; ///< a transaction is open
    QElapsedTimer sinceCommit;
    QTimer timer; ///< commits what was added last when nothing follows it
    std::optional<Error> failed;

    Result<void> check(Result<void> done) {
        if (!done && !failed)
            failed = done.error();
        return done;
    }

    template <class... Values> Result<void> put(Statement statement, Values&&... values) {
        const std::array<SqlValue, sizeof...(Values)> row{SqlValue(std::forward<Values>(values))...};
        return store->run(statement, row);
    }

    /// Runs `insert` inside the open transaction and commits when it is time.
    template <class Insert> Result<void> add(Insert insert) {
        if (failed)
            return *failed;
        if (auto begun = begin(); !begun)
            return check(begun);
        if (auto done = insert(); !done)
            return check(done);
        if (static_cast<double>(sinceCommit.elapsed()) >= 1e3 * commitInterval_s)
            return commit();
        if (!timer.isActive() && QAbstractEventDispatcher::instance() != nullptr)
            timer.start();
        return {};
    }

    Result<void> begin() {
        if (pending)
            return {};
        auto begun = store->execute("BEGIN IMMEDIATE");
        pending = begun.ok();
        return begun;
    }

    Result<void> commit() {
        timer.stop();
        if (failed)
            return *failed;
        sinceCommit.start();
        if (!pending)
            return {};
        pending = false;
        return check(store->execute("COMMIT"));
    }

    Result<void> addObjects(const TraceSample& s) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            const ObjectSample& o = s.objects[i];
            auto done =
                put(kInsertSample, s.time_s, names[i], sqlNumber(o.measured_K), sqlNumber(o.estimated_K),
                    sqlNumber(o.rate_K_s), sqlNumber(o.target_K), sqlNumber(o.viewFactor));
            if (done)
                done = put(kInsertObjectState, s.time_s, names[i], sqlNumber(o.lambda1), sqlNumber(o.lambda2),
                           std::int64_t{o.valid});
            if (done && simulated)
                done = put(kInsertTruth, s.time_s, names[i], sqlNumber(o.true_K));
            if (!done)
                return done;
        }
        return {};
    }

    Result<void> putPose(Statement statement, double time_s, const Vector6d& x) {
        Eigen::Quaterniond q(poseFromCoordinates(x).linear());
        if (q.w() < 0.0)
            q.coeffs() = -q.coeffs();
        return put(statement, time_s, sqlNumber(x[0]), sqlNumber(x[1]), sqlNumber(x[2]), sqlNumber(q.w()),
                   sqlNumber(q.x()), sqlNumber(q.y()), sqlNumber(q.z()));
    }

    Result<void> addRig(const TraceSample& s) {
        auto done = putPose(kInsertPose, s.time_s, s.coordinates);
        const auto& u = s.twist;
        if (done)
            done = put(kInsertMotion, s.time_s, sqlNumber(u[0]), sqlNumber(u[1]), sqlNumber(u[2]),
                       sqlNumber(u[3]), sqlNumber(u[4]), sqlNumber(u[5]), sqlNumber(s.smallestSingularValue),
                       std::int64_t{s.limits.bits});
        if (done)
            done = put(kInsertSource, s.time_s, sqlNumber(s.source_K));
        if (done)
            done = putPose(kInsertSourcePose, s.time_s, s.source);
        return done;
    }
};

SessionWriter::SessionWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

SessionWriter::~SessionWriter() {
    static_cast<void>(m_impl->commit());
}

Result<std::unique_ptr<SessionWriter>> SessionWriter::create(const std::string& path,
                                                             const Experiment& experiment, bool simulated,
                                                             double commitInterval_s) {
    if (auto valid = validate(experiment); !valid)
        return valid.error();
    if (auto clear = clearPlace(path); !clear)
        return clear.error();
    auto store = SessionStore::create(path);
    if (!store)
        return store.error();

    auto impl = std::make_unique<Impl>();
    impl->path = path;
    impl->store = std::move(*store);
    impl->simulated = simulated;
    impl->commitInterval_s = commitInterval_s;
    for (const ObjectSpec& object : experiment.objects)
        impl->names.push_back(object.name);
    auto made = makeTables(*impl->store);
    const std::array<std::pair<const char*, std::string>, 3> facts{
        {{"software", "Bask " BASK_VERSION},
         {"created", nowUtc()},
         {"simulated", simulated ? "true" : "false"}}};
    for (const auto& [key, value] : facts) {
        if (made)
            made = impl->put(kPutMeta, std::string(key), value);
    }
    if (made) {
        const auto insert = impl->store->prepare("INSERT INTO experiment VALUES(?)");
        const std::array<SqlValue, 1> row{experimentToJson(experiment)};
        made = insert ? impl->store->run(*insert, row) : Result<void>(insert.error());
    }
    for (const char* sql : {"COMMIT", "PRAGMA journal_mode = WAL"}) {
        if (made)
            made = impl->store->execute(sql);
    }
    if (!made)
        return made.error();
    impl->sinceCommit.start();
    impl->timer.setSingleShot(true);
    impl->timer.setInterval(static_cast<int>(1e3 * commitInterval_s));
    QObject::connect(&impl->timer, &QTimer::timeout,
                     [raw = impl.get()] { static_cast<void>(raw->commit()); });
    return std::unique_ptr<SessionWriter>(new SessionWriter(std::move(impl)));
}

Result<void> SessionWriter::add(const TraceSample& sample) {
    if (sample.objects.size() != m_impl->names.size())
        throw std::invalid_argument("SessionWriter: a sample needs one entry an object");
    return m_impl->add([&] {
        auto done = m_impl->addObjects(sample);
        if (done)
            done = m_impl->addRig(sample);
        m_impl->samples += done.ok() ? 1 : 0;
        return done;
    });
}

Result<void> SessionWriter::add(const TraceEvent& event) {
    return m_impl->add([&] {
        return m_impl->put(kInsertEvent, event.time_s, std::string(messageName(event.message.code)),
                           argsJson(event.message.args), describe(event.message));
    });
}

Result<void> SessionWriter::add(const TraceNote& note) {
    return m_impl->add([&] { return m_impl->put(kInsertNote, note.time_s, note.text); });
}

Result<void> SessionWriter::add(const CommandRow& command) {
    return m_impl->add(
        [&] { return m_impl->put(kInsertCommand, command.time_s, command.name, command.value); });
}

Result<void> SessionWriter::flush() {
    return m_impl->commit();
}

Result<void> SessionWriter::finish(const std::string& outcome) {
    auto done = m_impl->add([&] { return m_impl->put(kPutMeta, std::string("outcome"), outcome); });
    if (done)
        done = m_impl->add([&] { return m_impl->put(kPutMeta, std::string("finished"), nowUtc()); });
    return done ? flush() : done;
}

const std::string& SessionWriter::path() const {
    return m_impl->path;
}

std::size_t SessionWriter::rows() const {
    return m_impl->samples;
}

} // namespace bask
