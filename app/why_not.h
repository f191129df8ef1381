#pragma once
// Why a verb of the run cannot be done now: what its button or key says instead of doing nothing.

#include "app/actions.h"

#include <QString>

namespace bask {

/// One translated sentence that names what to do first; empty while `allows(snapshot, verb)`.
QString whyNot(const Snapshot& snapshot, Verb verb);

} // namespace bask
