#pragma once
// The part of the command line that all subcommands share: --help, complaints about usage, the exit code.

#include "engine/base/result.h"

#include <QCommandLineParser>

#include <initializer_list>
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

/// An option that does something only together with others, or without some.
struct IdleOption {
    const char* name;
    bool hasEffect;
    const char* why; ///< behind the option's name: "is for --live"
};
/// Refuses the first option that is given and would have no effect; returns the exit code then.
std::optional<int> refuseIdle(const QCommandLineParser& parser, const char* command,
                              std::initializer_list<IdleOption> options);

} // namespace bask
