#pragma once
// What the arguments of `bask` ask for: a subcommand, a text on the console, or the window.

#include <QStringList>

#include <memory>
#include <optional>

class QCoreApplication;

namespace bask {

/// What to do. If it has an exit code, everything has been done; if not, a window is wanted.
struct Dispatch {
    std::optional<int> exitCode;
    QString file;        ///< absolute; empty for the first example
    QStringList options; ///< Qt's own, with their values
};

/// Takes the arguments of main(). Prints --help, --version and complaints; runs subcommands on a
/// QCoreApplication, those that draw figures on what `makeDrawing` returns. Where a subcommand is in the
/// program `bask-draw`, this becomes it, with its process and its arguments.
Dispatch dispatch(int& argc, char** argv,
                  std::unique_ptr<QCoreApplication> (*makeDrawing)(char** argv) = nullptr);

/// Replaces this program by the window, `bask-window`, which keeps its process and its first argument.
/// Returns an exit code, after a sentence, if there is no display or the window's program cannot be started.
int becomeWindow(char* program, const Dispatch& asked);

} // namespace bask
