#pragma once
// Operator, sample, batch and notes of a run in words, that its record is cut, and how fast it was simulated.

#include "engine/model/run_labels.h"
#include "engine/model/trace.h"

#include <QString>

namespace bask {

struct SimulationPace;

/// Returns "Operator A. Hu, sample 7, batch 3", without what is not known; empty if nothing is.
QString runLabelWords(const RunLabels& labels);

/// Returns the note, and who wrote it if that is known.
QString noteText(const TraceNote& note);

/// Returns what is known of the end of a run for which isCutAfterStop() holds.
QString cutAfterStopText();

/// Returns "Faster than real time: 8:37 (min:s) of the simulated rig in 0:57 by the clock".
QString paceWords(const SimulationPace& pace);

} // namespace bask
