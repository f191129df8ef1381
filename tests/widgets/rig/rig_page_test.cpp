// The Rig page as a person uses it: which rig, its devices, the checklist, the heat, the limits.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "tests/support/longer_translator.h"
#include "tests/widgets/rig/rig_page_fixture.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"
#include "widgets/rig/device_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QTabWidget>

#include <limits>

namespace bask {
namespace {

struct RigPageTest : test::RigPageFixture {
    DeviceDialog* dialog() {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return page.findChild<DeviceDialog*>("deviceDialog");
    }
};

} // namespace

// Catches a real rig whose set-up is gone after one click on the simulated one.
TEST_F(RigPageTest, TheRealRigIsKeptWhileTheSimulatedOneIsUsed) {
    useReal();
    EXPECT_TRUE(child<QRadioButton>("useReal")->isChecked());
    click("useSimulated");
    EXPECT_FALSE(experiment.rig);
    EXPECT_EQ(text("state.robot"), "Simulated");
    EXPECT_FALSE(child<QPushButton>("setUp.robot")->isVisible());
    EXPECT_FALSE(child<QPushButton>("saveRig")->isEnabled());
    click("useReal");
    EXPECT_EQ(experiment.rig, test::realRig());
    EXPECT_EQ(edits, 2);
    click("useReal"); // it is in use: nothing to do
    EXPECT_EQ(edits, 2);
}

// Catches a choice that shows what was asked for instead of what is in use.
TEST_F(RigPageTest, ARefusedChoiceIsTakenBackInWords) {
    refusal = "a run is on";
    click("useReal");
    EXPECT_TRUE(child<QRadioButton>("useSimulated")->isChecked());
    EXPECT_EQ(child<MessageBar>("rigMessage")->sentence(), refusal);
    refusal.clear();
    click("useReal");
    EXPECT_TRUE(experiment.rig);
    EXPECT_EQ(child<MessageBar>("rigMessage")->sentence(), "");
}

// Catches a rig of three sensors that cannot be used for two objects, or whose channels change unsaid.
TEST_F(RigPageTest, ARigOfOtherObjectsIsMadeToFitAndSaid) {
    RigSpec rig = test::realRig();
    rig.thermometer->channels = {3, 1, 2};
    page.useRig(rig);
    ASSERT_TRUE(experiment.rig);
    EXPECT_EQ(experiment.rig->thermometer->channels, (std::vector{3, 1}));
    EXPECT_TRUE(child<MessageBar>("rigMessage")->sentence().contains("3 objects"));
}

// Catches a choice that is shown and not made, or made where no camera is, and the channel of another sensor.
TEST_F(RigPageTest, WhatReadsAnObjectIsChosen) {
    const auto choose = [this](const char* name, ReadBy readBy) {
        auto* box = child<QComboBox>(name);
        box->setCurrentIndex(static_cast<int>(readBy));
        emit box->activated(static_cast<int>(readBy));
    };
    choose("readBy.1", ReadBy::Both);
    EXPECT_EQ(experiment.objects[1].readBy, ReadBy::Both);
    EXPECT_TRUE(experiment.simulation.thermalCamera); // the simulated rig gets one
    EXPECT_TRUE(child<QWidget>("setUp.thermalCamera")->parentWidget()->isVisible());
    EXPECT_FALSE(child<QLabel>("readByNote")->isVisible());
    useReal();
    click("setUp.thermalCamera"); // catches a card that the page forgets
    ASSERT_TRUE(dialog());
    EXPECT_EQ(dialog()->role(), DeviceRole::ThermalCamera);
    click("cancelDevice");
    experiment.rig->thermometer->channels = {5, 2};
    page.setExperiment(experiment);
    choose("readBy.0", ReadBy::Camera);
    EXPECT_EQ(experiment.rig->thermometer->channels, std::vector{2});
    EXPECT_TRUE(text("check.devices").contains("Thermal camera")) << qPrintable(text("check.devices"));
    choose("readBy.0", ReadBy::Contact);
    EXPECT_EQ(experiment.rig->thermometer->channels, (std::vector{5, 2}));
    experiment.rig->thermalCamera.emplace().device = "0";
    experiment.rig->thermalCamera->profile = findThermalProfile("p2-pro").value();
    page.setExperiment(experiment);
    EXPECT_TRUE(child<QLabel>("readByNote")->isVisible()); // its pose is not known
    refusal = "a run is on";
    choose("readBy.0", ReadBy::Camera);
    EXPECT_EQ(child<QComboBox>("readBy.0")->currentIndex(), 0); // as it still is
}

// Catches a state, an age or a problem that the page keeps to itself, and a state told by colour alone.
TEST_F(RigPageTest, TheCardsTellHowTheDevicesAre) {
    useReal();
    EXPECT_EQ(text("driver.robot"), QStringLiteral("Grbl or grblHAL (G-code) \u00b7 /dev/ttyROBOT"));
    EXPECT_EQ(text("state.robot"), "Live");
    EXPECT_EQ(text("age.robot"), "12 ms ago, 10.0 Hz");
    EXPECT_EQ(text("state.camera"), "None");
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.devices[0].status.link = LinkState::Lost;
    snapshot.devices[0].status.problem = {MessageCode::LinkLost, {"/dev/ttyROBOT", "unplugged"}};
    snapshot.devices[1].status.link = LinkState::Opening;
    snapshot.devices[1].age_s = 1e300;
    page.apply(snapshot, true);
    EXPECT_EQ(text("state.robot"), "Lost");
    EXPECT_TRUE(text("problem.robot").contains("unplugged")) << text("problem.robot").toStdString();
    EXPECT_TRUE(child<QLabel>("problem.robot")->isVisible());
    EXPECT_EQ(text("state.thermometer"), "Opening");
    EXPECT_EQ(text("age.thermometer"), "");
    snapshot = test::quietSnapshot(experiment);
    snapshot.devices[0].status.discarded = 3;
    page.apply(snapshot, true);
    EXPECT_EQ(text("age.robot"), "12 ms ago, 10.0 Hz, 3 answer(s) discarded"); // English is in its own file
    EXPECT_FALSE(child<QLabel>("age.robot")->toolTip().contains("The last of them"));
    snapshot.devices[0].status.lastDiscarded = {MessageCode::ThermalPictureConstant, {}};
    page.apply(snapshot, true);
    EXPECT_TRUE(child<QLabel>("age.robot")->toolTip().contains("The last of them: all pixels"))
        << child<QLabel>("age.robot")->toolTip().toStdString();
    EXPECT_FALSE(child<QLabel>("problem.robot")->isVisible());
}

// Catches another device at a port of which nobody can say that it is the right one.
TEST_F(RigPageTest, AnotherDeviceIsToldAndAccepted) {
    useReal();
    EXPECT_FALSE(child<QAbstractButton>("accept.robot")->isVisible());
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.devices[0].status.identity = "Grbl 1.1h";
    page.apply(snapshot, true);
    EXPECT_EQ(text("state.robot"), "Live: Grbl 1.1h");
    snapshot.devices[0].status.link = LinkState::Opening;
    snapshot.devices[0].status.problem = {MessageCode::DeviceExchanged, {"/dev/ttyROBOT", "left", "right"}};
    page.apply(snapshot, true);
    EXPECT_TRUE(text("problem.robot").contains("right")) << text("problem.robot").toStdString();
    click("accept.robot");
    const auto* accepted = last<AcceptDevice>();
    ASSERT_TRUE(accepted);
    EXPECT_EQ(accepted->role, DeviceRole::Robot);
}

// Catches a device that is set up in the dialog and not in the experiment, or the other way round.
TEST_F(RigPageTest, ADeviceIsSetUpTriedAndUsed) {
    page.useRig(RigSpec());
    click("setUp.robot");
    ASSERT_TRUE(dialog());
    EXPECT_TRUE(last<ListPorts>());
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.ports.emplace().push_back({"/dev/ttyUSB7", "FTDI"});
    page.apply(snapshot, true);
    QTest::mouseClick(dialog()->findChild<QPushButton*>("tryDevice"), Qt::LeftButton);
    ASSERT_TRUE(last<TryDevice>());
    EXPECT_EQ(last<TryDevice>()->rig.robot->port, "/dev/ttyUSB7");
    EXPECT_FALSE(experiment.rig->robot); // only tried
    snapshot.ports.reset();
    snapshot.tried.emplace().state.status.identity = "Grbl 1.1h";
    page.apply(snapshot, true);
    EXPECT_TRUE(dialog()->findChild<QLabel*>("tryResult")->text().contains("Grbl 1.1h"));

    QTest::mouseClick(dialog()->findChild<QPushButton*>("useDevice"), Qt::LeftButton);
    ASSERT_TRUE(last<TryDevice>()); // its port is let go for the rig
    EXPECT_EQ(last<TryDevice>()->rig, RigSpec());
    ASSERT_TRUE(experiment.rig->robot);
    EXPECT_EQ(experiment.rig->robot->port, "/dev/ttyUSB7");
    EXPECT_FALSE(dialog());
    click("remove.robot");
    EXPECT_FALSE(experiment.rig->robot);
}

// Catches a dialog that closes on a refusal, hides it, or keeps a port open after Cancel.
TEST_F(RigPageTest, ARefusedDeviceStaysInItsDialog) {
    page.useRig(test::realRig());
    click("setUp.thermometer");
    dialog()->findChild<QComboBox*>("port")->setEditText("/dev/ttyROBOT"); // the robot's
    QTest::mouseClick(dialog()->findChild<QPushButton*>("useDevice"), Qt::LeftButton);
    ASSERT_TRUE(dialog());
    EXPECT_TRUE(dialog()->findChild<MessageBar*>("deviceMessage")->sentence().contains("two devices are on"));
    EXPECT_EQ(child<MessageBar>("rigMessage")->sentence(), "");
    EXPECT_EQ(experiment.rig, test::realRig());
    QTest::mouseClick(dialog()->findChild<QPushButton*>("tryDevice"), Qt::LeftButton);
    QTest::mouseClick(dialog()->findChild<QPushButton*>("cancelDevice"), Qt::LeftButton);
    ASSERT_TRUE(last<TryDevice>());
    EXPECT_EQ(last<TryDevice>()->rig, RigSpec());
    EXPECT_FALSE(dialog());
    const std::size_t count = sent.size();
    click("setUp.robot"); // looked at only: nothing to end
    QTest::mouseClick(dialog()->findChild<QPushButton*>("cancelDevice"), Qt::LeftButton);
    EXPECT_EQ(sent.size(), count + 1); // ListPorts
}

// Catches devices, limits or motion that can be changed during a run.
TEST_F(RigPageTest, ARunLocksThePage) {
    useReal();
    click("setUp.robot");
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.state = RunState::Armed;
    page.apply(snapshot, false);
    EXPECT_FALSE(dialog());
    for (const char* name : {"useSimulated", "useReal", "openRig", "setUp.robot", "remove.robot", "stepUp.x",
                             "goToPose", "heatOn"})
        EXPECT_FALSE(child<QAbstractButton>(name)->isEnabled()) << name;
    EXPECT_FALSE(child<QDoubleSpinBox>("upper.z")->isEnabled());
    EXPECT_TRUE(child<QLabel>("manualReason")->isVisible());
    snapshot.state = RunState::Fault; // may be set up, not moved
    page.apply(snapshot, true);
    EXPECT_TRUE(child<QPushButton>("setUp.robot")->isEnabled());
    EXPECT_FALSE(child<QAbstractButton>("stepUp.x")->isEnabled());
    EXPECT_TRUE(text("manualReason").contains("Reset"));
    apply();
    EXPECT_TRUE(child<QAbstractButton>("stepUp.x")->isEnabled());
    EXPECT_FALSE(child<QLabel>("manualReason")->isVisible());
}

// Catches a real source that heats by one slip of the mouse, and a question where nothing can happen.
TEST_F(RigPageTest, HeatOnTheRealRigAsksOnTheWayUpOnly) {
    child<QuantitySpinBox>("heatSetPoint")->setValue_K(350.0);
    click("heatOn"); // simulated
    ASSERT_TRUE(last<SetHeat>());
    EXPECT_NEAR(*last<SetHeat>()->setPoint_K, 350.0, 1e-9);

    useReal();
    sent.clear();
    click("heatOn");
    auto* question = child<QMessageBox>("heatQuestion");
    EXPECT_FALSE(question->isModal()); // STOP stays within reach
    EXPECT_TRUE(sent.empty());
    QTest::keyClick(question, Qt::Key_Return); // the default answer
    EXPECT_TRUE(sent.empty());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    click("heatOn");
    for (QAbstractButton* button : child<QMessageBox>("heatQuestion")->buttons())
        if (child<QMessageBox>("heatQuestion")->buttonRole(button) == QMessageBox::AcceptRole)
            QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(last<SetHeat>());
    EXPECT_NEAR(*last<SetHeat>()->setPoint_K, 350.0, 1e-9);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.heatSetPoint_K = 350.0;
    page.apply(snapshot, true);
    EXPECT_TRUE(text("heatState").contains(QStringLiteral("Heating towards 76.9\u00a0\u00b0C")));
    child<QuantitySpinBox>("heatSetPoint")->setValue_K(340.0); // less
    click("heatOn");
    EXPECT_NEAR(*last<SetHeat>()->setPoint_K, 340.0, 1e-9);
    click("heatOff");
    ASSERT_TRUE(last<SetHeat>());
    EXPECT_FALSE(last<SetHeat>()->setPoint_K);
}

// Catches a source kept hot by a person that is offered switches, or no place to type.
TEST_F(RigPageTest, ATypedTemperatureReachesTheEngine) {
    useReal();
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.isSourceManual = true;
    page.apply(snapshot, true);
    EXPECT_FALSE(child<QPushButton>("heatOn")->isVisible());
    auto* field = child<QuantitySpinBox>("typedSource");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "180");
    QTest::keyClick(field, Qt::Key_Return);
    click("takeTyped");
    ASSERT_TRUE(last<TypeSourceTemperature>());
    EXPECT_NEAR(last<TypeSourceTemperature>()->temperature_K, kelvinFromCelsius(180.0), 1e-9);
}

