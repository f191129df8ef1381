#pragma once
// Simulated faults in words: those that are active, and what one would do on this rig.

#include "engine/runtime/fault_effect.h"
#include "engine/runtime/snapshot.h"

#include <QStringList>

namespace bask {

/// Returns "Sensor lost: bunny" for each active fault.
QStringList activeFaultWords(const Snapshot& snapshot);
/// Returns a sentence that says why a fault would show nothing, or when it shows; empty if it shows at once.
QString faultEffectWords(FaultEffect effect);

} // namespace bask
