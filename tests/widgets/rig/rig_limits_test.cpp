// Safety limits and the zeroing of the sensors on the Rig page.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/model/coordinate_range.h"
#include "tests/widgets/rig/rig_page_fixture.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/rig/axis_table.h"
#include "widgets/rig/coordinate_words.h"
#include "widgets/rig/thermal_camera_form.h"

#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

#include <map>

namespace bask {
namespace {

struct RigLimitsTest : test::RigPageFixture {
    RigLimitsTest() { child<QTabWidget>("rigTabs")->setCurrentIndex(1); }

    /// As a person types it.
    void type(const char* name, const QString& number) {
        auto* field = child<QDoubleSpinBox>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, number);
        QTest::keyClick(field, Qt::Key_Return);
    }
    QMessageBox* question() {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return page.findChild<QMessageBox*>("limitQuestion");
    }
    void answer(QMessageBox::ButtonRole role) {
        QMessageBox* box = question();
        ASSERT_TRUE(box);
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == role)
                return QTest::mouseClick(button, Qt::LeftButton);
    }
};

} // namespace

// Catches a limit that does not reach the experiment, in the wrong unit or rounding its neighbours.
TEST_F(RigLimitsTest, EveryLimitIsTheExperiments) {
    click("safetyMore");
    SafetySpec wanted = experiment.safety;
    wanted.warning_K = kelvinFromCelsius(110.0);
    wanted.trip_K = kelvinFromCelsius(140.0);
    type("safety.warning", "110");
    type("safety.trip", "140");
    const std::map<const char*, double SafetySpec::*> numbers{
        {"safety.heldLimit", &SafetySpec::pauseLimit_s},
        {"safety.stalePeriods", &SafetySpec::stalePeriods},
        {"safety.frozen", &SafetySpec::frozen_s},
        {"safety.warming", &SafetySpec::warming_K},
        {"safety.crossCheck", &SafetySpec::crossCheck_K},
        {"safety.sourceHeating", &SafetySpec::sourceHeating_s},
        {"safety.sourceBand", &SafetySpec::sourceBand_K},
        {"safety.sourceUnasked", &SafetySpec::sourceUnasked_K},
        {"safety.leastDisk", &SafetySpec::minDisk_MB},
    };
    double value = 11.0; // each another
    for (const auto& [name, limit] : numbers) {
        EXPECT_EQ(child<QDoubleSpinBox>(name)->value(), wanted.*limit) << name;
        type(name, QString::number(++value));
        wanted.*limit = value;
    }
    type("safety.jumps", "5");
    wanted.jumps = 5;
    EXPECT_EQ(experiment.safety, wanted);
    EXPECT_EQ(edits, 12);
    EXPECT_FALSE(question()); // simulated
}

// Catches an automatic limit that hides its number, or that cannot be had again.
TEST_F(RigLimitsTest, AutomaticLimitsAreShownAndLeft) {
    click("safetyMore");
    auto* field = child<QuantitySpinBox>("safety.sourceTrip");
    EXPECT_FALSE(field->isEnabled());
    EXPECT_NEAR(field->value_K(), experiment.source.temperature_K + 50.0, 1e-9);
    click("safety.sourceTripAutomatic");
    EXPECT_TRUE(field->isEnabled());
    EXPECT_EQ(experiment.safety.sourceTrip_K, experiment.source.temperature_K + 50.0);
    type("safety.sourceTrip", "230");
    EXPECT_NEAR(*experiment.safety.sourceTrip_K, kelvinFromCelsius(230.0), 1e-9);
    click("safety.sourceTripAutomatic");
    EXPECT_FALSE(experiment.safety.sourceTrip_K);

    EXPECT_FALSE(child<QDoubleSpinBox>("safety.largestRate")->isEnabled());
    click("safety.largestRateAutomatic");
    EXPECT_EQ(experiment.safety.largestRate_K_s, 2.0);
    type("safety.largestRate", "4.5");
    EXPECT_EQ(experiment.safety.largestRate_K_s, 4.5);
    click("safety.largestRateAutomatic");
    EXPECT_EQ(experiment.safety, SafetySpec());
}

