#pragma once
// The examples that come with Bask, inside the binary, so that the first start works from any folder.

#include "engine/recipe/recipe.h"

#include <QString>
#include <QStringList>

namespace bask {

/// Names without suffix, "three-objects" first.
QStringList exampleNames();

/// Reads an example with the contours it refers to. Unpacks them to a temporary folder: run it as a job.
Result<Experiment> readExample(const QString& name);

/// Recipes of such experiments.
QStringList exampleRecipeNames();
Result<Recipe> readExampleRecipe(const QString& name);

} // namespace bask
