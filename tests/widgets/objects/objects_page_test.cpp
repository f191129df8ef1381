#include "engine/experiment/experiment_file.h"
#include "widgets/objects/objects_page.h"

#include "tests/support/longer_translator.h"
#include "tests/support/thread_time.h"
#include "tests/widgets/objects/page_history.h"
#include "widgets/common/display.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"
#include "widgets/objects/fourier_fits.h"
#include "widgets/objects/mounting_plan.h"
#include "widgets/objects/object_list.h"
#include "widgets/objects/outline_preview.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSlider>
#include <QSplitter>
#include <QStyleOptionSlider>
#include <QTabBar>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace bask {
namespace {

const Experiment& example() {
    static const Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    return experiment;
}

QPoint handle(QSlider* slider, int value) {
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = value;
    option.sliderValue = value;
    option.orientation = Qt::Horizontal;
    option.state |= QStyle::State_Horizontal;
    return slider->style()
        ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider)
        .center();
}

/// The page with the example, its signals recorded; the application of the test accepts every edit.
struct ObjectsPageTest : testing::Test {
    ObjectsPage page;
    QSignalSpy edited{&page, &ObjectsPage::experimentEdited};
    test::PageHistory history{page};

    ObjectsPageTest() {
        page.setExperiment(example());
        history.begin();
        page.resize(1150, 620);
        page.show();
        page.activateWindow();
        QApplication::processEvents();
    }
    template <class T> T* child(const char* name) {
        auto* found = page.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void select(const std::string& name) {
        for (std::size_t i = 0; i < page.experiment().objects.size(); ++i)
            if (page.experiment().objects[i].name == name)
                child<ObjectList>("objectList")->setCurrentRow(static_cast<int>(i));
    }
    void type(QWidget* field, const QString& text) {
        field->setFocus();
        if (auto* spin = qobject_cast<QAbstractSpinBox*>(field))
            spin->selectAll();
        else
            qobject_cast<QLineEdit*>(field)->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void click(const char* name) { QTest::mouseClick(child<QPushButton>(name), Qt::LeftButton); }
    void clickInMessage(const char* name) {
        auto* button = child<MessageBar>("pageMessage")->findChild<QAbstractButton*>(name);
        ASSERT_NE(button, nullptr);
        ASSERT_TRUE(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
    }
    QString residual() { return child<QLabel>("residual")->text(); }
    bool fitted() {
        return QTest::qWaitFor([this] { return residual().contains("mm"); }, 120000);
    }
    QString message() { return child<MessageBar>("pageMessage")->sentence(); }
    const Experiment& last() { return page.experiment(); }
};

// Catches a list that does not mirror the experiment or counts the robot's axes wrongly.
TEST_F(ObjectsPageTest, ListsTheObjectsAndTheDegreesOfFreedom) {
    auto* list = child<ObjectList>("objectList");
    ASSERT_EQ(list->count(), 3);
    EXPECT_EQ(list->item(0)->text(), "circle");
    EXPECT_EQ(list->item(1)->text(), "bunny");
    EXPECT_EQ(child<QLabel>("objectCount")->text(), "3 of 4 degrees of freedom used");
    EXPECT_EQ(edited.count(), 0);
}

// Catches a slider whose drag does not move the residual, or that commits at each step of the drag.
TEST_F(ObjectsPageTest, DraggingTheHarmonicsChangesTheResidualAndCommitsOnce) {
    select("bunny");
    ASSERT_TRUE(fitted());
    auto* slider = child<QSlider>("harmonicsSlider");
    ASSERT_EQ(slider->value(), 5);
    const QString before = residual();
    const QPoint from = handle(slider, 5);
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    QTest::mouseMove(slider, handle(slider, 12));
    ASSERT_TRUE(QTest::qWaitFor([&] { return residual() != before && residual().contains("mm"); }, 120000));
    EXPECT_EQ(edited.count(), 0) << "a drag in progress is a preview";
    EXPECT_EQ(child<QDoubleSpinBox>("harmonicsSpin")->value(), slider->value());
    const int reached = slider->value();
    EXPECT_NEAR(reached, 12, 1);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, handle(slider, reached));
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 1; }, 120000));
    EXPECT_EQ(std::get<FourierContour>(last().objects[1].shape).harmonics(), reached);
    EXPECT_EQ(last().objects[1].origin.harmonics, reached);
    EXPECT_EQ(last().objects[1].origin.outline, example().objects[1].origin.outline);

    click("undo");
    EXPECT_EQ(edited.count(), 1) << "what is undone is no edit of the page's";
    EXPECT_EQ(last(), example());
    EXPECT_EQ(slider->value(), 5);
    ASSERT_TRUE(fitted());
    EXPECT_EQ(residual(), before);
    click("redo");
    EXPECT_EQ(std::get<FourierContour>(last().objects[1].shape).harmonics(), reached);
}

// Catches another number than the fewest, one taken before the smaller ones are fitted, and a crossing
// outline.
TEST_F(ObjectsPageTest, FewestHarmonicsForATolerance) {
    select("hand");
    child<QDoubleSpinBox>("tolerance")->setValue(1.5);
    click("fewestHarmonics"); // while the fits are on their way
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 1; }, 120000));
    const Contour& outline = example().objects[2].origin.outline;
    EXPECT_EQ(std::get<FourierContour>(last().objects[2].shape), fitFourierWithin(outline, 1.5e-3)->contour);
    EXPECT_EQ(child<QSlider>("harmonicsSlider")->value(), last().objects[2].origin.harmonics);
    EXPECT_FALSE(child<QLabel>("toleranceVerdict")->isVisible());
    click("undo");
    EXPECT_EQ(last(), example());
    // Five harmonics come within 10.14 mm, but cross.
    type(child<QDoubleSpinBox>("tolerance"), "10.2");
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 2; }, 120000));
    EXPECT_EQ(std::get<FourierContour>(last().objects[2].shape).harmonics(), 6);
}

