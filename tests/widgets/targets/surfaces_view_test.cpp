// The targets' surfaces from a verdict to the picture, under OpenGL.

#include "engine/runtime/rig_setup.h"
#include "tests/support/wait_for.h"
#include "widgets/scene/target_scene.h"
#include "widgets/targets/surfaces_view.h"

#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QThreadPool>

#include <gtest/gtest.h>

namespace bask {
namespace {

int differentPixels(const QImage& a, const QImage& b) {
    int different = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
        for (int x = 0; x < std::min(a.width(), b.width()); ++x)
            different += a.pixel(x, y) != b.pixel(x, y);
    return different;
}

struct SurfacesViewTest : testing::Test {
    SurfacesView view;
    Experiment experiment = readExperiment(std::string(BASK_EXAMPLES) + "/three-objects.json").value();

    SurfacesViewTest() {
        view.resize(700, 560);
        view.setExperiment(experiment);
        view.show();
        QApplication::processEvents();
    }
    TargetScene* scene() { return view.findChild<TargetScene*>("targetScene"); }
    QImage picture() { return scene()->image({600, 400}); }
    /// Waits for a picture that differs from `before` in more than a share of it.
    QImage changed(const QImage& before, double share = 0.02) {
        QImage now;
        EXPECT_TRUE(test::waitFor([&] {
            now = picture();
            return differentPixels(now, before) > share * before.width() * before.height();
        }));
        return now;
    }
};

// Catches a verdict whose surfaces never come, a slider of the angle that draws nothing anew, and one that
// stays where it was put when the pose is asked for again.
TEST_F(SurfacesViewTest, SurfacesFollowVerdictAndAngle) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const auto verdict = jointFeasibility(feasibilityRequest(experiment));
    ASSERT_TRUE(verdict);
    ASSERT_TRUE(verdict->feasible);
    const QImage empty = picture();
    view.setVerdict(*verdict);
    const QImage atPose = changed(empty, 0.1); // more than objects that move
    EXPECT_TRUE(atPose.save("surfaces_at_pose.png"));
    auto* slider = view.findChild<QSlider*>("heldAngle");
    auto* back = view.findChild<QPushButton*>("heldAtPose");
    EXPECT_FALSE(back->isEnabled());
    const int before = slider->value();
    slider->setValue(before > 0 ? slider->minimum() : slider->maximum());
    EXPECT_TRUE(changed(atPose).save("surfaces_at_limit.png"));
    EXPECT_TRUE(back->isEnabled());
    QTest::mouseClick(back, Qt::LeftButton);
    EXPECT_EQ(slider->value(), before);
    EXPECT_TRUE(test::waitFor([&] { return differentPixels(picture(), atPose) < 600 * 400 / 100; }));
}

// Catches surfaces of the objects before that arrive after others were set, and are taken for theirs.
TEST_F(SurfacesViewTest, SurfacesOfAnOlderGeometryAreNotHeard) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    view.setVerdict(*jointFeasibility(feasibilityRequest(experiment)));
    view.findChild<QComboBox*>("cutObject")->setCurrentIndex(3);
    Experiment fewer = experiment;
    fewer.objects.pop_back();
    view.setExperiment(fewer);
    const QImage alone = picture();
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QApplication::processEvents();
    EXPECT_LT(differentPixels(picture(), alone), 600 * 400 / 100);
}

// Catches a cut that is not drawn, does not move, or stays.
TEST_F(SurfacesViewTest, ACutIsDrawnAndMoved) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    const QImage empty = picture();
    view.setVerdict(*jointFeasibility(feasibilityRequest(experiment)));
    const QImage without = changed(empty, 0.1);
    auto* object = view.findChild<QComboBox*>("cutObject");
    ASSERT_EQ(object->count(), 4);
    object->setCurrentIndex(2);
    const QImage cut = changed(without, 0.05);
    EXPECT_TRUE(cut.save("surfaces_cut.png"));
    auto* place = view.findChild<QSlider*>("cutPlace");
    EXPECT_EQ(place->value(), 0) << "the middle of the workspace";
    place->setValue(place->maximum() / 2);
    changed(cut);
    object->setCurrentIndex(0);
    EXPECT_TRUE(test::waitFor([&] { return differentPixels(picture(), without) < 600 * 400 / 100; }));
}

// Catches a picture of an older question that looks like the present answer.
TEST_F(SurfacesViewTest, StaleIsVisible) {
    if (!scene()->hasPicture())
        GTEST_SKIP() << "no OpenGL";
    view.setVerdict(*jointFeasibility(feasibilityRequest(experiment)));
    const QImage fresh = changed(QImage(600, 400, QImage::Format_RGB32));
    QTest::qWait(0);
    view.setStale(true);
    EXPECT_TRUE(changed(fresh).save("surfaces_stale.png"));
}

} // namespace
} // namespace bask
