#pragma once
// Why a verb of the run is not possible now: its button or key shows this instead of doing nothing.

#include "app/actions.h"

#include <QString>

namespace bask {

/// Returns one translated sentence that names what to do first; empty if `allows(snapshot, verb)`.
QString whyNot(const Snapshot& snapshot, Verb verb);

} // namespace bask