// Catches silence, or a number taken anyhow, where no number of harmonics does.
TEST_F(ObjectsPageTest, AToleranceOutOfReachIsToldWithWhatIsReached) {
    select("bunny");
    type(child<QDoubleSpinBox>("tolerance"), "0.01"); // and Enter
    auto* verdict = child<QLabel>("toleranceVerdict");
    ASSERT_TRUE(QTest::qWaitFor([&] { return verdict->text().contains("cannot be reached"); }, 120000));
    const Contour& outline = example().objects[1].origin.outline;
    double min_m = 1.0;
    for (int h = 1; h <= kMaxHarmonics; ++h)
        if (const FourierFit fit = fitFourier(outline, h).value(); !fit.crossesItself)
            min_m = std::min(min_m, fit.hausdorff_m);
    EXPECT_TRUE(verdict->text().contains(QString::number(min_m * 1e3, 'f', 3)))
        << verdict->text().toStdString();
    EXPECT_TRUE(verdict->isVisible());
    EXPECT_EQ(edited.count(), 0);
    child<QDoubleSpinBox>("tolerance")->setValue(0.02);
    EXPECT_FALSE(verdict->isVisible()) << "it was said of another tolerance";
    EXPECT_FALSE(child<QPushButton>("takeClosest")->isVisible());
    click("fewestHarmonics");
    ASSERT_TRUE(QTest::qWaitFor([&] { return child<QPushButton>("takeClosest")->isVisible(); }, 120000));
    click("takeClosest");
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 1; }, 120000));
    EXPECT_NEAR(fitFourier(outline, last().objects[1].origin.harmonics)->hausdorff_m, min_m, 1e-9);
    EXPECT_FALSE(child<QPushButton>("takeClosest")->isVisible());
}

// Catches the outline itself lost, off its place or not to be undone, and no way back to the fit before.
TEST_F(ObjectsPageTest, TheOutlineItselfAndBack) {
    select("bunny");
    ASSERT_TRUE(fitted());
    type(child<QDoubleSpinBox>("harmonicsSpin"), "12");
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 1; }, 120000));
    const Experiment fourier = last();
    auto* use = child<QCheckBox>("useOutline");
    EXPECT_FALSE(use->isChecked());
    use->setFocus();
    QTest::keyClick(use, Qt::Key_Space);
    ASSERT_EQ(edited.count(), 2);
    const ObjectSpec& object = last().objects[1];
    EXPECT_EQ(std::get<Contour>(object.shape), centred(example().objects[1].origin.outline));
    EXPECT_EQ(object.origin.outline, example().objects[1].origin.outline);
    EXPECT_EQ(object.origin.harmonics, 0);
    EXPECT_TRUE(validate(last()).ok());
    EXPECT_TRUE(residual().contains("289 corners")) << residual().toStdString();
    EXPECT_FALSE(child<OutlinePreview>("outlinePreview")->accessibleDescription().contains("Fourier"));
    QTest::keyClick(use, Qt::Key_Space);
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 3; }, 120000));
    EXPECT_EQ(last(), fourier) << "with the number of harmonics it had";
    click("undo");
    EXPECT_TRUE(use->isChecked());
    click("undo");
    EXPECT_EQ(last(), fourier);
    EXPECT_FALSE(use->isChecked());
}

