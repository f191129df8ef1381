#include "widgets/calibrate/calibration_age.h"

#include <QCoreApplication>

namespace bask {
namespace {

struct CalibrationAge {
    Q_DECLARE_TR_FUNCTIONS(bask::CalibrationAge)
};

} // namespace

std::string calibrationDate() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

QString ageText(const std::string& date, const QDateTime& now) {
    const QDateTime then = QDateTime::fromString(QString::fromStdString(date), Qt::ISODate);
    if (!then.isValid())
        return CalibrationAge::tr("at an unknown time");
    const qint64 seconds = then.secsTo(now);
    if (seconds < 0)
        return CalibrationAge::tr("in the future: check the computer's clock");
    const auto minutes = static_cast<int>(seconds / 60);
    if (minutes < 1)
        return CalibrationAge::tr("just now");
    if (minutes < 120)
        return CalibrationAge::tr("%n minute(s) ago", nullptr, minutes);
    if (minutes < 48 * 60)
        return CalibrationAge::tr("%n hour(s) ago", nullptr, minutes / 60);
    return CalibrationAge::tr("%n day(s) ago", nullptr, minutes / (24 * 60));
}

namespace {

QStringList agesOf(const VisionSpec& vision, const QDateTime& now) {
    if (vision.markers.empty() && !vision.camera)
        return {};
    return {vision.camera ? CalibrationAge::tr("Camera calibrated %1.").arg(ageText(vision.cameraDate, now))
                          : CalibrationAge::tr("Camera not calibrated."),
            vision.cameraPose ? CalibrationAge::tr("Where the camera stands was measured %1.")
                                    .arg(ageText(vision.cameraPoseDate, now))
                              : CalibrationAge::tr("Where the camera stands is not measured."),
            vision.sourcePoseDate.empty()
                ? CalibrationAge::tr("The source's place is as typed, not measured by the camera.")
                : CalibrationAge::tr("The source's place was measured %1.")
                      .arg(ageText(vision.sourcePoseDate, now))};
}

/// What is not measured of a simulated camera is as it is.
QStringList agesOf(const ThermalCalibration& thermal, bool isSimulated, const QDateTime& now) {
    QStringList ages;
    if (thermal.lens)
        ages
            << CalibrationAge::tr("Thermal camera's lens calibrated %1.").arg(ageText(thermal.lensDate, now));
    else if (!isSimulated)
        ages << CalibrationAge::tr("Thermal camera's lens not calibrated.");
    if (thermal.pose && !thermal.poseDate.empty())
        ages << CalibrationAge::tr("The thermal camera's place was measured %1.")
                    .arg(ageText(thermal.poseDate, now));
    else if (thermal.pose)
        ages << CalibrationAge::tr("The thermal camera's place is as typed, not measured.");
    else if (!isSimulated)
        ages << CalibrationAge::tr("The thermal camera's place is not known.");
    return ages;
}

} // namespace

QStringList calibrationAges(const Experiment& experiment, const QDateTime& now) {
    QStringList ages = agesOf(experiment.vision, now);
    const bool isSimulated = !experiment.rig;
    if (thermalProfile(experiment, isSimulated))
        ages += agesOf(thermalCalibration(experiment, isSimulated), isSimulated, now);
    return ages;
}

} // namespace bask
