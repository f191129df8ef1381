#include "engine/recording/session_store.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/recording/session_file.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlField>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QUrl>
#include <QVariant>

#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

namespace bask {
namespace {

constexpr int kBusyTimeout_ms = 5000;

/// SQLite's primary result codes that mean something to a person.
enum SqliteCode {
    kBusy = 5,
    kLocked = 6,
    kReadOnly = 8,
    kCorrupt = 11,
    kCannotOpen = 14,
    kNotADatabase = 26
};

int sqliteCode(const QSqlError& error) {
    return error.nativeErrorCode().toInt() & 0xff;
}

std::string words(const QSqlError& error) {
    const QString text = error.databaseText().isEmpty() ? error.driverText() : error.databaseText();
    return text.trimmed().toStdString();
}

QString sideFile(const std::string& path, const char* suffix) {
    return QString::fromStdString(path) + suffix;
}

QString uriOf(const QString& path, const char* options) {
    return QString::fromLatin1(QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath()).toEncoded()) + options;
}

QString storedQString(const std::string& text) {
    QString stored = QString::fromStdString(text);
    stored.replace(QChar(0xfffe), QChar(0xfffd)).replace(QChar(0xffff), QChar(0xfffd));
    while (stored.startsWith(QChar(0xfeff)))
        stored.remove(0, 1);
    return stored;
}

QVariant toVariant(const SqlValue& value) {
    if (const auto* number = std::get_if<double>(&value))
        return *number;
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return static_cast<qlonglong>(*whole);
    if (const auto* text = std::get_if<std::string>(&value))
        return storedQString(*text);
    if (const auto* blob = std::get_if<SqlBlob>(&value))
        return QByteArray::fromStdString(blob->bytes);
    return {};
}

SqlValue fromVariant(const QVariant& value) {
    if (value.isNull())
        return {};
    if (value.typeId() == QMetaType::Double)
        return value.toDouble();
    if (value.typeId() == QMetaType::LongLong || value.typeId() == QMetaType::Int)
        return std::int64_t{value.toLongLong()};
    if (value.typeId() == QMetaType::QByteArray)
        return SqlBlob{value.toByteArray().toStdString()};
    return value.toString().toStdString();
}

} // namespace

SqlValue sqlNumber(double value) {
    return std::isnan(value) ? SqlValue{} : SqlValue{value};
}

double numberOf(const SqlValue& value) {
    if (const auto* number = std::get_if<double>(&value))
        return *number;
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    return std::numeric_limits<double>::quiet_NaN();
}

std::string storedText(const std::string& text) {
    return storedQString(text).toStdString();
}

std::string textOf(const SqlValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text == nullptr ? std::string{} : *text;
}

std::string sqlText(const std::string& text) {
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

struct SessionStore::Impl {
    std::string path;
    bool writes = false;
    bool isDamaged = false;
    bool isMarked = true;
    int version = kSessionVersion;
    QString connection;
    QSqlDatabase database;
    std::deque<QSqlQuery> statements;
    std::optional<HiddenFolder>
        copy; ///< holds the database that is read instead, where its own folder forbids it

    ~Impl() { close(); }

    void close() {
        statements.clear();
        if (connection.isEmpty())
            return;
        database.close();
        database = {};
        QSqlDatabase::removeDatabase(connection);
        connection.clear();
    }

    Result<void> connect(const QString& file, const QString& options) {
        static std::atomic<unsigned> counter{0};
        close();
        connection = QStringLiteral("bask-session-%1").arg(++counter);
        database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), connection);
        database.setDatabaseName(file);
        database.setConnectOptions(options + QStringLiteral(";QSQLITE_BUSY_TIMEOUT=%1").arg(kBusyTimeout_ms));
        if (!database.open())
            return failure(database.lastError());
        if (isDamaged) // SQLite reads what it can of a schema then, and of a file that is cut short
            QSqlQuery(database).exec(QStringLiteral("PRAGMA writable_schema = ON"));
        return {};
    }

    Error failure(const QSqlError& error) const {
        const int code = sqliteCode(error);
        if (code == kBusy || code == kLocked)
            return Error(MessageCode::SessionBusy, path, {words(error)});
        if (writes)
            return Error(MessageCode::FileUnwritable, path, {words(error)});
        if (code == kNotADatabase)
            return Error(MessageCode::NotASession, path);
        if (code == kCannotOpen || code == kReadOnly)
            return Error(MessageCode::FileUnreadable, path, {words(error)});
        return Error(MessageCode::SessionDamaged, path, {code == kCorrupt ? kNotWhole : words(error)});
    }

    Result<std::int64_t> pragma(const char* name) {
        QSqlQuery query(database);
        if (!query.exec(QStringLiteral("PRAGMA ") + QLatin1String(name)) || !query.next())
            return failure(query.lastError());
        return std::int64_t{query.value(0).toLongLong()};
    }
};

