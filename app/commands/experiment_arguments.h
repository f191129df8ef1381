#pragma once
// What subcommands that take an experiment have in common on the command line.

#include "engine/session/experiment.h"

#include <QString>

#include <string>
#include <vector>

namespace bask {

/// A value of `option` that is not what is expected, in words.
Error badValue(const QString& option, const QString& value, const char* expected);

/// "50,40,40" in degC as kelvin.
Result<std::vector<double>> parseTargets(const QString& text);

/// Files that reading the experiment read: itself and the outlines beside it.
std::vector<std::string> inputsOf(const std::string& path, const Experiment& experiment);

} // namespace bask
