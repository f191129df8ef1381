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

QStringList agesOf(const ThermalCalibration& thermal, const QDateTime& now) {
    return {
        thermal.lens
            ? CalibrationAge::tr("Thermal camera's lens calibrated %1.").arg(ageText(thermal.lensDate, now))
            : CalibrationAge::tr("Thermal camera's lens not calibrated."),
        !thermal.pose ? CalibrationAge::tr("The thermal camera's place is not known.")
        : thermal.poseDate.empty()
            ? CalibrationAge::tr("The thermal camera's place is as typed, not measured.")
            : CalibrationAge::tr("The thermal camera's place was measured %1.")
                  .arg(ageText(thermal.poseDate, now))};
}

} // namespace

QStringList calibrationAges(const Experiment& experiment, const QDateTime& now) {
    QStringList ages = agesOf(experiment.vision, now);
    const bool isSimulated = !experiment.rig;
    const ThermalCalibration thermal = thermalCalibration(experiment, isSimulated);
    const bool isKnownAsItIs = isSimulated && thermal == ThermalCalibration();
    if (thermalProfile(experiment, isSimulated) && !isKnownAsItIs)
        ages += agesOf(thermal, now);
    return ages;
}

} // namespace bask
