#pragma once
// A whole recipe on the simulated rig, as fast as the machine goes.

#include "engine/recipe/recipe_runner.h"

#include <functional>
#include <stop_token>

namespace bask {

/// After every sampling period; may be empty.
using RecipeWatch = std::function<void(const RecipeRunner& runner, const Snapshot& snapshot)>;

/// Runs to the recipe's end. A run is recorded where the runner says, each on a rig of its own at ambient;
/// waits are on the rig of the run before them. A stop ends it as stopNow does.
void runSimulated(RecipeRunner& runner, const RecipeWatch& watch = {}, std::stop_token stop = {});

} // namespace bask
