// bask merge: the parts of a divided study or field as the files that one process would have written, or how
// far they are.

#include "app/commands/command_line.h"
#include "app/commands/field_blocks.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/commands/studies.h"
#include "app/commands/study_output.h"
#include "app/exact_version.h"
#include "engine/base/message_code.h"

#include <QCommandLineParser>
#include <QDateTime>
#include <QDir>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace bask {
namespace {

constexpr const char* kName = "merge";

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

/// How far one part is.
struct PartState {
    std::int64_t done = 0, share = 0;
    double mean_s = 0.0; ///< computing time of a case
    std::string word;
};

PartState stateOf(const ShardPart& part) {
    constexpr double kQuiet_s = 600.0;
    PartState state;
    state.share = part.header.shard.share(part.header.cases);
    std::vector<bool> has(static_cast<std::size_t>(state.share), false);
    double took_s = 0.0;
    for (const PartRecord& record : part.records) {
        has[static_cast<std::size_t>(record.index / part.header.shard.of)] = true;
        took_s += record.took_s;
    }
    state.done = std::count(has.begin(), has.end(), true);
    state.mean_s = part.records.empty() ? 0.0 : took_s / static_cast<double>(part.records.size());
    const double quiet_s = 1e-3 * static_cast<double>(QDateTime::currentMSecsSinceEpoch() - part.changed_ms);
    state.word = part.isDamaged              ? "damaged"
                 : state.done == state.share ? "done"
                 : part.isBeingWritten       ? "under way"
                 : quiet_s < kQuiet_s        ? "written " + roughDuration(quiet_s) + " ago"
                                             : "rests for " + roughDuration(quiet_s);
    return state;
}

/// Cases a second of the parts that are not done, by how they came so far.
double speedOf(const ShardPart& part, const PartState& state) {
    const double since_s = 1e-3 * static_cast<double>(part.changed_ms - part.begun_ms);
    return state.done < state.share && since_s > 0.0 ? static_cast<double>(state.done) / since_s : 0.0;
}

int printStatus(const std::vector<std::string>& paths) {
    std::vector<ShardPart> parts;
    for (const std::string& path : paths) {
        auto part = readPart(path);
        if (!part && part.error().code() == MessageCode::FileEmpty)
            continue; // its process has just begun
        if (!part)
            return refuse(kName, part.error());
        if (!parts.empty())
            if (const auto same = checkSameWork(path, part->header.work, parts.front().header.work); !same)
                return refuse(kName, same.error());
        parts.push_back(std::move(*part));
    }
    if (parts.empty())
        return refuse(kName, Error(MessageCode::FileEmpty, paths.front()));
    std::int64_t done = 0;
    double speed = 0.0;
    for (const ShardPart& part : parts) {
        const PartState state = stateOf(part);
        std::printf("%s: %lld of %lld, %s\n", part.path.c_str(), static_cast<long long>(state.done),
                    static_cast<long long>(state.share), state.word.c_str());
        done += state.done;
        speed += speedOf(part, state);
    }
    const std::int64_t cases = parts.front().header.cases;
    const int of = parts.front().header.shard.of;
    if (static_cast<int>(parts.size()) < of)
        std::printf("%d of %d shards have not begun\n", of - static_cast<int>(parts.size()), of);
    std::printf(
        "%lld of %lld cases (%.1f %%)%s\n", static_cast<long long>(done), static_cast<long long>(cases),
        100.0 * static_cast<double>(done) / static_cast<double>(cases),
        done < cases && speed > 0.0
            ? (", about " + roughDuration(static_cast<double>(cases - done) / speed) + " left").c_str()
            : "");
    return done == cases ? kExitDone : kExitNegative;
}

/// Parts of another version would be written as this one writes them.
Result<void> checkVersion(const MergedParts& parts) {
    const std::string own = "Bask " + exactVersion().toStdString();
    const auto work = nlohmann::json::parse(parts.work());
    const std::string theirs = work.value("software", "");
    return theirs == own ? Result<void>()
                         : Error(MessageCode::PartOfAnother, "the parts", {"software", own, theirs});
}

int mergeInto(const QString& output, const std::vector<std::string>& paths) {
    const auto parts = MergedParts::of(paths);
    if (!parts)
        return refuse(kName, parts.error());
    if (const auto version = checkVersion(*parts); !version)
        return refuse(kName, version.error());
    return nlohmann::json::parse(parts->work()).contains("field") ? mergeField(*parts, output)
                                                                  : mergeStudy(*parts, output);
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
    if (const auto code = parseCommand(parser, kName, arguments, -1))
        return *code;
    const auto paths = partsOf(parser.positionalArguments());
    if (!paths)
        return refuse(kName, paths.error());
    if (parser.isSet("status")) {
        if (parser.isSet("output"))
            return refuse(kName, QStringLiteral("--status writes no files; leave -o out"));
        return printStatus(*paths);
    }
    if (parser.value("output").isEmpty())
        return refuse(kName, QStringLiteral("-o PATH is needed"));
    return mergeInto(parser.value("output"), *paths);
}

} // namespace bask