// Catches a polygon that the experiment refuses for its corners, and an outline thinned for good.
TEST_F(ObjectsPageTest, AnOutlineOfManyPointsIsThinnedAsAPolygon) {
    Contour fine;
    for (int k = 0; k < 20000; ++k) {
        const double t = 2.0 * std::numbers::pi * k / 20000, r = 0.03 + 0.003 * std::cos(9 * t);
        fine.points_m.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    Experiment experiment = example();
    experiment.objects[1].origin.outline = fine;
    page.setExperiment(experiment);
    select("bunny");
    auto* use = child<QCheckBox>("useOutline");
    ASSERT_TRUE(QTest::qWaitFor([&] { return use->isEnabled(); }, 120000));
    QTest::keyClick(use, Qt::Key_Space);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_LE(std::get<Contour>(last().objects[1].shape).points_m.size(), kMaxCorners);
    EXPECT_EQ(last().objects[1].origin.outline, fine);
    EXPECT_TRUE(validate(last()).ok());
    EXPECT_TRUE(residual().contains("from 20000 to")) << residual().toStdString();
}

// Catches distances that do not reach the preview, or are of another number of harmonics.
TEST_F(ObjectsPageTest, ThePreviewTellsTheDistancesOfTheFitShown) {
    select("bunny");
    ASSERT_TRUE(fitted());
    const Contour& outline = example().objects[1].origin.outline;
    const auto told = [&](int h) {
        const FourierFit fit = fitFourier(outline, h).value();
        const auto distances = distancesTo(fit, pointsAlong(outline, contourPerimeter(outline) / 1000.0));
        const QString largest = QString::number(*std::ranges::max_element(distances) * 1e3, 'f', 3);
        return child<OutlinePreview>("outlinePreview")
            ->accessibleDescription()
            .contains(largest + " mm from");
    };
    EXPECT_TRUE(told(5));
    auto* slider = child<QSlider>("harmonicsSlider");
    slider->setSliderDown(true);
    slider->setValue(9);
    EXPECT_TRUE(QTest::qWaitFor([&] { return told(9); }, 120000)) << "in a drag";
    slider->setSliderDown(false);
    select("circle");
    EXPECT_FALSE(child<OutlinePreview>("outlinePreview")->accessibleDescription().contains("Fourier"));
}

// Catches residual figures that are not those of the fit, or not in mm.
TEST_F(ObjectsPageTest, ResidualIsThatOfTheFitInMillimetres) {
    select("hand");
    ASSERT_TRUE(fitted());
    const ContourOrigin& hand = example().objects[2].origin;
    const FourierFit fit = fitFourier(hand.outline, hand.harmonics).value();
    EXPECT_TRUE(residual().contains(QString::number(fit.rms_m * 1e3, 'f', 3))) << residual().toStdString();
    EXPECT_TRUE(residual().contains(QString::number(fit.max_m * 1e3, 'f', 3)));
    EXPECT_TRUE(residual().contains(QString::number(fit.hausdorff_m * 1e3, 'f', 3)));
    EXPECT_TRUE(residual().contains(formatSigned(fit.areaError * 100.0, 2)));
    EXPECT_EQ(child<QLabel>("crossingWarning")->isVisible(), fit.crossesItself);
}

// Catches a warning that stays away when the truncated curve crosses itself.
TEST_F(ObjectsPageTest, WarnsOfACrossingOutline) {
    // A thin comb: few harmonics make its teeth cross.
    Contour comb;
    for (int k = 0; k < 6; ++k) {
        const double x = 0.01 * k;
        comb.points_m.insert(comb.points_m.end(), {{x, 0.0}, {x + 0.0005, 0.08}, {x + 0.001, 0.0}});
    }
    comb.points_m.insert(comb.points_m.end(), {{0.051, -0.001}, {0.0, -0.001}});
    const Contour outline = makeContour(comb.points_m).value();
    int crossing = 0;
    for (int h = 1; h <= kMaxHarmonics && crossing == 0; ++h)
        if (fitFourier(outline, h).value().crossesItself)
            crossing = h;
    ASSERT_GT(crossing, 0);
    Experiment experiment = example();
    experiment.objects[1].origin.outline = outline;
    page.setExperiment(experiment);
    select("bunny");
    auto* spin = child<QDoubleSpinBox>("harmonicsSpin");
    ASSERT_TRUE(fitted());
    const QPoint before = child<QSlider>("harmonicsSlider")->mapTo(&page, QPoint());
    EXPECT_FALSE(child<QLabel>("crossingWarning")->isVisible());
    type(spin, QString::number(crossing));
    EXPECT_TRUE(QTest::qWaitFor([&] { return child<QLabel>("crossingWarning")->isVisible(); }, 120000));
    QApplication::processEvents();
    EXPECT_EQ(child<QSlider>("harmonicsSlider")->mapTo(&page, QPoint()), before)
        << "it moves under the mouse";
}

// Catches fields that are shown or sent in the wrong unit.
TEST_F(ObjectsPageTest, FieldsAreInReadableUnitsAndEditsInSi) {
    select("bunny");
    EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>("mountX")->value(), -4.35);
    EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>("infill")->value(), 30.0);
    type(child<QDoubleSpinBox>("thickness"), "2.5");
    EXPECT_DOUBLE_EQ(last().objects[1].material.thickness_m, 0.0025);
    type(child<QDoubleSpinBox>("mountY"), "-3.1");
    EXPECT_DOUBLE_EQ(last().objects[1].mounting[kY], -0.031);
    type(child<QDoubleSpinBox>("mountRotation"), "90");
    EXPECT_DOUBLE_EQ(last().objects[1].mounting[kThetaZ], radFromDeg(90.0));
    type(child<QDoubleSpinBox>("mountTiltX"), "-12.5");
    EXPECT_DOUBLE_EQ(last().objects[1].mounting[kThetaX], radFromDeg(-12.5));
    type(child<QDoubleSpinBox>("mountTiltY"), "20");
    EXPECT_DOUBLE_EQ(last().objects[1].mounting[kThetaY], radFromDeg(20.0));
    EXPECT_DOUBLE_EQ(last().objects[1].mounting[kThetaX], radFromDeg(-12.5));
    type(child<QDoubleSpinBox>("infill"), "45");
    EXPECT_DOUBLE_EQ(last().objects[1].material.infill, 0.45);
    type(child<QuantitySpinBox>("target"), "47");
    EXPECT_DOUBLE_EQ(last().objects[1].target_K, 320.15);
    EXPECT_EQ(edited.count(), 7);
    // What was not touched is bit for bit what it was.
    EXPECT_EQ(last().objects[1].mounting[kX], example().objects[1].mounting[kX]);
    EXPECT_EQ(last().objects[1].shape, example().objects[1].shape);
    EXPECT_EQ(last().objects[0], example().objects[0]);
}

// Catches a target that changes when only the display unit does.
TEST_F(ObjectsPageTest, UnitSwitchShowsTheSameTarget) {
    page.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_NEAR(child<QuantitySpinBox>("target")->value(), 104.0, 0.05);
    EXPECT_EQ(edited.count(), 0);
    type(child<QuantitySpinBox>("target"), "122");
    EXPECT_NEAR(last().objects[0].target_K, 323.15, 1e-9);
}

