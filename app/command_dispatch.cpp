#include "app/command_dispatch.h"

#include "app/commands/command_line.h"
#include "app/exact_version.h"
#include "engine/base/program_part.h"
#include "engine/base/unfinished.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace bask {
namespace {

std::string subcommandList() {
    std::string text = "Subcommands (bask SUBCOMMAND --help tells more):\n";
    for (const Subcommand& each : subcommands()) {
        std::string name = each.name;
        name.resize(18, ' ');
        text += "  " + name + each.summary + "\n";
    }
    return text;
}

/// The end of everything that prints: figures that did not get out are no success.
int finished(int exitCode) {
    const char* reason = std::fflush(stdout) != 0   ? std::strerror(errno)
                         : std::ferror(stdout) != 0 ? "a part of the text was lost"
                                                    : nullptr;
    if (reason == nullptr)
        return exitCode;
    std::fprintf(stderr, "bask: standard output cannot be written: %s\n", reason);
    return kExitBadInput;
}

/// Empty, or what is wrong with an argument that is not UTF-8: it would come out of Qt as another name.
std::string notUtf8(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (QUtf8StringView(argv[i]).isValidUtf8())
            continue;
        std::string text;
        for (const char* c = argv[i]; *c != '\0'; ++c) {
            std::array<char, 8> piece{*c};
            if (*c < ' ' || *c > '~')
                std::snprintf(piece.data(), piece.size(), "\\x%02x", static_cast<unsigned char>(*c));
            text += piece.data();
        }
        return "argument " + std::to_string(i) + ", \"" + text +
               "\", is not valid UTF-8; rename the file and try again";
    }
    return {};
}

int printHelp() {
    std::printf(
        "Usage: bask [FILE]                open the window, with an experiment, recipe or rig (*.json) or a "
        "session "
        "(*.bask)\n"
        "       bask SUBCOMMAND [options]  work without a display\n\n"
        "%s\nOptions:\n  -h, --help     this text\n  -v, --version  the exact version\n\n"
        "Exit codes: 0 done and positive, 1 fault, 2 bad input or unwritable output, 3 a negative verdict.\n",
        subcommandList().c_str());
    return kExitDone;
}

/// Options of Qt itself that take a value, as in "-platform offscreen".
bool isQtOptionWithValue(const QString& argument) {
    static constexpr std::array kNames{"platform", "style",    "stylesheet",
                                       "display",  "geometry", "platformtheme"};
    for (const char* name : kNames)
        if (argument == QStringLiteral("-%1").arg(QLatin1String(name)) ||
            argument == QStringLiteral("--%1").arg(QLatin1String(name)))
            return true;
    return false;
}

int unknown(const QString& word) {
    std::fprintf(stderr, "bask: \"%s\" is neither a subcommand nor a file\n%s", qPrintable(word),
                 subcommandList().c_str());
    return kExitBadInput;
}

/// Becomes a program that belongs to this one. Returns an exit code, after a sentence, if it cannot.
int become(const char* part, char** argv) {
    const std::string path = programPart(part, {});
    ::execv(path.c_str(), argv);
    std::fprintf(stderr, "bask: a part of the program, %s, cannot be started: %s; install Bask again\n", part,
                 std::strerror(errno));
    return kExitFault;
}

QStringList argumentsAfter(int first, int argc, char** argv) {
    QStringList arguments;
    for (int i = first; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return arguments;
}

/// Before a subcommand does its work.
void settle() {
    deleteUnfinishedOnSignals();
    std::setlocale(LC_NUMERIC, "C"); // Qt took the user's: devices and files want the decimal point
    QCoreApplication::setApplicationName(QStringLiteral("bask"));
}

/// One shard of a work that draws: to load what draws would cost more than many a shard.
std::optional<int> runShard(const Subcommand& subcommand, int& argc, char** argv) {
    const QStringList arguments = argumentsAfter(2, argc, argv);
    if (subcommand.runShard == nullptr ||
        !std::ranges::any_of(arguments, [](const QString& word) { return word.startsWith("--shard"); }))
        return std::nullopt;
    const QCoreApplication application(argc, argv);
    settle();
    return subcommand.runShard(arguments);
}

int runSubcommand(const Subcommand& subcommand, int& argc, char** argv,
                  std::unique_ptr<QCoreApplication> (*makeDrawing)(char** argv)) {
    if (const auto done = runShard(subcommand, argc, argv))
        return finished(*done);
    if (subcommand.run == nullptr)
        return become("bask-draw", argv);
    const auto application =
        subcommand.drawsFigures ? makeDrawing(argv) : std::make_unique<QCoreApplication>(argc, argv);
    settle();
    return finished(subcommand.run(argumentsAfter(2, argc, argv)));
}

Dispatch ended(int exitCode) {
    return {exitCode, {}, {}};
}

/// Empty, or why no window can open here.
QString missingDisplay() {
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (!qEnvironmentVariableIsEmpty(variable))
            return {};
    return QStringLiteral(
        "bask: the window needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set. Log in to a "
        "desktop, use ssh -X or xvfb-run, or work without a window: bask --help");
}

} // namespace

Dispatch dispatch(int& argc, char** argv, std::unique_ptr<QCoreApplication> (*makeDrawing)(char** argv)) {
    Dispatch result;
    if (const std::string sentence = notUtf8(argc, argv); !sentence.empty()) {
        std::fprintf(stderr, "bask: %s\n", sentence.c_str());
        return ended(kExitBadInput);
    }
    for (int i = 1; i < argc; ++i) {
        const QString word = QString::fromLocal8Bit(argv[i]);
        if (isQtOptionWithValue(word)) {
            result.options << word;
            if (++i < argc)
                result.options << QString::fromLocal8Bit(argv[i]);
            continue;
        }
        if (i == 1)
            for (const Subcommand& each : subcommands())
                if (word == QLatin1String(each.name))
                    return ended(runSubcommand(each, argc, argv, makeDrawing));
        if (word == QLatin1String("-h") || word == QLatin1String("--help"))
            return ended(finished(printHelp()));
        if (word == QLatin1String("-v") || word == QLatin1String("--version")) {
            std::printf("Bask %s\n", qPrintable(exactVersion()));
            return ended(finished(kExitDone));
        }
        const bool isFile = word.endsWith(QLatin1String(".json")) || word.endsWith(QLatin1String(".bask")) ||
                            QFileInfo(word).isFile();
        if (!isFile || word.startsWith(u'-'))
            return ended(unknown(word));
        if (!QFileInfo(word).isFile()) {
            std::fprintf(stderr, "bask: %s: there is no such file; check the path\n", qPrintable(word));
            return ended(kExitBadInput);
        }
        if (!result.file.isEmpty()) {
            std::fprintf(stderr, "bask: %s: one file at a time\n", qPrintable(word));
            return ended(kExitBadInput);
        }
        result.file = QFileInfo(word).absoluteFilePath();
    }
    return result;
}

int becomeWindow(char* program, const Dispatch& asked) {
    if (const QString sentence = missingDisplay(); !sentence.isEmpty()) {
        std::fprintf(stderr, "%s\n", qPrintable(sentence));
        return kExitFault;
    }
    std::vector<QByteArray> words;
    for (const QString& option : asked.options)
        words.push_back(option.toLocal8Bit());
    if (!asked.file.isEmpty())
        words.insert(words.end(), {"--", asked.file.toLocal8Bit()});
    std::vector<char*> arguments{program};
    for (QByteArray& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return become("bask-window", arguments.data());
}

} // namespace bask
