#pragma once
// Joins the pieces of a drawing end to end into outlines.

#include "engine/shape/outline_file.h"

namespace bask {

/// Makes outlines from pieces (m, at least one point each). Ends within `tolerance_m` of each other are
/// joined: an outline is closed if it returns to its start, otherwise open. Where more than two ends meet,
/// side branches are separated and the straightest continuation is used; a path that returns to an earlier
/// point is cut there, so that touching outlines stay separate. Straight pieces drawn twice count once, and
/// pieces not longer than the tolerance are dropped. The time grows with the number of pieces, not with its
/// square.
std::vector<FileOutline> chained(std::vector<std::vector<Eigen::Vector2d>> pieces, double tolerance_m);

} // namespace bask
