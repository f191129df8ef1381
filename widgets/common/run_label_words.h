#pragma once
// Operator, sample and batch of a run in words.

#include "engine/model/run_labels.h"
#include "engine/model/trace.h"

#include <QString>

namespace bask {

/// Returns "Operator A. Hu, sample 7, batch 3", without what is not known; empty if nothing is.
QString runLabelWords(const RunLabels& labels);

/// Returns the note, and who wrote it if that is known.
QString noteText(const TraceNote& note);

} // namespace bask