// Catches a disk's radius in the wrong unit, and area and perimeter not following it.
TEST_F(ObjectsPageTest, RadiusOfADisk) {
    EXPECT_TRUE(child<QDoubleSpinBox>("radius")->isVisible());
    type(child<QDoubleSpinBox>("radius"), "2");
    EXPECT_EQ(last().objects[0].shape, Shape(Disk{0.02}));
    EXPECT_EQ(child<QLabel>("area")->text(), QString::fromUtf8("12.57 cm²"));
    EXPECT_EQ(child<QLabel>("perimeter")->text(), "12.57 cm");
    select("hand");
    EXPECT_FALSE(child<QDoubleSpinBox>("radius")->isVisible());
}

// Catches presets that are not recognised, or that change the plate's thickness.
TEST_F(ObjectsPageTest, MaterialPresets) {
    auto* preset = child<QComboBox>("materialPreset");
    EXPECT_EQ(preset->currentText(), "aluminium, painted");
    type(child<QDoubleSpinBox>("thickness"), "3");
    preset->setFocus();
    const int bare = preset->findText("aluminium, bare");
    ASSERT_GE(bare, 0);
    preset->setCurrentIndex(bare);
    emit preset->activated(bare);
    EXPECT_DOUBLE_EQ(last().objects[0].material.emittance, 0.09);
    EXPECT_DOUBLE_EQ(last().objects[0].material.absorptance, 0.09);
    EXPECT_DOUBLE_EQ(last().objects[0].material.thickness_m, 0.003);
    type(child<QDoubleSpinBox>("emittance"), "0.5");
    EXPECT_TRUE(preset->currentText().startsWith("typed values"));
}

// Catches materials of one's own that are not offered, do not fill in, or are still told of other values.
TEST_F(ObjectsPageTest, MaterialsOfALibrary) {
    MaterialLibrary library(1);
    library[0] = {"our paint", 0.95, 0.94, 911.0, 2755.0, 0.002, 1.0, "DSC, sample 12", "2026-11-23"};
    library[0].uncertainties = {{"emittance", 0.02}, {"thickness", 1e-5}};
    page.setMaterialLibrary(library);
    auto* preset = child<QComboBox>("materialPreset");
    EXPECT_EQ(preset->currentText(), "aluminium, painted");
    const int row = preset->findText("our paint");
    ASSERT_EQ(row, preset->count() - 1);
    const double thickness_m = last().objects[0].material.thickness_m;
    preset->setFocus();
    preset->setCurrentIndex(row);
    emit preset->activated(row);
    Material wanted = library[0];
    wanted.thickness_m = thickness_m; // of the plate, not of the sample
    wanted.uncertainties.erase("thickness");
    EXPECT_EQ(last().objects[0].material, wanted);
    EXPECT_EQ(edited.count(), 1);
    EXPECT_EQ(preset->currentText(), "our paint");
    EXPECT_EQ(child<QLabel>("presetSource")->text(),
              QString::fromUtf8("DSC, sample 12, 2026-11-23\nStandard uncertainty: emittance\u00a00.02"));
    type(child<QDoubleSpinBox>("thickness"), "3");
    EXPECT_EQ(last().objects[0].material.source, "DSC, sample 12");
    EXPECT_EQ(preset->currentText(), "our paint");
    type(child<QDoubleSpinBox>("emittance"), "0.5");
    EXPECT_EQ(preset->currentText(), "typed values");
    EXPECT_EQ(last().objects[0].material.name, "");
    EXPECT_EQ(last().objects[0].material.source, "");
    EXPECT_EQ(last().objects[0].material.date, "");
    EXPECT_TRUE(last().objects[0].material.uncertainties.empty());
    EXPECT_FALSE(child<QLabel>("presetSource")->isVisible());
    click("undo");
    EXPECT_EQ(last().objects[0].material.name, "our paint");
}

// Catches a source from another lab's file that is not shown, or is taken for that of a preset.
TEST_F(ObjectsPageTest, AMaterialFromElsewhereKeepsItsNameAndSource) {
    Experiment experiment = example();
    experiment.objects[0].material.name = "their paint";
    experiment.objects[0].material.source = "their book";
    page.setExperiment(experiment);
    EXPECT_EQ(child<QComboBox>("materialPreset")->currentText(), "their paint");
    EXPECT_EQ(child<QLabel>("presetSource")->text(), "their book");
}

// Catches a saved material whose name comes to another object, or costs the object its rates.
TEST_F(ObjectsPageTest, ASavedMaterialNamesTheObjectsWithItsValues) {
    Experiment experiment = example();
    experiment.objects[0].estimatedRates = HeatRates{0.2, 2e-11, 0.16};
    page.setExperiment(experiment);
    QSignalSpy wanted(&page, &ObjectsPage::saveMaterialWanted);
    click("saveMaterial");
    EXPECT_EQ(wanted.count(), 1);
    Material saved = experiment.objects[0].material;
    saved.emittance = 0.3;
    saved.name = "ours";
    page.nameMaterial(saved);
    EXPECT_EQ(edited.count(), 0);
    saved.emittance = experiment.objects[0].material.emittance;
    saved.source = "book";
    page.nameMaterial(saved);
    EXPECT_EQ(edited.count(), 1);
    EXPECT_EQ(last().objects[0].material, saved);
    EXPECT_TRUE(last().objects[0].estimatedRates.has_value());
}

