#pragma once
// Joins the pieces that a drawing is made of, end to end, into outlines.

#include "engine/shape/outline_file.h"

namespace bask {

/// Outlines from pieces (m, at least one point each) whose ends within `tolerance_m` of each other are one:
/// closed where they lead back, open elsewhere. Where more than two ends meet, a spur is set apart and the
/// straightest way is taken; a way that comes back to where it was is cut there, so that outlines which touch
/// stay apart. Straight pieces drawn twice count once; what is no longer than the tolerance is dropped. Time
/// grows with the pieces, not their square.
std::vector<FileOutline> chained(std::vector<std::vector<Eigen::Vector2d>> pieces, double tolerance_m);

} // namespace bask
