#pragma once
// Steps of a recipe and what has become of them, as words and shapes.

#include "engine/base/units.h"
#include "engine/recipe/recipe_runner.h"

#include <QPixmap>
#include <QString>

namespace bask {

/// "two-circles", "Wait".
QString stepWords(const RecipeStep& step);
/// "all have settled for 1:00", "left is at 30.0 °C or below".
QString conditionWords(const RecipeStep& step, TemperatureUnit unit);
/// "15:00"; of a step that ends by its time, that.
QString maxDurationWords(const RecipeStep& step);
/// "Done".
QString stateWord(RecipeProgress::State state);
QPixmap statePixmap(RecipeProgress::State state, bool dark, int size, double devicePixelRatio);
/// A sentence.
QString endWords(RecipeEnd end);

} // namespace bask
