#include "engine/session/limits_widened.h"

#include <algorithm>
#include <array>

namespace bask {
namespace {

/// 0 is no limit.
bool widensAcceleration(double before, double after) {
    return before > 0.0 && (after == 0.0 || after > before);
}

bool widensRobot(const RobotLimits& before, const RobotLimits& after) {
    for (int k = 0; k < 6; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (after.free[i] &&
            (!before.free[i] || after.lower[k] < before.lower[k] || after.upper[k] > before.upper[k]))
            return true;
    }
    return after.maxSpeed_m_s > before.maxSpeed_m_s || after.maxRotation_rad_s > before.maxRotation_rad_s ||
           after.clearance_m < before.clearance_m ||
           widensAcceleration(before.maxAcceleration_m_s2, after.maxAcceleration_m_s2) ||
           widensAcceleration(before.maxAngularAcceleration_rad_s2, after.maxAngularAcceleration_rad_s2);
}

bool widensObjects(const Experiment& before, const Experiment& after) {
    return std::ranges::any_of(after.objects, [&](const ObjectSpec& object) {
        const auto was = std::ranges::find(before.objects, object.name, &ObjectSpec::name);
        return was != before.objects.end() && (warningLimit_K(after, object) > warningLimit_K(before, *was) ||
                                               tripLimit_K(after, object) > tripLimit_K(before, *was));
    });
}

/// An automatic one is kLeastRate_K_s or more; how much more depends on what is heated.
bool widensRate(const std::optional<double>& before, const std::optional<double>& after) {
    if (!after)
        return before.has_value();
    return *after > before.value_or(SafetySpec::kLeastRate_K_s);
}

bool widensWatch(const SafetySpec& before, const SafetySpec& after) {
    constexpr std::array raised{&SafetySpec::warning_K,    &SafetySpec::trip_K,
                                &SafetySpec::stalePeriods, &SafetySpec::heldLimit_s,
                                &SafetySpec::frozen_s,     &SafetySpec::warming_K,
                                &SafetySpec::crossCheck_K, &SafetySpec::sourceHeating_s,
                                &SafetySpec::sourceBand_K, &SafetySpec::sourceUnasked_K};
    return std::ranges::any_of(raised, [&](auto limit) { return after.*limit > before.*limit; }) ||
           after.jumps > before.jumps || after.leastDisk_MB < before.leastDisk_MB ||
           widensRate(before.largestRate_K_s, after.largestRate_K_s);
}

} // namespace

bool widensLimits(const Experiment& before, const Experiment& after) {
    return widensRobot(before.robot, after.robot) || widensObjects(before, after) ||
           sourceTripLimit_K(after) > sourceTripLimit_K(before) || widensWatch(before.safety, after.safety);
}

} // namespace bask