// Catches a limit that stays shown though it was refused, and a refusal that is kept to itself.
TEST_F(RigLimitsTest, ARefusedLimitIsTakenBackInWords) {
    type("safety.trip", "100"); // under the warning
    EXPECT_NE(message(), "");
    EXPECT_NEAR(child<QuantitySpinBox>("safety.trip")->value_K(), kelvinFromCelsius(150.0), 1e-9);
    EXPECT_EQ(experiment.safety, SafetySpec());
    experiment.safety.sourceTrip_K = 520.0;
    page.setExperiment(experiment);
    refusal = "a run is on";
    click("safety.sourceTripAutomatic");
    EXPECT_FALSE(child<QCheckBox>("safety.sourceTripAutomatic")->isChecked());
    EXPECT_TRUE(child<QuantitySpinBox>("safety.sourceTrip")->isEnabled());
}

// Catches a limit of the real rig that one slip of the mouse wheel raises, and questions on the way down.
TEST_F(RigLimitsTest, RaisingALimitOfTheRealRigAsks) {
    useReal();
    type("safety.trip", "140"); // lower
    EXPECT_FALSE(question());
    EXPECT_NEAR(experiment.safety.trip_K, kelvinFromCelsius(140.0), 1e-9);
    type("safety.trip", "145");
    ASSERT_TRUE(question());
    EXPECT_FALSE(question()->isModal()); // STOP stays within reach
    EXPECT_TRUE(question()->text().startsWith(
        QStringLiteral("Objects: trip: 145.0\u00a0\u00b0C instead of 140.0\u00a0\u00b0C")))
        << question()->text().toStdString();
    EXPECT_NEAR(child<QuantitySpinBox>("safety.trip")->value_K(), kelvinFromCelsius(140.0), 1e-9);
    QTest::keyClick(question(), Qt::Key_Return); // the default answer
    EXPECT_FALSE(question());
    EXPECT_NEAR(experiment.safety.trip_K, kelvinFromCelsius(140.0), 1e-9);
    type("safety.trip", "145");
    answer(QMessageBox::AcceptRole);
    EXPECT_NEAR(experiment.safety.trip_K, kelvinFromCelsius(145.0), 1e-9);
    EXPECT_FALSE(question());

    const double top_m = experiment.robot.upper[kZ];
    type("upper.z", QString::number(1000.0 * top_m + 10.0));
    ASSERT_TRUE(question());
    EXPECT_TRUE(question()->text().contains("instead of")) << question()->text().toStdString();
    EXPECT_EQ(experiment.robot.upper[kZ], top_m);
    answer(QMessageBox::AcceptRole);
    EXPECT_NEAR(experiment.robot.upper[kZ], top_m + 0.01, 1e-9);
    type("clearance", "30");
    EXPECT_FALSE(question());
}

// Catches a yes that undoes what was changed meanwhile, or that comes when a run is armed.
TEST_F(RigLimitsTest, AQuestionEndsWithWhatItWasAbout) {
    useReal();
    type("safety.heldLimit", "20");
    ASSERT_TRUE(question());
    experiment.objects[0].target_K += 1.0; // on another page
    page.setExperiment(experiment);
    EXPECT_FALSE(question());
    type("safety.heldLimit", "20");
    ASSERT_TRUE(question());
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.state = RunState::Armed;
    page.apply(snapshot, false);
    EXPECT_FALSE(question());
    EXPECT_FALSE(child<QDoubleSpinBox>("safety.heldLimit")->isEnabled());
    EXPECT_FALSE(child<QuantitySpinBox>("safety.sourceTrip")->isEnabled());
    EXPECT_EQ(experiment.safety, SafetySpec());
}

TEST_F(RigLimitsTest, ObjectsWithLimitsOfTheirOwnAreTold) {
    EXPECT_FALSE(child<QLabel>("ownLimits")->isVisible());
    experiment.objects[1].warning_K = kelvinFromCelsius(90.0);
    page.setExperiment(experiment);
    EXPECT_TRUE(child<QLabel>("ownLimits")->isVisible());
    EXPECT_EQ(text("ownLimits"),
              QStringLiteral("right has limits of its own: warning 90.0\u00a0\u00b0C, trip "
                             "150.0\u00a0\u00b0C."));
}