// Catches a limit that is read in the wrong unit, rounds its neighbours, or stays shown though refused.
TEST_F(RigPageTest, LimitsAreTheExperiments) {
    child<QTabWidget>("rigTabs")->setCurrentIndex(1);
    const RobotLimits before = experiment.robot;
    child<QDoubleSpinBox>("upper.z")->setValue(250.0);
    EXPECT_NEAR(experiment.robot.upper[kZ], 0.25, 1e-12);
    child<QDoubleSpinBox>("maxRotation")->setValue(9.0);
    EXPECT_NEAR(experiment.robot.maxRotation_rad_s, radFromDeg(9.0), 1e-12);
    child<QDoubleSpinBox>("clearance")->setValue(12.0);
    EXPECT_NEAR(experiment.robot.clearance_m, 0.012, 1e-12);
    EXPECT_EQ(experiment.robot.lower, before.lower); // to the last digit
    EXPECT_EQ(edits, 3);
    child<QDoubleSpinBox>("upper.z")->setValue(-900.0); // under the lower one
    EXPECT_NE(child<MessageBar>("rigMessage")->sentence(), "");
    EXPECT_NEAR(child<QDoubleSpinBox>("upper.z")->value(), 250.0, 1e-9);
    child<QDoubleSpinBox>("sourceEmittance")->setValue(0.5);
    EXPECT_NEAR(experiment.source.emittance, 0.5, 1e-12);
    EXPECT_FALSE(child<QDoubleSpinBox>("upper.theta_z")->isVisible()); // not free
}

