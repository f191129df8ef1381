#pragma once
// The programs that --allow-program confirms for one run.

#include "engine/drivers/program_files.h"
#include "engine/model/experiment.h"
#include "engine/runtime/command.h"

#include <vector>

namespace bask {

/// Returns a command for each program of the experiment's rig. Errors: a program that cannot be started.
Result<std::vector<Command>> allowedPrograms(const Experiment& experiment);

} // namespace bask
