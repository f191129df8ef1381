#pragma once
// A recipe on a real rig in real time, without a window.

#include "app/commands/live_place.h"
#include "engine/recipe/recipe_runner.h"
#include "engine/recipe/simulated_recipe.h"

namespace bask {

/// Runs until the end of the recipe. SIGINT, SIGTERM and SIGHUP stop it, a second one is STOP.
void runLive(RecipeRunner& runner, const RecipeWatch& watch, const LiveStart& start, const RunLabels& labels);

} // namespace bask
