#include "widgets/calibrate/pose_words.h"

#include "engine/base/units.h"
#include "widgets/common/display.h"

#include <QCoreApplication>

namespace bask {
namespace {

struct PoseWords {
    Q_DECLARE_TR_FUNCTIONS(PoseWords)
};

} // namespace

QString plainNumber(double value, int decimals) {
    return formatSigned(value, decimals).remove(QLatin1Char('+'));
}

QString millimetres(double length_m, int decimals) {
    return PoseWords::tr("%1 mm").arg(plainNumber(1000.0 * length_m, decimals));
}

QString degrees(double angle_rad, int decimals) {
    return PoseWords::tr("%1\u00b0").arg(plainNumber(degFromRad(angle_rad), decimals));
}

QString poseWords(const Pose& X) {
    const Vector6d q = coordinatesFromPose(X);
    return PoseWords::tr("x %1, y %2, z %3; turned by %4, %5, %6 about x, y, z")
        .arg(millimetres(q[kX]), millimetres(q[kY]), millimetres(q[kZ]), degrees(q[kThetaX]),
             degrees(q[kThetaY]), degrees(q[kThetaZ]));
}

} // namespace bask
