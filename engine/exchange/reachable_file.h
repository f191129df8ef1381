#pragma once
// A map of reachable pairs as a CSV table, written by `bask feasibility --reachable` and the Targets page.

#include "engine/control/reachable_pairs.h"

#include <string>
#include <vector>

namespace bask {

/// The first line of every such table.
inline constexpr const char* kReachableMark = "# Pairs of steady temperatures within the workspace";

/// Returns "reachable-1-2": the numbers of the objects, from 1; the table's ending is ".csv".
std::string reachableFileStem(int first, int second);

/// Returns one row for each cell (degC, share of the poses, 0 or 1), with names, target and definitions in
/// comment lines. `names` are those of all objects.
std::string reachableCsv(const std::vector<std::string>& names, const ReachableMap& map);

} // namespace bask
