#include "engine/recording/session_store.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/recording/session_file.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace bask {
namespace {

constexpr int kBusyTimeout_ms = 5000;

struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using SqlStatement = std::unique_ptr<sqlite3_stmt, Finalize>;

struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};

QString sideFile(const std::string& path, const char* suffix) {
    return QString::fromStdString(path) + suffix;
}

QString uriOf(const QString& path, const char* options) {
    return QString::fromLatin1(QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath()).toEncoded()) + options;
}

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// `stored`: keeps the texts that are stored otherwise than they are, until the statement has run.
int bind(sqlite3_stmt* statement, int at, const SqlValue& value, std::deque<std::string>& stored) {
    if (const auto* number = std::get_if<double>(&value))
        return sqlite3_bind_double(statement, at, *number);
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return sqlite3_bind_int64(statement, at, *whole);
    if (const auto* text = std::get_if<std::string>(&value)) {
        const std::string& bytes = isAscii(*text) ? *text : stored.emplace_back(storedText(*text));
        return sqlite3_bind_text64(statement, at, bytes.data(), bytes.size(), SQLITE_STATIC, SQLITE_UTF8);
    }
    if (const auto* blob = std::get_if<SqlBlob>(&value))
        return sqlite3_bind_blob64(statement, at, blob->bytes.data(), blob->bytes.size(), SQLITE_STATIC);
    return sqlite3_bind_null(statement, at);
}

SqlValue columnOf(sqlite3_stmt* statement, int k) {
    const int type = sqlite3_column_type(statement, k);
    if (type == SQLITE_FLOAT)
        return sqlite3_column_double(statement, k);
    if (type == SQLITE_INTEGER)
        return std::int64_t{sqlite3_column_int64(statement, k)};
    if (type == SQLITE_NULL)
        return {};
    const void* const bytes =
        type == SQLITE_BLOB ? sqlite3_column_blob(statement, k) : sqlite3_column_text(statement, k);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, k));
    std::string read = size == 0 ? std::string() : std::string(static_cast<const char*>(bytes), size);
    if (type == SQLITE_BLOB)
        return SqlBlob{std::move(read)};
    return isAscii(read) ? std::move(read) : storedText(read); // damage may have made it none
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
    QString stored = QString::fromStdString(text);
    stored.replace(QChar(0xfffe), QChar(0xfffd)).replace(QChar(0xffff), QChar(0xfffd));
    while (stored.startsWith(QChar(0xfeff)))
        stored.remove(0, 1);
    return stored.toStdString();
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
    std::unique_ptr<sqlite3, Close> database;
    std::deque<SqlStatement> statements;
    std::optional<HiddenFolder>
        copy; ///< holds the database that is read instead, where its own folder forbids it

    ~Impl() { close(); }

    void close() {
        statements.clear();
        database.reset();
    }

    Result<void> connect(const QString& file, int flags) {
        close();
        sqlite3* opened = nullptr;
        const int code = sqlite3_open_v2(file.toUtf8().constData(), &opened,
                                         flags | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE, nullptr);
        database.reset(opened);
        if (code != SQLITE_OK)
            return failure();
        sqlite3_busy_timeout(opened, kBusyTimeout_ms);
        if (isDamaged) // SQLite reads what it can of a schema then, and of a file that is cut short
            sqlite3_exec(opened, "PRAGMA writable_schema = ON", nullptr, nullptr, nullptr);
        return {};
    }

    /// Of the last call.
    Error failure() const {
        const int code = sqlite3_errcode(database.get()) & 0xff; // the primary one
        const std::string words = QString::fromUtf8(sqlite3_errmsg(database.get())).trimmed().toStdString();
        if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
            return Error(MessageCode::SessionBusy, path, {words});
        if (writes)
            return Error(MessageCode::FileUnwritable, path, {words});
        if (code == SQLITE_NOTADB)
            return Error(MessageCode::NotASession, path);
        if (code == SQLITE_CANTOPEN || code == SQLITE_READONLY)
            return Error(MessageCode::FileUnreadable, path, {words});
        return Error(MessageCode::SessionDamaged, path, {code == SQLITE_CORRUPT ? kNotWhole : words});
    }

    Result<SqlStatement> prepared(const std::string& sql) const {
        sqlite3_stmt* made = nullptr;
        const int code =
            sqlite3_prepare_v2(database.get(), sql.data(), static_cast<int>(sql.size()), &made, nullptr);
        SqlStatement statement(made);
        if (code != SQLITE_OK)
            return failure();
        return statement;
    }

    Result<void> select(const std::string& sql, const std::function<void(Row)>& row,
                        const std::stop_token& stop) const {
        const auto statement = prepared(sql);
        if (!statement)
            return statement.error();
        std::vector<SqlValue> values(static_cast<std::size_t>(sqlite3_column_count(statement->get())));
        int code = SQLITE_ROW;
        while (!stop.stop_requested() && (code = sqlite3_step(statement->get())) == SQLITE_ROW) {
            for (std::size_t k = 0; k < values.size(); ++k)
                values[k] = columnOf(statement->get(), static_cast<int>(k));
            row(values);
        }
        if (code != SQLITE_ROW && code != SQLITE_DONE)
            return failure();
        return {};
    }

    Result<std::int64_t> pragma(const char* name) const {
        std::int64_t number = 0;
        const auto done = select(std::string("PRAGMA ") + name,
                                 [&](Row row) { number = static_cast<std::int64_t>(numberOf(row[0])); }, {});
        if (!done)
            return done.error();
        return number;
    }
};

