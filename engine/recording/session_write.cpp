#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/base/replaced_files.h"
#include "engine/base/version.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recording/recorded_prediction.h"
#include "engine/recording/row_chain.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_seal.h"
#include "engine/recording/session_store.h"
#include "engine/recording/session_tables.h"
#include "engine/recording/trace_overview.h"
#include "engine/thermography/frame_picture_file.h"

#include <QAbstractEventDispatcher>
#include <QDateTime>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTimer>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr const char* kSoftware = "Bask " BASK_VERSION;

enum Statement : std::size_t {
    kInsertStep,
    kInsertTargetStep,
    kInsertOverview,
    kInsertCommand,
    kInsertEvent,
    kInsertNote,
    kPutMeta,
    kInsertFrame, ///< only of a rig with a thermal camera
};

/// In the order of Statement, after kInsertStep.
constexpr std::array kStatements{
    "INSERT INTO target_step VALUES(?, ?, ?)", "INSERT INTO overview VALUES(?, ?)",
    "INSERT INTO command VALUES(?, ?, ?, ?)",  "INSERT INTO event VALUES(?, ?, ?, ?)",
    "INSERT INTO note VALUES(?, ?, ?)",        "INSERT OR REPLACE INTO meta VALUES(?, ?)",
};

/// In the order of Statement.
constexpr std::array kTables{ChainTable::Step,    ChainTable::TargetStep,  ChainTable::Overview,
                             ChainTable::Command, ChainTable::Event,       ChainTable::Note,
                             ChainTable::Meta,    ChainTable::ThermalFrame};

constexpr const char* kThereIsOne = "there is a recording of that name";
constexpr const char* kCreateTraffic = "CREATE TABLE IF NOT EXISTS traffic(time_s REAL NOT NULL, "
                                       "link TEXT NOT NULL, kind TEXT NOT NULL, bytes BLOB NOT NULL)";
constexpr const char* kInsertTraffic = "INSERT INTO traffic VALUES(?, ?, ?, ?)";
constexpr const char* kCreatePrediction = "CREATE TABLE IF NOT EXISTS prediction(time_s REAL NOT NULL, "
                                          "object TEXT NOT NULL, temperature_K REAL, lowest_K REAL, "
                                          "highest_K REAL)";
constexpr const char* kInsertPrediction = "INSERT INTO prediction VALUES(?, ?, ?, ?, ?)";

std::string nowUtc() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

