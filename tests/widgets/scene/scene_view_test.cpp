#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"
#include "widgets/scene/scene_view.h"
#include "widgets/scene/vtk_view.h"

#include <QApplication>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QtTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace bask {
namespace {

using test::keepScreenshot;

const QColor kSource(0xff, 0xb4, 0x5c); // the glow in the middle of the source

class SceneViewTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!VtkView::available())
            GTEST_SKIP() << "no OpenGL here";
        QApplication::setPalette(themePalette(false));
    }
    void TearDown() override { QApplication::setPalette(themePalette(false)); }

    static void show(QWidget& widget) {
        widget.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
    }
    static VtkView* pictureOf(const SceneView& view) { return view.findChild<VtkView*>(); }
    static QImage grab(const SceneView& view) { return pictureOf(view)->grabFramebuffer(); }
    /// Lets frames that were asked for be drawn, until none is asked for any more.
    static void drawPending(const SceneView& view) {
        int before = pictureOf(view)->frames();
        while (QTest::qWaitFor([&] { return pictureOf(view)->frames() > before; },
                               3 * VtkView::kFrameInterval_ms))
            before = pictureOf(view)->frames();
    }
    static TraceSample sampleAt(double x_m, double z_m) {
        TraceSample sample = test::spiral(1).front();
        sample.coordinates << x_m, 0.0, z_m, 0.0, 0.0, 0.0;
        return sample;
    }
};

// Catches an empty picture, the usual result of any slip between Qt's and VTK's framebuffers.
TEST_F(SceneViewTest, DrawsSourceAndObjectsInTheirColours) {
    SceneView view;
    view.resize(1000, 700);
    view.setExperiment(test::threeObjects());
    show(view);
    const QImage image = grab(view);
    EXPECT_EQ(image.size(), QSize(1000, 700) * view.devicePixelRatioF());
    EXPECT_GT(test::pixelsOf(image, kSource), 200);
    for (int i = 0; i < 3; ++i)
        EXPECT_GT(test::pixelsOf(image, seriesColor(i, false)), 60) << "outline of object " << i;
    EXPECT_GT(test::pixelsOf(image, unknownColour(false), 4), 500) << "objects with no temperature yet";
    EXPECT_GT(test::pixelsOf(image, QApplication::palette().color(QPalette::Base), 2), 200000);
}

// Catches a trail that is not drawn, and temperatures that do not reach the colours.
TEST_F(SceneViewTest, ATraceColoursObjectsAndTrail) {
    SceneView view;
    view.resize(1000, 700);
    view.setExperiment(test::threeObjects());
    show(view);
    const QImage before = grab(view);
    view.setSamples(test::spiral(600));
    const QImage after = grab(view);
    EXPECT_GT(test::differentPixels(before, after), 5000);
    EXPECT_LT(test::pixelsOf(after, unknownColour(false), 2),
              test::pixelsOf(before, unknownColour(false), 2) / 4);
    view.clearTrace();
    EXPECT_LT(test::pixelsOf(grab(view), mapColour(0.3, false), 6),
              test::pixelsOf(after, mapColour(0.3, false), 6));
}

// Catches a planned path that is not drawn before Start, covers the trail, stays when there is no prediction
// any more, or keeps the colours of the other theme.
TEST_F(SceneViewTest, ThePlannedPathIsDrawnAndRemoved) {
    SceneView view;
    view.resize(1000, 700);
    view.setExperiment(test::threeObjects());
    show(view);
    const QImage before = grab(view);
    PredictedRun plan;
    for (const TraceSample& sample : test::spiral(300))
        plan.samples.push_back({sample.time_s, sample.coordinates, {}});
    view.setPlan(plan);
    const QImage planned = grab(view);
    keepScreenshot(planned, QStringLiteral("scene-planned"));
    const int drawn = test::differentPixels(before, planned);
    EXPECT_GT(drawn, 300);
    EXPECT_LT(drawn, 20000) << "a thin line";
    plan.end = PredictedEnd::Cut;
    view.setPlan(plan);
    EXPECT_GT(test::differentPixels(planned, grab(view)), 10) << "a cross where nothing settles";
    plan.end = PredictedEnd::Settled;
    view.setPlan(plan);
    view.clearTrace();
    EXPECT_LT(test::differentPixels(planned, grab(view)), 100) << "Arm leaves it";

    view.setSamples(test::spiral(300));
    const QImage withPlan = grab(view);
    keepScreenshot(withPlan, QStringLiteral("scene-planned-run"));
    QApplication::setPalette(themePalette(true));
    QCoreApplication::processEvents();
    keepScreenshot(grab(view), QStringLiteral("scene-planned-run-dark"));
    QApplication::setPalette(themePalette(false));
    QCoreApplication::processEvents();
    view.setPlan({});
    const QImage trailOnly = grab(view);
    EXPECT_LT(test::differentPixels(withPlan, trailOnly), drawn) << "dimmer, and under the trail";
    view.clearTrace();
    view.setPose(test::threeObjects().start);
    view.setPlan(plan);
    (void)grab(view);
    view.setPlan({});
    const QImage without = grab(view); // where labels are now, which keep off the path and then their place
    view.setPlan(plan);
    EXPECT_GT(test::differentPixels(without, grab(view)), 300);
    view.setPlan({});
    EXPECT_LT(test::differentPixels(without, grab(view)), 100);

    view.setPlan(plan);
    view.setExperiment(test::threeObjects());
    EXPECT_LT(test::differentPixels(without, grab(view)), 100) << "it was of another experiment";
}