// Catches edits that lose what this page does not show.
TEST_F(ObjectsPageTest, WhatThePageDoesNotShowOutlivesAnEdit) {
    Experiment experiment = example();
    experiment.objects[0].simulatedMaterial = experiment.objects[1].material;
    experiment.source.pose[kX] = 0.02;
    experiment.source.tracked = true;
    experiment.source.temperatureProfile = {{0.0, 473.15}, {1000.0, 573.15}};
    experiment.simulation.sourceMotion = {{0.0, experiment.source.pose}};
    experiment.simulation.sourceEmittance = 0.3;
    page.setExperiment(experiment);
    type(child<QDoubleSpinBox>("emittance"), "0.5");
    experiment.objects[0].material.emittance = 0.5;
    experiment.objects[0].material.name = last().objects[0].material.name;
    EXPECT_EQ(last(), experiment);
}

// Catches start values of one material that go on steering an object of another.
TEST_F(ObjectsPageTest, AnotherMaterialTakesTheBelievedRatesAway) {
    Experiment experiment = example();
    for (ObjectSpec& object : experiment.objects)
        object.estimatedRates = HeatRates{0.2, 2e-11, 0.16};
    page.setExperiment(experiment);
    child<QDoubleSpinBox>("emittance")->setValue(0.5);
    const auto changed = std::ranges::count_if(
        last().objects, [](const ObjectSpec& object) { return !object.estimatedRates.has_value(); });
    EXPECT_EQ(changed, 1);
}

// Catches a rename that is lost, and an undo that the page does not show.
TEST_F(ObjectsPageTest, RenameAndUndo) {
    type(child<QLineEdit>("objectName"), "plate");
    EXPECT_EQ(last().objects[0].name, "plate");
    EXPECT_EQ(child<ObjectList>("objectList")->item(0)->text(), "plate");
    click("undo");
    EXPECT_EQ(last(), example());
    EXPECT_EQ(child<QLineEdit>("objectName")->text(), "circle");
}

// Catches adding past the robot's axes, overlapping mountings, and a removal that cannot be undone.
TEST_F(ObjectsPageTest, AddDuplicateRemoveUndo) {
    click("addDisk");
    ASSERT_EQ(last().objects.size(), 4u);
    EXPECT_EQ(last().objects[3].name, "disk");
    EXPECT_EQ(page.selectedObject(), 3);
    EXPECT_TRUE(validate(last()).ok());
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_GT((last().objects[i].mounting - last().objects[3].mounting).head<2>().norm(),
                  shapeRadius(last().objects[i].shape) + 0.015);
    EXPECT_FALSE(child<QPushButton>("addDisk")->isEnabled());
    EXPECT_FALSE(child<QPushButton>("importOutline")->isEnabled());
    EXPECT_FALSE(child<QPushButton>("duplicateObject")->isEnabled());

    click("removeObject");
    EXPECT_EQ(last(), example());
    EXPECT_TRUE(message().contains("disk"));
    clickInMessage("messageAction");
    EXPECT_EQ(last().objects.size(), 4u);
    click("undo");
    ASSERT_EQ(last(), example());
    select("hand");
    type(child<QDoubleSpinBox>("mountTiltY"), "20");
    ASSERT_TRUE(child<QPushButton>("duplicateObject")->isEnabled());
    click("duplicateObject");
    ASSERT_EQ(last().objects.size(), 4u);
    EXPECT_EQ(last().objects[3].name, "hand 2");
    EXPECT_EQ(last().objects[3].shape, example().objects[2].shape);
    EXPECT_EQ(last().objects[3].mounting.tail<4>(), last().objects[2].mounting.tail<4>());
}

// Catches a drop that goes another way than the button's, a plain drawing that asks, an import of more than
// one step of undo.
TEST_F(ObjectsPageTest, ADroppedDrawingOfOneOutlineBecomesAnObject) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QStringLiteral(BASK_TEST_DATA "/contours/svg/bunny_mm.svg"))});
    QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(400, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page, &drop);
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 1; }, 120000));
    EXPECT_FALSE(child<QWidget>("importPanel")->isVisible());
    const ObjectSpec& added = last().objects.at(3);
    EXPECT_EQ(added.name, "bunny_mm");
    EXPECT_EQ(added.origin.harmonics, 20);
    EXPECT_EQ(added.origin.file, "bunny_mm.svg");
    EXPECT_NEAR(contourCentroid(added.origin.outline).norm(), 0.0, 1e-9);
    EXPECT_EQ(std::get<FourierContour>(added.shape).harmonics(), 20);
    EXPECT_TRUE(validate(last()).ok());
    click("undo");
    EXPECT_EQ(last(), example());
}

// Catches an experiment dropped here that the window never gets to see.
TEST_F(ObjectsPageTest, DropsOfOtherFilesAreTheWindows) {
    for (const char* name : {"/tmp/experiment.json", "/tmp/run.bask", "/tmp/text.pdf"}) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString::fromLatin1(name))});
        QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&page, &enter);
        EXPECT_FALSE(enter.isAccepted()) << name;
    }
}

// Catches the offer to take a removal back that stays when something else would be taken back.
TEST_F(ObjectsPageTest, TheOfferToUndoEndsWithTheNextEdit) {
    click("removeObject");
    ASSERT_TRUE(message().contains("circle"));
    Experiment other = page.experiment();
    other.robot.clearance_m += 0.001; // on another page
    page.setExperiment(other);
    EXPECT_EQ(message(), "");
}