// Catches parts of a source that an edit loses, or of which the page says nothing.
TEST_F(RigPageTest, TheSourceTellsHowEvenItIs) {
    EXPECT_EQ(child<QLabel>("sourceEvenness")->text(), "even");
    experiment.source.uneven.profile = {{0.0, 1.0}, {0.05, 0.5}};
    page.setExperiment(experiment);
    EXPECT_EQ(child<QLabel>("sourceEvenness")->text(),
              "Radial profile of 2 points, radiating 34 to 100 % of what an even one does");
    child<QDoubleSpinBox>("sourceEmittance")->setValue(0.5);
    EXPECT_EQ(experiment.source.uneven.profile.size(), 2U);
    EXPECT_EQ(experiment.source.emittance, 0.5);
}

// Catches a tick where something is wrong, and reasons of the engine that are not shown.
TEST_F(RigPageTest, TheChecklistTellsWhatIsMissing) {
    const auto state = [this](const char* name) { return child<QLabel>(name)->accessibleDescription(); };
    EXPECT_EQ(state("check.devices"), "done"); // simulated
    EXPECT_EQ(state("check.sensors"), "done");
    EXPECT_EQ(state("check.source"), "not yet"); // 26.9 of 200 degC
    useReal();
    EXPECT_EQ(state("check.devices"), "done");
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.devices[2].status.link = LinkState::Lost;
    snapshot.place = PlaceState::Unsure;
    snapshot.latest.objects[1].valid = false;
    snapshot.heatSetPoint_K = 304.0;
    snapshot.reasons = {{MessageCode::RobotPlaceUnsure, {}}, {MessageCode::ReasonRecorderFailed, {"full"}}};
    page.apply(snapshot, true);
    EXPECT_EQ(state("check.devices"), "wrong");
    EXPECT_TRUE(text("check.devices").contains("Heat source"));
    EXPECT_EQ(state("check.place"), "wrong");
    EXPECT_TRUE(text("check.sensors").contains("1 of 2"));
    EXPECT_EQ(state("check.source"), "done"); // within 5 K
    EXPECT_EQ(state("check.recording"), "wrong");
    EXPECT_TRUE(text("reason.0").contains("place"));
    EXPECT_TRUE(text("reason.1").contains("full"));
    snapshot.sampleAge_s = 3.1 * experiment.sampling.period_s;
    snapshot.reasons.clear();
    page.apply(snapshot, true);
    EXPECT_EQ(state("check.sensors"), "wrong");
    EXPECT_FALSE(child<QLabel>("reason.0")->isVisible());
    experiment.rig->source.reset();
    page.setExperiment(experiment);
    EXPECT_TRUE(text("check.devices").contains("none set up"));
}

