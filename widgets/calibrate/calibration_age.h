#pragma once
// How old an experiment's calibrations are, in words: for the checklist and the page.

#include "engine/model/vision_spec.h"

#include <QDateTime>
#include <QStringList>

namespace bask {

/// Now, as VisionSpec has its dates.
std::string calibrationDate();

/// "3 hours ago"; "at an unknown time" for a date that is none.
QString ageText(const std::string& date, const QDateTime& now = QDateTime::currentDateTimeUtc());

/// A sentence each for the camera, where it stands, and where the source is; none for a rig without markers
/// and camera.
QStringList calibrationAges(const VisionSpec& vision, const QDateTime& now = QDateTime::currentDateTimeUtc());

} // namespace bask