SessionStore::SessionStore(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
SessionStore::~SessionStore() = default;

Result<std::unique_ptr<SessionStore>> SessionStore::create(const std::string& path) {
    auto impl = std::make_unique<Impl>();
    impl->path = path;
    impl->writes = true;
    if (auto connected = impl->connect(QFileInfo(QString::fromStdString(path)).absoluteFilePath(), {});
        !connected)
        return connected.error();
    return std::unique_ptr<SessionStore>(new SessionStore(std::move(impl)));
}

namespace {

// Of SQLite's header, where a file says what it is (https://www.sqlite.org/fileformat2.html, section 1.3).
constexpr qsizetype kHeaderSize = 100, kFractionsAt = 21, kMarkAt = 68;
constexpr std::string_view kMagic("SQLite format 3\0", 16);
constexpr std::string_view kFractions("\x40\x20\x20"); ///< three numbers that are the same in every database
constexpr std::string_view kMark("Bask");              ///< kSessionApplicationId

bool hasAt(const QByteArray& header, qsizetype at, std::string_view bytes) {
    return header.mid(at, static_cast<qsizetype>(bytes.size())).toStdString() == bytes;
}

/// Is it one of the views that Bask makes: columns of `step`, for each object or once?
bool isOwnView(const QString& sql) {
    static const QRegularExpression kBegin(QStringLiteral(
        R"(\ACREATE VIEW (sample|object_state|truth|camera|pose|motion|source|source_pose) AS SELECT [\w ,.+)-]+\z)"));
    static const QRegularExpression kEnd(QStringLiteral(R"(FROM step( CROSS JOIN object)?( WHERE 0)?\z)"));
    const QRegularExpressionMatch end = kEnd.match(sql);
    QString columns = sql.left(end.capturedStart());
    columns.remove(QStringLiteral("ifnull("));
    return end.hasMatch() && kBegin.match(columns).hasMatch() &&
           !columns.contains(QStringLiteral("FROM"), Qt::CaseInsensitive);
}

/// A file from elsewhere must not compute when it is read: a view may never end, a generated column fill the
/// memory.
bool isHarmless(const SqlValue& schemaSql, int version) {
    if (std::holds_alternative<std::monostate>(schemaSql)) // SQLite's own index
        return true;
    if (SessionStore::isPlainTable(textOf(schemaSql)))
        return true;
    const QString sql = QString::fromStdString(textOf(schemaSql));
    return sql.startsWith(QStringLiteral("CREATE INDEX ")) ||
           sql.startsWith(QStringLiteral("CREATE UNIQUE INDEX ")) || (version > 1 && isOwnView(sql));
}

/// Says in words that a database without a log beside it is shorter than its own header says. A file that has
/// a log is not looked at: closing it here would drop the locks of a connection that records into it.
Result<void> checkHeader(const std::string& path, bool mayBeShort, bool mayBeUnmarked) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        return Error(MessageCode::FileUnreadable, path, {file.errorString().toStdString()});
    const QByteArray header = file.read(kHeaderSize);
    const bool isDatabase = hasAt(header, 0, kMagic), isMarked = hasAt(header, kMarkAt, kMark);
    if (!isDatabase && !isMarked)
        return Error(MessageCode::NotASession, path);
    if (header.size() < kHeaderSize)
        return Error(MessageCode::SessionDamaged, path, {"it is cut short"});
    if (!isDatabase || !hasAt(header, kFractionsAt, kFractions))
        return Error(MessageCode::SessionDamaged, path, {kNoHeader});
    const auto big = [&](qsizetype at, int bytes) {
        qint64 value = 0;
        for (int k = 0; k < bytes; ++k)
            value = value * 256 + static_cast<unsigned char>(header[at + k]);
        return value;
    };
    if (!isMarked && !mayBeUnmarked)
        return Error(MessageCode::NotASession, path);
    const qint64 pageSize = big(16, 2) == 1 ? 65536 : big(16, 2);
    const qint64 expected = big(28, 4) * pageSize;
    const bool sizeKnown = big(24, 4) == big(92, 4);
    if (sizeKnown && file.size() < expected && !mayBeShort)
        return Error(MessageCode::SessionDamaged, path, {"it is cut short"});
    return {};
}

} // namespace

Result<std::unique_ptr<SessionStore>> SessionStore::open(const std::string& path) {
    return open(path, Looks::All);
}

