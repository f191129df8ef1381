// How old calibrations are, in words.

#include "widgets/calibrate/calibration_age.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

const QDateTime kNow = QDateTime::fromString("2026-11-21T22:45:00Z", Qt::ISODate);

std::string before(qint64 seconds) {
    return kNow.addSecs(-seconds).toString(Qt::ISODate).toStdString();
}

} // namespace

// Catches: a span in the wrong unit or rounded up, and a date that is none or lies ahead taken for an age.
TEST(CalibrationAge, IsToldInTheUnitThatFits) {
    constexpr qint64 kMinute = 60, kHour = 60 * kMinute, kDay = 24 * kHour;
    const auto age = [](qint64 seconds) { return ageText(before(seconds), kNow); };
    EXPECT_EQ(age(0), "just now");
    EXPECT_EQ(age(59), "just now");
    EXPECT_TRUE(age(kMinute).startsWith("1 minute")) << age(kMinute).toStdString();
    EXPECT_TRUE(age(2 * kHour - 1).startsWith("119 minute"));
    EXPECT_TRUE(age(2 * kHour).startsWith("2 hour"));
    EXPECT_TRUE(age(2 * kDay - 1).startsWith("47 hour"));
    EXPECT_TRUE(age(2 * kDay).startsWith("2 day"));
    EXPECT_TRUE(age(400 * kDay).startsWith("400 day"));
    EXPECT_TRUE(age(-1).contains("future"));
    for (const char* wrong : {"", "yesterday", "2026-13-40T00:00:00Z"})
        EXPECT_EQ(ageText(wrong, kNow), "at an unknown time") << wrong;
    EXPECT_EQ(ageText(calibrationDate()), "just now") << calibrationDate();
}

// Catches: a rig without a camera that is told to lack calibrations, and one of three that goes unsaid.
TEST(CalibrationAge, OfTheCameraItsPlaceAndTheSource) {
    Experiment experiment;
    VisionSpec& vision = experiment.vision;
    EXPECT_TRUE(calibrationAges(experiment, kNow).isEmpty());
    vision.markers.emplace_back();
    QStringList ages = calibrationAges(experiment, kNow);
    ASSERT_EQ(ages.size(), 3);
    EXPECT_EQ(ages[0], "Camera not calibrated.");
    EXPECT_TRUE(ages[1].contains("not measured"));
    EXPECT_TRUE(ages[2].contains("as typed"));
    vision.camera.emplace();
    vision.cameraPose = Vector6d::Zero();
    vision.cameraPoseDate = before(7200);
    vision.sourcePoseDate = before(300);
    ages = calibrationAges(experiment, kNow);
    EXPECT_TRUE(ages[0].contains("at an unknown time"));
    EXPECT_TRUE(ages[1].contains("2 hour"));
    EXPECT_TRUE(ages[2].contains("5 minute"));
    experiment.simulation.thermalCamera.emplace(); // known as it is
    EXPECT_EQ(calibrationAges(experiment, kNow), ages);
}

TEST(CalibrationAge, OfTheThermalCamera) {
    Experiment experiment;
    ThermalCameraSpec& camera = experiment.rig.emplace().thermalCamera.emplace();
    QStringList ages = calibrationAges(experiment, kNow);
    ASSERT_EQ(ages.size(), 2);
    EXPECT_TRUE(ages[0].contains("not calibrated"));
    EXPECT_TRUE(ages[1].contains("not known"));
    camera.calibration.pose = Vector6d::Zero();
    EXPECT_TRUE(calibrationAges(experiment, kNow)[1].contains("as typed"));
    camera.calibration.poseDate = before(300);
    camera.calibration.lens.emplace();
    camera.calibration.lensDate = before(7200);
    ages = calibrationAges(experiment, kNow);
    EXPECT_TRUE(ages[0].contains("2 hour"));
    EXPECT_TRUE(ages[1].contains("5 minute"));
}

} // namespace bask
