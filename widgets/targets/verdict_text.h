#pragma once
// Verdicts on targets in words, and the nearest target that one object can reach.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"

#include <QString>

namespace bask {

/// What a verdict amounts to inside the workspace; a target within the source's range may still lie outside
/// it.
FeasibilityVerdict verdictHere(const TargetVerdict& verdict);

QString verdictWord(FeasibilityVerdict verdict); ///< "Reachable", "Too hot", "Too cold"
/// "needs F = 0.16, up to 0.93 here". `environment_K` names the room where it is the bound.
QString verdictDetail(const TargetVerdict& verdict, double environment_K, TemperatureUnit unit);

/// The target itself if it is reachable, else the bound of the reachable range, rounded inwards to a tenth in
/// the unit shown so that what is displayed is reachable too. K.
double nearestReachable_K(const TargetVerdict& verdict, TemperatureUnit unit);

QString axisName(int coordinate); ///< "z", "θx"
/// "θx +10.0°", "z +6.0 cm".
QString coordinateText(int coordinate, double value);
/// "x 1.2 cm, y -3.4 cm, θx 10.0°": the coordinates that the robot moves or that are not 0.
QString poseText(const Vector6d& pose, const RobotLimits& robot);
/// "2.1 cm", of an angle "12.0°".
QString marginText(const PoseMargin& margin);
/// "clearance", "workspace z".
QString limitWord(const PoseMargin& margin);

} // namespace bask
