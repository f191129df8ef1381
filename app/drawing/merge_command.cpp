// bask merge: the parts of a divided study or field as the files that one process would have written, or how
// far they are.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/field_blocks.h"
#include "app/drawing/studies.h"
#include "app/studies/shard_run.h"
#include "app/studies/study_output.h"
#include "engine/base/message_code.h"

#include <QCommandLineParser>
#include <QDateTime>
#include <QDir>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <new>
#include <optional>
#include <set>

namespace bask {
namespace {

constexpr const char* kMerge = "merge";

/// A part that is named twice, or is in a folder that is named, too.
std::optional<std::string> namedTwice(const std::vector<std::string>& paths) {
    std::set<QString> known;
    for (const std::string& path : paths) {
        const QString file = QFileInfo(QString::fromStdString(path)).canonicalFilePath();
        if (!file.isEmpty() && !known.insert(file).second)
            return path;
    }
    return std::nullopt;
}

/// The parts that are named, and those in folders that are.
Result<std::vector<std::string>> partsOf(const QStringList& arguments) {
    std::vector<std::string> paths;
    for (const QString& argument : arguments) {
        if (!QFileInfo(argument).isDir()) {
            paths.push_back(argument.toStdString());
            continue;
        }
        const QStringList names =
            QDir(argument).entryList({QStringLiteral("*.part")}, QDir::Files, QDir::Name);
        if (names.isEmpty())
            return Error(MessageCode::NotAPart, argument.toStdString());
        for (const QString& name : names)
            paths.push_back(QDir(argument).filePath(name).toStdString());
    }
    return paths;
}

enum class PartState { Damaged, Done, UnderWay, Resting };

double quiet_s(const ShardPart& part) {
    return 1e-3 * static_cast<double>(QDateTime::currentMSecsSinceEpoch() - part.changed_ms);
}

/// Somebody works on it by its lock, or where there are none by its last change.
PartState stateOf(const ShardPart& part, std::int64_t share) {
    constexpr double kQuiet_s = 60.0;
    return part.isDamaged                                            ? PartState::Damaged
           : static_cast<std::int64_t>(part.records.size()) >= share ? PartState::Done
           : part.isBeingWritten || quiet_s(part) < kQuiet_s         ? PartState::UnderWay
                                                                     : PartState::Resting;
}

std::string wordOf(PartState state, const ShardPart& part) {
    switch (state) {
    case PartState::Damaged:
        return "damaged";
    case PartState::Done:
        return "done";
    case PartState::UnderWay:
        return "under way";
    case PartState::Resting:
        break;
    }
    return "rests for " + roughDuration(quiet_s(part));
}

/// Cases a second, by the computing time of those that are there.
double speedOf(const ShardPart& part) {
    double took_s = 0.0;
    for (const PartRecord& record : part.records)
        took_s += record.took_s;
    return took_s > 0.0
               ? static_cast<double>(part.header.threads) * static_cast<double>(part.records.size()) / took_s
               : 0.0;
}

int printStatus(const std::vector<std::string>& paths) {
    std::optional<PartHeader> first;
    std::vector<bool> has;
    std::set<int> begun;
    bool isDamaged = false;
    double speed = 0.0;
    for (const std::string& path : paths) {
        const auto part = readPart(path, false);
        if (!part && part.error().code() == MessageCode::FileEmpty)
            continue; // its process has just begun
        if (!part)
            return refuse(kMerge, part.error());
        if (!first) {
            first = part->header;
            has.resize(static_cast<std::size_t>(first->cases));
        }
        if (const auto same = checkSameParts(path, part->header, *first); !same)
            return refuse(kMerge, same.error());
        for (const PartRecord& record : part->records)
            has[static_cast<std::size_t>(record.index)] = true;
        begun.insert(part->header.shard.number);
        isDamaged = isDamaged || part->isDamaged;
        const std::int64_t share = part->header.shard.share(part->header.cases);
        const PartState state = stateOf(*part, share);
        if (state == PartState::UnderWay)
            speed += speedOf(*part);
        std::printf("%s: %zu of %lld, %s\n", path.c_str(), part->records.size(),
                    static_cast<long long>(share), wordOf(state, *part).c_str());
    }
    if (!first)
        return refuse(kMerge, Error(MessageCode::FileEmpty, paths.front()));
    if (const int lacking = first->shard.of - static_cast<int>(begun.size()); lacking > 0)
        std::printf("%d of %d shards have not begun\n", lacking, first->shard.of);
    const auto done = std::count(has.begin(), has.end(), true);
    const auto cases = static_cast<std::ptrdiff_t>(has.size());
    std::printf(
        "%lld of %lld cases (%.1f %%)%s\n", static_cast<long long>(done), static_cast<long long>(cases),
        100.0 * static_cast<double>(done) / static_cast<double>(cases),
        done < cases && speed > 0.0
            ? (", about " + roughDuration(static_cast<double>(cases - done) / speed) + " left").c_str()
            : "");
    return done == cases && !isDamaged ? kExitDone : kExitNegative;
}

/// Parts of another version would be written as this one writes them.
Result<void> checkVersion(const nlohmann::json& work) {
    const std::string own = ownSoftware();
    const auto software = work.find("software");
    const std::string theirs =
        software != work.end() && software->is_string() ? software->get<std::string>() : std::string();
    return theirs == own ? Result<void>()
                         : Error(MessageCode::PartOfAnother, "the parts", {"software", own, theirs});
}

int mergeInto(const QString& output, const std::vector<std::string>& paths) {
    std::optional<Progress> progress(std::in_place, 1.0);
    const auto parts = MergedParts::of(paths, progress->share());
    progress.reset();
    if (!parts)
        return refuse(kMerge, parts.error());
    const auto work = nlohmann::json::parse(parts->work());
    if (const auto version = checkVersion(work); !version)
        return refuse(kMerge, version.error());
    return work.contains("field") ? mergeField(*parts, work, output) : mergeStudy(*parts, work, output);
}

} // namespace

int mergeCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription("Puts the parts of a divided study or field together (see --shard of "
                                     "bask study and bask field): the\n"
                                     "very files, byte for byte, that one process would have written, and "
                                     "the same summary. Parts of other\n"
                                     "work, of another version of Bask or of another kind of processor are "
                                     "refused, and so are damaged ones\n"
                                     "and a work of which cases are missing.\n"
                                     "Exit code: that of the study or field; 2 bad input or unwritable "
                                     "output; with --status 3 while cases\n"
                                     "are missing.");
    parser.addOptions(
        {{{"h", "help"}, "Displays this help."},
         {{"o", "output"}, "Folder of a study's files, or file of a field.", "PATH"},
         {"status", "Prints how far each part is, and about how long the rest takes. Writes nothing."}});
    parser.addPositionalArgument("PART", "Parts, or folders with them.", "PART...");
    if (const auto code = parseCommand(parser, kMerge, arguments, -1))
        return *code;
    const auto paths = partsOf(parser.positionalArguments());
    if (!paths)
        return refuse(kMerge, paths.error());
    if (const auto twice = namedTwice(*paths))
        return refuse(kMerge, QStringLiteral("%1 is named twice; name each part, or its folder, once")
                                  .arg(QString::fromStdString(*twice)));
    if (parser.isSet("status")) {
        if (parser.isSet("output"))
            return refuse(kMerge, QStringLiteral("--status writes no files; leave -o out"));
        return printStatus(*paths);
    }
    if (parser.value("output").isEmpty())
        return refuse(kMerge, QStringLiteral("-o PATH is needed"));
    try {
        return mergeInto(parser.value("output"), *paths);
    } catch (const std::bad_alloc&) {
        return refuse(kMerge, QStringLiteral("there is not enough memory for these parts"));
    }
}

} // namespace bask
