#pragma once
// Runs a whole recipe on the simulated rig, as fast as the machine allows.

#include "engine/recipe/recipe_runner.h"

#include <functional>
#include <stop_token>

namespace bask {

/// Called after every sampling period; may be empty.
using RecipeWatch = std::function<void(const RecipeRunner& runner, const Snapshot& snapshot)>;

/// Runs to the end of the recipe. A run is recorded where the runner says, each on a new rig at ambient
/// temperature; waits use the rig of the run before them. A stop request ends it as stopNow does.
void runSimulated(RecipeRunner& runner, const RecipeWatch& watch = {}, const std::stop_token& stop = {},
                  const RunLabels& labels = {});

} // namespace bask
