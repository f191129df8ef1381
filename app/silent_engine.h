#pragma once
// What is still known if the engine does not answer.

#include "engine/runtime/snapshot.h"

namespace bask {

/// Returns the last snapshot as it is `since_s` seconds later: its values are kept with their ages, and what
/// only a working engine knows is marked as unknown.
Snapshot withoutAnswer(const Snapshot& last, double since_s);

} // namespace bask