// Catches "its place is sure" beside "not sure", and "Press Reset first" where Reset needs Home.
TEST_F(RigPageTest, AnUnsurePlaceIsToldOnceWithItsSteps) {
    useReal();
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.state = RunState::Fault;
    snapshot.place = PlaceState::Unsure;
    snapshot.reasons = {{MessageCode::RobotPlaceUnsure, {}}};
    page.apply(snapshot, true);
    const auto says = [this](const char* words) {
        const auto labels = page.findChildren<QLabel*>();
        return std::ranges::any_of(
            labels, [&](const QLabel* label) { return label->text().contains(QLatin1String(words)); });
    };
    EXPECT_TRUE(says("Home the robot or confirm its place, then press Reset"));
    EXPECT_FALSE(says("Press Reset first"));
    EXPECT_TRUE(child<QPushButton>("homeRobot")->isEnabled());
    EXPECT_EQ(child<QPushButton>("clearAlarm")->text(), "Confirm its place");
    snapshot.place = PlaceState::Sure;
    snapshot.remedy = {MessageCode::RemedyReset, {}};
    page.apply(snapshot, true);
    EXPECT_TRUE(says("Press Reset first"));
    EXPECT_EQ(text("reason.0"), "The robot's place was not sure. It is sure again: press Reset.");
    EXPECT_EQ(child<QPushButton>("clearAlarm")->text(), "Clear alarm");
    snapshot.remedy = messageAbout(MessageCode::RemedyWait, {MessageCode::SafetySourceHot, {"253.8", "250"}});
    page.apply(snapshot, true);
    EXPECT_FALSE(says("Press Reset first"));
    EXPECT_EQ(text("reason.0"), "The robot's place was not sure. It is sure again.") << "Reset is refused";
}