// Catches a pose that moves numbers but not the picture, or moves it the wrong way.
TEST_F(SceneViewTest, PoseMovesTheObjectsOnScreen) {
    SceneView view;
    view.resize(1000, 700);
    Experiment experiment = test::threeObjects();
    experiment.objects.resize(1);
    view.setExperiment(experiment);
    view.viewAlongMinusZ();
    show(view);
    const QColor outline = seriesColor(0, false);
    Vector6d left = Vector6d::Zero();
    left << -0.1, 0.0, 0.1, 0.0, 0.0, 0.0;
    view.setPose(left);
    const QPointF first = test::middleOf(grab(view), outline);
    Vector6d right = left;
    right[kX] = 0.1;
    view.setPose(right);
    const QPointF second = test::middleOf(grab(view), outline);
    EXPECT_GT(second.x(), first.x() + 150.0);
    EXPECT_NEAR(second.y(), first.y(), 25.0);
}

// Catches a source that is drawn at the robot's base wherever it is: by the experiment, by a live pose, by a
// trace.
TEST_F(SceneViewTest, TheSourceIsDrawnWhereItLies) {
    SceneView view;
    view.resize(1000, 700);
    Experiment experiment = test::threeObjects();
    experiment.objects.clear(); // nothing in the way
    experiment.source.pose[kX] = -0.1;
    view.setExperiment(experiment);
    view.viewAlongMinusZ();
    show(view);
    const QPointF first = test::middleOf(grab(view), kSource);
    Vector6d place = Vector6d::Zero();
    place[kY] = 0.1;
    view.setSourcePose(place);
    const QPointF second = test::middleOf(grab(view), kSource);
    TraceSample sample;
    sample.source[kX] = 0.1;
    view.appendSamples({sample});
    const QPointF third = test::middleOf(grab(view), kSource);
    EXPECT_GT(second.x(), first.x() + 80.0);
    EXPECT_LT(second.y(), first.y() - 80.0);
    EXPECT_NEAR(third.x() - second.x(), second.x() - first.x(), 3.0);
    EXPECT_NEAR(third.y(), first.y(), 3.0);
}

// Catches floor lines that shine through a source that has been moved, and a tilted one that lies flat.
TEST_F(SceneViewTest, AMovedAndTiltedSourceLooksSo) {
    SceneView view;
    view.resize(1000, 700);
    view.setExperiment(test::threeObjects());
    show(view);
    const int flat = test::pixelsOf(grab(view), kSource, 60);
    std::vector<TraceSample> samples = test::spiral(300);
    for (TraceSample& sample : samples) {
        sample.source[kX] = 0.08;
        sample.source[kY] = -0.05;
        sample.source[kZ] = 0.04;
        sample.source[kThetaX] = 0.7; // towards the viewer of the isometric preset: more of it is seen
    }
    view.setSamples(samples);
    const QImage image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-moved-source"));
    EXPECT_GT(test::pixelsOf(image, kSource, 60), 1.2 * flat);
}

