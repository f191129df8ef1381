#pragma once
// Verdicts on targets in words, and the nearest target that one object can reach.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"

#include <QString>

namespace bask {

/// Returns the verdict inside the workspace; a target within the source's range may still be outside it.
FeasibilityVerdict verdictHere(const TargetVerdict& verdict);

QString verdictWord(FeasibilityVerdict verdict); ///< "Reachable", "Too hot", "Too cold"
/// "needs F = 0.16, up to 0.93 here". `environment_K` names the room where it is the bound.
QString verdictDetail(const TargetVerdict& verdict, double environment_K, TemperatureUnit unit);

/// Returns the target if it is reachable, otherwise the limit of the reachable range, rounded inwards to a
/// tenth in the shown unit so that the displayed value is also reachable. K.
double nearestReachable_K(const TargetVerdict& verdict, TemperatureUnit unit);

QString axisName(int coordinate); ///< "z", "θx"
/// "θx +10.0°", "z +6.0 cm".
QString coordinateText(int coordinate, double value);
/// "x 1.2 cm, y -3.4 cm, θx 10.0°": the coordinates that the robot moves or that are not 0.
QString poseText(const Vector6d& pose, const RobotLimits& robot);
/// Returns "2.1 cm", for an angle "12.0°".
QString marginText(const PoseMargin& margin);
/// "clearance", "workspace z".
QString limitWord(const PoseMargin& margin);

} // namespace bask
