#pragma once
// The zeroing of the sensors that a recorded run used.

#include "engine/recording/session_file.h"

#include <vector>

namespace bask {

/// Returns the offset of each sensor, K, in the experiment's order, as Arm recorded them; empty if the
/// recording has none.
std::vector<double> zeroOffsets_K(const SessionRecord& facts);

} // namespace bask
