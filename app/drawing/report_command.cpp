// bask report: a recorded session as one file to read, HTML or PDF.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/session_outputs.h"
#include "app/studies/study_output.h"

#include <QCommandLineParser>

namespace bask {
namespace {

constexpr double kAfterSession = 0.8, kAfterInput = 0.9; // of the work

Result<void> reported(const std::string& from, const std::string& to, const Language& language) {
    Progress progress(1.0);
    auto session = readSession(from, partOf(progress.share(), 0.0, kAfterSession));
    if (!session)
        return session.error();
    RunReportInput input = reportInput(std::move(*session), TemperatureUnit::Celsius);
    progress.tell(kAfterInput);
    input.language = language.current();
    auto written = writeReport(input, to);
    progress.tell(1.0);
    return written;
}

} // namespace

int reportCommand(const QStringList& arguments) {
    constexpr const char* kName = "report";
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Writes a report of a recorded session: how it ended, metrics with their definitions, traces, "
        "trajectories,\n"
        "set-up, feasibility of the targets, calibration, events, versions and the file's SHA-256. "
        "Everything\n"
        "is in the one file. Exit code: 0 done, 2 bad input or unwritable output.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions({{{"o", "output"}, "The report, *.html or *.pdf. Required.", "FILE"},
                       {"language", "en, fr, zh_CN or zh_TW.", "CODE", "en"}});
    parser.addPositionalArgument("SESSION.bask", "The session; one that is being recorded will do.");
    if (const auto code = parseCommand(parser, kName, arguments, 1))
        return *code;
    if (!parser.isSet("output"))
        return refuse(kName, QStringLiteral("-o FILE.html or -o FILE.pdf is needed"));
    const std::string path = parser.value("output").toStdString();
    const std::string from = parser.positionalArguments().front().toStdString();
    if (const auto place = checkReportFile(path, from); !place)
        return refuse(kName, place.error());
    Language language;
    if (const auto spoken = setLanguage(language, parser.value("language")); !spoken)
        return refuse(kName, spoken.error());
    const auto written = reported(from, path, language);
    return written ? kExitDone : refuse(kName, written.error());
}

} // namespace bask
