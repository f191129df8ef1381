// The targets' surfaces from a verdict to the picture, under OpenGL.

#include "tests/widgets/targets/surfaces_fixture.h"
#include "widgets/scene/vtk_view.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QToolButton>

namespace bask::test {
namespace {

struct SurfacesViewTest : SurfacesTest {};

// Catches a verdict whose surfaces never come, a slider of the angle that draws nothing anew, and one that
// stays where it was put when the pose is asked for again.
TEST_F(SurfacesViewTest, SurfacesFollowVerdictAndAngle) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    ASSERT_TRUE(verdict().feasible);
    const QImage empty = picture();
    view.setVerdict(verdict());
    settle();
    const QImage atPose = changed(empty, 0.1); // more than objects that move
    keep("surfaces_at_pose.png");
    auto* slider = view.findChild<QSlider*>("heldThetaX");
    auto* back = view.findChild<QPushButton*>("heldAtPose");
    EXPECT_FALSE(back->isEnabled());
    const int before = slider->value();
    slider->setValue(before > 0 ? slider->minimum() : slider->maximum());
    changed(atPose);
    keep("surfaces_at_limit.png");
    EXPECT_TRUE(back->isEnabled());
    QTest::mouseClick(back, Qt::LeftButton);
    EXPECT_EQ(slider->value(), before);
    EXPECT_TRUE(becomes(atPose));
}

// Catches surfaces of the objects before that arrive after others were set, and are taken for theirs.
TEST_F(SurfacesViewTest, SurfacesOfAnOlderGeometryAreNotHeard) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    view.setVerdict(verdict());
    view.findChild<QComboBox*>("cutObject")->setCurrentIndex(3);
    Experiment fewer = experiment;
    fewer.objects.pop_back();
    view.setExperiment(fewer);
    const QImage alone = picture();
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(120000));
    QApplication::processEvents();
    EXPECT_LT(differentPixels(picture(), alone), 600 * 400 / 100);
}

// Catches a cut that is not drawn, opens elsewhere than at the verdict's pose, does not move, or stays.
TEST_F(SurfacesViewTest, ACutIsDrawnAndMoved) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage without = withSurfaces();
    auto* object = view.findChild<QComboBox*>("cutObject");
    ASSERT_EQ(object->count(), 4);
    object->setCurrentIndex(2);
    const QImage cut = changed(without, 0.05);
    keep("surfaces_cut.png");
    auto* place = view.findChild<QSlider*>("cutPlace");
    const auto pose = verdict().pose;
    EXPECT_NE(place->value(), 0) << "the middle of the workspace tells nothing";
    EXPECT_NEAR(place->value(), 1000.0 * pose[kY], 0.51) << "at the pose that was found";
    place->setValue(place->maximum() / 2);
    const QImage moved = changed(cut);
    EXPECT_EQ(find<QLabel>("cutWord")->text(), QStringLiteral("y = +5.0 cm"));
    keep("surfaces_cut_view.png");
    view.setVerdict(verdict());
    settle();
    EXPECT_EQ(place->value(), place->maximum() / 2) << "a verdict takes it away";
    find<QComboBox>("cutQuantity")->setCurrentIndex(1);
    changed(moved, 0.01);
    keep("surfaces_cut_F.png"); // the bar and its colours
    object->setCurrentIndex(0);
    EXPECT_TRUE(becomes(without));
}

// Catches a picture of an older question that looks like the present answer.
TEST_F(SurfacesViewTest, StaleIsVisible) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage fresh = withSurfaces();
    view.setStale(true);
    changed(fresh);
    keep("surfaces_stale.png");
}

