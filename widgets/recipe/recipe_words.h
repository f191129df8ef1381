#pragma once
// Steps of a recipe and their states, as words and shapes.

#include "engine/base/units.h"
#include "engine/recipe/recipe_runner.h"

#include <QPixmap>
#include <QString>

namespace bask {

/// "two-circles", "Wait".
QString stepWords(const RecipeStep& step);
/// "all have settled for 1:00", "left is at 30.0 °C or below".
QString conditionWords(const RecipeStep& step, TemperatureUnit unit);
/// Returns "15:00"; for a step that ends after a time, that time.
QString maxDurationWords(const RecipeStep& step);
/// "Done".
QString stateWord(RecipeProgress::State state);
QPixmap statePixmap(RecipeProgress::State state, bool dark, int size, double devicePixelRatio);
/// Returns the end of a recipe in a sentence.
QString endWords(RecipeEnd end);

} // namespace bask