// Catches a fill that spills over between the fingers of a non-convex outline.
TEST_F(SceneViewTest, NonConvexShapesAreFilledTruly) {
    SceneView view;
    view.resize(1000, 1000);
    Experiment experiment = test::threeObjects();
    experiment.objects = {experiment.objects[2]};
    experiment.objects[0].mounting.setZero();
    experiment.source.shape = Disk{0.01}; // out of the way, under the palm
    experiment.robot.lower << -0.05, -0.05, 0.01, 0.0, 0.0, 0.0;
    experiment.robot.upper << 0.05, 0.05, 0.06, 0.0, 0.0, 0.0;
    experiment.start << 0.0, 0.0, 0.05, 0.0, 0.0, 0.0;
    view.setExperiment(experiment);
    view.viewAlongMinusZ();
    show(view);
    const QImage image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-non-convex"));
    // The area of the polygon against the fill's pixels, at the scale of the wrist: the lowest edge, 28 mm
    // long.
    const auto& points = std::get<Contour>(experiment.objects[0].shape).points_m;
    double area_m2 = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d& a = points[i];
        const Eigen::Vector2d& b = points[(i + 1) % points.size()];
        area_m2 += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    const QColor outline = seriesColor(0, false);
    int wrist = 0;
    for (int y = image.height() - 1; y >= 0 && wrist < 20; --y) {
        wrist = 0;
        for (int x = 0; x < image.width(); ++x)
            wrist += QColor(image.pixel(x, y)) == outline ? 1 : 0;
    }
    const double pixelsPerMetre = (wrist + 1) / 0.028;
    const double expected = area_m2 * pixelsPerMetre * pixelsPerMetre;
    const int filled = test::pixelsOf(image, unknownColour(false), 3) + test::pixelsOf(image, outline, 3) / 2;
    EXPECT_NEAR(filled, expected, 0.06 * expected);
}

/// Plates of about the size of the example's source: a rectangle, a lobed and an L-shaped one.
std::vector<std::pair<QString, Shape>> plates() {
    const Contour rectangle{{{-0.12, -0.08}, {0.12, -0.08}, {0.12, 0.08}, {-0.12, 0.08}}};
    std::vector<std::complex<double>> lobes(9);
    lobes[1] = {0.018, 0.0};
    lobes[5] = {0.1, 0.0};
    const Contour corner = *makeContour(
        {{-0.12, -0.12}, {0.12, -0.12}, {0.12, -0.05}, {-0.05, -0.05}, {-0.05, 0.12}, {-0.12, 0.12}});
    return {{QStringLiteral("disk"), Disk{0.1}},
            {QStringLiteral("rectangle"), rectangle},
            {QStringLiteral("lobes"), FourierContour(lobes)},
            {QStringLiteral("washer"), withHoles(Disk{0.1}, {Contour{shapeOutline(Disk{0.04}, 60)}})},
            {QStringLiteral("corner"), centred(corner)}};
}

/// Pixels of the source's colours, from the middle's orange to the rim's red.
int glowingPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c(image.pixel(x, y));
            count += c.red() > 190 && c.blue() < 110 && c.red() - c.blue() > 130 ? 1 : 0;
        }
    return count;
}

// Catches a source drawn as another shape than it has: as a disk, spilled into a notch, or empty.
TEST_F(SceneViewTest, SourcesOfEveryShapeGlowOverTheirWholeArea) {
    SceneView view;
    view.resize(900, 900);
    Experiment experiment = test::threeObjects();
    experiment.objects.clear();
    view.viewAlongMinusZ();
    show(view);
    double pixelsPerArea = 0.0;
    for (const auto& [name, shape] : plates()) {
        experiment.source.shape = shape; // within the workspace, so that the scale stays
        view.setExperiment(experiment);
        const QImage image = grab(view);
        const double ratio = glowingPixels(image) / shapeArea(shape);
        if (pixelsPerArea == 0.0)
            pixelsPerArea = ratio;
        EXPECT_NEAR(ratio, pixelsPerArea, 0.04 * pixelsPerArea) << name.toStdString();
        EXPECT_GT(test::pixelsOf(image, kSource), 500) << name.toStdString();
    }
    EXPECT_GT(pixelsPerArea, 1e6);
}

// Catches an outline that crosses itself a little, as fits of few harmonics do, left without its glow.
TEST_F(SceneViewTest, ASourceThatCrossesItselfStillGlows) {
    SceneView view;
    view.resize(900, 900);
    Experiment experiment = test::threeObjects();
    experiment.objects.clear();
    std::vector<std::complex<double>> cusps(9);
    cusps[1] = {0.035, 0.0}; // loops from 0.1 / 3 on
    cusps[5] = {0.1, 0.0};
    experiment.source.shape = FourierContour(cusps);
    view.setExperiment(experiment);
    view.viewAlongMinusZ();
    show(view);
    const QImage image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-source-crossing"));
    EXPECT_GT(test::pixelsOf(image, kSource), 500);
}

