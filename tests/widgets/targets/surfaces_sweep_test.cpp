// The fourth variable: played in the view, and exported from it.

#include "tests/widgets/targets/surfaces_fixture.h"

#include <QAction>
#include <QDir>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include <cmath>
#include <set>

namespace bask::test {
namespace {

struct SurfacesSweepTest : SurfacesTest {
    QToolButton* playButton() { return find<QToolButton>("playSweep"); }
    /// Values that the slider of the held angle comes to, until there are so many.
    std::set<int> valuesOf(const char* slider, std::size_t count) {
        std::set<int> values;
        EXPECT_TRUE(waitFor([&] {
            values.insert(find<QSlider>(slider)->value());
            return values.size() >= count;
        }));
        return values;
    }
};

// Catches a button that plays nothing, a slider that does not follow, and slider or surfaces that do not go
// back to what they were.
TEST_F(SurfacesSweepTest, PlayingMovesSliderAndSurfaces) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage still = withSurfaces();
    const int before = find<QSlider>("heldThetaX")->value();
    QTest::mouseClick(playButton(), Qt::LeftButton);
    EXPECT_TRUE(playButton()->isChecked());
    auto* slider = find<QSlider>("heldThetaX");
    ASSERT_TRUE(waitFor([&] { return slider->value() == slider->minimum(); }));
    const QImage first = picture();
    const std::set<int> seen = valuesOf("heldThetaX", 4);
    changed(first);
    keep("surfaces_playing.png");
    const double step = (slider->maximum() - slider->minimum()) / 8.0;
    for (const int value : seen) {
        const double frames = (value - slider->minimum()) / step;
        EXPECT_NEAR(frames, std::round(frames), 0.51 / step) << value;
    }
    QTest::mouseClick(playButton(), Qt::LeftButton);
    EXPECT_FALSE(playButton()->isChecked());
    EXPECT_EQ(slider->value(), before) << "as before it was played";
    EXPECT_FALSE(find<QPushButton>("heldAtPose")->isEnabled());
    const QDeadlineTimer frames(3 * SceneSequence::kFrameTime_ms);
    waitFor([&] { return frames.hasExpired(); });
    EXPECT_EQ(slider->value(), before) << "it goes on";
    EXPECT_TRUE(becomes(still));
}

// Catches frames of the targets before that go on as if they were of the new ones, and an edit that ends it.
TEST_F(SurfacesSweepTest, ATargetEditedPlaysOnWithItsSurfaces) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    withSurfaces();
    QTest::mouseClick(playButton(), Qt::LeftButton);
    auto* slider = find<QSlider>("heldThetaX");
    const auto at = [&](int value) { return waitFor([&] { return slider->value() == value; }); };
    ASSERT_TRUE(at(slider->minimum()));
    const QImage before = picture();
    view.setStale(true);
    changed(before); // hatched
    for (ObjectSpec& object : experiment.objects)
        object.target_K += 8.0;
    view.setExperiment(experiment);
    view.setVerdict(verdict());
    EXPECT_TRUE(playButton()->isChecked());
    ASSERT_TRUE(at(slider->maximum()));
    ASSERT_TRUE(at(slider->minimum()));
    const QImage hotter = picture();
    keep("surfaces_playing_hotter.png");
    EXPECT_GT(differentPixels(hotter, before), 600 * 400 / 50);
    slider->setValue(slider->maximum()); // which ends it
    slider->setValue(slider->minimum());
    settle();
    EXPECT_TRUE(becomes(hotter)) << "the surfaces before were played";
}

// Catches an animation that nobody sees and goes on, and one that starts by itself.
TEST_F(SurfacesSweepTest, PlayingEndsWhenHidden) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    withSurfaces();
    QTest::mouseClick(playButton(), Qt::LeftButton);
    valuesOf("heldThetaX", 3);
    view.hide();
    EXPECT_FALSE(playButton()->isChecked());
    view.show();
    const int value = find<QSlider>("heldThetaX")->value();
    const QDeadlineTimer frames(3 * SceneSequence::kFrameTime_ms);
    waitFor([&] { return frames.hasExpired(); });
    EXPECT_EQ(find<QSlider>("heldThetaX")->value(), value);
}

// Catches a slider that fights with the animation, and angles that are played over an angle.
TEST_F(SurfacesSweepTest, OverAnglesTheHeightIsPlayedAndASliderEndsIt) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage positions = withSurfaces();
    find<QComboBox>("surfaceSpace")->setCurrentIndex(2);
    settle();
    changed(positions, 0.1);
    auto* x = find<QSlider>("heldX");
    const int before = x->value();
    QTest::mouseClick(playButton(), Qt::LeftButton);
    valuesOf("heldZ", 4);
    EXPECT_EQ(x->value(), before);
    x->setValue(50);
    EXPECT_FALSE(playButton()->isChecked());
    EXPECT_EQ(x->value(), 50);
}

