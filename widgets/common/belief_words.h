#pragma once
// What a controller believed of the objects when it began, in words.

#include "engine/model/experiment.h"

#include <QString>

namespace bask {

/// Returns by which factor the heat rates that an experiment gives its controller are wrong on purpose; 1 for
/// none.
double wrongRatesFactor(const Experiment& experiment);

/// Returns "The controller begins with heat rates wrong by up to ×4, as the experiment asks."; empty for 1.
QString wrongRatesText(double factor);
QString wrongRatesText(const Experiment& experiment);

} // namespace bask
