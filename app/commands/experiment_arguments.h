#pragma once
// What subcommands with an experiment share on the command line.

#include "engine/model/experiment.h"

#include <QString>

#include <string>
#include <vector>

class QCommandLineParser;

namespace bask {

/// Returns the error for a value of `option` that is not as expected, in words.
Error badValue(const QString& option, const QString& value, const char* expected);

/// Returns the finite number in `text`; `where` is named in the error.
Result<double> finiteNumber(const QString& text, const std::string& where);

/// Returns the object of --object, or the only one.
Result<const ObjectSpec*> chosenObject(const QCommandLineParser& parser, const Experiment& experiment);

/// Replaces the experiment's values by those of --targets ("50,40,40", degC) and --source-model, if they are
/// given. The result is not validated.
Result<void> replaceTargets(const QCommandLineParser& parser, Experiment& experiment);
Result<void> replaceSourceModel(const QCommandLineParser& parser, Experiment& experiment);

/// Says on standard error which objects overlap a part in one plane.
void warnOfOverlaps(const char* command, const Experiment& experiment);

/// Returns the files that were read for the experiment: itself and the outlines beside it.
std::vector<std::string> inputsOf(const std::string& path, const Experiment& experiment);

} // namespace bask