// Catches an import that a person cancelled and that comes nevertheless.
TEST_F(ObjectsPageTest, ReadingCanBeCancelled) {
    page.offerFile(BASK_TEST_DATA "/contours/svg/bunny_mm.svg");
    EXPECT_TRUE(message().contains("bunny_mm.svg"));
    clickInMessage("messageAction");
    EXPECT_EQ(message(), "");
    page.offerFile(BASK_TEST_DATA "/contours/svg/hand_mm.svg");
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() > 0; }, 120000));
    EXPECT_EQ(last().objects.size(), 4u);
    EXPECT_EQ(last().objects.at(3).name, "hand_mm");
}

// Catches a keyboard that is on Remove after an import, so that Space takes another object away: the button
// that began it is greyed, or the panel that asked is hidden.
TEST_F(ObjectsPageTest, AfterAnImportTheKeyboardIsOnTheName) {
    const auto imported = [this](int edits) {
        return QTest::qWaitFor([this, edits] { return edited.count() == edits; }, 120000);
    };
    auto* name = child<QLineEdit>("objectName");
    child<QPushButton>("importOutline")->setFocus();
    page.offerFile(BASK_TEST_DATA "/contours/svg/hand_mm.svg"); // has all that is needed
    ASSERT_TRUE(imported(1));
    EXPECT_FALSE(child<QPushButton>("importOutline")->isEnabled()) << "or its focus would not be lost";
    EXPECT_EQ(page.focusWidget(), name);
    EXPECT_EQ(name->selectedText(), "hand_mm");

    click("removeObject");
    EXPECT_EQ(edited.count(), 2);
    child<QPushButton>("importOutline")->setFocus();
    page.offerFile(BASK_TEST_DATA "/contours/bunny_tab_noheader.txt"); // its unit is asked for
    auto* panel = child<QWidget>("importPanel");
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel->isVisible(); }, 120000));
    auto* unit = child<QComboBox>("importUnit");
    unit->setCurrentIndex(unit->findText("cm"));
    auto* accept = child<QPushButton>("importAccept");
    ASSERT_TRUE(QTest::qWaitFor([&] { return accept->isEnabled(); }, 120000));
    accept->setFocus();
    QTest::mouseClick(accept, Qt::LeftButton);
    ASSERT_TRUE(imported(3));
    EXPECT_EQ(page.focusWidget(), name);
    EXPECT_EQ(name->selectedText(), "bunny_tab_noheader");
}

// Catches a panel that was left and hands the keyboard to whatever comes next, and an import that takes it
// from a field in which somebody types.
TEST_F(ObjectsPageTest, AnImportTakesTheKeyboardFromNobody) {
    auto* import = child<QPushButton>("importOutline");
    import->setFocus();
    page.offerFile(BASK_EXAMPLES "/contours/bunny_1200.png");
    auto* panel = child<QWidget>("importPanel");
    ASSERT_TRUE(panel->isVisible());
    child<QPushButton>("importCancel")->setFocus();
    QTest::mouseClick(child<QPushButton>("importCancel"), Qt::LeftButton);
    EXPECT_FALSE(panel->isVisible());
    EXPECT_EQ(page.focusWidget(), import);

    page.offerFile(BASK_TEST_DATA "/contours/svg/hand_mm.svg");
    auto* thickness = child<QDoubleSpinBox>("thickness");
    thickness->setFocus();
    ASSERT_TRUE(QTest::qWaitFor([this] { return edited.count() == 1; }, 120000));
    EXPECT_EQ(page.focusWidget(), thickness);
}

// Catches a file that needs an answer and does not ask, and a panel that stays.
TEST_F(ObjectsPageTest, APictureOpensTheImportPanel) {
    page.offerFile(BASK_EXAMPLES "/contours/bunny_1200.png");
    ASSERT_TRUE(child<QWidget>("importPanel")->isVisible());
    QTest::keyClick(child<QWidget>("importPanel"), Qt::Key_Escape);
    EXPECT_FALSE(child<QWidget>("importPanel")->isVisible());
    EXPECT_TRUE(child<QWidget>("outlinePreview")->isVisible());
    page.offerFile(BASK_EXAMPLES "/contours/bunny_1200.png");
    page.setEditable(false, "A run is on.");
    EXPECT_FALSE(child<QWidget>("importPanel")->isVisible()) << "a run began";
}

// Catches silence about a file of another kind, or that cannot be read.
TEST_F(ObjectsPageTest, OtherFilesAreRefusedInWords) {
    page.offerFile("/data/notes.pdf");
    EXPECT_TRUE(message().contains("notes.pdf"));
    for (const QString name : {"svg/bad_truncated.svg", "bad_nan_row.csv", "truncated.jpg"}) {
        page.offerFile(QStringLiteral(BASK_TEST_DATA "/contours/") + name);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return message().startsWith(name.section('/', -1) + ": "); }, 120000))
            << name.toStdString() << message().toStdString();
        EXPECT_FALSE(child<QWidget>("importPanel")->isVisible());
    }
    EXPECT_EQ(edited.count(), 0);
}

