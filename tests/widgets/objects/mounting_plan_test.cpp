// The views of the end-effector: objects moved, turned and tilted by mouse and keys.

#include "engine/base/units.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/theme.h"
#include "widgets/objects/mounting_plan.h"
#include "widgets/objects/mounting_views.h"
#include "widgets/objects/outline_painting.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTabBar>
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

// Catches names that are not drawn, and a readout that stays away while an object is dragged; keeps pictures
// of small and large plans in both themes.
TEST_F(MountingPlanTest, NamesTheObjectsAndTellsWhereOneIsDragged) {
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        QApplication::processEvents();
        for (const int width : {220, 400}) {
            plan.resize(width, width);
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
    const QRect foot(0, plan.height() - 20, plan.width() - 60, 16);
    mouse(QEvent::MouseButtonPress, middleOf(0));
    EXPECT_EQ(plan.grab().toImage().copy(foot), before.copy(foot));
    mouse(QEvent::MouseMove, middleOf(0) + QPointF(0.0, 40.0));
    EXPECT_NE(plan.grab().toImage().copy(foot), before.copy(foot));
    mouse(QEvent::MouseButtonRelease, middleOf(0));
}

/// From the front: the first disk at a height and tilts that no field shows in full.
struct MountingSideTest : MountingPlanTest {
    const Vector6d before =
        (Vector6d() << -0.0412345678, 0.0123456789, 0.0111111111, 0.1234567891, 0.0, 0.0).finished();

    MountingSideTest() {
        mounting(0) = before;
        look(MountingView::Front);
    }
    void look(MountingView view) {
        plan.setView(view);
        show();
    }
    /// That a drag or key changed this coordinate of the first disk and no other; its value.
    double onlyChanged(Coordinate coordinate) {
        for (int c = 0; c < 6; ++c)
            EXPECT_EQ(mounting(0)[c] == before[c], c != coordinate) << kCoordinateNames[c];
        return mounting(0)[coordinate];
    }
    /// Turns the handle about the object's centre, clockwise as seen.
    void turnHandle(double by_deg) {
        const QPointF centre = middleOf(0), arm = plan.handlePosition() - centre;
        QTransform turn;
        turn.rotate(by_deg); // y is down
        drag(centre + arm, centre + turn.map(arm));
    }
};

// Catches: a height dragged that takes x along, is not in steps, or goes down where the hand goes up.
TEST_F(MountingSideTest, DraggingChangesTheHeightAlone) {
    for (const MountingView view : {MountingView::Front, MountingView::Side}) {
        mounting(0) = before;
        look(view);
        drag(middleOf(0), middleOf(0) + QPointF(33.0, -47.0));
        const double z_m = onlyChanged(kZ);
        EXPECT_GT(z_m, before[kZ]);
        EXPECT_NEAR(std::remainder(z_m, 0.005), 0.0, 1e-12);
    }
    EXPECT_EQ(moves, 2);
}

// Catches: an object that is seen edge-on, and so has no area, and can only be gripped at its middle.
TEST_F(MountingSideTest, AThinEdgeCanBeGrippedAlongItsLength) {
    const double out_px = 0.8 * 0.015 * kMmPerM * plan.fittedScale();
    ASSERT_GT(out_px, 20.0);
    drag(middleOf(1) + QPointF(out_px, 4.0), middleOf(1) + QPointF(out_px, -60.0));
    EXPECT_EQ(selected, 1);
    EXPECT_GT(mounting(1)[kZ], 0.0);
}

// Catches: a tilt that changes the other angles, or turns the other way than the hand does.
TEST_F(MountingSideTest, TheHandleTiltsAboutTheAxisOfTheView) {
    turnHandle(20.0);
    EXPECT_NEAR(degFromRad(onlyChanged(kThetaY)), 20.0, 1e-9); // the back leans to +x
    mounting(0) = before;
    look(MountingView::Side);
    turnHandle(27.1); // from 7.07 degrees about x, against which the view's clockwise is
    EXPECT_NEAR(degFromRad(onlyChanged(kThetaX)), -20.0, 1e-9);
    const Eigen::Vector3d back = poseFromCoordinates(mounting(0)).linear().col(2);
    EXPECT_GT(back.y(), 0.0); // to the right
}

// Catches: a handle without effect on an object that is turned by a quarter about z, since its own x axis is
// then the one that the front view looks along; and a tilt against the hand.
TEST_F(MountingSideTest, TheTiltFollowsTheHandWhateverTheRotation) {
    for (const MountingView view : {MountingView::Front, MountingView::Side})
        for (int turned_deg = -180; turned_deg <= 180; turned_deg += 15) {
            mounting(0) << -0.04, 0.0, 0.0, 0.0, 0.0, radFromDeg(turned_deg);
            look(view);
            const Vector6d at = mounting(0);
            turnHandle(30.0);
            const int changed = static_cast<int>((mounting(0).array() != at.array()).count());
            EXPECT_EQ(changed, 1) << turned_deg;
            EXPECT_EQ(mounting(0)[kThetaZ], at[kThetaZ]);
            const Eigen::Vector3d back = poseFromCoordinates(mounting(0)).linear().col(2);
            EXPECT_GT(back[view == MountingView::Front ? kX : kY], std::sin(radFromDeg(30.0)) * 0.7)
                << turned_deg;
        }
}

// Catches: a tilt that jumps to another pose with the same look where it passes the upright.
TEST_F(MountingSideTest, ATiltGoesOnPastTheUpright) {
    for (int k = 1; k <= 40; ++k) {
        QTest::keyClick(&plan, Qt::Key_PageUp);
        EXPECT_NEAR(std::remainder(degFromRad(mounting(0)[kThetaY]) - 5.0 * k, 360.0), 0.0, 1e-9);
        EXPECT_EQ(mounting(0)[kThetaX], before[kThetaX]);
        EXPECT_EQ(mounting(0)[kThetaZ], before[kThetaZ]);
    }
    QTest::keyClick(&plan, Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_NEAR(mounting(0)[kZ], before[kZ] + 0.01, 1e-12);
}

// Catches: a tilted object that the plan draws as wide as if it lay flat.
TEST_F(MountingSideTest, TheProjectionIsThatOfThePose) {
    ObjectSpec disk = objects[0];
    disk.mounting << 0.0, 0.0, 0.02, 0.0, radFromDeg(60.0), 0.0;
    const auto size = [&](Coordinate right, Coordinate up) {
        const QRectF box = face_mm(mountedRings(disk, 720, right, up)).boundingRect();
        return QSizeF(box.width(), box.height());
    };
    EXPECT_NEAR(size(kX, kY).width(), 15.0, 0.01); // 30 mm cos 60
    EXPECT_NEAR(size(kX, kY).height(), 30.0, 0.01);
    EXPECT_NEAR(size(kX, kZ).width(), 15.0, 0.01);
    EXPECT_NEAR(size(kX, kZ).height(), 25.98, 0.01);
    EXPECT_NEAR(size(kY, kZ).width(), 30.0, 0.01);
}

// Catches: the handle of an object near the upper edge out of sight.
TEST_F(MountingSideTest, HandlesAreInView) {
    for (const MountingView view : {MountingView::Top, MountingView::Front, MountingView::Side})
        for (int deg = -90; deg <= 90; deg += 15) {
            mounting(0) << 0.0, 0.05, 0.03, radFromDeg(deg), radFromDeg(0.3 * deg), 0.0;
            look(view);
            EXPECT_TRUE(QRectF(plan.rect()).adjusted(7, 7, -7, -7).contains(plan.handlePosition()))
                << deg << " deg, view " << static_cast<int>(view) << ", " << plan.handlePosition().x() << ", "
                << plan.handlePosition().y();
        }
}

/// Both views as the page has them.
struct MountingViewsTest : testing::Test {
    MountingViews views;
    MountingPlan& plan = *views.findChild<MountingPlan*>("mountingPlan");
    MountingPlan& side = *views.findChild<MountingPlan*>("mountingSide");
    std::vector<ObjectSpec> objects{2};
    QSignalSpy dragged{&views, &MountingViews::objectDragged};
    QSignalSpy moved{&views, &MountingViews::objectMoved};

    MountingViewsTest() {
        for (ObjectSpec& object : objects)
            object.shape = Disk{0.02};
        objects[0].name = "low";
        objects[1].name = "high";
        objects[1].mounting << 0.05, 0.01, 0.03, 0.0, 0.3, 0.0;
        views.resize(500, 460);
        views.show();
        views.setObjects(objects, 0, 0.2);
        QApplication::processEvents();
    }
    void press(QEvent::Type type, const QPointF& at) {
        QMouseEvent event(type, at, side.mapToGlobal(at), Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        QApplication::sendEvent(&side, &event);
    }
};

// Catches: two views of two scales, or of which the lower does not stand under the upper.
TEST_F(MountingViewsTest, AreOneDrawing) {
    const auto spread = [](const MountingPlan& view) {
        return view.objectPosition(1) - view.objectPosition(0);
    };
    for (const QSize size : {QSize(500, 460), QSize(900, 400), QSize(320, 800)}) {
        views.resize(size);
        QApplication::processEvents();
        EXPECT_NEAR(side.objectPosition(0).x(), plan.objectPosition(0).x(), 1e-6);
        EXPECT_NEAR(spread(side).x(), spread(plan).x(), 1e-6);
        EXPECT_NEAR(-spread(side).y() / 30.0, spread(plan).x() / 50.0, 1e-6);
    }
    views.findChild<QTabBar*>("mountingFrom")->setCurrentIndex(1);
    EXPECT_EQ(side.view(), MountingView::Side);
    EXPECT_NEAR(spread(side).x() / 10.0, -spread(plan).y() / 10.0, 1e-6);
}

// Catches: a view in which an object stays where it was while the other drags it, an edit at each move of the
// mouse, and an Escape after which it is shown where it was let go.
TEST_F(MountingViewsTest, OneFollowsTheDragOfTheOther) {
    views.findChild<QTabBar*>("mountingFrom")->setCurrentIndex(1);
    const QImage before = plan.grab().toImage();
    const QPointF handle = side.handlePosition(), centre = side.objectPosition(0);
    press(QEvent::MouseButtonPress, handle);
    press(QEvent::MouseMove, centre + QPointF(40.0, -40.0));
    EXPECT_NE(plan.grab().toImage(), before); // narrower in y
    ASSERT_EQ(dragged.count(), 1);
    EXPECT_NEAR(degFromRad(dragged.at(0).at(1).value<Vector6d>()[kThetaX]), -45.0, 1e-9);
    QTest::keyClick(&side, Qt::Key_Escape);
    press(QEvent::MouseButtonRelease, centre + QPointF(40.0, -40.0));
    EXPECT_EQ(plan.grab().toImage(), before);
    EXPECT_EQ(dragged.count(), 2);
    EXPECT_EQ(dragged.at(1).at(1).value<Vector6d>(), objects[0].mounting);
    EXPECT_EQ(moved.count(), 0);
}

} // namespace bask