SessionStore::SessionStore(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
SessionStore::~SessionStore() = default;

Result<std::unique_ptr<SessionStore>> SessionStore::create(const std::string& path) {
    auto impl = std::make_unique<Impl>();
    impl->path = path;
    impl->writes = true;
    if (auto connected = impl->connect(QFileInfo(QString::fromStdString(path)).absoluteFilePath(),
                                       SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
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
    const QString log = file + QStringLiteral("-wal");
    const bool hasLog = QFileInfo::exists(log);
    if (!hasLog) {
        // Nobody writes: read without locks, so that nothing is left beside the file and any folder will do.
        if (auto header = checkHeader(path, isDamaged, isAltered); !header)
            return header.error();
        if (auto done = impl->connect(uriOf(file, "?immutable=1"), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
            !done)
            return done.error();
    } else if (auto done = impl->connect(file, SQLITE_OPEN_READONLY); !done) {
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
        if (auto done = impl->connect(copied, SQLITE_OPEN_READONLY); !done)
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
    return m_impl->select(sql, [](Row) {}, {});
}

Result<std::size_t> SessionStore::prepare(const std::string& sql) {
    auto statement = m_impl->prepared(sql);
    if (!statement)
        return statement.error();
    m_impl->statements.push_back(std::move(*statement));
    return m_impl->statements.size() - 1;
}

Result<void> SessionStore::run(std::size_t statement, std::span<const SqlValue> values) {
    sqlite3_stmt* const run = m_impl->statements.at(statement).get();
    std::deque<std::string> stored;
    int code = SQLITE_OK;
    for (std::size_t k = 0; k < values.size() && code == SQLITE_OK; ++k)
        code = bind(run, static_cast<int>(k) + 1, values[k], stored);
    while (code == SQLITE_OK || code == SQLITE_ROW)
        code = sqlite3_step(run);
    Result<void> done;
    if (code != SQLITE_DONE)
        done = m_impl->failure();
    sqlite3_reset(run);
    sqlite3_clear_bindings(run);
    return done;
}

Result<void> SessionStore::select(const std::string& sql, const std::function<void(Row)>& row,
                                  const std::stop_token& stop) const {
    return m_impl->select(sql, row, stop);
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
