// Tools > Simulate fault: what is ticked, what is possible, and why not.

#include "app/document.h"
#include "app/fault_menu.h"

#include <QMenu>
#include <QWidget>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

struct FaultMenuTest : testing::Test {
    QWidget window;
    FaultMenu faults{&window};
    Experiment experiment = Document::blank();
    Snapshot snapshot;
    std::vector<SimulateFault> asked;

    FaultMenuTest() {
        ObjectSpec other = experiment.objects[0];
        other.name = "salt & pepper";
        experiment.objects.push_back(other);
        faults.setExperiment(experiment);
        QObject::connect(&faults, &FaultMenu::faultChosen, &faults,
                         [this](const SimulateFault& fault) { asked.push_back(fault); });
        snapshot.heat = HeatState::Off;
        faults.apply(snapshot);
    }
    QAction* ofRig(const char* name) { return window.findChild<QAction*>(QLatin1String(name)); }
    QMenu* menuOf(const char* name) { return window.findChild<QMenu*>(QLatin1String(name)); }
    QAction* ofObject(const char* name, int object) { return menuOf(name)->actions().at(object); }
    void tell(const std::vector<ActiveFault>& active) {
        snapshot.faults = active;
        faults.apply(snapshot);
    }
};

} // namespace

// Catches: a tick that shows what a person asked for, and an active fault that cannot be ended where it is.
TEST_F(FaultMenuTest, ATickIsWhatTheEngineTells) {
    QAction* lost = ofRig("robot-lost");
    lost->trigger();
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(asked[0].fault, SimulatedFault::RobotLost);
    EXPECT_TRUE(asked[0].isOn);
    EXPECT_FALSE(lost->isChecked()) << "the engine has not told so";
    tell({{SimulatedFault::RobotLost, 0}, {SimulatedFault::SensorOpen, 1}});
    EXPECT_TRUE(lost->isChecked());
    EXPECT_TRUE(ofObject("sensor-open", 1)->isChecked());
    EXPECT_FALSE(ofObject("sensor-open", 0)->isChecked());
    EXPECT_TRUE(menuOf("sensor-open")->menuAction()->isChecked()) << "seen before the menu is opened";
    EXPECT_FALSE(menuOf("sensor-short")->menuAction()->isChecked());
    ofObject("sensor-open", 1)->trigger();
    ASSERT_EQ(asked.size(), 2U);
    EXPECT_EQ(asked[1].fault, SimulatedFault::SensorOpen);
    EXPECT_EQ(asked[1].object, 1U);
    EXPECT_FALSE(asked[1].isOn);
    EXPECT_TRUE(ofObject("sensor-open", 1)->isChecked()) << "it is still on";
    tell({});
    EXPECT_FALSE(lost->isChecked());
    EXPECT_FALSE(menuOf("sensor-open")->menuAction()->isChecked());
    EXPECT_FALSE(ofRig("restoreDevices")->isEnabled());
}

// Catches: ticks lost with a renamed object, and a name that takes a mnemonic.
TEST_F(FaultMenuTest, TicksStayWhenTheObjectsChange) {
    tell({{SimulatedFault::ObjectHot, 0}});
    EXPECT_EQ(ofObject("object-hot", 1)->text(), QStringLiteral("salt && pepper"));
    experiment.objects[0].name = "plate";
    faults.setExperiment(experiment);
    EXPECT_EQ(ofObject("object-hot", 0)->text(), QStringLiteral("plate"));
    EXPECT_TRUE(ofObject("object-hot", 0)->isChecked());
    EXPECT_FALSE(ofObject("object-hot", 1)->isChecked());
}

