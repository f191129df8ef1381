#pragma once
// Operator, sample, batch and notes of a run in words, and that its record is cut.

#include "engine/model/run_labels.h"
#include "engine/model/trace.h"

#include <QString>

namespace bask {

/// Returns "Operator A. Hu, sample 7, batch 3", without what is not known; empty if nothing is.
QString runLabelWords(const RunLabels& labels);

/// Returns the note, and who wrote it if that is known.
QString noteText(const TraceNote& note);

/// Returns what is known of the end of a run for which isCutAfterStop() holds.
QString cutAfterStopText();

} // namespace bask
