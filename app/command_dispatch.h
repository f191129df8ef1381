#pragma once
// What the arguments of `bask` ask for: a subcommand, a text on the console, or the window.

#include <QStringList>

#include <optional>

namespace bask {

/// What to do. If it has an exit code, everything has been done.
struct Dispatch {
    std::optional<int> exitCode;
    QString file; ///< file for the window; empty for the first example
};

/// Takes the arguments of main(). Prints --help, --version and complaints; runs subcommands on a
/// QCoreApplication.
Dispatch dispatch(int& argc, char** argv);

/// Returns the sentence to print if there is no display for the window; empty if there is one.
QString missingDisplay();

} // namespace bask
