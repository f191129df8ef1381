#pragma once
// The age of an experiment's calibrations in words, for the checklist and the page.

#include "engine/model/experiment.h"

#include <QDateTime>
#include <QStringList>

namespace bask {

/// Returns the current time in the date format of VisionSpec.
std::string calibrationDate();

/// Returns "3 hours ago"; "at an unknown time" if the date is invalid.
QString ageText(const std::string& date, const QDateTime& now = QDateTime::currentDateTimeUtc());

/// Returns one sentence each for the camera, its pose, and the source's pose, if the rig has markers or a
/// camera; and for the thermal camera's lens and pose, but of a simulated one that is known as it is.
QStringList calibrationAges(const Experiment& experiment,
                            const QDateTime& now = QDateTime::currentDateTimeUtc());

} // namespace bask
