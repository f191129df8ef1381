#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/session_facts.h"
#include "engine/recording/session_header.h"
#include "engine/recording/session_seal.h"

#include <QFile>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include <unistd.h>

namespace bask {
namespace {

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

/// A copy of a sealed session is sealed anew.
Result<void> sealCopy(const std::string& path) {
    {
        const auto store = SessionStore::create(path);
        if (!store)
            return store.error();
        const auto hasSeal = (*store)->hasTable("seal");
        if (!hasSeal)
            return hasSeal.error();
        bool isClosed = false;
        Result<void> done;
        if (*hasSeal)
            done = (*store)->select("SELECT 1 FROM seal", [&](SessionStore::Row) { isClosed = true; });
        if (done && isClosed)
            done = (*store)->execute("BEGIN");
        if (done && isClosed)
            done = makeSeal(**store);
        if (done && isClosed)
            done = (*store)->execute("COMMIT");
        if (!done)
            return done;
    }
    return sealSession(path);
}

constexpr double kStructure = 0.15; // of the reading: the look at all pages of the file
constexpr auto kLast = static_cast<std::size_t>(std::numeric_limits<std::int64_t>::max());

/// Reads the whole of a session, its samples of version 2 one by one into `take`, those of version 1 into the
/// record.
Result<SessionRecord> readAll(const std::string& path,
                              const std::function<void(SessionRecord&, const TraceSample&)>& take,
                              const std::stop_token& stop, const ShareDone& told) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    // One transaction, so that all tables are seen at the same moment of a run that is still being recorded.
    auto done = (*store)->execute("BEGIN");
    if (done)
        done = checkIntegrity(**store, path);
    if (!done)
        return done.error();
    auto record = readFacts(**store, path);
    if (!record)
        return record;
    tellShare(told, kStructure);
    ShareCount count(partOf(told, kStructure, 1.0), roughRows(**store, "step"));
    if ((*store)->version() < 2)
        done = readFirstVersion(**store, *record);
    else if (const auto tables = SessionTables::of(**store, *record))
        done = readSteps(
            **store, *tables, path, 1, kLast,
            [&](const TraceSample& sample) {
                take(*record, sample);
                count.add();
            },
            stop);
    else
        done = tables.error();
    if (!done)
        return done.error();
    tellShare(told, 1.0);
    return record;
}

/// Null if there was none.
const TraceEvent* runEnd(const SessionRecord& facts) {
    const auto stop = std::ranges::find_if(facts.events, [](const TraceEvent& event) {
        return event.time_s >= 0.0 && std::ranges::find(runEnds(), event.message.code) != runEnds().end();
    });
    return stop == facts.events.end() ? nullptr : &*stop;
}

} // namespace

Result<SessionRecord> readSession(const std::string& path, const ShareDone& done) {
    return readAll(
        path, [](SessionRecord& record, const TraceSample& sample) { record.samples.push_back(sample); }, {},
        done);
}

Result<void> readSamples(const std::string& path, const std::function<void(const TraceSample&)>& take,
                         const std::stop_token& stop, const ShareDone& done) {
    const auto record = readAll(
        path, [&](SessionRecord&, const TraceSample& sample) { take(sample); }, stop, done);
    if (!record)
        return record.error();
    std::ranges::for_each(record->samples, take);
    return {};
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
    const auto seal = lookAtSeal(from);
    if (!seal)
        return seal.error();
    const auto hidden = HiddenFolder::in(folderOfFile(to));
    if (!hidden)
        return Error(MessageCode::FileUnwritable, to, hidden.error().message.args);
    const QString part = QString::fromStdString(hidden->place("session.bask"));
    auto copied = (*store)->execute("VACUUM INTO " + sqlText(part.toStdString()));
    if (!copied)
        copied = Error(MessageCode::FileUnwritable, to, {describe(copied.error().message)});
    if (copied)
        copied = putInPlace(part, to);
    if (copied && mayBeSealed(*seal)) // its pages lie in another order
        copied = sealCopy(to);
    return copied;
}

std::span<const MessageCode> runEnds() {
    static constexpr std::array kEnds{MessageCode::EventStopped, MessageCode::EventStoppedFor,
                                      MessageCode::EventEmergencyStop};
    return kEnds;
}

double controlledUntil_s(const SessionRecord& facts) {
    const TraceEvent* const stop = runEnd(facts);
    return stop == nullptr ? std::numeric_limits<double>::infinity() : stop->time_s;
}

int endPriority(const Message& end) {
    const auto cause = end.code == MessageCode::EventStoppedFor ? messageWithin(end) : std::nullopt;
    return cause ? alarmPriority(cause->code) : 0;
}

int endPriority(const SessionRecord& facts) {
    const TraceEvent* const stop = runEnd(facts);
    return stop == nullptr ? 0 : endPriority(stop->message);
}

std::optional<double> startedUtc_s(const SessionRecord& facts) {
    constexpr double kMax_s = 1e12; // beyond it is no time
    const auto start = std::ranges::find(facts.commands, "start", &CommandRow::name);
    if (start == facts.commands.end())
        return std::nullopt;
    const auto told = nlohmann::json::parse(start->value, nullptr, false);
    const auto at = told.is_object() ? told.find("started_utc_s") : told.end();
    if (at == told.end() || !at->is_number())
        return std::nullopt;
    const auto time_s = at->get<double>();
    return std::abs(time_s) < kMax_s ? std::optional(time_s) : std::nullopt;
}

bool isCutAfterStop(const SessionRecord& facts) {
    return (facts.interrupted() || facts.outcome == kOutcomeInterrupted) &&
           std::isfinite(controlledUntil_s(facts));
}

std::vector<TraceSample> SessionRecord::controlledSamples() const {
    std::vector<TraceSample> out = samples;
    std::erase_if(out, [until_s = controlledUntil_s(*this)](const TraceSample& sample) {
        return sample.time_s > until_s;
    });
    return out;
}

} // namespace bask
