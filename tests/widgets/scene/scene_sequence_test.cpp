#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/scene/scene_sequence.h"
#include "widgets/scene/vtk_view.h"

#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

/// The paper's: the translation subset of its disks for theta_x from 0 to 90 degrees.
std::vector<SurfaceFrame> nineTilts() {
    TargetGeometry geometry{RadiatingContour(Disk{0.10}),
                            {},
                            {{RadiatingContour(Disk{0.015})}},
                            {},
                            surfaceAxes(PoseSubset::Translation, {}, 2.0 * kSurfaceStep_m)};
    geometry.X_RS = Pose::Identity();
    std::vector<double> tilts;
    for (int i = 0; i < 9; ++i)
        tilts.push_back(radFromDeg(11.25 * i));
    const auto frames = targetSweep(geometry, kThetaX, tilts, std::array{0.2});
    EXPECT_TRUE(frames);
    return *frames;
}

Experiment oneDisk() {
    Experiment experiment = test::threeObjects();
    experiment.objects.resize(1);
    experiment.objects[0].mounting.setZero();
    return experiment;
}

class SceneSequenceTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!VtkView::available())
            GTEST_SKIP() << "no OpenGL here";
        QApplication::setPalette(themePalette(false));
    }
};

// Catches: a sequence that writes one frame over and over, loses one, or leaves the scene at its last frame.
TEST_F(SceneSequenceTest, WritesEveryFrameAndTheSheet) {
    TargetScene scene;
    scene.setExperiment(oneDisk());
    scene.resize(600, 420);
    scene.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&scene));
    SceneSequence sequence(scene);
    sequence.setFrames(nineTilts(), PoseSubset::Translation, kThetaX);
    EXPECT_EQ(sequence.caption(1), QStringLiteral("θx = 11.3°"));
    sequence.show(2);
    const auto* picture = scene.findChild<VtkView*>();
    const QImage before = const_cast<VtkView*>(picture)->grabFramebuffer();
    QTemporaryDir folder;
    QSignalSpy saved(&sequence, &SceneSequence::saved), progressed(&sequence, &SceneSequence::progressed);
    sequence.save(folder.path(), {400, 300});
    EXPECT_EQ(progressed.count(), 0) << "the window waits";
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() == 1; }, 120000));
    EXPECT_EQ(saved[0][0].value<Error>().code(), MessageCode::None);
    EXPECT_EQ(progressed.count(), 9);
    QImage last;
    for (int i = 1; i <= 9; ++i) {
        const QImage frame(folder.filePath(QStringLiteral("frame-%1.png").arg(i)));
        ASSERT_EQ(frame.size(), QSize(400, 300)) << i;
        EXPECT_GT(test::differentPixels(frame, last), 200) << i;
        last = frame;
    }
    // Catches a frame that does not say which it is: the caption is at its upper edge, the rest as drawn.
    sequence.show(0);
    const QImage bare = scene.image({400, 300});
    const QImage first(folder.filePath(QStringLiteral("frame-1.png")));
    const QRect upper(100, 0, 200, 25), lower(0, 25, 400, 275);
    EXPECT_GT(test::differentPixels(bare.copy(upper), first.copy(upper)), 50);
    EXPECT_LT(test::differentPixels(bare.copy(lower), first.copy(lower)), 20);
    test::keepScreenshot(first, QStringLiteral("targets-frame-1"));
    sequence.show(2);
    const QImage sheet(folder.filePath(QStringLiteral("panels.png")));
    test::keepScreenshot(sheet, QStringLiteral("targets-nine-panels"));
    EXPECT_EQ(sheet.width(), 1200);
    EXPECT_GT(sheet.height(), 900);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 10);
    EXPECT_LT(test::differentPixels(before, const_cast<VtkView*>(picture)->grabFramebuffer()), 20);
}

