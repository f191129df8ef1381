#pragma once
// `bask run --recipe`: several runs and waits, one after another.

#include <QString>

namespace bask {

struct RecipeRequest {
    QString recipe;
    QString folder;  ///< for the sessions, none of which may be there yet; empty: none are recorded
    QString summary; ///< JSON; empty: none
    bool isLive = false;
};

/// An ExitCode.
int runRecipe(const RecipeRequest& request);

} // namespace bask