// Catches a zeroing that is not asked for, and one whose when, where and why not the page keeps to itself.
TEST_F(RigLimitsTest, TheSensorsAreZeroedFromThePage) {
    EXPECT_TRUE(text("zeroState").contains("Not zeroed yet"));
    click("zeroSensors");
    ASSERT_TRUE(last<ZeroSensors>());
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.zeroing = {1.7e9, kelvinFromCelsius(24.93), {-0.12, 1.3}};
    snapshot.zeroProblem = {MessageCode::ReasonNotAtAmbient, {"25"}};
    page.apply(snapshot, true);
    EXPECT_TRUE(text("zeroState").contains("2023")) << text("zeroState").toStdString();
    EXPECT_TRUE(text("zeroState").contains(QStringLiteral("24.93\u00a0\u00b0C")));
    EXPECT_EQ(text("zeroOffsets"), QStringLiteral("Offsets: left \u22120.12\u00a0K, right +1.30\u00a0K. That "
                                                  "of right is large: check the sensor and its wiring."));
    EXPECT_FALSE(child<QPushButton>("zeroSensors")->isEnabled());
    EXPECT_TRUE(text("zeroProblem").contains("temperature"));
    snapshot.heatOn = true;
    page.apply(snapshot, true);
    EXPECT_EQ(text("zeroProblem"), "Not while the heat is on.");
    apply();
    EXPECT_TRUE(child<QPushButton>("zeroSensors")->isEnabled());
    EXPECT_FALSE(child<QLabel>("zeroProblem")->isVisible());
}

// Catches a field that shows a value of a file as another: the page with a narrower range than files have.
TEST_F(RigLimitsTest, TheSourceAndTheWorkspaceAreShownAsAFileMayHaveThem) {
    experiment.robot.free.fill(true);
    for (const bool isUpper : {false, true}) {
        for (int k = 0; k < 6; ++k) {
            const ValidRange range = coordinateRange(k, kMaxPlace_cm, true);
            const EdgeUnit unit = coordinateUnit(k);
            experiment.robot.lower[k] = toSi(isUpper ? 0.5 * range.min : range.min, unit);
            experiment.robot.upper[k] = toSi(isUpper ? range.max : 0.5 * range.max, unit);
        }
        experiment.source.emittance = isUpper ? 1.0 : 0.0004;
        experiment.source.temperature_K =
            kelvinFromCelsius(isUpper ? kMaxTemperature_degC : kMinTemperature_degC);
        page.setExperiment(experiment);
        EXPECT_EQ(child<QDoubleSpinBox>("sourceEmittance")->value(), experiment.source.emittance);
        EXPECT_NEAR(child<QuantitySpinBox>("sourceSetPoint")->value_K(), experiment.source.temperature_K,
                    1e-9);
        for (int k = 0; k < 6; ++k) {
            const auto shown = [&](const char* part) {
                return child<QDoubleSpinBox>(coordinateObjectName(part, k).toLatin1())->value();
            };
            EXPECT_NEAR(shown("lower"), shownCoordinate(k, experiment.robot.lower[k]), 1e-9) << k;
            EXPECT_NEAR(shown("upper"), shownCoordinate(k, experiment.robot.upper[k]), 1e-9) << k;
        }
    }
    EXPECT_EQ(child<QDoubleSpinBox>("upper.theta_y")->maximum(), 90.0) << "more would be refused";
    EXPECT_EQ(edits, 0);
}

// The same of the axes of a robot, and of a thermal camera's pose.
TEST(RigForms, AxesAndAThermalCamerasPoseAreShownAsAFileMayHaveThem) {
    AxisTable table;
    ThermalCameraForm form;
    for (const double sign : {-1.0, 1.0}) {
        std::vector<AxisSpec> axes;
        Vector6d pose;
        for (int k = 0; k < 6; ++k) {
            axes.push_back({"XYZABC"[k], k, false, sign * maxAxisOrigin(k)});
            pose[k] = toSi(sign * coordinateRange(k, kMaxPlace_cm, false).max, coordinateUnit(k));
        }
        table.setAxes(axes);
        ThermalCameraSpec camera = form.camera();
        camera.calibration.pose = pose;
        form.setCamera(camera);
        for (int k = 0; k < 6; ++k) {
            const auto* origin = table.findChild<QDoubleSpinBox*>(coordinateObjectName("origin", k));
            const auto* place = form.findChild<QDoubleSpinBox*>(coordinateObjectName("thermalPose", k));
            EXPECT_NEAR(origin->value(), shownCoordinate(k, sign * maxAxisOrigin(k)), 1e-9) << k;
            EXPECT_NEAR(place->value(), shownCoordinate(k, pose[k]), 1e-9) << k;
            EXPECT_NEAR(place->maximum(), std::abs(place->value()), 1e-9) << k << ": more would be refused";
        }
    }
}

} // namespace bask