// Catches: a fault that is offered and shows nothing, one that is greyed without a word, and an active one
// that cannot be ended because it would show nothing now.
TEST_F(FaultMenuTest, WhatWouldShowNothingSaysWhy) {
    const auto says = [](const QAction* action, const char* text) {
        return action->toolTip().contains(QLatin1String(text)) &&
               action->statusTip().contains(QLatin1String(text));
    };
    QAction* notHeating = ofRig("source-not-heating");
    EXPECT_FALSE(notHeating->isEnabled());
    EXPECT_TRUE(says(notHeating, "the heat is off")) << notHeating->toolTip().toStdString();
    EXPECT_TRUE(ofRig("source-heats-alone")->isEnabled());
    snapshot.heat = HeatState::On;
    tell({});
    EXPECT_TRUE(notHeating->isEnabled());
    EXPECT_FALSE(ofRig("source-heats-alone")->isEnabled());
    EXPECT_TRUE(says(ofRig("source-heats-alone"), "the heat is on"));
    tell({{SimulatedFault::SourceNotHeating, 0}});
    snapshot.heat = HeatState::Off;
    tell(snapshot.faults);
    EXPECT_TRUE(notHeating->isEnabled()) << "else it could not be ended here";
    EXPECT_TRUE(says(notHeating, "Active."));

    EXPECT_TRUE(says(ofObject("sensor-off", 0), "warmer than the room"));
    experiment.objects[0].readBy = ReadBy::Camera;
    faults.setExperiment(experiment);
    EXPECT_FALSE(ofObject("sensor-lost", 0)->isEnabled());
    EXPECT_TRUE(says(ofObject("sensor-lost", 0), "the thermal camera reads the object"));
    EXPECT_TRUE(ofObject("sensor-lost", 1)->isEnabled());
    EXPECT_TRUE(menuOf("sensor-lost")->menuAction()->isEnabled());
    experiment.objects[1].readBy = ReadBy::Camera;
    faults.setExperiment(experiment);
    EXPECT_FALSE(menuOf("sensor-lost")->menuAction()->isEnabled());
    EXPECT_TRUE(says(menuOf("sensor-lost")->menuAction(), "the thermal camera reads the object"));
    EXPECT_TRUE(menuOf("object-hot")->menuAction()->isEnabled());
}

// Catches: a source that can be hidden from a camera whose pictures no run uses.
TEST_F(FaultMenuTest, ASourceThatNoRunFollowsCannotBeHidden) {
    experiment.vision.markers = {{Part::Source, 3, 0.05}};
    faults.setExperiment(experiment);
    const QAction* hidden = ofRig("source-covered");
    EXPECT_FALSE(hidden->isEnabled());
    EXPECT_TRUE(hidden->toolTip().contains(QStringLiteral("nothing else here uses the camera")))
        << hidden->toolTip().toStdString();
    experiment.source.tracked = true;
    faults.setExperiment(experiment);
    EXPECT_TRUE(hidden->isEnabled());
}

// Catches: a camera that can be lost where no run uses one, and no word about why nothing comes of it.
TEST_F(FaultMenuTest, ACameraThatNoRunUsesCannotBeLost) {
    QAction* lost = ofRig("camera-lost");
    EXPECT_FALSE(lost->isEnabled());
    EXPECT_TRUE(lost->toolTip().contains(QStringLiteral("no camera follows the source")))
        << lost->toolTip().toStdString();
    EXPECT_EQ(lost->statusTip(), lost->toolTip());
    experiment.source.tracked = true;
    faults.setExperiment(experiment);
    EXPECT_TRUE(lost->isEnabled());
    EXPECT_FALSE(lost->toolTip().contains(QStringLiteral("Would")));
}

// Catches: faults offered on a real rig, or refused there without a word.
TEST_F(FaultMenuTest, ARealRigSaysThatItHasNone) {
    QAction* top = faults.menu()->menuAction();
    EXPECT_TRUE(top->isEnabled());
    snapshot.simulated = false;
    faults.apply(snapshot);
    EXPECT_FALSE(top->isEnabled());
    EXPECT_TRUE(top->toolTip().contains(QStringLiteral("real rig")));
    snapshot.simulated = true;
    faults.apply(snapshot);
    EXPECT_TRUE(top->isEnabled());
    EXPECT_FALSE(top->toolTip().contains(QStringLiteral("real rig")));
}

} // namespace bask::test