// Catches a view that goes on showing the end-effector's positions, a ghost that is not where the objects'
// surfaces are, and a cut of the other space.
TEST_F(SurfacesViewTest, OwnPositionsAreShown) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage positions = withSurfaces();
    auto* space = find<QComboBox>("surfaceSpace");
    ASSERT_EQ(space->count(), 3);
    space->setCurrentIndex(1);
    settle();
    const QImage own = changed(positions, 0.1);
    keep("surfaces_own.png");
    find<QComboBox>("cutObject")->setCurrentIndex(1);
    changed(own, 0.05);
    // The circle hangs 5 cm towards +y of the end-effector, and so does its slider's range.
    const auto turned_mm = [this] {
        return find<QSlider>("cutPlace")->maximum() - 1000.0 * experiment.robot.upper[kY];
    };
    EXPECT_NEAR(turned_mm(), 50.0, 10.0);
    find<QComboBox>("cutObject")->setCurrentIndex(0);
    space->setCurrentIndex(0);
    EXPECT_TRUE(becomes(positions));
}

// Catches angles with the sliders of angles, a position that is not held, and a cut across positions.
TEST_F(SurfacesViewTest, AnglesAreShownAtTheHeldPosition) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage positions = withSurfaces();
    find<QComboBox>("surfaceSpace")->setCurrentIndex(2);
    settle();
    const QImage angles = changed(positions, 0.1);
    keep("surfaces_angles.png");
    EXPECT_FALSE(find<QSlider>("heldThetaX")->isVisible());
    for (const char* name : {"heldX", "heldY", "heldZ"})
        EXPECT_TRUE(find<QSlider>(name)->isVisible()) << name;
    auto* back = find<QPushButton>("heldAtPose");
    EXPECT_FALSE(back->isEnabled());
    find<QSlider>("heldZ")->setValue(120);
    EXPECT_EQ(find<QLabel>("heldWordZ")->text(), QStringLiteral("z +12.0 cm"));
    changed(angles, 0.05);
    auto* object = find<QComboBox>("cutObject");
    object->setCurrentIndex(2);
    EXPECT_EQ(find<QComboBox>("cutAxis")->currentText(), QStringLiteral("\u03b8y"));
    EXPECT_EQ(find<QSlider>("cutPlace")->maximum(), 180) << "half degrees";
    keep("surfaces_angles_cut.png");
    object->setCurrentIndex(0);
    QTest::mouseClick(back, Qt::LeftButton);
    EXPECT_TRUE(becomes(angles, 0.05));
}

// Catches a pick that the page does not tell of, or whose words lack a figure, and one that stays when what
// it tells of has gone.
TEST_F(SurfacesViewTest, APickIsSeenAndTold) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage before = withSurfaces();
    auto* words = find<QLabel>("picked");
    auto* start = find<QPushButton>("startHere");
    EXPECT_FALSE(start->isVisible());
    auto* vtk = view.findChild<VtkView*>();
    QTest::mouseClick(vtk, Qt::LeftButton, {}, vtk->rect().center());
    ASSERT_TRUE(start->isVisible()) << "there is no surface in the middle";
    keep("surfaces_picked.png");
    EXPECT_EQ(words->text().count(u'\n'), 3);
    EXPECT_EQ(words->text().count(QStringLiteral("K/cm")), 3);
    changed(before, 0.001);
    QSignalSpy wanted(&view, &SurfacesView::startWanted);
    QTest::mouseClick(start, Qt::LeftButton);
    EXPECT_EQ(wanted.count(), 1);
    find<QSlider>("heldThetaX")->setValue(20);
    EXPECT_FALSE(words->isVisible()) << "it was of another angle";
}

// Catches words of a picked point, and a button that starts there, that stay when its mark has gone.
TEST_F(SurfacesViewTest, APicksMarkAndWordsGoTogether) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage before = withSurfaces();
    auto* start = find<QPushButton>("startHere");
    auto* vtk = view.findChild<VtkView*>();
    const auto pick = [&] {
        QTest::mouseClick(vtk, Qt::LeftButton, {}, vtk->rect().center());
        ASSERT_TRUE(start->isVisible()) << "there is no surface in the middle";
        changed(before, 0.001);
    };
    pick();
    experiment.start[kZ] += 0.01; // as "Start here" does
    view.setExperiment(experiment);
    EXPECT_FALSE(start->isVisible());
    withSurfaces();
    pick();
    experiment.source.temperature_K += 1.0;
    view.setExperiment(experiment);
    EXPECT_FALSE(start->isVisible());
    withSurfaces();
    pick();
    JointVerdict turned = verdict();
    turned.pose[kThetaX] += 0.1;
    view.setVerdict(turned);
    settle();
    EXPECT_FALSE(start->isVisible()) << "it was of another angle";
}

