#include "engine/recording/session_header.h"

#include "engine/base/edge_units.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/row_chain.h"
#include "engine/recording/session_facts.h"
#include "engine/recording/session_seal.h"
#include "engine/recording/session_store.h"

#include <QDir>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <thread>

namespace bask {
namespace {

using Row = SessionStore::Row;

// A page that shows the file lets it go within a second.
constexpr const char* kTags = "tags";
constexpr int kTries = 10;
constexpr std::chrono::milliseconds kBetweenTries(200);

// A list reads whatever lies in its folder: no more of it than fits the memory.
constexpr const char* kSelectMeta = "SELECT key, substr(value, 1, 65536) FROM meta "
                                    "WHERE key IN ('created', 'simulated', 'operator', 'sample', 'batch', "
                                    "'outcome', 'tags') LIMIT 7";
constexpr const char* kSelectExperiment =
    "SELECT json FROM experiment WHERE length(json) < 16777216 ORDER BY rowid LIMIT 1";
constexpr const char* kSelectNotes = "SELECT substr(text, 1, 4096) FROM note ORDER BY rowid LIMIT 1000";

/// As controlledUntil_s() finds it.
std::string selectStop() {
    std::string codes;
    for (const MessageCode code : runEnds())
        codes += (codes.empty() ? "" : ", ") + sqlText(messageName(code));
    return "SELECT time_s, code, substr(args, 1, 8192) FROM event WHERE time_s >= 0 AND code IN (" + codes +
           ") ORDER BY rowid LIMIT 1";
}

std::vector<std::string> textsOf(const nlohmann::json& list) {
    std::vector<std::string> texts;
    for (const auto& entry : list)
        if (entry.is_string())
            texts.push_back(printable(entry.get<std::string>()));
    return texts;
}

/// Null for none, also of what is no object.
const nlohmann::json* fieldOf(const nlohmann::json& json, const std::string& key) {
    const auto found = json.find(key);
    return found != json.end() ? &*found : nullptr;
}

std::string textAt(const nlohmann::json& json, const std::string& key) {
    const nlohmann::json* field = fieldOf(json, key);
    return field != nullptr && field->is_string() ? printable(field->get<std::string>()) : std::string();
}

double numberAt(const nlohmann::json& json, const std::string& key) {
    const nlohmann::json* field = fieldOf(json, key);
    return field != nullptr && field->is_number() ? field->get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
}

/// In whichever of its two spellings it stands.
double temperatureAt(const nlohmann::json& json, const std::string& name) {
    const double written = numberAt(json, readableKey(name, EdgeUnit::Temperature));
    return std::isfinite(written) ? toSi(written, EdgeUnit::Temperature)
                                  : numberAt(json, siKey(name, EdgeUnit::Temperature));
}

void takeExperiment(SessionHeader& header, const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    header.title = textAt(json, "title");
    if (const nlohmann::json* controller = fieldOf(json, "controller"))
        header.controller = textAt(*controller, "kind");
    const nlohmann::json* objects = fieldOf(json, "objects");
    if (objects == nullptr || !objects->is_array())
        return;
    for (const nlohmann::json& object : *objects) {
        ListedObject listed{textAt(object, "name"), temperatureAt(object, "target")};
        if (const nlohmann::json* material = fieldOf(object, "material")) {
            listed.material = textAt(*material, "name");
            listed.emittance = numberAt(*material, "emittance");
        }
        if (!listed.name.empty())
            header.objects.push_back(std::move(listed));
    }
}

Result<void> readInto(SessionHeader& header) {
    const auto store = SessionStore::open(header.path);
    if (!store)
        return store.error();
    auto done = (*store)->execute("BEGIN"); // all of one moment
    if (done)
        done = (*store)->select(kSelectMeta, [&](Row row) {
            const std::string key = textOf(row[0]), value = textOf(row[1]);
            if (key == "created")
                header.created = value;
            else if (key == "simulated")
                header.simulated = value == "true";
            else if (key == "operator")
                header.labels.operatorName = printable(value);
            else if (key == "sample")
                header.labels.sample = printable(value);
            else if (key == "batch")
                header.labels.batch = printable(value);
            else if (key == "outcome")
                header.outcome = value;
            else if (key == "tags")
                header.tags = textsOf(nlohmann::json::parse(value, nullptr, false));
        });
    if (done)
        done = (*store)->select(kSelectExperiment, [&](Row row) { takeExperiment(header, textOf(row[0])); });
    if (done)
        done = (*store)->select((*store)->version() < 2
                                    ? "SELECT rowid, time_s FROM pose ORDER BY rowid DESC LIMIT 1"
                                    : "SELECT number, time_s FROM step ORDER BY number DESC LIMIT 1",
                                [&](Row row) {
                                    header.samples = static_cast<std::uint64_t>(numberOf(row[0]));
                                    header.end_s = numberOf(row[1]);
                                });
    if (done)
        done = (*store)->select(selectStop(), [&](Row row) {
            const TraceEvent end = eventOf(row);
            header.stopped_s = end.time_s;
            header.endPriority = endPriority(end.message);
        });
    if (done)
        done = (*store)->select(kSelectNotes,
                                [&](Row row) { header.notes.push_back(printable(textOf(row[0]))); });
    return done;
}

/// Goes on with the chain, if there is one.
Result<void> chainFact(SessionStore& store, std::span<const SqlValue> fact) {
    const auto last = lastLink(store);
    if (!last || !*last)
        return last ? Result<void>() : last.error();
    const auto insert = store.prepare(kInsertLink);
    if (!insert)
        return insert.error();
    RowChain chain((*last)->number, (*last)->hash);
    chain.add(ChainTable::Meta, fact);
    return store.run(*insert, rowOf(chain.takeLink()));
}

/// One entry of `meta`, in a transaction. Always through the log: readers look for that beside the file, not
/// for a rollback journal.
Result<void> putFact(const std::string& path, const std::string& key, const std::string& value,
                     bool isSealed) {
    const auto store = SessionStore::create(path);
    if (!store)
        return store.error();
    for (const char* sql : {"PRAGMA synchronous = FULL", "PRAGMA journal_mode = WAL", "BEGIN IMMEDIATE"}) {
        if (auto done = (*store)->execute(sql); !done)
            return done;
    }
    const auto put = (*store)->prepare("INSERT OR REPLACE INTO meta VALUES(?, ?)");
    if (!put)
        return put.error();
    const std::array<SqlValue, 2> row{key, value};
    auto done = (*store)->run(*put, row);
    if (done && key != kTags)
        done = chainFact(**store, row);
    const auto hasSeal = done ? (*store)->hasTable("seal") : Result<bool>(done.error());
    if (!hasSeal)
        return hasSeal.error();
    if (*hasSeal && isSealed)
        done = makeSeal(**store);
    return done ? (*store)->execute("COMMIT") : done;
}

/// The same, and the seal anew.
Result<void> putFactSealed(const std::string& path, const std::string& key, const std::string& value) {
    const auto seal = lookAtSeal(path);
    if (!seal)
        return seal.error();
    // What was altered is not sealed anew.
    auto done = putFact(path, key, value, mayBeSealed(*seal));
    return done ? sealSession(path) : done;
}

} // namespace

SessionHeader readSessionHeader(const std::string& path) {
    SessionHeader header;
    header.path = path;
    if (const auto done = readInto(header); !done) {
        header = {};
        header.path = path;
        header.error = done.error();
    }
    return header;
}

Result<void> checkSession(const std::string& path) {
    const auto store = SessionStore::open(path);
    return store ? checkIntegrity(**store, path) : store.error();
}

std::vector<std::string> sessionFiles(const std::string& folder) {
    std::vector<std::string> paths;
    const QDir dir(QString::fromStdString(folder));
    for (const QFileInfo& file : dir.entryInfoList({QStringLiteral("*.bask")}, QDir::Files, QDir::NoSort))
        paths.push_back(file.absoluteFilePath().toStdString());
    return paths;
}

Result<void> writeSessionTags(const std::string& path, const std::vector<std::string>& tags) {
    const SessionHeader header = readSessionHeader(path);
    if (header.error)
        return *header.error;
    if (header.outcome.empty())
        return Error(MessageCode::SessionBusy, path, {"its recording has no end"});
    const auto json = nlohmann::json(tags).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return putFactSealed(path, kTags, json);
}

Result<void> closeInterrupted(const std::string& path) {
    if (const auto read = readSamples(path, [](const TraceSample&) {}); !read)
        return read;
    const SessionHeader header = readSessionHeader(path);
    if (header.error)
        return *header.error;
    if (!header.outcome.empty())
        return {};
    auto folded = removeLog(path); // also finds out whether somebody records into it
    for (int tries = 1; tries < kTries && !folded && folded.error().code() == MessageCode::SessionBusy;
         ++tries) {
        std::this_thread::sleep_for(kBetweenTries);
        folded = removeLog(path);
    }
    if (!folded)
        return folded;
    return putFactSealed(path, "outcome", kOutcomeInterrupted);
}

} // namespace bask
