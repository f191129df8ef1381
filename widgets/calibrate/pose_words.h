#pragma once
// Numbers, lengths, angles and poses in words, as calibrations tell them.

#include "engine/base/pose.h"

#include <QString>

namespace bask {

/// "-1.2", with a true minus sign, and without a plus sign.
QString plainNumber(double value, int decimals);
/// "-1.2 mm".
QString millimetres(double length_m, int decimals = 1);
/// "1.25°".
QString degrees(double angle_rad, int decimals = 2);
/// "x 1.2 mm, y ...; turned by ... about x, y, z".
QString poseWords(const Pose& X);

} // namespace bask
