// bask verify: whether a recorded session is as it was recorded.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/model/experiment.h"
#include "engine/recording/session_verify.h"

#include <QCommandLineParser>

#include <cstdio>

namespace bask {
namespace {

constexpr const char* kVerify = "verify";
constexpr qsizetype kHeadDigits = 64;
constexpr const char* kSomeReadable =
    "damaged: the file is cut short, or was written over; tables that are not named above can be read";
constexpr const char* kAllReadable =
    "damaged: the file is cut short, or was written over; every row can be read all the same";

void print(const SessionFinding& finding) {
    static constexpr const char* kWords[] = {"changed", "removed", "added"};
    std::printf("%s", finding.table.c_str());
    if (!finding.name.empty())
        std::printf(", %s%s%s", finding.type.c_str(), finding.type.empty() ? "" : " ",
                    printable(finding.name).c_str());
    else if (finding.lastRow > 0)
        std::printf(", rows %lld to %lld", static_cast<long long>(finding.row),
                    static_cast<long long>(finding.lastRow));
    else if (finding.row > 0)
        std::printf(", row %lld", static_cast<long long>(finding.row));
    if (finding.time_s)
        std::printf(", %s%s s", finding.isAfter ? "after " : "", formatNumber(*finding.time_s, 6).c_str());
    std::printf(": %s\n", kWords[static_cast<int>(finding.kind)]);
}

void print(const TableDamage& damage) {
    std::printf("%s: damaged; ", damage.table.c_str());
    if (damage.rows == 0)
        std::printf("no row of it can be read");
    else if (damage.rows == 1)
        std::printf("the first row can be read");
    else
        std::printf("the first %lld rows can be read", static_cast<long long>(damage.rows));
    if (damage.time_s)
        std::printf(", until %s s", formatNumber(*damage.time_s, 6).c_str());
    std::puts("");
}

const char* sealWords(const SessionVerdict& verdict) {
    switch (verdict.seal) {
    case Seal::Holds:
        return "no byte of the file has changed since it was sealed";
    case Seal::Broken:
        return "the file has changed since it was sealed";
    case Seal::Removed:
        return "removed: Bask seals a recording that says how it ended";
    case Seal::None:
        break;
    }
    return verdict.isClosed ? "none: tags, and bytes that are in no row, are not checked"
                            : "none: the recording is under way, or was not closed by itself";
}

Result<SessionVerdict> verified(const std::string& path, const std::string& head) {
    Progress progress(1.0);
    return verifySession(path, head, progress.share());
}

/// Whether it is as it was recorded; says so.
bool tell(const SessionVerdict& verdict, const std::string& expectedHead) {
    for (const TableDamage& damage : verdict.damages)
        print(damage);
    if (!verdict.hasChain && !verdict.isDamaged) {
        std::puts("not verifiable: the session has no hash chain; it was recorded by an older Bask");
        return false;
    }
    for (const SessionFinding& finding : verdict.findings)
        print(finding);
    if (verdict.allFindings > static_cast<std::int64_t>(verdict.findings.size()))
        std::printf("and %lld more\n", static_cast<long long>(verdict.allFindings) -
                                           static_cast<long long>(verdict.findings.size()));
    std::printf("rows: %lld\n", static_cast<long long>(verdict.rows));
    if (verdict.isDamaged) {
        std::puts(verdict.damages.empty() ? kAllReadable : kSomeReadable);
        std::puts("what to do: take another copy of the file, if there is one; else save what can be read, "
                  "with sqlite3 and its command .recover");
        return false;
    }
    std::printf("head: %s\nseal: %s\n", verdict.head.empty() ? "none" : verdict.head.c_str(),
                sealWords(verdict));
    if (!expectedHead.empty() && verdict.expectedLink == 0) {
        std::puts("altered: the head is not the one that is expected, and never was");
        return false;
    }
    if (!expectedHead.empty() && verdict.expectedLink < verdict.links)
        std::printf("the expected head is that of link %lld of %lld: the recording went on, or was closed, "
                    "after it\n",
                    static_cast<long long>(verdict.expectedLink), static_cast<long long>(verdict.links));
    if (verdict.isIntact()) {
        std::puts("intact");
        return true;
    }
    std::puts(verdict.allFindings > 0 ? "altered: what is named above is not as it was recorded"
              : verdict.seal == Seal::Removed
                  ? "altered: the seal was removed; tags, and bytes that are in no row, may have been changed"
                  : "altered: in tags, or in bytes of the file that are in no row; an older Bask "
                    "that changed the tags does that too");
    return false;
}

} // namespace

int verifyCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Looks at every row of a recorded session and says whether it is as it was recorded: each is in a\n"
        "chain of SHA-256 hashes, and a closed file is sealed as a whole. What was changed, removed or added "
        "is\n"
        "named by table, row and time. Who can write the file can make a new chain: compare the head with "
        "that\n"
        "in the run's report (--head), which is kept elsewhere.\n"
        "Exit code: 0 intact, 2 no session, 3 altered, damaged or without a chain.");
    parser.addOptions(
        {{{"h", "help"}, "Displays this help."},
         {"head", "The head that is expected, as the run's report has it: 64 hexadecimal digits.", "HEX"}});
    parser.addPositionalArgument("SESSION.bask", "The session; one that is being recorded will do.");
    if (const auto code = parseCommand(parser, kVerify, arguments, 1))
        return *code;
    const QString head = parser.value("head").toLower();
    if (parser.isSet("head") &&
        (head.size() != kHeadDigits || QByteArray::fromHex(head.toLatin1()).toHex() != head.toLatin1()))
        return refuse(kVerify, QStringLiteral("--head has 64 hexadecimal digits"));
    const auto verdict = verified(parser.positionalArguments().front().toStdString(), head.toStdString());
    if (!verdict) {
        const int refused = refuse(kVerify, verdict.error());
        return verdict.error().code() == MessageCode::SessionDamaged ? kExitNegative : refused;
    }
    return tell(*verdict, head.toStdString()) ? kExitDone : kExitNegative;
}

} // namespace bask
