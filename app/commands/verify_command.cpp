// bask verify: whether a recorded session is as it was recorded.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/model/experiment.h"
#include "engine/recording/session_verify.h"

#include <QCommandLineParser>

#include <cstdio>

namespace bask {
namespace {

constexpr const char* kVerify = "verify";
constexpr qsizetype kHeadDigits = 64;

void print(const SessionFinding& finding) {
    static constexpr const char* kWords[] = {"changed", "removed", "added"};
    std::printf("%s", finding.table.c_str());
    if (finding.row > 0)
        std::printf(", row %lld", static_cast<long long>(finding.row));
    if (finding.time_s)
        std::printf(", %s s", formatNumber(*finding.time_s, 6).c_str());
    std::printf(": %s\n", kWords[static_cast<int>(finding.kind)]);
}

const char* sealWords(const SessionVerdict& verdict) {
    switch (verdict.seal) {
    case Seal::Holds:
        return "no byte of the file has changed since it was sealed";
    case Seal::Broken:
        return "the file has changed since it was sealed";
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
    if (!verdict.hasChain) {
        std::puts("not verifiable: the session has no hash chain; it was recorded by an older Bask");
        return false;
    }
    for (const SessionFinding& finding : verdict.findings)
        print(finding);
    if (verdict.allFindings > static_cast<std::int64_t>(verdict.findings.size()))
        std::printf("and %lld more\n", static_cast<long long>(verdict.allFindings) -
                                           static_cast<long long>(verdict.findings.size()));
    std::printf("rows: %lld\nhead: %s\n", static_cast<long long>(verdict.rows), verdict.head.c_str());
    std::printf("seal: %s\n", sealWords(verdict));
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
    std::puts(verdict.allFindings > 0
                  ? "altered: the rows above are not as they were recorded"
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
        "Exit code: 0 intact, 2 not readable as a session, 3 altered or without a chain.");
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
    if (!verdict)
        return refuse(kVerify, verdict.error());
    return tell(*verdict, head.toStdString()) ? kExitDone : kExitNegative;
}

} // namespace bask
