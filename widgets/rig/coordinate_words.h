#pragma once
// The end-effector's coordinates as a person reads them: millimetres and degrees.

#include "engine/base/pose.h"

#include <QString>

namespace bask {

QString coordinateWord(int coordinate);            ///< "x", "θx"
QString coordinateSymbol(int coordinate);          ///< " mm", "°": as it follows a figure
double shownCoordinate(int coordinate, double si); ///< mm or degrees from m or rad
double coordinateFromShown(int coordinate, double shown);
/// Returns "axis.theta_x", the object name of a control for one coordinate.
QString coordinateObjectName(const char* part, int coordinate);
/// "12.3 mm", "-4.0°" with a true minus sign.
QString coordinateReadout(int coordinate, double si);

} // namespace bask
