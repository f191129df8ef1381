#pragma once
// What an experiment allows more than another: what a person is asked about first on a real rig.

#include "engine/model/experiment.h"

#include <optional>
#include <vector>

namespace bask {

/// Every limit of the robot, an object (a new one's against those without limits of their own) or the source
/// that is wider in `after`, every watch that is slower or blunter, and heat without a watchdog: a
/// LimitLooser each. Limits that are automatic count as what they amount to. None: it allows nothing more.
std::vector<Message> widenedLimits(const Experiment& before, const Experiment& after);
/// The same against what is set where nothing is said. Workspace and free axes are the rig's own and left
/// out.
std::vector<Message> widenedFromUsual(const Experiment& experiment);

/// What `next` allows a real rig more than is set now; where that is the simulated rig, whose limits nobody
/// was asked about, more than the usual, and in workspace and free axes more than `real`, the robot of the
/// real rig that was there before. None where `next` is for the simulated rig.
std::vector<Message> widenedOnRealRig(const Experiment& now, const Experiment& next,
                                      const std::optional<RobotLimits>& real = {});

/// In one sentence, LimitsLoosened; None without any.
Message limitsLoosened(const std::vector<Message>& widened);

/// True if there is any of widenedLimits.
bool widensLimits(const Experiment& before, const Experiment& after);

} // namespace bask