// Catches parts and rings that the picture does not show, or shows elsewhere.
TEST_F(SceneViewTest, AnUnevenSourceShowsWhereItRadiates) {
    SceneView view;
    view.resize(900, 900);
    Experiment experiment = test::threeObjects();
    experiment.objects.clear();
    experiment.source.shape = Disk{0.1};
    experiment.source.uneven.profile = {{0.0, 1.05}, {0.06, 1.0}, {0.1, 0.7}};
    view.viewAlongMinusZ();
    show(view);
    view.setExperiment(experiment);
    QImage image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-source-profile"));
    EXPECT_GT(test::pixelsOf(image, kSource), 500);
    SourcePartSpec left, right;
    left.shape = right.shape = Disk{0.04};
    left.pose[kX] = -0.05;
    right.pose[kX] = 0.05;
    right.temperatureRatio = 0.8;
    experiment.source.uneven = {{left, right}, {}};
    view.setExperiment(experiment);
    image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-source-parts"));
    const QPointF hot = test::middleOf(image, kSource, 4);
    const QPointF cold = test::middleOf(image, QColor(0xd9, 0x48, 0x1c), 4);
    EXPECT_LT(hot.x(), 0.5 * image.width() - 50.0);
    EXPECT_GT(cold.x(), 0.5 * image.width() + 50.0);
    EXPECT_GT(test::pixelsOf(image, QColor(0x6b, 0x64, 0x60)), 500);
}

// The pictures of other sources that a designer looks at; fails when two of them are the same.
TEST_F(SceneViewTest, SourcesLightAndDark) {
    SceneView view;
    view.resize(1000, 700);
    show(view);
    Experiment experiment = test::threeObjects();
    QImage last;
    for (const auto& [name, shape] : plates())
        for (const bool dark : {false, true}) {
            QApplication::setPalette(themePalette(dark));
            QCoreApplication::processEvents();
            experiment.source.shape = shape;
            view.setExperiment(experiment);
            view.setSamples(test::spiral(600));
            const QImage image = grab(view);
            keepScreenshot(image, QStringLiteral("scene-source-%1-%2")
                                      .arg(name, dark ? QStringLiteral("dark") : QStringLiteral("light")));
            EXPECT_GT(test::pixelsOf(image, kSource), 100);
            EXPECT_GT(test::differentPixels(image, last), 2000) << name.toStdString() << dark;
            last = image;
        }
}

// Catches one wrong reading that makes the objects alike for the rest of the run, and a target set meanwhile
// that the bar does not hold.
TEST_F(SceneViewTest, TheBarFollowsWhatIsShown) {
    SceneView view;
    view.resize(1000, 700);
    Experiment experiment = test::threeObjects();
    view.setExperiment(experiment);
    show(view);
    const double warm_K = kelvinFromCelsius(37.0);
    const auto shownIn = [&](double hottest_degC) { // the objects in the colour of that range
        const NiceRange range = niceRange(experiment.environment_K - kelvinFromCelsius(0.0), hottest_degC, 5);
        const QColor colour = mapColour((37.0 - range.min) / (range.max - range.min), false);
        return test::pixelsOf(grab(view), colour, 3);
    };
    view.setTemperatures({warm_K, warm_K, warm_K});
    const int before = shownIn(50.0);
    EXPECT_GT(before, 500);
    view.setTemperatures({kelvinFromCelsius(600.0), warm_K, warm_K});
    EXPECT_LT(shownIn(50.0), before / 4);
    view.setTemperatures({warm_K, warm_K, warm_K});
    EXPECT_GT(shownIn(50.0), before / 2);
    view.setSourceTemperature_K(kelvinFromCelsius(300.0));
    EXPECT_GT(shownIn(50.0), before / 2) << "the source has colours of its own";

    TraceSample sample = sampleAt(0.0, 0.1);
    for (ObjectSample& object : sample.objects) {
        object.estimated_K = object.measured_K = warm_K;
        object.target_K = kelvinFromCelsius(90.0);
    }
    view.appendSamples({sample});
    EXPECT_GT(shownIn(90.0), 500);
    TraceSample wrong = sampleAt(0.0, 0.1);
    for (ObjectSample& object : wrong.objects)
        object = sample.objects.front();
    wrong.objects[0].estimated_K = wrong.objects[0].measured_K = kelvinFromCelsius(600.0);
    view.appendSamples({wrong});
    EXPECT_LT(shownIn(90.0), 250);
    view.appendSamples({sample});
    EXPECT_GT(shownIn(90.0), 500) << "it is in the trail alone by now";
}

