// The plan of the end-effector, dragged and turned by mouse and keys.

#include "engine/base/units.h"
#include "widgets/common/theme.h"
#include "widgets/objects/mounting_plan.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

/// Two disks 8 cm apart along x; the first one is selected. What is asked for is done, as the page does it.
struct MountingPlanTest : testing::Test {
    MountingPlan plan;
    std::vector<ObjectSpec> objects;
    int selected = 0;
    int moves = 0;

    MountingPlanTest() {
        for (const double x_m : {-0.04, 0.04}) {
            ObjectSpec object;
            object.name = x_m < 0.0 ? "left" : "right";
            object.shape = Disk{0.015};
            object.mounting[kX] = x_m;
            objects.push_back(object);
        }
        QObject::connect(&plan, &MountingPlan::objectClicked, &plan, [this](int index) {
            selected = index;
            show();
        });
        QObject::connect(&plan, &MountingPlan::objectMoved, &plan, [this](int index, const Vector6d& to) {
            ++moves;
            objects[static_cast<std::size_t>(index)].mounting = to;
            show();
        });
        plan.resize(400, 300);
        plan.show();
        show();
    }
    void show() { plan.setObjects(objects, selected); }

    void mouse(QEvent::Type type, const QPointF& at, Qt::KeyboardModifiers keys = {}) {
        const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, plan.mapToGlobal(at), Qt::LeftButton, buttons, keys);
        QApplication::sendEvent(&plan, &event);
    }
    void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers keys = {}) {
        mouse(QEvent::MouseButtonPress, from, keys);
        mouse(QEvent::MouseMove, 0.5 * (from + to), keys);
        mouse(QEvent::MouseMove, to, keys);
        mouse(QEvent::MouseButtonRelease, to, keys);
    }
    QPointF middleOf(int index) const { return plan.objectPosition(index); }
    Vector6d& mounting(int index) { return objects[static_cast<std::size_t>(index)].mounting; }
};

} // namespace

// Catches a drag that commits at every move, snaps nowhere, or moves what was only clicked.
TEST_F(MountingPlanTest, DraggingMovesInStepsOfFiveMillimetresAndCommitsOnce) {
    const QPointF from = middleOf(1);
    drag(from, from + QPointF(1.0, 1.0));
    EXPECT_EQ(moves, 0);
    EXPECT_EQ(selected, 1);
    drag(from, from + QPointF(-30.0, -40.0));
    EXPECT_EQ(moves, 1);
    EXPECT_LT(mounting(1)[kX], 0.04);
    EXPECT_GT(mounting(1)[kY], 0.0); // up is +y
    for (const int c : {kX, kY})
        EXPECT_NEAR(std::remainder(mounting(1)[c], 0.005), 0.0, 1e-12);
    EXPECT_EQ(mounting(0)[kX], -0.04);
    const Vector6d before = mounting(1);
    selected = 1;
    show();
    const QPointF there = middleOf(1);
    drag(there, there + QPointF(17.0, 0.0), Qt::AltModifier);
    EXPECT_NEAR(std::remainder(mounting(1)[kX], 1e-4), 0.0, 1e-12);
    EXPECT_NE(mounting(1)[kX], before[kX]);
}

