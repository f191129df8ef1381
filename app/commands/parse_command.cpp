#include "app/commands/parse_command.h"

#include "app/commands/command_line.h"

#include <cstdio>
#include <cstdlib>

namespace bask {

std::optional<int> parseCommand(QCommandLineParser& parser, const char* name, const QStringList& arguments,
                                int positionals, const QStringList& repeatable) {
    const QString program = QStringLiteral("bask ") + name;
    if (!parser.parse(QStringList(program) + arguments)) {
        std::fprintf(stderr, "bask %s: %s (see bask %s --help)\n", name, qPrintable(parser.errorText()),
                     name);
        return kExitBadInput;
    }
    if (parser.isSet("help")) {
        // QCommandLineParser prints argv[0] of the process; ours is "bask SUBCOMMAND".
        const QString text = parser.helpText();
        const auto firstLineEnd = text.indexOf(u'\n');
        QString usage = QStringLiteral("Usage: bask %1 [options]").arg(name);
        usage += text.left(firstLineEnd).section(QStringLiteral("[options]"), 1);
        std::fputs(qPrintable(usage + text.mid(firstLineEnd)), stdout);
        return kExitDone;
    }
    QStringList seen; // an option without a value may not be asked for values
    for (const QString& given : parser.optionNames()) {
        const QString option = given == u"output" ? QStringLiteral("o") : given;
        if (seen.contains(option) && !repeatable.contains(option)) {
            std::fprintf(stderr, "bask %s: %s%s is given twice\n", name, given.size() == 1 ? "-" : "--",
                         qPrintable(given));
            return kExitBadInput;
        }
        seen.append(option);
    }
    const int given = static_cast<int>(parser.positionalArguments().size()), min = std::abs(positionals);
    if (positionals < 0 ? given < min : given != positionals) {
        std::fprintf(stderr, "bask %s: %s%d argument%s expected, %d given (see bask %s --help)\n", name,
                     positionals < 0 ? "at least " : "", min, min == 1 ? "" : "s", given, name);
        return kExitBadInput;
    }
    return std::nullopt;
}

int refuse(const char* command, const Error& error) {
    std::fprintf(stderr, "bask %s: %s\n", command, describe(error).c_str());
    return kExitBadInput;
}

int refuse(const char* command, const QString& words) {
    std::fprintf(stderr, "bask %s: %s (see bask %s --help)\n", command, qPrintable(words), command);
    return kExitBadInput;
}

std::optional<int> refuseIdle(const QCommandLineParser& parser, const char* command,
                              std::initializer_list<IdleOption> options) {
    for (const IdleOption& option : options)
        if (!option.hasEffect && parser.isSet(option.name))
            return refuse(command, (option.name[1] == '\0' ? QStringLiteral("-") : QStringLiteral("--")) +
                                       QLatin1String(option.name) + QLatin1Char(' ') +
                                       QString::fromUtf8(option.why));
    return std::nullopt;
}

} // namespace bask
