// bask export: a recorded session as CSV, one file a table.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"

#include "engine/session/session_file.h"

#include <QCommandLineParser>

#include <cstdio>

namespace bask {

int exportCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Writes each table of a recorded session as a CSV file with its units in the header: sample.csv,\n"
        "pose.csv, event.csv ... Numbers have all their digits; an empty field is a value that was not "
        "known.\n"
        "Prints the names of the files written.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption({"csv", "Folder for the files; made if it is not there. Required.", "DIR"});
    parser.addPositionalArgument("SESSION.bask", "The session; one that is being recorded will do.");
    if (const auto code = parseCommand(parser, "export", arguments, 1))
        return *code;
    if (parser.value("csv").isEmpty()) {
        std::fprintf(stderr, "bask export: --csv DIR is needed (see bask export --help)\n");
        return kExitBadInput;
    }
    const auto files = exportSessionCsv(parser.positionalArguments().front().toStdString(),
                                        parser.value("csv").toStdString());
    if (!files) {
        std::fprintf(stderr, "bask export: %s\n", describe(files.error()).c_str());
        return kExitBadInput;
    }
    for (const std::string& file : *files)
        std::printf("%s\n", file.c_str());
    return kExitDone;
}

} // namespace bask
