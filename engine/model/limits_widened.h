#pragma once
// Which limits an experiment loosens compared with another: a person must confirm them first on a real rig.

#include "engine/model/experiment.h"

#include <optional>
#include <vector>

namespace bask {

/// Returns one LimitLooser for every limit of the robot, an object (a new object is compared with those
/// without limits of their own), the source or a device of the real rig (one that the device before did not
/// have is compared with the default) that is wider in `after`, for every check that is slower or less
/// sensitive, and for heat without a watchdog. Automatic limits count with their actual values. Empty if
/// nothing is loosened.
std::vector<Message> widenedLimits(const Experiment& before, const Experiment& after);
/// Like widenedLimits, compared with the defaults. Workspace and free axes belong to the rig and are not
/// compared.
std::vector<Message> widenedFromUsual(const Experiment& experiment);

/// Returns what `next` loosens on a real rig compared with the present experiment. If the present one is for
/// the simulated rig, whose limits nobody confirmed, compares with the defaults, and for workspace and free
/// axes with `real`, the robot of the previous real rig. Empty if `next` is for the simulated rig.
std::vector<Message> widenedOnRealRig(const Experiment& now, const Experiment& next,
                                      const std::optional<RobotLimits>& real = {});

/// Returns them as one sentence, LimitsLoosened; None if there are none.
Message limitsLoosened(const std::vector<Message>& widened);

/// Returns whether widenedLimits has any.
bool widensLimits(const Experiment& before, const Experiment& after);

} // namespace bask