// Catches a start offered where the robot cannot be, or while it may not be edited, or refused without a
// word; and a picked pose whose words leave out how it is turned.
TEST_F(SurfacesViewTest, StartHereSaysWhyNot) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    withSurfaces();
    auto* vtk = view.findChild<VtkView*>();
    auto* start = find<QPushButton>("startHere");
    QTest::mouseClick(vtk, Qt::LeftButton, {}, vtk->rect().center());
    ASSERT_TRUE(start->isVisible());
    EXPECT_TRUE(start->isEnabled()) << start->toolTip().toStdString();
    view.setStartable(false, QStringLiteral("A run is on."));
    EXPECT_FALSE(start->isEnabled());
    EXPECT_EQ(start->toolTip(), QStringLiteral("A run is on."));
    view.setStartable(true, {});
    EXPECT_TRUE(start->isEnabled());

    find<QComboBox>("surfaceSpace")->setCurrentIndex(2);
    settle();
    picture();
    for (int y = 20; y < 80 && !start->isVisible(); y += 5) // not near the axis that the robot turns about
        QTest::mouseClick(vtk, Qt::LeftButton, {}, {vtk->width() * 45 / 100, vtk->height() * y / 100});
    ASSERT_TRUE(start->isVisible());
    keep("surfaces_angles_picked.png");
    EXPECT_TRUE(find<QLabel>("picked")->text().contains(QStringLiteral("\u03b8z"))) << "how it is turned";
    EXPECT_FALSE(start->isEnabled());
    EXPECT_TRUE(start->toolTip().contains(QStringLiteral("outside the workspace")))
        << start->toolTip().toStdString();
}

// Catches controls that need more width than a window of 1100 has left for them, in any state.
TEST_F(SurfacesViewTest, TheControlsFitANarrowWindow) {
    constexpr int kLeft_px = 374;
    view.setVerdict(verdict());
    for (int space = 0; space < 3; ++space)
        for (const int object : {0, 1}) {
            find<QComboBox>("surfaceSpace")->setCurrentIndex(space);
            find<QComboBox>("cutObject")->setCurrentIndex(object);
            QApplication::processEvents();
            EXPECT_LE(view.minimumSizeHint().width(), kLeft_px) << space << ' ' << object;
        }
}

// Catches: a page that waits for the fine surfaces where shade makes them slow, or stays with coarse ones.
TEST_F(SurfacesViewTest, WithShadeCoarseSurfacesComeFirst) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    for (std::size_t i = 0; i < 3; ++i)
        experiment.objects[i].mounting[kZ] = 0.03 * (1.0 - static_cast<double>(i));
    view.setExperiment(experiment);
    const QImage empty = picture();
    view.setVerdict(verdict());
    ASSERT_TRUE(QThreadPool::globalInstance()->waitForDone(120000));
    QApplication::processEvents(); // the coarse ones; the fine ones have begun
    const QImage coarse = picture();
    EXPECT_GT(differentPixels(coarse, empty), 600 * 400 / 20);
    keep("surfaces_shaded_coarse.png");
    settle();
    const QImage fine = picture();
    EXPECT_GT(differentPixels(fine, coarse), 600 * 400 / 100) << "hatched no more";
    keep("surfaces_shaded.png");
    settle();
    EXPECT_LT(differentPixels(picture(), fine), 600 * 400 / 100) << "and there it ends";
}

} // namespace
} // namespace bask::test
