#include "engine/control/robot_limits.h"

#include <algorithm>

namespace bask {

int RobotLimits::degreesOfFreedom() const {
    return static_cast<int>(std::ranges::count(free, true));
}

std::string describe(const ActiveLimits& limits) {
    constexpr std::array names{"speed", "rotation", "acceleration", "angular acceleration", "clearance"};
    std::string words;
    const auto say = [&](const std::string& name) { words += (words.empty() ? "" : ", ") + name; };
    for (std::size_t k = 0; k < names.size(); ++k)
        if (limits.has(static_cast<Limit>(k)))
            say(names[k]);
    for (int k = 0; k < 6; ++k)
        if (limits.has(Limit::Workspace, k))
            say(std::string("workspace ") + kCoordinateNames[static_cast<std::size_t>(k)]);
    return words;
}

} // namespace bask
