// Every edit of the Objects page is one step of undo, which brings back exactly what was.

#include "app/document.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/objects/mounting_plan.h"
#include "widgets/objects/object_list.h"
#include "widgets/objects/objects_page.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>

#include <gtest/gtest.h>

#include <functional>

namespace bask::test {
namespace {

/// The page with a document, as the window has them.
struct ObjectsUndoTest : testing::Test {
    ObjectsPage page;
    QSignalSpy edited{&page, &ObjectsPage::experimentEdited};

    Document document;
    double max_m = 10.0; ///< the bunny's x, taken from the page

    ObjectsUndoTest() {
        const auto show = [this] { page.setExperiment(document.experiment()); };
        for (auto change : {&Document::opened, &Document::edited, &Document::targetsChanged})
            QObject::connect(&document, change, &page, show);
        QObject::connect(&page, &ObjectsPage::experimentEdited, &page,
                         [this, show](const Experiment& experiment) {
                             const bool refused =
                                 experiment.objects.size() > 1 && experiment.objects[1].mounting[kX] > max_m;
                             if (refused || !document.edit(experiment, Page::Objects))
                                 show();
                         });
        document.open(readExperiment(BASK_EXAMPLES "/three-objects.json").value(), {});
        page.resize(1150, 720);
        page.show();
        page.activateWindow();
        child<QTabBar>("objectTabs")->setCurrentIndex(1);
        page.selectObject(1); // the bunny
        QApplication::processEvents();
    }
    template <class T> T* child(const char* name) {
        auto* found = page.findChild<T*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void type(const char* name, const QString& text) {
        auto* field = child<QWidget>(name);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void click(const char* name) { QTest::mouseClick(child<QPushButton>(name), Qt::LeftButton); }
    void drag(const QPointF& from, const QPointF& to, const char* view = "mountingPlan") {
        auto* plan = child<MountingPlan>(view);
        const auto send = [&](QEvent::Type type, const QPointF& at) {
            QMouseEvent event(type, at, plan->mapToGlobal(at), Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                              Qt::NoModifier);
            QApplication::sendEvent(plan, &event);
        };
        send(QEvent::MouseButtonPress, from);
        for (int k = 1; k <= 4; ++k)
            send(QEvent::MouseMove, from + 0.25 * k * (to - from));
        send(QEvent::MouseButtonRelease, to);
    }
    int steps() {
        int count = 0;
        for (; document.toUndo() != nullptr; ++count)
            document.undo();
        for (int i = 0; i < count; ++i)
            document.redo();
        return count;
    }
    /// Does the edit, waits for it, takes it back, does it again and takes it back again. What it made.
    Experiment isOneStep(const char* what, const std::function<void()>& edit) {
        SCOPED_TRACE(what);
        const Experiment before = page.experiment();
        const int stepsBefore = steps();
        edited.clear();
        edit();
        EXPECT_TRUE(QTest::qWaitFor([this] { return edited.count() > 0; }, 120000));
        EXPECT_EQ(edited.count(), 1);
        const Experiment after = page.experiment();
        EXPECT_NE(after, before);
        EXPECT_EQ(document.experiment(), after);
        EXPECT_EQ(steps(), stepsBefore + 1);
        for (int round = 0; round < 2; ++round) {
            document.undo();
            EXPECT_EQ(page.experiment(), before);
            EXPECT_EQ(document.experiment(), before);
            EXPECT_EQ(steps(), stepsBefore);
            if (round == 0) {
                document.redo();
                EXPECT_EQ(page.experiment(), after);
            }
        }
        return after;
    }
};

} // namespace

// Catches a move or turn on the plan that takes a step for each move of the mouse, moves another object or is
// not taken back.
TEST_F(ObjectsUndoTest, OnThePlan) {
    auto* plan = child<MountingPlan>("mountingPlan");
    isOneStep("drag",
              [&] { drag(plan->objectPosition(1), plan->objectPosition(1) + QPointF(-30.0, -20.0)); });
    isOneStep("turn", [&] { drag(plan->handlePosition(), plan->objectPosition(1) + QPointF(60.0, 5.0)); });
    for (const Qt::Key key :
         {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown})
        isOneStep("key", [&] { QTest::keyClick(plan, key); });
    isOneStep("key held", [&] {
        QTest::keyPress(plan, Qt::Key_Left);
        for (int k = 0; k < 3; ++k) {
            QKeyEvent again(QEvent::KeyPress, Qt::Key_Left, Qt::NoModifier, {}, true);
            QApplication::sendEvent(plan, &again);
        }
        EXPECT_EQ(edited.count(), 4);
        edited.clear();
        edited << QVariantList(); // they are the one edit that it is to undo
    });
    isOneStep("key with Shift", [&] { QTest::keyClick(plan, Qt::Key_Left, Qt::ShiftModifier); });
}

// The same from the front.
TEST_F(ObjectsUndoTest, OnTheSideView) {
    auto* side = child<MountingPlan>("mountingSide");
    const Experiment lifted = isOneStep("drag", [&] {
        drag(side->objectPosition(1), side->objectPosition(1) + QPointF(0.0, -30.0), "mountingSide");
    });
    EXPECT_GT(lifted.objects[1].mounting[kZ], page.experiment().objects[1].mounting[kZ]);
    const Experiment tilted = isOneStep("tilt", [&] {
        drag(side->handlePosition(), side->handlePosition() + QPointF(20.0, 5.0), "mountingSide");
    });
    EXPECT_GT(tilted.objects[1].mounting[kThetaY], 0.0);
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_PageDown})
        isOneStep("key", [&] { QTest::keyClick(side, key); });
}

// Catches a drag of an object that was not selected which leaves the selection as a step of its own, or is
// taken back on another object.
TEST_F(ObjectsUndoTest, ADragOfAnotherObject) {
    auto* plan = child<MountingPlan>("mountingPlan");
    const Experiment before = page.experiment();
    drag(plan->objectPosition(2), plan->objectPosition(2) + QPointF(30.0, 20.0));
    EXPECT_EQ(edited.count(), 1);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(page.experiment().objects[1], before.objects[1]);
    EXPECT_NE(page.experiment().objects[2].mounting, before.objects[2].mounting);
    document.undo();
    EXPECT_EQ(page.experiment(), before);
}

// Catches a field whose typing is a step a digit, that is taken back to what the field shows, or that rounds
// another one in passing.
TEST_F(ObjectsUndoTest, NumbersTyped) {
    // Digits that no field shows: they must come back all the same.
    Experiment experiment = page.experiment();
    experiment.objects[1].mounting << 0.0123456789, -0.0234567891, 0.0011111111, 0.0345678912, -0.0456789123,
        0.1234567891;
    experiment.objects[1].material.emittance = 0.87654321;
    experiment.objects[1].material.absorptance = 0.76543219;
    experiment.objects[1].material.specificHeat_J_kgK = 1234.56789;
    experiment.objects[1].material.density_kg_m3 = 1111.23456789;
    experiment.objects[1].material.thickness_m = 0.00123456789;
    experiment.objects[1].material.infill = 0.333333333;
    experiment.objects[1].target_K = 317.123456;
    experiment.objects[1].estimatedRates = HeatRates{0.2, 2e-11, 0.16};
    document.open(experiment, {});
    page.selectObject(1);
    struct Field {
        const char* name;
        const char* text;
        void (*copy)(ObjectSpec& to, const ObjectSpec& from);
    };
    const Field fields[] = {
        {"mountX", "3.1",
         [](ObjectSpec& to, const ObjectSpec& from) { to.mounting[kX] = from.mounting[kX]; }},
        {"mountY", "-4.2",
         [](ObjectSpec& to, const ObjectSpec& from) { to.mounting[kY] = from.mounting[kY]; }},
        {"mountZ", "1.5",
         [](ObjectSpec& to, const ObjectSpec& from) { to.mounting[kZ] = from.mounting[kZ]; }},
        {"mountRotation", "75",
         [](ObjectSpec& to, const ObjectSpec& from) { to.mounting[kThetaZ] = from.mounting[kThetaZ]; }},
        {"mountTiltX", "-15.5",
         [](ObjectSpec& to, const ObjectSpec& from) { to.mounting[kThetaX] = from.mounting[kThetaX]; }},
        {"mountTiltY", "20",
         [](ObjectSpec& to, const ObjectSpec& from) { to.mounting[kThetaY] = from.mounting[kThetaY]; }},
        {"target", "47.5", [](ObjectSpec& to, const ObjectSpec& from) { to.target_K = from.target_K; }},
        {"emittance", "0.5",
         [](ObjectSpec& to, const ObjectSpec& from) { to.material.emittance = from.material.emittance; }},
        {"absorptance", "0.6",
         [](ObjectSpec& to, const ObjectSpec& from) { to.material.absorptance = from.material.absorptance; }},
        {"specificHeat", "1500",
         [](ObjectSpec& to, const ObjectSpec& from) {
             to.material.specificHeat_J_kgK = from.material.specificHeat_J_kgK;
         }},
        {"density", "950",
         [](ObjectSpec& to, const ObjectSpec& from) {
             to.material.density_kg_m3 = from.material.density_kg_m3;
         }},
        {"thickness", "2.25",
         [](ObjectSpec& to, const ObjectSpec& from) { to.material.thickness_m = from.material.thickness_m; }},
        {"infill", "45",
         [](ObjectSpec& to, const ObjectSpec& from) { to.material.infill = from.material.infill; }},
    };
    for (const Field& field : fields) {
        Experiment rest = isOneStep(field.name, [&] { type(field.name, field.text); });
        field.copy(rest.objects[1], experiment.objects[1]);
        if (rest.objects[1].material == experiment.objects[1].material)
            rest.objects[1].estimatedRates = experiment.objects[1].estimatedRates; // another material's
        EXPECT_EQ(rest, experiment) << field.name << " changed more than itself";
    }
    page.selectObject(0);
    isOneStep("radius", [&] { type("radius", "2.2"); });
}

// Catches a material, name or object that is not taken back whole.
TEST_F(ObjectsUndoTest, MaterialNameAndObjects) {
    isOneStep("material", [&] {
        auto* preset = child<QComboBox>("materialPreset");
        const int row = preset->findText("glass");
        ASSERT_GE(row, 0);
        preset->setCurrentIndex(row);
        emit preset->activated(row);
    });
    isOneStep("name in the form", [&] { type("objectName", "hare"); });
    isOneStep("name in the list", [&] { child<ObjectList>("objectList")->item(1)->setText("hare"); });
    isOneStep("add disk", [&] { click("addDisk"); });
    isOneStep("duplicate", [&] { click("duplicateObject"); });
    isOneStep("import", [&] { page.offerFile(QStringLiteral(BASK_TEST_DATA "/contours/svg/bunny_mm.svg")); });
    isOneStep("remove", [&] { click("removeObject"); });
}

// Catches harmonics that leave the fit of the number before, or the raw outline lost.
TEST_F(ObjectsUndoTest, Harmonics) {
    ASSERT_TRUE(QTest::qWaitFor([this] { return child<QLabel>("residual")->text().contains("mm"); }, 120000));
    isOneStep("number typed", [&] { type("harmonicsSpin", "12"); });
    Experiment experiment = page.experiment();
    experiment.objects[1].shape = experiment.objects[1].origin.outline;
    experiment.objects[1].origin.harmonics = 0;
    document.open(experiment, {});
    page.selectObject(1);
    isOneStep("a fit in place of the polygon", [&] { type("harmonicsSpin", "9"); });
}

// Catches steps that are right alone and wrong in a row.
TEST_F(ObjectsUndoTest, AllTheWayBackAndForth) {
    const Experiment before = page.experiment();
    type("mountX", "-5.5");
    click("addDisk");
    type("radius", "1.1");
    type("objectName", "coin");
    page.selectObject(0);
    type("emittance", "0.4");
    click("removeObject");
    const Experiment after = page.experiment();
    ASSERT_EQ(steps(), 6);
    while (document.toUndo() != nullptr)
        document.undo();
    EXPECT_EQ(page.experiment(), before);
    EXPECT_FALSE(document.modified());
    while (document.toRedo() != nullptr)
        document.redo();
    EXPECT_EQ(page.experiment(), after);
    EXPECT_TRUE(document.modified());
}

// Catches a refused step of a held key that takes the steps before it, or the whole history, along.
TEST_F(ObjectsUndoTest, ARefusedStepOfAHeldKeyLeavesTheOthers) {
    type("thickness", "2.5");
    const Experiment first = page.experiment();
    max_m = first.objects[1].mounting[kX] + 0.0025; // two steps
    auto* plan = child<MountingPlan>("mountingPlan");
    for (int k = 0; k < 4; ++k) {
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, QString(), k > 0);
        QApplication::sendEvent(plan, &held);
    }
    const Experiment last = page.experiment();
    EXPECT_NEAR(last.objects[1].mounting[kX], first.objects[1].mounting[kX] + 0.002, 1e-12);
    EXPECT_EQ(steps(), 2);
    document.undo();
    EXPECT_EQ(page.experiment(), first);
    document.redo();
    EXPECT_EQ(page.experiment(), last);
}

} // namespace bask::test
