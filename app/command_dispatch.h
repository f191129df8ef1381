#pragma once
// What the words after `bask` ask for: a subcommand, a text on the console, or the window.

#include <QStringList>

#include <optional>

namespace bask {

/// What to do. With an exit code everything has been done.
struct Dispatch {
    std::optional<int> exitCode;
    QString file; ///< for the window; empty: the first example
};

/// Takes main()s arguments. Prints --help, --version and complaints; runs subcommands on a QCoreApplication.
Dispatch dispatch(int& argc, char** argv);

/// The sentence to print when the window has no display to open on; empty when it has.
QString missingDisplay();

} // namespace bask
