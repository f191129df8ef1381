#pragma once
// A map of reachable pairs as a CSV table: what `bask feasibility --reachable` and the Targets page write.

#include "engine/control/reachable_pairs.h"

#include <string>
#include <vector>

namespace bask {

/// First line of every such table.
inline constexpr const char* kReachableMark = "# Pairs of steady temperatures within the workspace";

/// "reachable-1-2": of the objects by number from 1; the table's ending is ".csv".
std::string reachableFileStem(int first, int second);

/// A row a cell (degC, share of the poses, 0 or 1), with names, target and definitions in comment lines.
/// `names` of all objects.
std::string reachableCsv(const std::vector<std::string>& names, const ReachableMap& map);

} // namespace bask
