#pragma once
// `bask run --recipe`: several runs and waits, one after another.

#include "app/commands/live_place.h"

#include <QString>

namespace bask {

struct RecipeRequest {
    QString recipe;
    QString folder;  ///< for the sessions, none of which may exist yet; empty: nothing is recorded
    QString summary; ///< JSON; empty: none
    bool isLive = false;
    LivePlace place = LivePlace::AsFound;
    bool mayLoosenLimits = false;  ///< whether limits of the real rig may be loosened
    bool mayStartPrograms = false; ///< whether programs of the rig may be started that nobody has confirmed
    RunLabels labels{};            ///< of all its recordings
    MonitorSettings monitor{};     ///< where it is published; with isLive
};

/// Runs the recipe. Returns an ExitCode.
int runRecipe(const RecipeRequest& request);

} // namespace bask