// Catches a refused edit that stays on the screen, from a direct and from a late answer.
TEST_F(ObjectsPageTest, RefusedEditGoesBackAndTellsWhy) {
    const auto connection = QObject::connect(&page, &ObjectsPage::experimentEdited, &page, [this] {
        page.setExperiment(example());
        page.showError("the name is used twice");
    });
    type(child<QLineEdit>("objectName"), "bunny");
    EXPECT_EQ(page.experiment(), example());
    EXPECT_EQ(child<QLineEdit>("objectName")->text(), "circle");
    EXPECT_EQ(message(), "the name is used twice");

    QObject::disconnect(connection);
    type(child<QDoubleSpinBox>("thickness"), "2");
    const Experiment accepted = page.experiment();
    type(child<QLineEdit>("objectName"), "bunny");
    page.setExperiment(accepted);
    page.showError("the name is used twice");
    EXPECT_EQ(page.experiment(), accepted);
    EXPECT_EQ(child<QLineEdit>("objectName")->text(), "circle");
    EXPECT_EQ(message(), "the name is used twice");
}

// Catches an outline that comes when its place is taken, and a button that takes back something else.
TEST_F(ObjectsPageTest, WhatIsEditedDuringAnImportCounts) {
    click("removeObject");
    page.offerFile(BASK_EXAMPLES "/contours/gear.svg");
    ASSERT_TRUE(message().startsWith("Reading"));
    while (child<QPushButton>("addDisk")->isEnabled())
        click("addDisk");
    EXPECT_TRUE(message().startsWith("Reading")) << "an edit leaves the button that cancels";
    const auto objects = page.experiment().objects;
    ASSERT_TRUE(QTest::qWaitFor([&] { return !message().startsWith("Reading"); }, 120000));
    EXPECT_EQ(page.experiment().objects, objects);
    EXPECT_TRUE(message().contains("free axis")) << message().toStdString();
}

// Catches fields that can be edited during a run.
TEST_F(ObjectsPageTest, NotEditableDuringARun) {
    page.setEditable(false, "A run is on; stop it to edit the objects.");
    for (const char* name : {"thickness", "mountX", "emittance", "radius"})
        EXPECT_FALSE(child<QDoubleSpinBox>(name)->isEnabled()) << name;
    for (const char* name : {"addDisk", "importOutline", "removeObject"})
        EXPECT_FALSE(child<QPushButton>(name)->isEnabled()) << name;
    EXPECT_FALSE(child<QSlider>("harmonicsSlider")->isEnabled());
    EXPECT_EQ(child<MessageBar>("editNote")->sentence(), "A run is on; stop it to edit the objects.");
    page.offerFile(BASK_EXAMPLES "/contours/bunny_1200.png");
    EXPECT_FALSE(child<QWidget>("importPanel")->isVisible());
    EXPECT_EQ(message(), "A run is on; stop it to edit the objects.");
    select("bunny");
    EXPECT_EQ(page.selectedObject(), 1) << "looking is allowed";
    page.setEditable(true, {});
    EXPECT_TRUE(child<QDoubleSpinBox>("thickness")->isEnabled());
    EXPECT_EQ(child<MessageBar>("editNote")->sentence(), "");
}

// Catches: views of the mounting that stay small where there is room, or push the rest out of a low page, and
// fields that are somewhere else when they come.
TEST_F(ObjectsPageTest, TheMountingTakesTheMiddleOfThePage) {
    const auto* plan = child<QWidget>("mountingPlan");
    const auto* side = child<QWidget>("mountingSide");
    for (const QSize size : {QSize(1300, 820), QSize(1150, 560)}) {
        child<QTabBar>("objectTabs")->setCurrentIndex(0);
        page.resize(size);
        QApplication::processEvents();
        EXPECT_FALSE(plan->isVisible());
        for (int i = 0; i < 4; ++i)
            QApplication::processEvents();
        const auto fieldTop = [&] { return child<QDoubleSpinBox>("emittance")->mapTo(&page, QPoint()).y(); };
        const int before = fieldTop();
        child<QTabBar>("objectTabs")->setCurrentIndex(1);
        for (int i = 0; i < 4; ++i)
            QApplication::processEvents();
        for (const QWidget* view : {plan, side}) {
            EXPECT_TRUE(page.rect().contains(QRect(view->mapTo(&page, QPoint(0, 0)), view->size())));
            EXPECT_GE(view->height(), 0.24 * page.height());
            EXPECT_GE(view->width(), 400);
        }
        EXPECT_EQ(fieldTop(), before) << "the form is scrolled away from under who types in it";
        EXPECT_GT(child<ObjectList>("objectList")->height(), 60);
        page.grab().save(QStringLiteral("objects_mounting_%1.png").arg(size.width()));
    }
}

// Catches an outline drawn out of register with its fit.
TEST_F(ObjectsPageTest, RawOutlineIsDrawnInTheFitsFrame) {
    const Contour& raw = example().objects[1].origin.outline;
    const FourierFit fit = fitFourier(raw, 40).value();
    Contour shifted = raw;
    for (auto& p : shifted.points_m)
        p += Eigen::Vector2d(0.02, -0.01);
    const Contour moved = registered(shifted, fit.contour);
    double worst_m = 0.0;
    for (const auto& p : moved.points_m) {
        double nearest_m = 1.0;
        for (int k = 0; k < 4000; ++k) {
            const auto q = fit.contour.point(k / 4000.0);
            nearest_m = std::min(nearest_m, std::hypot(p.x() - q.real(), p.y() - q.imag()));
        }
        worst_m = std::max(worst_m, nearest_m);
    }
    EXPECT_LT(worst_m, fit.max_m + 1e-4);
}