Result<std::unique_ptr<SessionStore>> SessionStore::openDamaged(const std::string& path) {
    return open(path, Looks::Damaged);
}

Result<std::unique_ptr<SessionStore>> SessionStore::openAltered(const std::string& path) {
    return open(path, Looks::Altered);
}

bool SessionStore::isPlainTable(const std::string& sql) {
    static const QRegularExpression kGenerated(QStringLiteral(R"(\bAS\b)"),
                                               QRegularExpression::CaseInsensitiveOption);
    return sql.starts_with("CREATE TABLE ") && !kGenerated.match(QString::fromStdString(sql)).hasMatch();
}

Result<std::unique_ptr<SessionStore>> SessionStore::open(const std::string& path, Looks looks) {
    const bool isDamaged = looks == Looks::Damaged, isAltered = looks == Looks::Altered;
    const QFileInfo info(QString::fromStdString(path));
    const QString file =
        info.canonicalFilePath(); // the log lies beside the file itself, not beside a link to it
    if (!info.exists())
        return Error(MessageCode::FileNotFound, path);
    if (!info.isFile())
        return Error(MessageCode::FileUnreadable, path, {"not a file"});
    if (info.size() == 0)
        return Error(MessageCode::NotASession, path);

    auto impl = std::make_unique<Impl>();
    impl->path = path;
    impl->isDamaged = isDamaged;
    const QString readOnly = QStringLiteral("QSQLITE_OPEN_READONLY");
    const QString log = file + QStringLiteral("-wal");
    const bool hasLog = QFileInfo::exists(log);
    if (!hasLog) {
        // Nobody writes: read without locks, so that nothing is left beside the file and any folder will do.
        if (auto header = checkHeader(path, isDamaged, isAltered); !header)
            return header.error();
        if (auto done = impl->connect(uriOf(file, "?immutable=1"), readOnly + ";QSQLITE_OPEN_URI"); !done)
            return done.error();
    } else if (auto done = impl->connect(file, readOnly); !done) {
        return done.error();
    }

    auto applicationId = impl->pragma("application_id");
    if (!applicationId && hasLog && applicationId.error().code() == MessageCode::FileUnreadable) {
        // The log must be replayed, which needs a folder that can be written: replay it in a copy.
        auto temporary = HiddenFolder::temporary();
        if (!temporary)
            return applicationId.error();
        impl->copy.emplace(std::move(*temporary));
        const QString copied = QString::fromStdString(impl->copy->place("session.bask"));
        if (!QFile::copy(file, copied) || !QFile::copy(log, copied + "-wal"))
            return applicationId.error();
        if (auto done = impl->connect(copied, readOnly); !done)
            return done.error();
        applicationId = impl->pragma("application_id");
    }
    if (!applicationId)
        return applicationId.error();
    impl->isMarked = *applicationId == kSessionApplicationId;
    if (!impl->isMarked && !isAltered)
        return Error(MessageCode::NotASession, path);
    const auto version = impl->pragma("user_version");
    if (!version)
        return version.error();
    const bool isPossible = *version > 0 && *version <= kSessionVersion + kMaxVersionsToCome;
    if (!isPossible && !isDamaged)
        return Error(MessageCode::SessionDamaged, path, {kNoVersion});
    if (isPossible && *version > kSessionVersion && !isAltered)
        return Error(MessageCode::VersionTooNew, path,
                     {std::to_string(*version), std::to_string(kSessionVersion)});
    if (isPossible)
        impl->version = static_cast<int>(*version);
    std::unique_ptr<SessionStore> store(new SessionStore(std::move(impl)));
    if (isAltered)
        return store;
    std::string foreign;
    auto read = store->select("SELECT sql, type, name FROM sqlite_master", [&](Row row) {
        if (!isHarmless(row[0], store->version()))
            foreign = textOf(row[1]) + ' ' + textOf(row[2]);
    });
    // The views have a row for each sample and object: with more objects than a run has they have no end.
    constexpr int kMaxObjects = 6;
    int objects = 0;
    const auto hasObjects = store->hasTable("object");
    if (read && foreign.empty() && hasObjects && *hasObjects)
        read = store->select("SELECT 1 FROM object LIMIT " + std::to_string(kMaxObjects + 1),
                             [&](Row) { ++objects; });
    if (objects > kMaxObjects)
        foreign = "more than " + std::to_string(kMaxObjects) + " objects";
    if (read && !foreign.empty())
        read = Error(MessageCode::SessionDamaged, path, {"Bask does not make this: " + foreign});
    if (!read && !(isDamaged && foreign.empty()))
        return read.error();
    return store;
}