// Catches a source that is too cold without a word about how long it takes, and a time of another set point.
TEST_F(RigPageTest, TheChecklistTellsHowLongTheSourceTakes) {
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.warmUp = SourceWarmUp{sourceSetPoint_K(experiment.source, 0.0), 131.0};
    page.apply(snapshot, true);
    EXPECT_TRUE(text("check.source").contains("takes about 2:20")) << text("check.source").toStdString();
    snapshot.warmUp->in_s.reset();
    page.apply(snapshot, true);
    EXPECT_TRUE(text("check.source").contains("not known")) << text("check.source").toStdString();
    snapshot.heatSetPoint_K = kelvinFromCelsius(100.0); // by hand
    page.apply(snapshot, true);
    EXPECT_TRUE(text("check.source").endsWith("yet")) << text("check.source").toStdString();
}

// Catches a source at absolute zero, where it has told nothing yet.
TEST_F(RigPageTest, AnUnknownTemperatureIsADash) {
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.source_K.reset();
    snapshot.sourceAge_s = std::numeric_limits<double>::infinity();
    page.apply(snapshot, true);
    EXPECT_EQ(text("measuredSource"), QStringLiteral("\u2014"));
    EXPECT_TRUE(text("heatState").contains(QStringLiteral("\u2014"))) << text("heatState").toStdString();
    EXPECT_TRUE(text("check.source").contains("Source: no temperature"));
}