std::string argsJson(const Message& message) {
    return nlohmann::json(argTexts(message)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<void> executeAll(SessionStore& store, const std::vector<std::string>& statements) {
    for (const std::string& sql : statements) {
        if (auto done = store.execute(sql); !done)
            return done;
    }
    return {};
}

/// In the transaction that it begins.
Result<void> makeTables(SessionStore& store, const SessionTables& tables) {
    std::vector<std::string> statements{
        "PRAGMA page_size = 16384", // a row takes 400 bytes: little is left over at a page's end
        "PRAGMA synchronous = FULL", "BEGIN IMMEDIATE"};
    std::ranges::move(tables.create(), std::back_inserter(statements));
    statements.emplace_back(kCreateChain);
    statements.emplace_back(kCreateSeal);
    statements.emplace_back("PRAGMA application_id = ").append(std::to_string(kSessionApplicationId));
    statements.emplace_back("PRAGMA user_version = ").append(std::to_string(kSessionVersion));
    return executeAll(store, statements);
}

/// In the order of Statement.
Result<void> prepareRows(SessionStore& store, const SessionTables& tables) {
    std::vector<std::string> prepared{tables.insertStep()};
    prepared.insert(prepared.end(), kStatements.begin(), kStatements.end());
    if (tables.hasFrames())
        prepared.emplace_back("INSERT INTO thermal_frame VALUES(?, ?)");
    for (const std::string& sql : prepared) {
        if (auto done = store.prepare(sql); !done)
            return done.error();
    }
    return {};
}

/// The folder, locked while a session is made in it: between the look at what is there and the new file
/// nobody else makes one. Where folders cannot be locked (some network drives) it goes without.
class LockedFolder {
public:
    explicit LockedFolder(const std::string& file)
        : m_folder(::open(QFileInfo(QString::fromStdString(file)).absolutePath().toLocal8Bit().constData(),
                          O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        for (int k = 0; k < kLooks && isTaken(); ++k)
            ::poll(nullptr, 0, kLook_ms);
    }
    ~LockedFolder() {
        if (m_folder >= 0)
            ::close(m_folder);
    }
    LockedFolder(const LockedFolder&) = delete;
    LockedFolder& operator=(const LockedFolder&) = delete;

private:
    static constexpr int kLooks = 250, kLook_ms = 20;

    bool isTaken() const {
        return m_folder >= 0 && ::flock(m_folder, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    }

    int m_folder;
};

/// Whether a new session may be put there; the log of an old one is folded into it.
Result<void> checkPlace(const std::string& path, SessionWriter::Earlier earlier) {
    auto clear = checkReplaceable(path);
    if (clear && earlier == SessionWriter::Earlier::Kept &&
        QFileInfo(QString::fromStdString(path)).size() > 0)
        return Error(MessageCode::FileUnwritable, path, {kThereIsOne});
    return clear ? removeLog(path) : clear;
}

/// Moves a made session to its place. Where nothing may be replaced, a link fails if somebody was quicker,
/// also where folders have no locks.
Result<void> moveInPlace(const std::string& made, const std::string& path, SessionWriter::Earlier earlier,
                         ReplacedFiles& replaced) {
    const QFileInfo old(QString::fromStdString(path));
    const bool isKept = earlier == SessionWriter::Earlier::Kept, isThere = old.exists();
    const Error thereIsOne(MessageCode::FileUnwritable, path, {kThereIsOne});
    if (isKept && isThere && old.size() > 0)
        return thereIsOne;
    if (auto aside = replaced.setAside(path); !aside)
        return aside;
    if (isKept && !isThere) {
        if (::link(made.c_str(), path.c_str()) == 0)
            return {};
        if (errno == EEXIST) {
            replaced.keepNew(); // what is there is somebody else's
            return thereIsOne;
        }
    }
    return ::rename(made.c_str(), path.c_str()) == 0
               ? Result<void>()
               : Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
}

} // namespace

struct SessionWriter::Impl {
    Impl(const Experiment& experiment, bool simulated)
        : tables(experiment, simulated), profile(thermalProfile(experiment, simulated)),
          targets_K(experiment.objects.size()), overview(experiment.objects.size()) {
        for (const ObjectSpec& object : experiment.objects)
            names.push_back(object.name);
    }

    std::string path;
    std::unique_ptr<SessionStore> store;
    SessionTables tables;
    std::optional<ThermalProfile> profile; ///< of the thermal camera
    double commitInterval_s = 0.5;
    std::size_t samples = 0;
    std::vector<std::string> names;               ///< of the objects
    std::vector<std::optional<double>> targets_K; ///< as recorded last
    TraceOverview overview;                       ///< of the samples since the last row of its table
    bool pending = false;                         ///< a transaction is open
    /// Statements, once their tables are there.
    std::optional<std::size_t> insertTraffic, insertPrediction;
    RowChain chain;
    std::size_t insertLink = 0; ///< statement
    bool isFinished = false;
    QElapsedTimer sinceCommit;
    QTimer timer; ///< commits what was added last when nothing follows it
    std::optional<Error> failed;

    Result<void> make(const Experiment& experiment, bool simulated, const RunLabels& labels, Earlier earlier,
                      ReplacedFiles& replaced);
    Result<void> writeBeginning(const Experiment& experiment, bool simulated, const RunLabels& labels);
    Result<void> open();

    Result<void> check(Result<void> done) {
        if (!done && !failed)
            failed = done.error();
        return done;
    }

    template <class... Values> Result<void> put(Statement statement, Values&&... values) {
        const std::array<SqlValue, sizeof...(Values)> row{SqlValue(std::forward<Values>(values))...};
        return insert(statement, kTables[statement], row);
    }

    Result<void> insert(std::size_t statement, ChainTable table, std::span<const SqlValue> row) {
        auto done = store->run(statement, row);
        if (done)
            chain.add(table, row);
        return done;
    }

    /// Chains rows that are there already.
    Result<void> chainRows(ChainTable table) {
        return store->select(selectRows(table), [&](SessionStore::Row row) { chain.add(table, row); });
    }

    /// Makes a table that not every session has, with its link of the chain.
    Result<void> makeTable(ChainTable table, const char* create, const char* insertRow,
                           std::optional<std::size_t>& statement) {
        if (statement)
            return {};
        if (auto made = store->execute(create); !made)
            return made;
        auto chained = store->select(std::string("SELECT type, name, sql FROM sqlite_master WHERE name = '") +
                                         tableName(table) + '\'',
                                     [&](SessionStore::Row row) { chain.add(ChainTable::Schema, row); });
        if (!chained)
            return chained;
        auto prepared = store->prepare(insertRow);
        if (!prepared)
            return prepared.error();
        statement = *prepared;
        return {};
    }

    Result<void> addPrediction(const PredictedRun& run) {
        const bool isFirst = !insertPrediction;
        auto done = makeTable(ChainTable::Prediction, kCreatePrediction, kInsertPrediction, insertPrediction);
        if (done && isFirst)
            done = put(kPutMeta, std::string(kPredictedEndKey), std::string(predictedEndWord(run.end)));
        const auto value = [](const std::vector<double>& of, std::size_t i) {
            return i < of.size() ? sqlNumber(of[i]) : SqlValue();
        };
        for (const PredictedSample& sample : run.samples)
            for (std::size_t i = 0; done && i < names.size(); ++i) {
                const std::array<SqlValue, 5> row{sample.time_s, names[i], value(sample.temperatures_K, i),
                                                  value(sample.lowest_K, i), value(sample.highest_K, i)};
                done = insert(*insertPrediction, ChainTable::Prediction, row);
            }
        return done;
    }

    /// The link of what was added since the last one.
    Result<void> putLink() {
        if (!chain.hasRows())
            return {};
        const auto row = rowOf(chain.takeLink());
        return store->run(insertLink, row);
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
        auto done = putLink();
        return check(done ? store->execute("COMMIT") : done);
    }

    Result<void> addSample(const TraceSample& sample) {
        const auto number = static_cast<std::int64_t>(samples) + 1;
        auto done = insert(kInsertStep, ChainTable::Step, tables.stepRow(number, sample));
        for (std::size_t i = 0; done && i < targets_K.size(); ++i)
            done = addTarget(i, sample);
        if (!done)
            return done;
        ++samples;
        overview.add(sample);
        if (overview.samples() < kSamplesPerOverviewRow)
            return {};
        done = put(kInsertOverview, number, SqlBlob{overview.bytes()});
        overview = TraceOverview(targets_K.size());
        return done;
    }

    Result<void> addTarget(std::size_t object, const TraceSample& sample) {
        const double target_K = sample.objects[object].target_K;
        if (std::isnan(target_K) || targets_K[object] == target_K)
            return {};
        targets_K[object] = target_K;
        return put(kInsertTargetStep, sample.time_s, static_cast<std::int64_t>(object) + 1, target_K);
    }
};

/// Makes the session in a hidden folder and moves it to its place: what is found under the name is a whole
/// session, the old one or the new one, at whatever moment the process is killed.
Result<void> SessionWriter::Impl::make(const Experiment& experiment, bool simulated, const RunLabels& labels,
                                       Earlier earlier, ReplacedFiles& replaced) {
    const auto hidden = HiddenFolder::in(folderOfFile(path));
    if (!hidden)
        return Error(MessageCode::FileUnwritable, path, hidden.error().message.args);
    const std::string part = hidden->place("session.bask");
    auto created = SessionStore::create(part);
    if (!created)
        return Error(created.error().code(), path, created.error().message.args);
    store = std::move(*created);
    const auto made = writeBeginning(experiment, simulated, labels);
    store.reset();
    if (!made)
        return Error(made.error().code(), path, made.error().message.args);
    return moveInPlace(part, path, earlier, replaced);
}

/// Tables, header and experiment, in one transaction.
Result<void> SessionWriter::Impl::writeBeginning(const Experiment& experiment, bool simulated,
                                                 const RunLabels& labels) {
    auto made = makeTables(*store, tables);
    if (made)
        made = prepareRows(*store, tables);
    const std::array<std::pair<const char*, std::string>, 6> facts{
        {{"software", kSoftware},
         {"created", nowUtc()},
         {"simulated", simulated ? "true" : "false"},
         {"operator", labels.operatorName},
         {"sample", labels.sample},
         {"batch", labels.batch}}};
    for (const auto& [key, value] : facts) {
        if (made && !value.empty())
            made = put(kPutMeta, std::string(key), value);
    }
    if (made) {
        const auto insert = store->prepare("INSERT INTO experiment VALUES(?)");
        const std::array<SqlValue, 1> row{experimentToJson(experiment)};
        made = insert ? this->insert(*insert, ChainTable::Experiment, row) : Result<void>(insert.error());
    }
    for (const ChainTable table : {ChainTable::Object, ChainTable::Schema}) {
        if (made)
            made = chainRows(table);
    }
    if (made) {
        const auto insert = store->prepare(kInsertLink);
        insertLink = insert ? *insert : 0;
        made = insert ? putLink() : Result<void>(insert.error());
    }
    return made ? store->execute("COMMIT") : made;
}

/// For the rows that come.
Result<void> SessionWriter::Impl::open() {
    auto created = SessionStore::create(path);
    if (!created)
        return created.error();
    store = std::move(*created);
    auto made =
        executeAll(*store, {"PRAGMA synchronous = FULL",
                            "PRAGMA cache_size = -512", // it only appends: the usual 2 MB fill for minutes
                            "PRAGMA journal_mode = WAL",
                            "PRAGMA wal_autocheckpoint = 256"}); // pages: the log stays at 4 MB
    if (made)
        made = prepareRows(*store, tables);
    if (made) {
        const auto insert = store->prepare(kInsertLink);
        insertLink = insert ? *insert : 0;
        made = insert ? Result<void>() : Result<void>(insert.error());
    }
    if (made) // its log is there from here on: who looks sees that it is being written
        made = store->run(kPutMeta, std::array<SqlValue, 2>{std::string("software"), std::string(kSoftware)});
    return made;
}

SessionWriter::SessionWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

Result<void> SessionWriter::close() {
    if (!m_impl->store)
        return {};
    auto done = m_impl->commit();
    m_impl->store.reset(); // merges its write-ahead log
    return done;
}

SessionWriter::~SessionWriter() {
    static_cast<void>(close());
    if (m_impl->isFinished)
        static_cast<void>(sealSession(m_impl->path)); // where it cannot be, the chain is there
}

Result<std::unique_ptr<SessionWriter>> SessionWriter::create(const std::string& path,
                                                             const Experiment& experiment, bool simulated,
                                                             double commitInterval_s, Earlier earlier,
                                                             const RunLabels& labels) {
    if (auto valid = validate(experiment); !valid)
        return valid.error();
    const LockedFolder folder(path);
    if (auto clear = checkPlace(path, earlier); !clear)
        return clear.error();
    auto impl = std::make_unique<Impl>(experiment, simulated);
    impl->path = path;
    impl->commitInterval_s = commitInterval_s;
    ReplacedFiles replaced; // until the new one can be written
    auto made = impl->make(experiment, simulated, labels, earlier, replaced);
    if (made)
        made = impl->open();
    if (!made) {
        impl->store.reset(); // with its log, before the old one is put back
        return made.error();
    }
    replaced.keepNew();
    impl->sinceCommit.start();
    impl->timer.setSingleShot(true);
    impl->timer.setInterval(static_cast<int>(1e3 * commitInterval_s));
    QObject::connect(&impl->timer, &QTimer::timeout,
                     [raw = impl.get()] { static_cast<void>(raw->commit()); });
    return std::unique_ptr<SessionWriter>(new SessionWriter(std::move(impl)));
}

Result<void> SessionWriter::add(const TraceSample& sample) {
    if (sample.objects.size() != m_impl->targets_K.size())
        throw std::invalid_argument("SessionWriter: a sample needs one entry an object");
    return m_impl->add([&] { return m_impl->addSample(sample); });
}

Result<void> SessionWriter::add(const TraceEvent& event) {
    return m_impl->add([&] {
        return m_impl->put(kInsertEvent, event.time_s, std::string(messageName(event.message.code)),
                           argsJson(event.message), describe(event.message));
    });
}

Result<void> SessionWriter::add(const TraceNote& note) {
    return m_impl->add([&] { return m_impl->put(kInsertNote, note.time_s, note.text, note.operatorName); });
}

Result<void> SessionWriter::add(const CommandRow& command) {
    return m_impl->add([&] {
        return m_impl->put(kInsertCommand, command.time_s, command.name, command.value, command.operatorName);
    });
}

Result<void> SessionWriter::add(const TraceFrame& frame) {
    if (!m_impl->profile)
        throw std::invalid_argument("SessionWriter: a picture of a thermal camera that is not there");
    std::string png = pngOfCounts(countsOfPicture(*frame.picture, *m_impl->profile));
    return m_impl->add([&] { return m_impl->put(kInsertFrame, frame.time_s, SqlBlob{std::move(png)}); });
}

Result<void> SessionWriter::add(const TrafficLine& line, double start_s) {
    return m_impl->add([&]() -> Result<void> {
        if (auto made =
                m_impl->makeTable(ChainTable::Traffic, kCreateTraffic, kInsertTraffic, m_impl->insertTraffic);
            !made)
            return made;
        const std::array<SqlValue, 4> row{line.time_s - start_s, line.link,
                                          std::string(trafficKindWord(line.kind)), SqlBlob{line.bytes}};
        return m_impl->insert(*m_impl->insertTraffic, ChainTable::Traffic, row);
    });
}

Result<void> SessionWriter::add(const PredictedRun& run) {
    return m_impl->add([&] { return m_impl->addPrediction(run); });
}

Result<void> SessionWriter::flush() {
    return m_impl->commit();
}

Result<void> SessionWriter::finish(const std::string& outcome) {
    auto done = m_impl->add([&] {
        auto put = m_impl->put(kPutMeta, std::string("outcome"), outcome);
        if (put)
            put = m_impl->put(kPutMeta, std::string("finished"), nowUtc());
        return put ? makeSeal(*m_impl->store) : put;
    });
    m_impl->isFinished = done.ok();
    return done ? flush() : done;
}

const std::string& SessionWriter::path() const {
    return m_impl->path;
}

std::size_t SessionWriter::rows() const {
    return m_impl->samples;
}

} // namespace bask