Result<void> SessionStore::execute(const std::string& sql) {
    QSqlQuery query(m_impl->database);
    if (!query.exec(QString::fromStdString(sql)))
        return m_impl->failure(query.lastError());
    return {};
}

Result<std::size_t> SessionStore::prepare(const std::string& sql) {
    QSqlQuery query(m_impl->database);
    if (!query.prepare(QString::fromStdString(sql)))
        return m_impl->failure(query.lastError());
    m_impl->statements.push_back(std::move(query));
    return m_impl->statements.size() - 1;
}

Result<void> SessionStore::run(std::size_t statement, std::span<const SqlValue> values) {
    QSqlQuery& query = m_impl->statements.at(statement);
    for (std::size_t k = 0; k < values.size(); ++k)
        query.bindValue(static_cast<int>(k), toVariant(values[k]));
    if (!query.exec())
        return m_impl->failure(query.lastError());
    return {};
}

Result<void> SessionStore::select(const std::string& sql, const std::function<void(Row)>& row,
                                  const std::stop_token& stop) const {
    QSqlQuery query(m_impl->database);
    query.setForwardOnly(true);
    if (!query.exec(QString::fromStdString(sql)))
        return m_impl->failure(query.lastError());
    std::vector<SqlValue> values(static_cast<std::size_t>(query.record().count()));
    while (!stop.stop_requested() && query.next()) {
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = fromVariant(query.value(static_cast<int>(k)));
        row(values);
    }
    if (query.lastError().isValid())
        return m_impl->failure(query.lastError());
    return {};
}

Result<bool> SessionStore::hasTable(const std::string& name) const {
    bool has = false;
    const auto done = select("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = " + sqlText(name),
                             [&](Row) { has = true; });
    return done ? Result<bool>(has) : done.error();
}

Result<std::vector<std::string>> SessionStore::columns(const std::string& table) const {
    std::vector<std::string> names;
    const auto done =
        select("PRAGMA table_info(\"" + table + "\")", [&](Row row) { names.push_back(textOf(row[1])); });
    if (!done)
        return done.error();
    return names;
}

const std::string& SessionStore::path() const {
    return m_impl->path;
}

int SessionStore::version() const {
    return m_impl->version;
}

bool SessionStore::isMarked() const {
    return m_impl->isMarked;
}

Result<std::vector<std::string>> SessionStore::tables() const {
    std::vector<std::string> names;
    const auto done = select(
        "SELECT name FROM sqlite_master WHERE type IN ('table', 'view') AND name NOT LIKE 'sqlite\\_%' "
        "ESCAPE '\\' AND name NOT IN ('step', 'object', 'target_step', 'overview', 'thermal_frame', 'chain', "
        "'seal') ORDER BY "
        "rowid",
        [&](Row row) { names.push_back(textOf(row[0])); });
    if (!done)
        return done.error();
    return names;
}

Result<void> checkReplaceable(const std::string& path) {
    const QFileInfo info(QString::fromStdString(path));
    if (path.empty() || !QFileInfo(info.absolutePath()).isDir())
        return Error(MessageCode::FileUnwritable, path,
                     {"there is no folder " + info.absolutePath().toStdString()});
    if (info.exists() && !info.isFile())
        return Error(MessageCode::FileUnwritable, path, {"there is something else of that name"});
    if (!info.exists() || info.size() == 0)
        return {};
    const auto old = SessionStore::open(path);
    const bool isSession = old.ok() || old.error().code() == MessageCode::SessionDamaged ||
                           old.error().code() == MessageCode::VersionTooNew;
    if (!isSession)
        return Error(MessageCode::FileUnwritable, path,
                     {"there is a file of that name that is not a Bask session; choose another name"});
    return {};
}

Result<void> removeLog(const std::string& path) {
    if (QFileInfo::exists(sideFile(path, "-wal"))) {
        // Someone who records into the file keeps its log from being folded in.
        std::string mode;
        const auto old = SessionStore::create(path);
        const auto asked = old ? (*old)->select("PRAGMA journal_mode = DELETE",
                                                [&](SessionStore::Row row) { mode = textOf(row[0]); })
                               : Result<void>(old.error());
        if ((!asked && asked.error().code() == MessageCode::SessionBusy) || (asked && mode != "delete"))
            return Error(MessageCode::SessionBusy, path, {"a run is being recorded into it"});
    }
    for (const char* suffix : {"-wal", "-shm", "-journal"}) {
        QFile part(sideFile(path, suffix));
        if (part.exists() && !part.remove())
            return Error(MessageCode::FileUnwritable, path, {part.errorString().toStdString()});
    }
    return {};
}

} // namespace bask
