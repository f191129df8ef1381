#pragma once
// Readings of a thermal camera as a person reads them.

#include "engine/base/units.h"

#include <QString>

namespace bask {

/// Returns "40.2 °C ± 0.6 K", with the expanded uncertainty (two standard deviations).
QString thermalReadingText(double T_K, double uncertainty_K, TemperatureUnit unit);

} // namespace bask