// Catches "The heat is off" and a tick beside a plate that heats all the same.
TEST_F(RigPageTest, ASourceThatHeatsUnaskedIsNotSimplyOff) {
    useReal();
    Snapshot snapshot = test::quietSnapshot(experiment);
    page.apply(snapshot, true);
    EXPECT_TRUE(text("heatState").contains("The heat is off"));
    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    snapshot.alarms = {alarm};
    page.apply(snapshot, true);
    EXPECT_TRUE(text("heatState").contains("heats though its heat is off"))
        << text("heatState").toStdString();
    EXPECT_EQ(child<QLabel>("heatState")->palette().color(QPalette::WindowText),
              alarmColor(1, isDark(&page)));
    EXPECT_TRUE(text("check.source").contains("heats though its heat is off"));
    EXPECT_EQ(child<QLabel>("check.source")->accessibleDescription(), "wrong");
}

// Catches "The heat is off" of a heater that does not answer, and a place, a heat or a temperature that is
// ticked though nobody knows it.
TEST_F(RigPageTest, WhatIsNotKnownIsSaidToBeUnknown) {
    useReal();
    const auto state = [this](const char* name) { return child<QLabel>(name)->accessibleDescription(); };
    Snapshot snapshot = test::quietSnapshot(experiment);
    snapshot.heat = HeatState::Unknown;
    snapshot.source_K.reset();
    snapshot.latest.source_K = kelvinFromCelsius(182.3);
    snapshot.sourceAge_s = 12.0;
    snapshot.place = PlaceState::Unknown;
    snapshot.placeAge_s = 65.0;
    snapshot.sensors = {SensorTrust::Trusted, SensorTrust::Distrusted};
    snapshot.latest.objects[1].valid = false;
    page.apply(snapshot, true);
    EXPECT_TRUE(text("heatState").contains("UNKNOWN")) << text("heatState").toStdString();
    EXPECT_TRUE(text("heatState").contains(QStringLiteral("182.3\u00a0\u00b0C, 12 s old")));
    EXPECT_FALSE(text("heatState").contains("off"));
    for (const char* name : {"check.source", "check.place", "check.sensors"})
        EXPECT_EQ(state(name), "not known") << name;
    EXPECT_TRUE(text("check.place").contains("65 s old"));
    EXPECT_TRUE(text("check.sensors").contains("1 of 2 not believed"));
    const QColor unknown = child<QLabel>("heatState")->palette().color(QPalette::WindowText);
    page.apply(test::quietSnapshot(experiment), true);
    EXPECT_TRUE(text("heatState").contains("The heat is off"));
    EXPECT_NE(child<QLabel>("heatState")->palette().color(QPalette::WindowText), unknown);
    EXPECT_EQ(state("check.place"), "done");
}

// Catches a rig that cannot be given its name.
TEST_F(RigPageTest, ARigHasAName) {
    useReal();
    auto* name = child<QLineEdit>("rigName");
    EXPECT_EQ(name->text(), "bench 2");
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, "bench 3");
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(experiment.rig->name, "bench 3");
    EXPECT_EQ(edits, 1);
}

// Catches a layout that longer words push out of a small window.
TEST_F(RigPageTest, LongerWordsStillFit) {
    useReal();
    LongerTranslator longer;
    QCoreApplication::installTranslator(&longer);
    QApplication::processEvents();
    for (QScrollArea* scroll : page.findChildren<QScrollArea*>()) {
        EXPECT_LE(scroll->widget()->minimumSizeHint().width(),
                  scroll->isVisible() ? scroll->viewport()->width() : 420);
    }
    EXPECT_LE(page.minimumSizeHint().width(), 1010);
    QCoreApplication::removeTranslator(&longer);
}

} // namespace bask