// Catches an export that writes nothing, shows no progress, tells no end or leaves the controls away.
TEST_F(SurfacesSweepTest, AnAnimationIsExported) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage before = withSurfaces();
    QTemporaryDir folder;
    QSignalSpy told(&view, &SurfacesView::exported), problem(&view, &SurfacesView::problem);
    auto* progress = find<QProgressBar>("exportProgress");
    view.saveAnimation(folder.path(), {400, 300});
    EXPECT_TRUE(progress->isVisible());
    EXPECT_FALSE(find<QSlider>("heldThetaX")->isVisible()) << "it would change what is written";
    EXPECT_FALSE(find<QPushButton>("exportMenu")->isEnabled());
    ASSERT_TRUE(waitFor([&] { return progress->value() >= 3; }));
    keep("surfaces_exporting.png");
    ASSERT_TRUE(waitFor([&] { return told.count() == 1; }));
    EXPECT_EQ(problem.count(), 0);
    EXPECT_TRUE(told[0][0].toString().contains(QDir::toNativeSeparators(folder.path())));
    EXPECT_EQ(told[0][1].toStringList(), QStringList{folder.filePath("panels.png")});
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 10);
    const QImage first(folder.filePath(QStringLiteral("frame-1.png")));
    EXPECT_EQ(first.size(), QSize(400, 300));
    EXPECT_GT(differentPixels(first, QImage(folder.filePath(QStringLiteral("frame-9.png")))), 400 * 300 / 20);
    EXPECT_FALSE(progress->isVisible());
    EXPECT_TRUE(find<QSlider>("heldThetaX")->isVisible());
    EXPECT_TRUE(becomes(before));
}

// Catches an export that cannot be ended, that is told as done, or whose end takes the surfaces away; and
// one into a folder that is not there that is not told of.
TEST_F(SurfacesSweepTest, AnExportIsCancelledOrFails) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage before = withSurfaces();
    QTemporaryDir folder;
    QSignalSpy told(&view, &SurfacesView::exported), problem(&view, &SurfacesView::problem);
    view.saveAnimation(folder.path(), {400, 300});
    ASSERT_TRUE(waitFor([&] { return find<QProgressBar>("exportProgress")->value() >= 2; }));
    QTest::mouseClick(find<QPushButton>("exportCancel"), Qt::LeftButton);
    EXPECT_FALSE(find<QProgressBar>("exportProgress")->isVisible());
    EXPECT_TRUE(becomes(before));
    EXPECT_EQ(told.count(), 0);
    view.saveAnimation(QStringLiteral("/no/such/folder"), {400, 300});
    ASSERT_TRUE(waitFor([&] { return problem.count() == 1; }));
    EXPECT_TRUE(becomes(before));
    EXPECT_EQ(told.count(), 0);
    view.saveAnimation(folder.path(), {400, 300});
    experiment.robot.clearance_m += 0.01;
    view.setExperiment(experiment); // which ends it
    EXPECT_EQ(problem.count(), 2);
    view.setExperiment(experiment);
    EXPECT_EQ(problem.count(), 2);
    EXPECT_FALSE(find<QProgressBar>("exportProgress")->isVisible());
}

// Catches a verdict that comes during an export and is forgotten, or gets into half of the pictures, as does
// another direction.
TEST_F(SurfacesSweepTest, AVerdictDuringAnExportComesAfterIt) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage before = withSurfaces();
    QTemporaryDir folder, again;
    QSignalSpy told(&view, &SurfacesView::exported);
    view.saveAnimation(folder.path(), {200, 150});
    ASSERT_TRUE(waitFor([&] { return told.count() == 1; }));
    view.saveAnimation(again.path(), {200, 150});
    ASSERT_TRUE(waitFor([&] { return find<QProgressBar>("exportProgress")->value() >= 2; }));
    for (const char* turn : {"viewTop", "viewSide"})
        QTest::mouseClick(find<QWidget>(turn), Qt::LeftButton);
    const QPoint middle = scene()->mapTo(&view, scene()->rect().center());
    EXPECT_FALSE(scene()->isAncestorOf(view.childAt(middle)))
        << "a drag there turns the rest of the pictures";
    for (ObjectSpec& object : experiment.objects)
        object.target_K += 8.0;
    view.setStale(true);
    view.setExperiment(experiment);
    view.setVerdict(verdict());
    ASSERT_TRUE(waitFor([&] { return told.count() == 2; }));
    const auto last = QStringLiteral("frame-9.png");
    EXPECT_LT(differentPixels(QImage(folder.filePath(last)), QImage(again.filePath(last))), 50);
    changed(before);
}

// Catches a workspace too large to be sampled that is not told of, leaves the surfaces before, or a button
// that goes on waiting for it.
TEST_F(SurfacesSweepTest, WhatCannotBeSampledIsTold) {
    const JointVerdict before = verdict();
    experiment.robot.lower.head<3>().setConstant(-50.0);
    experiment.robot.upper.head<3>().setConstant(50.0);
    QSignalSpy problem(&view, &SurfacesView::problem);
    view.setExperiment(experiment);
    view.setVerdict(before);
    ASSERT_TRUE(waitFor([&] { return problem.count() == 1; }));
    EXPECT_FALSE(problem[0][0].toString().isEmpty());
    QTest::mouseClick(playButton(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return problem.count() >= 2; }));
    EXPECT_FALSE(playButton()->isChecked());
}

// Catches a picture that is not told of, of another size, or a folder that is not there taken for a success.
TEST_F(SurfacesSweepTest, APictureIsSavedInItsSize) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    withSurfaces();
    QTemporaryDir folder;
    QSignalSpy told(&view, &SurfacesView::exported), problem(&view, &SurfacesView::problem);
    const QString path = folder.filePath(QStringLiteral("targets.png"));
    view.savePicture(path, {1700, 1200});
    EXPECT_EQ(QImage(path).size(), QSize(1700, 1200));
    EXPECT_EQ(told.count(), 1);
    view.savePicture(QStringLiteral("/no/such/folder/targets.png"), {400, 300});
    EXPECT_EQ(problem.count(), 1);
    EXPECT_EQ(told.count(), 1);
}

} // namespace
} // namespace bask::test
