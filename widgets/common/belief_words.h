#pragma once
// What a controller believed of the objects when it began, in words.

#include "engine/model/experiment.h"

#include <QString>

namespace bask {

/// Returns "The controller began with heat rates wrong by up to ×4, as the experiment asks."; empty if it
/// asks for none.
QString wrongRatesText(const Experiment& experiment);

} // namespace bask