// Catches: an export that cannot be ended, tells of an end that it had not, or leaves the scene half-way.
TEST_F(SceneSequenceTest, SavingIsCancelled) {
    TargetScene scene;
    scene.setExperiment(oneDisk());
    scene.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&scene));
    SceneSequence sequence(scene);
    sequence.setFrames(std::vector<SurfaceFrame>(5), PoseSubset::Translation, kThetaX);
    QTemporaryDir folder;
    QSignalSpy saved(&sequence, &SceneSequence::saved), shown(&sequence, &SceneSequence::shown);
    QObject::connect(&sequence, &SceneSequence::progressed, &sequence, [&](int done) {
        if (done == 2)
            sequence.cancel();
    });
    sequence.save(folder.path(), {200, 150});
    EXPECT_TRUE(sequence.isSaving());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !sequence.isSaving(); }, 120000));
    EXPECT_EQ(shown.count(), 1);
    QCoreApplication::processEvents();
    EXPECT_EQ(saved.count(), 0);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2);
}

// Catches: a folder that is not there taken for a success.
TEST_F(SceneSequenceTest, AFolderThatIsNotThereIsSaid) {
    TargetScene scene;
    scene.setExperiment(oneDisk());
    scene.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&scene));
    SceneSequence sequence(scene);
    SurfaceFrame empty;
    empty.surfaces.resize(1);
    sequence.setFrames({empty, empty}, PoseSubset::Translation, kThetaX);
    QSignalSpy saved(&sequence, &SceneSequence::saved);
    sequence.save(QStringLiteral("/no/such/folder"), {400, 300});
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() == 1; }, 120000));
    EXPECT_EQ(saved[0][0].value<Error>().code(), MessageCode::FileUnwritable);
}

// Catches: pictures of the user's that an export replaces, and an export that does not replace itself.
TEST_F(SceneSequenceTest, OtherPicturesOfTheNameAreKept) {
    TargetScene scene;
    if (!scene.hasPicture())
        GTEST_SKIP() << "no OpenGL";
    scene.setExperiment(oneDisk());
    scene.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&scene));
    SceneSequence sequence(scene);
    SurfaceFrame empty;
    empty.surfaces.resize(1);
    sequence.setFrames({empty, empty}, PoseSubset::Translation, kThetaX);
    QSignalSpy saved(&sequence, &SceneSequence::saved);
    QTemporaryDir folder;
    for (const int done : {1, 2}) { // the second over the first
        sequence.save(folder.path(), {200, 150});
        ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() == done; }, 120000));
        EXPECT_EQ(saved.last()[0].value<Error>().code(), MessageCode::None);
    }
    for (const char* name : {"frame-2.png", "panels.png"}) {
        const QString path = folder.filePath(QLatin1String(name));
        const QImage exported(path);
        QImage mine(20, 10, QImage::Format_RGB32);
        mine.fill(Qt::red);
        ASSERT_TRUE(mine.save(path));
        saved.clear();
        sequence.save(folder.path(), {200, 150});
        ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() == 1; }, 120000));
        EXPECT_EQ(saved[0][0].value<Error>().code(), MessageCode::ExportForeign);
        EXPECT_EQ(QString::fromStdString(saved[0][0].value<Error>().where), path);
        EXPECT_EQ(QImage(path).size(), QSize(20, 10));
        ASSERT_TRUE(exported.save(path));
    }
}

// Catches: an animation that stands still, runs past its end, or goes on when it is told to stop.
TEST_F(SceneSequenceTest, PlaysRoundAndRound) {
    TargetScene scene;
    scene.setExperiment(oneDisk());
    SceneSequence sequence(scene);
    SurfaceFrame low, high;
    high.fixed[kZ] = 0.05;
    sequence.setFrames({low, high}, PoseSubset::Rotation, kZ);
    EXPECT_EQ(sequence.caption(1), QStringLiteral("z = 5.0 cm"));
    QSignalSpy shown(&sequence, &SceneSequence::shown);
    sequence.play(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return shown.count() >= 3; }, 120000));
    EXPECT_EQ(shown[0][0].toInt(), 1);
    EXPECT_EQ(shown[1][0].toInt(), 0);
    EXPECT_EQ(shown[2][0].toInt(), 1);
    sequence.play(false);
    EXPECT_FALSE(sequence.isPlaying());
    sequence.setFrames({low}, PoseSubset::Rotation, kZ);
    sequence.play(true);
    EXPECT_FALSE(sequence.isPlaying()) << "there is nothing to play";
}

} // namespace
} // namespace bask
