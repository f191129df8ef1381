#include "engine/control/robot_limits.h"

#include <algorithm>

namespace bask {

int RobotLimits::degreesOfFreedom() const {
    return static_cast<int>(std::ranges::count(free, true));
}

} // namespace bask
