#pragma once
// The examples inside the program file, so that the first start works from any folder.

#include "engine/recipe/recipe.h"

#include <QString>
#include <QStringList>

namespace bask {

/// Returns the names without suffix, "three-objects" first.
QStringList exampleNames();

/// Reads an example with the contours it refers to. Writes them to a temporary folder: run it as a job.
Result<Experiment> readExample(const QString& name);

/// Returns the names of the example recipes.
QStringList exampleRecipeNames();
Result<Recipe> readExampleRecipe(const QString& name);

} // namespace bask
