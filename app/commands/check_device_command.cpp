// bask check-device: whether a program keeps the rules of program drivers.

#include "app/commands/command_line.h"
#include "app/commands/engine_thread.h"
#include "app/commands/parse_command.h"
#include "engine/drivers/program_check.h"
#include "engine/drivers/program_files.h"

#include <QCommandLineParser>

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace bask {
namespace {

std::optional<ProgramRole> roleOf(const QString& word) {
    for (const ProgramRole role : {ProgramRole::Robot, ProgramRole::Thermometer, ProgramRole::HeatSource})
        if (word == QLatin1String(programRoleWord(role)))
            return role;
    return std::nullopt;
}

} // namespace

int checkDeviceCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Starts the program of a device and tries whether it keeps the rules of program drivers, one after\n"
        "the other. Each axis of a robot moves by 1 or 2 mm, or half a degree, a heat source heats by 5 K: "
        "stand by.\n"
        "Exit code: 0 all rules are kept, 2 bad input, 3 some are not.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("COMMAND", "The program and its arguments, after --.", "-- COMMAND...");
    parser.addOptions({{"role", "robot, thermometer or heater.", "ROLE"},
                       {"no-motion", "Moves and heats nothing."},
                       {"home", "Homes a robot first; it may move far."}});
    if (const auto code = parseCommand(parser, "check-device", arguments, -1))
        return *code;
    const auto role = roleOf(parser.value("role"));
    if (!role) {
        std::fprintf(stderr, "bask check-device: --role: robot, thermometer or heater expected\n");
        return kExitBadInput;
    }
    const bool isRobot = *role == ProgramRole::Robot;
    if (const auto code = refuseIdle(
            parser, "check-device",
            {{"home", isRobot, "is for a robot"},
             {"home", !parser.isSet("no-motion"), "moves the robot, and --no-motion lets nothing move"},
             {"no-motion", *role != ProgramRole::Thermometer, "is for a robot or a heat source"}}))
        return *code;
    std::vector<std::string> words;
    for (const QString& word : parser.positionalArguments())
        words.push_back(word.toStdString());
    const std::string command = commandLine(words);
    if (const auto files = programFiles(command); !files) {
        std::fprintf(stderr, "bask check-device: %s\n", describe(files.error()).c_str());
        return kExitBadInput;
    }
    int broken = 0, all = 0, untried = 0;
    std::optional<SignalCount> signalCount(std::in_place); // an interrupted program is ended, too
    ProgramCheckOptions options;
    options.mayMove = !parser.isSet("no-motion");
    options.mayHome = parser.isSet("home");
    options.isStopped = [&] { return signalCount->now() > 0; };
    checkProgram(command, *role, options, [&](const ProgramFinding& finding) {
        static constexpr std::array kMarks{"ok    ", "WRONG ", "?     "};
        const bool isTried = finding.kind != ProgramFinding::Kind::NotTried;
        all += isTried ? 1 : 0;
        untried += isTried ? 0 : 1;
        broken += finding.kind == ProgramFinding::Kind::Broken ? 1 : 0;
        std::printf("%s %s%s\n", kMarks[static_cast<std::size_t>(finding.kind)],
                    isTried ? "" : "not tried: ", finding.words.c_str());
        std::fflush(stdout);
    });
    const int signal = signalCount->last();
    signalCount.reset();
    if (signal != 0)
        endBySignal(signal);
    if (broken == 0)
        std::printf("All %d rules that were tried are kept%s.\n", all,
                    untried > 0 ? "; what is marked with ? was not tried" : "");
    else
        std::printf("%d of %d rules that were tried are broken.\n", broken, all);
    return broken == 0 ? kExitDone : kExitNegative;
}

} // namespace bask