// Catches text that stays in the old language or has no room in a longer one.
TEST_F(ObjectsPageTest, LanguageChangeWithLongerText) {
    select("bunny");
    ASSERT_TRUE(fitted());
    LongerTranslator longer;
    qApp->installTranslator(&longer);
    for (int i = 0; i < 6; ++i) // nested layouts settle one after the other
        QApplication::processEvents();
    page.grab().save("objects_longer.png");
    for (QLabel* label : page.findChildren<QLabel*>()) {
        const bool hasWords = label->text().contains(QRegularExpression("[A-Za-z]"));
        if (label->isVisible() && hasWords) {
            EXPECT_TRUE(label->text().contains('[')) << label->text().toStdString();
        }
    }
    for (QPushButton* button : page.findChildren<QPushButton*>()) {
        if (button->isVisible()) {
            EXPECT_TRUE(button->text().startsWith('[')) << button->text().toStdString();
            EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
        }
    }
    qApp->removeTranslator(&longer);
    QApplication::processEvents();
    EXPECT_EQ(child<QPushButton>("duplicateObject")->text(), "Du&plicate");
}

// Catches controls that a screen reader or the keyboard cannot find.
TEST_F(ObjectsPageTest, EveryControlHasAnAccessibleName) {
    for (QWidget* widget : page.findChildren<QWidget*>()) {
        const bool control = qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QComboBox*>(widget) ||
                             qobject_cast<QSlider*>(widget) || qobject_cast<ObjectList*>(widget) ||
                             widget->objectName() == "objectName";
        if (control) {
            EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
        }
    }
}

// Catches an edit or a selection that holds the GUI thread; keeps a picture of the page in both themes.
TEST_F(ObjectsPageTest, PictureInBothThemes) {
    const double before_s = test::threadTime_s();
    select("bunny");
    EXPECT_LT(test::threadTime_s() - before_s, 0.5);
    ASSERT_TRUE(fitted());
    ASSERT_TRUE(QTest::qWaitFor([&] { return page.findChild<FourierFits*>()->complete(); }, 120000));
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        QApplication::processEvents();
        const QImage picture = page.grab().toImage();
        EXPECT_TRUE(picture.save(dark ? "objects_dark.png" : "objects_light.png"));
        EXPECT_EQ(picture.pixelColor(2, 2).lightness() < 128, dark);
    }
    applyTheme(*qApp, Theme::Light);
    EXPECT_LE(page.minimumSizeHint().width(), 1100);
    EXPECT_LE(page.minimumSizeHint().height(), 560);
}

// Catches: an object in another's light that nobody is told of, or is told to overlap it; words of a mounting
// before.
TEST_F(ObjectsPageTest, WhoShadesWhomAtTheStartIsTold) {
    auto* remarks = child<QLabel>("mountingRemarks");
    Experiment stacked = example();
    stacked.objects[1].mounting = stacked.objects[2].mounting; // the bunny 4 cm below the hand
    stacked.objects[1].mounting[kZ] -= 0.04;
    page.setExperiment(stacked);
    const QRegularExpression told(
        QString::fromUtf8("\u2022 bunny takes \\d+ % of the light of hand at the start pose"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return remarks->text().contains(told); }))
        << remarks->text().toStdString();
    EXPECT_FALSE(remarks->text().contains("overlap"));
    page.setExperiment(example());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !remarks->text().contains("takes"); }));
}

// Catches: a share of light that is told only when the mouse is let go, or stays when the drag is given up; a
// drag through another object that nobody is told of; and fields that show what is no longer so.
TEST_F(ObjectsPageTest, ADragTellsAtOnceWhatItDoesToTheLight) {
    auto* remarks = child<QLabel>("mountingRemarks");
    Experiment stacked = example();
    stacked.objects[1].mounting = stacked.objects[2].mounting;
    stacked.objects[1].mounting[kZ] = 0.05; // the bunny behind the hand, which is in its light
    page.setExperiment(stacked);
    select("bunny");
    child<QTabBar>("objectTabs")->setCurrentIndex(1);
    for (int i = 0; i < 4; ++i)
        QApplication::processEvents();
    const auto told = [&](const char* what) {
        return QTest::qWaitFor([&] { return remarks->text().contains(QLatin1String(what)); });
    };
    ASSERT_TRUE(told("hand takes")) << remarks->text().toStdString();
    auto* side = child<MountingPlan>("mountingSide");
    const auto mouse = [&](QEvent::Type type, const QPointF& at) {
        QMouseEvent event(type, at, side->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(side, &event);
    };
    const QPointF at = side->objectPosition(1);
    const double cm_px = 0.2 * (side->objectPosition(2) - at).y();
    mouse(QEvent::MouseButtonPress, at);
    mouse(QEvent::MouseMove, at + QPointF(0.0, 10.0 * cm_px)); // now before it
    EXPECT_TRUE(told("bunny takes")) << remarks->text().toStdString();
    EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>("mountZ")->value(), -5.0);
    mouse(QEvent::MouseMove, at + QPointF(0.0, 5.0 * cm_px)); // in its plane
    EXPECT_TRUE(told("overlap")) << remarks->text().toStdString();
    QTest::keyClick(side, Qt::Key_Escape);
    EXPECT_TRUE(told("hand takes")) << remarks->text().toStdString();
    EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>("mountZ")->value(), 5.0);
    EXPECT_EQ(edited.count(), 0);
    EXPECT_EQ(last(), stacked);
}

} // namespace
} // namespace bask