// Catches a plate that burns a hand and looks nearly as grey as a cold one, since its set point is far above.
TEST_F(SceneViewTest, ASourceTooHotForAHandLooksHot) {
    SceneView view;
    view.resize(1000, 700);
    Experiment experiment = test::threeObjects();
    experiment.objects.clear();
    for (const bool isProfile : {false, true}) {
        experiment.source.temperature_K = kelvinFromCelsius(isProfile ? 100.0 : 600.0);
        if (isProfile)
            experiment.source.temperatureProfile = {{0.0, kelvinFromCelsius(600.0)}};
        view.setExperiment(experiment);
        view.viewAlongMinusZ();
        show(view);
        const int glowing = test::pixelsOf(grab(view), kSource);
        const QColor half(181, 140, 92); // between grey and glow, in the middle of the source
        view.setSourceHeat(HeatState::Off);
        view.setSourceTemperature_K(experiment.environment_K + 35.0);
        const QImage hot = grab(view);
        keepScreenshot(hot, QStringLiteral("scene-source-hand-hot"));
        EXPECT_GT(test::pixelsOf(hot, half), glowing / 2) << isProfile;
        view.setSourceTemperature_K(experiment.environment_K + 3.0);
        EXPECT_LT(test::pixelsOf(grab(view), half), glowing / 20) << isProfile;
    }
}

// Catches a cold plate that looks as hot as a glowing one, one that nobody knows of that looks cold, and a
// heat state that is not seen.
TEST_F(SceneViewTest, TheSourceLooksAsWarmAsItIs) {
    SceneView view;
    view.resize(1000, 700);
    Experiment experiment = test::threeObjects();
    experiment.objects.clear();
    view.setExperiment(experiment);
    view.viewAlongMinusZ();
    show(view);
    const QColor cold(0x6b, 0x64, 0x60);
    const int glowing = test::pixelsOf(grab(view), kSource);
    EXPECT_GT(glowing, 500) << "not known";
    view.setSourceTemperature_K(experiment.environment_K);
    QImage image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-source-cold"));
    EXPECT_GT(test::pixelsOf(image, cold), glowing / 2);
    EXPECT_LT(test::pixelsOf(image, kSource), glowing / 20);
    view.setSourceTemperature_K(0.5 * (experiment.environment_K + experiment.source.temperature_K));
    image = grab(view);
    EXPECT_LT(test::pixelsOf(image, kSource), glowing / 20);
    EXPECT_LT(test::pixelsOf(image, cold), glowing / 6) << "shaded parts";
    view.setSourceTemperature_K(experiment.source.temperature_K + 20.0);
    EXPECT_GT(test::pixelsOf(grab(view), kSource), glowing / 2);

    const auto with = [&](HeatState heat) {
        view.setSourceHeat(heat);
        return grab(view);
    };
    const QImage unknown = with(HeatState::Unknown), off = with(HeatState::Off), on = with(HeatState::On);
    const int violet = test::pixelsOf(unknown, unknownColor(false));
    EXPECT_GT(violet, 100);
    EXPECT_LT(test::pixelsOf(off, unknownColor(false)), violet / 4);
    EXPECT_LT(test::pixelsOf(on, unknownColor(false)), violet / 4);
    EXPECT_GT(test::differentPixels(off, on), 100);
}

