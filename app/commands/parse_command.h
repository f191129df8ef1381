#pragma once
// The part of the command line that all subcommands share: --help, complaints about usage, the exit code.

#include "engine/base/result.h"

#include <QCommandLineParser>

#include <optional>

namespace bask {

/// Parses a subcommand's arguments. An exit code means that it is done (help was printed) or refused
/// (reported on standard error). A negative `positionals` is a minimum number. Only the options that are
/// `repeatable` may come twice.
std::optional<int> parseCommand(QCommandLineParser& parser, const char* name, const QStringList& arguments,
                                int positionals, const QStringList& repeatable = {});

/// Reports on standard error, in the subcommand's name, why it is not done; returns the exit code. Words are
/// about usage, and name --help.
int refuse(const char* command, const Error& error);
int refuse(const char* command, const QString& words);

} // namespace bask
