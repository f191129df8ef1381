#include "widgets/rig/coordinate_words.h"

#include "engine/base/units.h"
#include "widgets/common/display.h"

#include <array>

namespace bask {

QString coordinateWord(int coordinate) {
    static const std::array<QString, 6> words{QStringLiteral("x"),       QStringLiteral("y"),
                                              QStringLiteral("z"),       QStringLiteral("\u03b8x"),
                                              QStringLiteral("\u03b8y"), QStringLiteral("\u03b8z")};
    return words[static_cast<std::size_t>(coordinate)];
}

QString coordinateSymbol(int coordinate) {
    return coordinate < kThetaX ? QStringLiteral("\u00a0mm") : QStringLiteral("\u00b0");
}

double shownCoordinate(int coordinate, double si) {
    return coordinate < kThetaX ? kMmPerM * si : degFromRad(si);
}

double coordinateFromShown(int coordinate, double shown) {
    return coordinate < kThetaX ? shown / kMmPerM : radFromDeg(shown);
}

QString coordinateObjectName(const char* part, int coordinate) {
    return QStringLiteral("%1.%2").arg(QLatin1String(part),
                                       QLatin1String(kCoordinateNames[static_cast<std::size_t>(coordinate)]));
}

QString coordinateReadout(int coordinate, double si) {
    return formatSigned(shownCoordinate(coordinate, si), 2).remove(u'+') + coordinateSymbol(coordinate);
}

} // namespace bask
