#pragma once
// What subcommands that take an experiment have in common on the command line.

#include "engine/model/experiment.h"

#include <QString>

#include <string>
#include <vector>

class QCommandLineParser;

namespace bask {

/// A value of `option` that is not what is expected, in words.
Error badValue(const QString& option, const QString& value, const char* expected);

/// What --targets ("50,40,40", degC) and --source-model say in place of the experiment's, where they are
/// given. The result is not validated.
Result<void> replaceTargets(const QCommandLineParser& parser, Experiment& experiment);
Result<void> replaceSourceModel(const QCommandLineParser& parser, Experiment& experiment);

/// Files that reading the experiment read: itself and the outlines beside it.
std::vector<std::string> inputsOf(const std::string& path, const Experiment& experiment);

} // namespace bask
