#pragma once
// A recipe on a real rig in real time, without a window.

#include "app/commands/live_place.h"
#include "engine/recipe/recipe_runner.h"
#include "engine/recipe/simulated_recipe.h"

namespace bask {

/// Runs to the recipe's end. SIGINT, SIGTERM and SIGHUP stop it, the second one is STOP.
void runLive(RecipeRunner& runner, const RecipeWatch& watch, LivePlace place);

} // namespace bask
