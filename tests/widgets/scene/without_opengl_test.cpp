#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/scene_view.h"
#include "widgets/scene/target_scene.h"

#include <QApplication>
#include <QLabel>
#include <QOpenGLWidget>
#include <QtTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches a crash, or an empty rectangle without a word, where there is no OpenGL (the offscreen platform has
// none).
TEST(SceneWithoutOpenGL, SaysSoAndTakesEverySetter) {
    SceneView view;
    view.resize(640, 480);
    view.setExperiment(test::threeObjects());
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    if (view.hasPicture())
        GTEST_SKIP() << "this platform has OpenGL";
    view.setSamples(test::spiral(50));
    view.setPose(Vector6d::Zero());
    view.setTemperatures({300.0});
    view.setTemperatureUnit(TemperatureUnit::Kelvin);
    view.viewAlongMinusZ();
    view.viewAlongX();
    view.viewIsometric();
    view.clearTrace();
    EXPECT_EQ(view.findChild<QOpenGLWidget*>(), nullptr);
    const auto* notice = view.findChild<QLabel*>();
    ASSERT_NE(notice, nullptr);
    EXPECT_TRUE(notice->isVisible());
    EXPECT_TRUE(notice->text().contains(QStringLiteral("OpenGL")));
    test::keepScreenshot(view.grab().toImage(), QStringLiteral("scene-without-opengl"));
}

TEST(SceneWithoutOpenGL, TheTargetsSceneDoesSoToo) {
    TargetScene scene;
    scene.resize(640, 480);
    scene.setExperiment(test::threeObjects());
    scene.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&scene));
    if (scene.hasPicture())
        GTEST_SKIP() << "this platform has OpenGL";
    scene.setSurfaces({Isosurface{}}, Vector6d::Zero());
    scene.setVerdictPoint(SceneVerdict{});
    scene.setCut(std::nullopt);
    scene.setStale(true);
    scene.setTemperatureUnit(TemperatureUnit::Kelvin);
    scene.clearPick();
    scene.viewAlongMinusZ();
    EXPECT_FALSE(scene.saveImage(QStringLiteral("/nowhere/scene.png"), {640, 480}));
    EXPECT_EQ(scene.findChild<QOpenGLWidget*>(), nullptr);
    const auto* notice = scene.findChild<QLabel*>();
    ASSERT_NE(notice, nullptr);
    EXPECT_TRUE(notice->isVisible());
    EXPECT_TRUE(notice->text().contains(QStringLiteral("OpenGL")));
}

} // namespace
} // namespace bask
