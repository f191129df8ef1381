#pragma once
// A source that is not at its set point, in words: how far it is from it, and how long that takes.

#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"

#include <QString>

namespace bask {

/// Returns where the source is to be: the set point of its heat, or that with which a run begins. NaN if the
/// engine has told none.
double sourceGoal_K(const Snapshot& snapshot);
/// Returns whether the source is known to be too cold for the run that is on, or for one that starts now.
bool isSourceCold(const Snapshot& snapshot);
/// Returns "Heated from now on it takes about 3:40.", or that nobody knows.
QString warmUpText(const SourceWarmUp& warmUp);
/// Returns what a Start now would cost with a source that is too cold.
QString coldSourceText(const Snapshot& snapshot, TemperatureUnit unit);
/// Returns that the run has ended and its recording goes on, with the source's temperature.
QString recordedUntilColdText(const Snapshot& snapshot, TemperatureUnit unit);

} // namespace bask