// Catches a long run whose beginning looks as new as its end.
TEST_F(SceneViewTest, ALongTrailFades) {
    SceneView view;
    view.resize(1000, 1000);
    Experiment experiment = test::threeObjects();
    experiment.objects.resize(1);
    experiment.objects[0].mounting.setZero();
    view.setExperiment(experiment);
    view.viewAlongMinusZ();
    show(view);
    std::vector<TraceSample> samples;
    constexpr int kRow = 800;
    for (int k = 0; k < 4 * kRow; ++k) { // four rows to and fro, from the lower to the upper end
        TraceSample sample = sampleAt(0.0, 0.1);
        const int row = k / kRow, place = k % kRow;
        sample.coordinates[kX] = 2.6e-4 * ((row % 2 == 0 ? place : kRow - place) - 0.5 * kRow);
        sample.coordinates[kY] = 0.05 * row - 0.075;
        sample.objects.resize(1);
        sample.objects[0].estimated_K = kelvinFromCelsius(37.0);
        samples.push_back(sample);
    }
    const NiceRange range = niceRange(experiment.environment_K - kelvinFromCelsius(0.0), 50.0, 5);
    const QColor colour = mapColour((37.0 - range.min) / (range.max - range.min), false);
    const auto inLowerHalf = [&](const std::vector<TraceSample>& trail) {
        view.setSamples(trail);
        view.setPose(sampleAt(0.0, 0.1).coordinates + 0.1 * Vector6d::Unit(kY)); // out of the lower half
        const QImage image = grab(view);
        return test::pixelsOf(image.copy(0, image.height() / 2, image.width(), image.height() / 2), colour,
                              4);
    };
    const int shortOne = inLowerHalf({samples.begin(), samples.begin() + kRow});
    EXPECT_GT(shortOne, 200);
    EXPECT_LT(inLowerHalf(samples), shortOne / 4) << "its first row, and the second";
}

// Catches drawing from within setters, and frames for things that nobody sees.
TEST_F(SceneViewTest, SettersDrawNothingAndAHiddenViewStaysIdle) {
    SceneView view;
    view.resize(600, 400);
    view.setExperiment(test::threeObjects());
    show(view);
    drawPending(view);
    const int shown = pictureOf(view)->frames();
    for (const TraceSample& sample : test::spiral(200))
        view.appendSamples({sample});
    EXPECT_EQ(pictureOf(view)->frames(), shown);
    drawPending(view);
    EXPECT_GT(pictureOf(view)->frames(), shown);
    EXPECT_LE(pictureOf(view)->frames(), shown + 2) << "200 appends in one go are one frame";

    view.hide();
    const int hidden = pictureOf(view)->frames();
    view.appendSamples(test::spiral(50));
    drawPending(view);
    EXPECT_EQ(pictureOf(view)->frames(), hidden);
}

