#pragma once
// View factor by brute force: Lambert's cosine law integrated over both visible areas. Shares nothing with
// the engine's way.

#include "engine/radiation/view_factor.h"

namespace bask::test {

/// F21 by tensor Gauss quadrature in four dimensions; good to about 1e-8 when the faces keep apart by a third
/// of the source's radius. `nodes` a dimension.
double lambertViewFactor(const Disk& source, const Shape& object, const Pose& X_SO, int nodes = 24);

} // namespace bask::test
