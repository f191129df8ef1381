#pragma once
// Sections of a run's report: its setup, whether its targets could be held, its calibration. HTML.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"
#include "engine/recording/session_file.h"

#include <QString>

namespace bask {

QString setupSection(const SessionRecord& session, TemperatureUnit unit);
/// `verdict` is that of `targets_K`, the last ones of the run; empty if it was not computed.
QString feasibilitySection(const SessionRecord& session, const std::vector<double>& targets_K,
                           const std::optional<JointVerdict>& verdict, TemperatureUnit unit);
QString calibrationSection(const SessionRecord& session);

/// Returns the targets at the end of the run, or the experiment's if there is no sample.
std::vector<double> lastTargets_K(const SessionRecord& session);

} // namespace bask