// Catches keys that move another object, and a rotation that leaves -180 to 180 degrees.
TEST_F(MountingPlanTest, KeysMoveAndTurnTheSelectedOne) {
    QTest::keyClick(&plan, Qt::Key_Right);
    QTest::keyClick(&plan, Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_NEAR(mounting(0)[kX], -0.039, 1e-12);
    EXPECT_NEAR(mounting(0)[kY], 0.01, 1e-12);
    for (int k = 0; k < 40; ++k)
        QTest::keyClick(&plan, Qt::Key_PageUp);
    EXPECT_NEAR(degFromRad(mounting(0)[kThetaZ]), -160.0, 1e-9);
    EXPECT_EQ(moves, 42);
}

// Catches a plan that can be changed while a run is on, and an Escape that leaves the change.
TEST_F(MountingPlanTest, EscapeAndReadOnlyChangeNothing) {
    const QPointF from = middleOf(0);
    mouse(QEvent::MouseButtonPress, from);
    mouse(QEvent::MouseMove, from + QPointF(40.0, 0.0));
    QTest::keyClick(&plan, Qt::Key_Escape);
    mouse(QEvent::MouseButtonRelease, from + QPointF(40.0, 0.0));
    EXPECT_EQ(moves, 0);
    plan.setReadOnly(true);
    drag(from, from + QPointF(40.0, 0.0));
    QTest::keyClick(&plan, Qt::Key_Left);
    EXPECT_EQ(moves, 0);
}

// Catches a handle or a small object that only a mouse's point can hit, and a turn that is not in steps.
TEST_F(MountingPlanTest, AnUnsteadyHandHitsTheHandleAndSmallObjects) {
    drag(plan.handlePosition() + QPointF(10.0, -10.0), middleOf(0) + QPointF(60.0, 3.0));
    EXPECT_EQ(moves, 1);
    EXPECT_NEAR(degFromRad(mounting(0)[kThetaZ]), -95.0, 1e-9);
    EXPECT_EQ(mounting(0)[kX], -0.04);
    objects[1].shape = Disk{0.0005};
    show();
    drag(middleOf(1) + QPointF(9.0, 6.0), middleOf(1) + QPointF(9.0, -34.0));
    EXPECT_EQ(moves, 2);
    EXPECT_EQ(selected, 1);
    EXPECT_GT(mounting(1)[kY], 0.0);
}

// Catches an overlap that cannot be mended since the object below is the one that moves.
TEST_F(MountingPlanTest, OfTwoThatOverlapTheSelectedOneMoves) {
    mounting(0) = mounting(1);
    selected = 1;
    show();
    drag(middleOf(1), middleOf(1) + QPointF(-60.0, 0.0));
    EXPECT_EQ(selected, 1);
    EXPECT_LT(mounting(1)[kX], 0.04);
    EXPECT_EQ(mounting(0)[kX], 0.04);
}

// Catches a grid that is too fine to be seen, or of squares that nobody counts in.
TEST(MountingPlanGrid, SquaresAreOfOneTwoOrFive) {
    for (double pixelsPerMm = 0.02; pixelsPerMm < 60.0; pixelsPerMm *= 1.07) {
        const double step_mm = gridStep_mm(pixelsPerMm);
        EXPECT_GE(step_mm * pixelsPerMm, 18.0 * (1.0 - 1e-9));
        EXPECT_LE(step_mm * pixelsPerMm, 18.0 * 2.5);
        const double lead = step_mm / std::pow(10.0, std::floor(std::log10(step_mm) + 1e-9));
        EXPECT_TRUE(std::abs(lead - 1.0) < 1e-6 || std::abs(lead - 2.0) < 1e-6 || std::abs(lead - 5.0) < 1e-6)
            << step_mm;
    }
}

// Catches a plan that stays small when there is room, names that are not drawn, and a readout that stays away
// while an object is dragged; keeps pictures of narrow and wide plans in both themes.
TEST_F(MountingPlanTest, GrowsWithItsColumnAndNamesTheObjects) {
    EXPECT_EQ(plan.heightForWidth(220), 220);
    EXPECT_EQ(plan.heightForWidth(400), 400);
    EXPECT_LT(plan.heightForWidth(1000), 500);
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        QApplication::processEvents();
        for (const int width : {220, 400}) {
            plan.resize(width, plan.heightForWidth(width));
            EXPECT_TRUE(plan.grab().save(
                QStringLiteral("mounting_plan_%1_%2.png").arg(dark ? "dark" : "light").arg(width)));
        }
    }
    applyTheme(*qApp, Theme::Light);
    const QImage before = plan.grab().toImage();
    objects[1].name = "other";
    show();
    EXPECT_NE(plan.grab().toImage(), before);
    objects[1].name = "right";
    show();
    EXPECT_EQ(plan.grab().toImage(), before);
    const QRect top(0, 2, plan.width(), 16);
    mouse(QEvent::MouseButtonPress, middleOf(0));
    EXPECT_EQ(plan.grab().toImage().copy(top), before.copy(top));
    mouse(QEvent::MouseMove, middleOf(0) + QPointF(0.0, 40.0));
    EXPECT_NE(plan.grab().toImage().copy(top), before.copy(top));
    mouse(QEvent::MouseButtonRelease, middleOf(0));
}

} // namespace bask
