// Objects with holes on the Objects page: said, drawn, and kept by edits.

#include "engine/experiment/experiment_file.h"
#include "widgets/objects/mounting_plan.h"
#include "widgets/objects/object_list.h"
#include "widgets/objects/objects_page.h"

#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

Contour square(double half_m, double x_m = 0.0) {
    return {
        {{x_m - half_m, -half_m}, {x_m + half_m, -half_m}, {x_m + half_m, half_m}, {x_m - half_m, half_m}}};
}

/// The example with a hole in its circle and two in its bunny.
Experiment pierced() {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    experiment.objects[0].shape = withHoles(experiment.objects[0].shape, {square(0.002)});
    ObjectSpec& bunny = experiment.objects[1];
    OriginalShape made =
        shapeFromOutline(bunny.origin.outline, {square(0.002), square(0.001, 0.005)}, 5).value();
    bunny.shape = made.shape;
    bunny.origin = made.origin;
    return experiment;
}

struct HolesTest : testing::Test {
    ObjectsPage page;
    QSignalSpy edited{&page, &ObjectsPage::experimentEdited};

    HolesTest() {
        page.setExperiment(pierced());
        page.resize(1150, 620);
        page.show();
        QApplication::processEvents();
    }
    void type(const char* name, const QString& text) {
        auto* field = page.findChild<QAbstractSpinBox*>(name);
        ASSERT_NE(field, nullptr) << name;
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
};

} // namespace

// Catches holes that are drawn but not said.
TEST_F(HolesTest, TheListSaysThem) {
    auto* list = page.findChild<ObjectList*>("objectList");
    const auto said = [&](int i) { return list->item(i)->data(Qt::AccessibleDescriptionRole).toString(); };
    EXPECT_TRUE(said(0).contains("disk")) << said(0).toStdString();
    EXPECT_TRUE(said(0).contains(", 1 hole ")) << said(0).toStdString();
    EXPECT_TRUE(said(1).contains("5 harmonics, 2 holes")) << said(1).toStdString();
    EXPECT_FALSE(said(2).contains("hole"));
}

// Catches holes lost, or left behind, by a fit with other harmonics.
TEST_F(HolesTest, StayThroughAnotherFit) {
    auto* list = page.findChild<ObjectList*>("objectList");
    list->setCurrentRow(1);
    type("harmonicsSpin", "9");
    ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() == 1; }, 120000));
    const ObjectSpec& bunny = page.experiment().objects[1];
    const OriginalShape expected =
        shapeFromOutline(pierced().objects[1].origin.outline, {square(0.002), square(0.001, 0.005)}, 9)
            .value();
    ASSERT_EQ(holesOf(bunny.shape).size(), 2U);
    EXPECT_EQ(outlineAs<FourierContour>(bunny.shape)->harmonics(), 9);
    EXPECT_LT((contourCentroid(holesOf(bunny.shape)[1]) - contourCentroid(holesOf(expected.shape)[1])).norm(),
              1e-9);
    EXPECT_EQ(bunny.origin.holes.size(), 2U);
}

// Catches a disk that loses its holes when its radius is typed.
TEST_F(HolesTest, StayThroughAnotherRadius) {
    page.findChild<ObjectList*>("objectList")->setCurrentRow(0);
    type("radius", "2.5");
    ASSERT_EQ(edited.count(), 1);
    EXPECT_EQ(page.experiment().objects[0].shape, withHoles(Disk{0.025}, {square(0.002)}));
}

// Catches a plan that fills the holes: what lies in one can be clicked.
TEST(MountingPlanHoles, AreOpen) {
    ObjectSpec ring, plug;
    ring.shape = withHoles(Disk{0.05}, {Contour{shapeOutline(Disk{0.03}, 60)}});
    plug.shape = Disk{0.01};
    MountingPlan plan;
    plan.setObjects({ring, plug}, 0);
    plan.resize(400, 300);
    plan.show();
    int clicked = -1;
    QObject::connect(&plan, &MountingPlan::objectClicked, &plan, [&](int index) { clicked = index; });
    const auto clickAt = [&](double x, double y) {
        clicked = -1;
        for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            const auto buttons = type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton;
            QMouseEvent event(type, {x, y}, plan.mapToGlobal(QPointF(x, y)), Qt::LeftButton, buttons, {});
            QApplication::sendEvent(&plan, &event);
        }
        return clicked;
    };
    std::vector<int> met; // along a line through the middle
    for (int x = 0; x < plan.width(); ++x)
        if (const int at = clickAt(x, 140.0); met.empty() || met.back() != at)
            met.push_back(at);
    EXPECT_EQ(met, (std::vector<int>{-1, 0, -1, 1, -1, 0, -1}));
}

} // namespace bask
