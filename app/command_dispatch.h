#pragma once
// What the arguments of `bask` ask for: a subcommand, a text on the console, or the window.

#include <QStringList>

#include <optional>

namespace bask {

/// What to do. If it has an exit code, everything has been done; if not, a window is wanted.
struct Dispatch {
    std::optional<int> exitCode;
    QString file;        ///< absolute; empty for the first example
    QStringList options; ///< Qt's own, with their values
};

/// Takes the arguments of main(). Prints --help, --version and complaints; runs subcommands on a
/// QCoreApplication.
Dispatch dispatch(int& argc, char** argv);

/// Replaces this program by the window, `bask-window`, which keeps its process and its first argument.
/// Returns an exit code, after a sentence, if there is no display or the window's program cannot be started.
int becomeWindow(char* program, const Dispatch& asked);

} // namespace bask
