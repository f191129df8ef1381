#pragma once
// What is still known when the engine does not answer.

#include "engine/runtime/snapshot.h"

namespace bask {

/// The last snapshot so many seconds later: what it told is kept with its age, and nothing is told as known
/// that only a working engine knows.
Snapshot withoutAnswer(const Snapshot& last, double since_s);

} // namespace bask
