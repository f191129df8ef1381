// The plan of the end-effector, dragged and turned by mouse and keys.

#include "engine/base/units.h"
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
    /// Where the disks are drawn: the plan is symmetric about its middle, so a click tells.
    QPointF middleOf(int index) {
        for (int x = 0; x < plan.width(); ++x) {
            const int before = selected;
            selected = -1;
            const QPointF at(index == 0 ? x : plan.width() - 1 - x, 140.0);
            mouse(QEvent::MouseButtonPress, at);
            mouse(QEvent::MouseButtonRelease, at);
            const bool hit = selected == index;
            selected = before;
            show();
            if (hit)
                return at + QPointF(index == 0 ? 20.0 : -20.0, 0.0);
        }
        ADD_FAILURE() << "object " << index << " is not drawn";
        return {};
    }
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

} // namespace bask