// Catches frames of a rig at rest: the engine tells its pose and temperatures 20 times a second.
TEST_F(SceneViewTest, WhatIsShownAlreadyIsNotDrawnAgain) {
    SceneView view;
    view.resize(400, 300);
    view.setExperiment(test::threeObjects());
    show(view);
    Vector6d pose = Vector6d::Zero(), source = Vector6d::Zero();
    std::vector<double> temperatures_K{300.0, std::nan(""), 310.0};
    const auto told = [&] {
        const int before = pictureOf(view)->frames();
        view.setPose(pose);
        view.setSourcePose(source);
        view.setTemperatures(temperatures_K);
        return before;
    };
    const auto isDrawn = [&] {
        const int before = told();
        const bool drawn = QTest::qWaitFor([&] { return pictureOf(view)->frames() > before; }, 20'000);
        drawPending(view);
        return drawn;
    };
    const auto staysAsItIs = [&] {
        const int before = told();
        drawPending(view);
        return pictureOf(view)->frames() == before;
    };
    pose[kZ] = 0.1;
    drawPending(view);
    EXPECT_TRUE(isDrawn());
    EXPECT_TRUE(staysAsItIs());
    pose[kX] = 0.01;
    EXPECT_TRUE(isDrawn());
    source[kY] = 0.01;
    EXPECT_TRUE(isDrawn());
    temperatures_K[1] = 305.0;
    EXPECT_TRUE(isDrawn());
    temperatures_K[2] = std::nan("");
    EXPECT_TRUE(isDrawn());
    EXPECT_TRUE(staysAsItIs());
}

// Catches frames faster than anybody needs while samples pour in.
TEST_F(SceneViewTest, DataAsksForAtMostFifteenFramesASecond) {
    SceneView view;
    view.resize(400, 300);
    view.setExperiment(test::threeObjects());
    show(view);
    drawPending(view);
    const int before = pictureOf(view)->frames();
    QElapsedTimer timer;
    timer.start();
    double x_m = 0.0;
    while (timer.elapsed() < 1000) {
        view.appendSamples({sampleAt(x_m, 0.1)});
        x_m += 1e-4;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    const double seconds = 1e-3 * static_cast<double>(timer.elapsed());
    EXPECT_LE(pictureOf(view)->frames() - before, 16.0 * seconds + 1.0);
    EXPECT_GE(pictureOf(view)->frames() - before, 1);
}

// Catches a picture lost on the way through a tab, another window (a new OpenGL context) and a tiny size.
TEST_F(SceneViewTest, SurvivesTabsOtherWindowsAndTinySizes) {
    QTabWidget tabs;
    auto* view = new SceneView;
    view->setExperiment(test::threeObjects());
    view->setSamples(test::spiral(300));
    tabs.addTab(view, QStringLiteral("scene"));
    tabs.addTab(new QWidget, QStringLiteral("other"));
    tabs.resize(800, 600);
    show(tabs);
    const QImage first = grab(*view);
    ASSERT_GT(test::pixelsOf(first, kSource), 100);
    tabs.setCurrentIndex(1);
    QCoreApplication::processEvents();
    tabs.setCurrentIndex(0);
    QCoreApplication::processEvents();
    EXPECT_LT(test::differentPixels(first, grab(*view)), 300);

    QWidget other;
    auto* layout = new QVBoxLayout(&other);
    layout->addWidget(view);
    view->show();
    other.resize(900, 650);
    show(other);
    EXPECT_GT(test::pixelsOf(grab(*view), kSource), 100);
    for (int i = 0; i < 3; ++i)
        EXPECT_GT(test::pixelsOf(grab(*view), seriesColor(i, false)), 40) << i;

    pictureOf(*view)->setMinimumSize(1, 1);
    view->setMinimumSize(1, 1);
    for (const QSize size : {QSize(40, 30), QSize(130, 100), QSize(30, 500), QSize(900, 650)}) {
        other.resize(size);
        QCoreApplication::processEvents();
        EXPECT_FALSE(grab(*view).isNull());
    }
    EXPECT_GT(test::pixelsOf(grab(*view), kSource), 100);

    delete view; // while its window lives on
    QCoreApplication::processEvents();
    tabs.addTab(new SceneView, QStringLiteral("again"));
    QCoreApplication::processEvents();
}

// Catches a second view that shares or spoils the first one's resources, and a bad order of destruction.
TEST_F(SceneViewTest, TwoViewsInOneWindowAreIndependent) {
    auto window = std::make_unique<QWidget>();
    auto* layout = new QHBoxLayout(window.get());
    auto* a = new SceneView;
    auto* b = new SceneView;
    layout->addWidget(a);
    layout->addWidget(b);
    a->setExperiment(test::threeObjects());
    window->resize(1100, 500);
    show(*window);
    EXPECT_GT(test::pixelsOf(grab(*a), kSource), 50);
    EXPECT_EQ(test::pixelsOf(grab(*b), kSource), 0);
    delete a;
    b->setExperiment(test::threeObjects());
    EXPECT_GT(test::pixelsOf(grab(*b), kSource), 50);
    window.reset();
}

// Catches a crash or noise before there is anything to show.
TEST_F(SceneViewTest, NoExperimentAndNoObjectsAreCalmPictures) {
    SceneView view;
    view.resize(600, 400);
    show(view);
    EXPECT_EQ(test::coloursIn(grab(view)), 1);
    view.appendSamples(test::spiral(3));
    view.setPose(Vector6d::Zero());
    EXPECT_EQ(test::coloursIn(grab(view)), 1);
    Experiment empty = test::threeObjects();
    empty.objects.clear();
    view.setExperiment(empty);
    EXPECT_GT(test::pixelsOf(grab(view), kSource), 50);
    keepScreenshot(grab(view), QStringLiteral("scene-no-objects"));
}

// Catches rebuilding everything at every append: appending to a long trace must cost next to nothing.
TEST_F(SceneViewTest, ThirtyThousandSamplesStayQuick) {
    SceneView view;
    view.resize(1000, 700);
    Experiment experiment = test::threeObjects();
    experiment.source.shape = plates().back().second;
    view.setExperiment(experiment);
    show(view);
    const std::vector<TraceSample> samples = test::spiral(30000);
    view.setSamples(samples);
    const QImage image = grab(view);
    keepScreenshot(image, QStringLiteral("scene-30000"));
    EXPECT_GT(test::coloursIn(image), 200);

    const std::clock_t begin = std::clock();
    for (int i = 0; i < 1000; ++i)
        view.appendSamples({samples[static_cast<std::size_t>(29000 + i)]});
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 1.0) << "s for 1,000 appends";
    // Processor time of all threads, which other work on the machine does not lengthen; drawing it is at most
    // that.
    std::vector<double> frames_s;
    for (int i = 0; i < 9; ++i) {
        const std::clock_t start = std::clock();
        view.appendSamples({samples[static_cast<std::size_t>(100 * i)]});
        EXPECT_FALSE(grab(view).isNull());
        frames_s.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::nth_element(frames_s.begin(), frames_s.begin() + 4, frames_s.end());
    RecordProperty("median_frame_ms", std::to_string(1e3 * frames_s[4]));
    EXPECT_LT(frames_s[4], 0.6);
}

// Catches mouse and keys that do not reach the camera, and a preset that does not bring it back.
TEST_F(SceneViewTest, MouseWheelAndKeysMoveTheCameraAndPresetsBringItBack) {
    SceneView view;
    view.resize(700, 500);
    view.setExperiment(test::threeObjects());
    show(view);
    const QImage home = grab(view);
    VtkView* picture = pictureOf(view);
    QTest::mousePress(picture, Qt::LeftButton, {}, {300, 250});
    QTest::mouseMove(picture, {380, 280});
    QMouseEvent move(QEvent::MouseMove, QPointF(380, 280), picture->mapToGlobal(QPointF(380, 280)),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(picture, &move);
    QTest::mouseRelease(picture, Qt::LeftButton, {}, {380, 280});
    const QImage turned = grab(view);
    EXPECT_GT(test::differentPixels(home, turned), 2000);
    QWheelEvent wheel(QPointF(350, 250), picture->mapToGlobal(QPointF(350, 250)), {}, {0, 240}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(picture, &wheel);
    EXPECT_GT(test::differentPixels(turned, grab(view)), 2000);
    QTest::keyClick(picture, Qt::Key_Home);
    EXPECT_LT(test::differentPixels(home, grab(view)), 100);
    for (const auto key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Plus}) {
        const QImage before = grab(view);
        QTest::keyClick(picture, key);
        EXPECT_GT(test::differentPixels(before, grab(view)), 1000) << key;
    }
    view.viewIsometric();
    EXPECT_LT(test::differentPixels(home, grab(view)), 100);
    // VTK's own keys would switch to wireframe or leave the program.
    for (const auto key : {Qt::Key_W, Qt::Key_E, Qt::Key_3})
        QTest::keyClick(picture, key);
    EXPECT_LT(test::differentPixels(home, grab(view)), 100);
}

// Catches a view in the old colours, units or language after a switch.
TEST_F(SceneViewTest, FollowsPaletteAndUnit) {
    SceneView view;
    view.resize(700, 500);
    view.setExperiment(test::threeObjects());
    view.setSamples(test::spiral(100));
    show(view);
    const QImage light = grab(view);
    view.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_GT(test::differentPixels(light, grab(view)), 100);
    QApplication::setPalette(themePalette(true));
    QCoreApplication::processEvents();
    EXPECT_EQ(QColor(grab(view).pixel(3, 3)), themePalette(true).color(QPalette::Base));
}

// The pictures a designer looks at; fails when a preset gives the same picture as another.
TEST_F(SceneViewTest, PresetsLightAndDark) {
    SceneView view;
    view.resize(1000, 700);
    view.setExperiment(test::threeObjects());
    view.setSamples(test::spiral(600));
    show(view);
    for (const bool dark : {false, true}) {
        QApplication::setPalette(themePalette(dark));
        QCoreApplication::processEvents();
        const QString suffix = dark ? QStringLiteral("dark") : QStringLiteral("light");
        view.viewAlongMinusZ();
        const QImage top = grab(view);
        view.viewAlongX();
        const QImage side = grab(view);
        view.viewIsometric();
        const QImage isometric = grab(view);
        keepScreenshot(top, QStringLiteral("scene-top-") + suffix);
        keepScreenshot(side, QStringLiteral("scene-side-") + suffix);
        keepScreenshot(isometric, QStringLiteral("scene-isometric-") + suffix);
        EXPECT_GT(test::differentPixels(top, side), 20000);
        EXPECT_GT(test::differentPixels(side, isometric), 20000);
    }
    QApplication::setPalette(themePalette(false));
    view.resize(420, 320);
    QCoreApplication::processEvents();
    keepScreenshot(grab(view), QStringLiteral("scene-small"));
}

} // namespace
} // namespace bask
