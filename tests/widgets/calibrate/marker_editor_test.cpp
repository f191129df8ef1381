// The list of a rig's markers and its form.

#include "widgets/calibrate/marker_editor.h"

#include "engine/base/units.h"
#include "engine/model/coordinate_range.h"
#include "engine/model/experiment_parameters.h"
#include "tests/widgets/calibrate/rig_bench.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <numbers>

namespace bask {
namespace {

struct MarkerEditorTest : testing::Test {
    test::RigBench bench;
    MarkerEditor editor;
    VisionSpec vision = bench.experiment.vision;
    bool refuses = false;
    int edits = 0;

    MarkerEditorTest() {
        editor.setVision(vision);
        QObject::connect(&editor, &MarkerEditor::visionEdited, &editor, [this](const VisionSpec& edited) {
            ++edits;
            if (!refuses)
                vision = edited;
            editor.setVision(vision);
        });
        editor.show();
        QApplication::processEvents();
    }
    template <class T> T* child(const char* name) {
        auto* found = editor.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QTreeWidget* list() { return child<QTreeWidget>("markerList"); }
    void choose(int row) { list()->setCurrentItem(list()->topLevelItem(row)); }
    QString cell(int row, int column) { return list()->topLevelItem(row)->text(column); }
};

} // namespace

// Catches: an id that is typed where the camera could have told it; the new marker not taken up in the form.
TEST_F(MarkerEditorTest, AddsTheMarkerThatIsSeenAndNotListed) {
    VisionView view = bench.look();
    ViewedMarker other = view.markers.front();
    other.marker.id = 23;
    view.markers.push_back(other);
    editor.setView(view);
    child<QPushButton>("markerAdd")->click();
    ASSERT_EQ(vision.markers.size(), 8U);
    EXPECT_EQ(vision.markers.back().id, 23);
    EXPECT_EQ(vision.markers.back().part, Part::EndEffector) << "as the last";
    EXPECT_EQ(list()->currentItem(), list()->topLevelItem(7));
    EXPECT_EQ(child<QDoubleSpinBox>("markerId")->value(), 23);
    child<QPushButton>("markerAdd")->click();
    EXPECT_EQ(vision.markers.back().id, 4) << "the lowest that is free";
}

// Catches: a field that edits another marker or another field, in another unit.
TEST_F(MarkerEditorTest, EachFieldEditsTheChosenMarker) {
    choose(5);
    EXPECT_EQ(edits, 0) << "choosing is no edit";
    EXPECT_NEAR(child<QDoubleSpinBox>("marker.x")->value(), 60.0, 1e-9);
    MarkerSpec expected = vision.markers[5];
    child<QDoubleSpinBox>("markerSide")->setValue(48.25);
    expected.side_m = 0.04825;
    child<QDoubleSpinBox>("marker.y")->setValue(-12.5);
    expected.pose[kY] = -0.0125;
    child<QDoubleSpinBox>("marker.theta_z")->setValue(90.0);
    expected.pose[kThetaZ] = std::numbers::pi / 2.0;
    child<QDoubleSpinBox>("markerId")->setValue(31);
    expected.id = 31;
    auto* part = child<QComboBox>("markerPart");
    part->setFocus();
    QTest::keyClick(part, Qt::Key_End);
    expected.part = Part::Base;
    EXPECT_EQ(edits, 5);
    EXPECT_EQ(vision.markers[5].id, expected.id);
    EXPECT_EQ(vision.markers[5].part, expected.part);
    EXPECT_NEAR(vision.markers[5].side_m, expected.side_m, 1e-12);
    EXPECT_TRUE(vision.markers[5].pose.isApprox(expected.pose, 1e-12));
    EXPECT_EQ(list()->currentItem(), list()->topLevelItem(5)) << "the same goes on being edited";
    EXPECT_EQ(cell(5, 0), "Base");
    EXPECT_EQ(cell(5, 1), "31");
    EXPECT_EQ(vision.markers[4], bench.experiment.vision.markers[4]);
}

// Catches: another marker removed than the chosen one, and a form that edits what is gone.
TEST_F(MarkerEditorTest, RemovesTheChosenOneDownToNone) {
    choose(1);
    child<QPushButton>("markerRemove")->click();
    ASSERT_EQ(vision.markers.size(), 6U);
    EXPECT_EQ(vision.markers[1].id, 2);
    for (int k = 0; k < 6; ++k)
        child<QPushButton>("markerRemove")->click();
    EXPECT_TRUE(vision.markers.empty());
    EXPECT_FALSE(child<QPushButton>("markerRemove")->isEnabled());
    EXPECT_FALSE(child<QDoubleSpinBox>("markerId")->isEnabled());
    child<QPushButton>("markerAdd")->click();
    EXPECT_EQ(vision.markers.size(), 1U);
    EXPECT_TRUE(child<QDoubleSpinBox>("markerId")->isEnabled());
}

// Catches: a field that goes on showing what the document has refused.
TEST_F(MarkerEditorTest, WhatIsRefusedIsTakenBack) {
    refuses = true;
    choose(0);
    child<QDoubleSpinBox>("markerId")->setValue(10); // listed already
    EXPECT_EQ(edits, 1);
    EXPECT_EQ(child<QDoubleSpinBox>("markerId")->value(), 0);
    auto* dictionary = child<QComboBox>("markerDictionary");
    dictionary->setFocus();
    QTest::keyClick(dictionary, Qt::Key_End);
    EXPECT_EQ(edits, 2);
    EXPECT_EQ(dictionary->currentText(), "4X4_50");
    EXPECT_EQ(child<QDoubleSpinBox>("markerId")->maximum(), 49);
    child<QPushButton>("markerAdd")->click();
    EXPECT_EQ(list()->topLevelItemCount(), 7);
}

// Catches: an experiment with a smaller dictionary that is changed by being shown: the largest id of the old
// form cut to fit.
TEST_F(MarkerEditorTest, ShowingAnExperimentEditsNothing) {
    VisionSpec large = vision;
    large.dictionary = "4X4_250";
    large.markers[0].id = 200;
    vision = large;
    editor.setVision(vision);
    EXPECT_EQ(child<QDoubleSpinBox>("markerId")->value(), 200);
    vision = bench.experiment.vision;
    vision.markers[0].id = 7;
    editor.setVision(vision);
    EXPECT_EQ(edits, 0);
    EXPECT_EQ(child<QDoubleSpinBox>("markerId")->value(), 7);
}

// Catches: a marker said to be seen that is not, or one whose pose the picture leaves open said to be known.
TEST_F(MarkerEditorTest, SaysWhichTheCameraSees) {
    EXPECT_EQ(cell(0, 3), "not seen");
    VisionView view = bench.look();
    view.markers[0].poses->isAmbiguous = true;
    view.markers[1].poses->isAmbiguous = false;
    view.markers[2].poses.reset();
    view.markers.pop_back();
    editor.setView(view);
    EXPECT_EQ(cell(0, 3), "two poses fit");
    EXPECT_TRUE(cell(1, 3).contains("px")) << cell(1, 3).toStdString();
    EXPECT_EQ(cell(2, 3), "seen");
    EXPECT_EQ(cell(6, 3), "not seen");
    view.markers.clear();
    editor.setView(view);
    EXPECT_EQ(cell(0, 3), "not seen");
}

// Catches a field that shows a value of a file as another: a form with a narrower range than files have.
TEST_F(MarkerEditorTest, ShowsWhatAFileMayHave) {
    const ValidRange side = parameterOf(markerParameters(), &MarkerSpec::side_m).range;
    for (const double sign : {-1.0, 1.0}) {
        MarkerSpec& marker = vision.markers.front();
        marker.side_m = (sign < 0.0 ? side.min : side.max) / kMmPerM;
        for (int k = 0; k < 6; ++k)
            marker.pose[k] = toSi(sign * coordinateRange(k, kMaxPlace_cm, true).max, coordinateUnit(k));
        editor.setVision(vision);
        choose(0);
        EXPECT_NEAR(child<QDoubleSpinBox>("markerSide")->value(), marker.side_m * kMmPerM, 1e-9);
        for (int k = 0; k < 6; ++k) {
            const std::string name = std::string("marker.") + kCoordinateNames[static_cast<std::size_t>(k)];
            const double shown = k < kThetaX ? kMmPerM * marker.pose[k] : degFromRad(marker.pose[k]);
            EXPECT_NEAR(child<QDoubleSpinBox>(name.c_str())->value(), shown, 1e-9) << name;
        }
    }
    EXPECT_EQ(edits, 0);
}

} // namespace bask
