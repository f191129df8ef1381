#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment_rig.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"
#include "widgets/scene/target_scene.h"
#include "widgets/scene/vtk_view.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <QtTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bask {
namespace {

using test::keepScreenshot;

using Fields = std::vector<std::shared_ptr<const Field>>;

/// Fields of the experiment's objects, the other coordinates held as at its start. Each is computed once.
Fields fieldsOf(const Experiment& experiment, PoseSubset subset = PoseSubset::Translation) {
    static std::vector<std::tuple<Experiment, PoseSubset, Fields>> known;
    for (const auto& [of, over, fields] : known)
        if (of == experiment && over == subset)
            return fields;
    const double step = subset == PoseSubset::Translation ? kSurfaceStep_m : 2.0 * kSurfaceStep_rad;
    TargetGeometry geometry{RadiatingContour(experiment.source.shape),
                            poseFromCoordinates(experiment.source.pose),
                            {},
                            {},
                            surfaceAxes(subset, experiment.robot, step)};
    for (const ObjectSpec& object : experiment.objects)
        geometry.objects.push_back({RadiatingContour(object.shape), poseFromCoordinates(object.mounting)});
    geometry.fixed = experiment.start;
    geometry.clearance_m = experiment.robot.clearance_m;
    const auto fields = targetFields(geometry);
    EXPECT_TRUE(fields);
    return std::get<Fields>(known.emplace_back(experiment, subset, *fields));
}

HeatRates ratesOf(const Experiment& experiment, const ObjectSpec& object) {
    return heatRates(object, surroundingsOf(experiment));
}

std::vector<Isosurface> surfacesOf(const Experiment& experiment,
                                   PoseSubset subset = PoseSubset::Translation) {
    std::vector<double> values;
    for (const ObjectSpec& object : experiment.objects)
        values.push_back(ratesOf(experiment, object).steadyViewFactor(object.target_K));
    return *targetSurfaces(fieldsOf(experiment, subset), values);
}

/// A square of half the side across z = height, in two triangles.
Isosurface square(double x_m, double y_m, double z_m, double half_m) {
    Isosurface sheet;
    sheet.value = 0.5;
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        sheet.points.emplace_back(x_m + i * half_m, y_m + j * half_m, z_m);
    sheet.normals.assign(4, Eigen::Vector3d::UnitZ());
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    return sheet;
}

class TargetSceneTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!VtkView::available())
            GTEST_SKIP() << "no OpenGL here";
        QApplication::setPalette(themePalette(false));
    }
    void TearDown() override { QApplication::setPalette(themePalette(false)); }

    static void show(QWidget& widget) {
        widget.resize(1000, 700);
        widget.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
    }
    static VtkView* pictureOf(const TargetScene& scene) { return scene.findChild<VtkView*>(); }
    static QImage grab(const TargetScene& scene) { return pictureOf(scene)->grabFramebuffer(); }
};

/// Mean colour of a few pixels about a place.
QColor colourAt(const QImage& image, QPoint place) {
    int red = 0, green = 0, blue = 0, count = 0;
    for (int dy = -3; dy <= 3; ++dy)
        for (int dx = -3; dx <= 3; ++dx, ++count) {
            const QColor colour(image.pixel(place + QPoint(dx, dy)));
            red += colour.red();
            green += colour.green();
            blue += colour.blue();
        }
    return {red / count, green / count, blue / count};
}

int apart(const QColor& a, const QColor& b) {
    return std::max(
        {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

/// How near a colour's hue is to another's, as a share of what both differ from their ground.
double likeness(const QColor& seen, const QColor& ground, const QColor& colour) {
    const Eigen::Vector3d a(seen.red() - ground.red(), seen.green() - ground.green(),
                            seen.blue() - ground.blue());
    const Eigen::Vector3d b(colour.red() - ground.red(), colour.green() - ground.green(),
                            colour.blue() - ground.blue());
    return a.norm() > 0.0 ? a.dot(b) / (a.norm() * b.norm()) : 0.0;
}

/// Where (R, m) is in the view from above, by the labels' own axes: two squares give the scale.
struct Above {
    QPointF centre;
    double pixelsPerMetre;
    QPoint operator()(double x_m, double y_m) const {
        return (centre + pixelsPerMetre * QPointF(x_m, -y_m)).toPoint();
    }
};

/// From the source's middle and rim, which a scene without surfaces shows.
Above scaleOf(const QImage& image) {
    const QPointF middle = test::middleOf(image, QColor(0xff, 0xb4, 0x5c), 40);
    int left = image.width(), right = 0;
    const int y = static_cast<int>(std::lround(middle.y()));
    for (int x = 0; x < image.width(); ++x) {
        const QColor colour(image.pixel(x, y));
        if (colour.red() > 180 && colour.blue() < 110 && colour.green() < 190) { // glowing
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    return {QPointF(0.5 * (left + right), middle.y()), (right - left) / 0.2};
}

// Catches: surfaces that are not drawn, drawn elsewhere than their points, or not in their objects' colours.
TEST_F(TargetSceneTest, SurfacesStandWhereTheyAreInTheirColours) {
    Experiment experiment = test::threeObjects();
    experiment.start.head<3>() << 0.0, -0.15, 0.2; // the ghost out of the way
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    const QImage before = grab(scene);
    const Above place = scaleOf(before);
    scene.setSurfaces(
        {square(-0.15, 0.14, 0.1, 0.03), square(0.0, 0.14, 0.15, 0.03), square(0.15, 0.14, 0.2, 0.03)},
        experiment.start);
    const QImage after = grab(scene);
    keepScreenshot(after, QStringLiteral("targets-squares"));
    const QColor ground = QApplication::palette().color(QPalette::Base);
    for (int i = 0; i < 3; ++i) {
        const QPoint middle = place(-0.15 + 0.15 * i + 0.011, 0.14 + 0.011);
        ASSERT_LT(apart(colourAt(before, middle), ground), 12);
        const QColor seen = colourAt(after, middle);
        EXPECT_GT(apart(seen, ground), 40) << "surface " << i << " is not there";
        for (int k = 0; k < 3; ++k)
            if (k != i) {
                EXPECT_GT(likeness(seen, ground, seriesColor(i, false)),
                          likeness(seen, ground, seriesColor(k, false)) + 0.02)
                    << "surface " << i << " looks like " << k;
            }
        const QPoint outside = place(-0.15 + 0.15 * i + 0.04, 0.14 + 0.011);
        EXPECT_LT(apart(colourAt(after, outside), colourAt(before, outside)), 12);
    }
}

// Catches: translucency that depends on the order in which surfaces are handed over or drawn.
TEST_F(TargetSceneTest, OverlappingSurfacesLookTheSameInAnyOrder) {
    Experiment experiment = test::threeObjects();
    experiment.start.head<3>() << 0.0, -0.15, 0.2;
    const Isosurface low = square(0.0, 0.14, 0.1, 0.03), high = square(0.0, 0.14, 0.2, 0.03);
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    const Above place = scaleOf(grab(scene));
    const QPoint middle = place(0.011, 0.151);
    scene.setSurfaces({low}, experiment.start);
    const QColor one = colourAt(grab(scene), middle);
    scene.setSurfaces({low, high}, experiment.start);
    const QColor lowFirst = colourAt(grab(scene), middle);
    EXPECT_GT(apart(one, lowFirst), 15) << "the one behind does not shine through";
    EXPECT_GT(likeness(lowFirst, Qt::white, seriesColor(0, false)), 0.5);
    // The same pair with its two sheets the other way round in each actor: the picture must not change.
    Isosurface both = low, swapped = high;
    for (auto* sheets : {&both, &swapped}) {
        const Isosurface& other = sheets == &both ? high : low;
        sheets->points.insert(sheets->points.end(), other.points.begin(), other.points.end());
        sheets->normals.insert(sheets->normals.end(), other.normals.begin(), other.normals.end());
        sheets->triangles.push_back({4, 5, 6});
        sheets->triangles.push_back({4, 6, 7});
    }
    scene.setSurfaces({both}, experiment.start);
    const QImage first = grab(scene);
    scene.setSurfaces({swapped}, experiment.start);
    EXPECT_LT(test::differentPixels(first, grab(scene)), 20);
}

// Catches: a whole example that does not show its three surfaces; kept in light and dark to be looked at.
TEST_F(TargetSceneTest, ShowsAnExamplesSurfaces) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    SceneVerdict verdict;
    verdict.pose << 0.01, 0.03, 0.12, 0.0, 0.0, 0.0;
    verdict.feasible = true;
    scene.setVerdictPoint(verdict);
    show(scene);
    const QImage light = grab(scene);
    keepScreenshot(light, QStringLiteral("targets-feasible-light"));
    EXPECT_GT(test::coloursIn(light), 3000);
    QApplication::setPalette(themePalette(true));
    QCoreApplication::processEvents();
    const QImage dark = grab(scene);
    keepScreenshot(dark, QStringLiteral("targets-feasible-dark"));
    EXPECT_EQ(QColor(dark.pixel(3, 3)), themePalette(true).color(QPalette::Base));
    QApplication::setPalette(themePalette(false));
    QCoreApplication::processEvents();

    verdict.feasible = false;
    verdict.closest = {{-0.02, 0.01, 0.09}, {0.03, 0.02, 0.11}};
    scene.setVerdictPoint(verdict);
    const QImage apartPicture = grab(scene);
    keepScreenshot(apartPicture, QStringLiteral("targets-infeasible-light"));
    EXPECT_GT(test::differentPixels(light, apartPicture), 300);
    scene.viewAlongX();
    keepScreenshot(grab(scene), QStringLiteral("targets-infeasible-side"));
}

// Catches: a common point that is not marked, is hidden behind surfaces, or stands elsewhere; a closest
// approach without its line.
TEST_F(TargetSceneTest, MarksTheCommonPointOrTheClosestApproach) {
    Experiment experiment = test::threeObjects();
    experiment.start.head<3>() << 0.0, -0.15, 0.2;
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    const QImage before = grab(scene);
    const Above place = scaleOf(before);
    const QColor mark = QApplication::palette().color(QPalette::Text);
    scene.setSurfaces({square(0.14, 0.15, 0.25, 0.03)}, experiment.start); // over the point
    SceneVerdict verdict;
    verdict.pose = experiment.start;
    verdict.pose.head<3>() << 0.14, 0.15, 0.1;
    verdict.feasible = true;
    scene.setVerdictPoint(verdict);
    EXPECT_LT(apart(colourAt(grab(scene), place(0.14, 0.15)), mark), 20) << "hidden or elsewhere";

    verdict.pose = experiment.start;
    verdict.feasible = false;
    verdict.closest = {{-0.15, 0.16, 0.1}, {-0.05, 0.16, 0.2}};
    scene.setVerdictPoint(verdict);
    const QImage closest = grab(scene);
    keepScreenshot(closest, QStringLiteral("targets-closest"));
    for (const double x_m : {-0.15, -0.05})
        EXPECT_LT(apart(colourAt(closest, place(x_m, 0.16)), mark), 20) << "end at " << x_m;
    int onLine = 0;
    for (int dy = -3; dy <= 3; ++dy)
        onLine += apart(QColor(closest.pixel(place(-0.12, 0.16) + QPoint(0, dy))), mark) < 60 ? 1 : 0;
    EXPECT_GE(onLine, 2) << "no line between them";
    scene.setVerdictPoint(std::nullopt);
    EXPECT_GT(apart(colourAt(grab(scene), place(-0.15, 0.16)), mark), 100) << "an old mark stays";
}

// Catches: an old picture that looks like a new one, and a hatch that stays.
TEST_F(TargetSceneTest, StaleIsSeen) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    show(scene);
    const QImage fresh = grab(scene);
    scene.setStale(true);
    const QImage stale = grab(scene);
    keepScreenshot(stale, QStringLiteral("targets-stale-light"));
    EXPECT_GT(test::differentPixels(fresh, stale), fresh.width() * fresh.height() / 10);
    scene.setStale(false);
    EXPECT_LT(test::differentPixels(fresh, grab(scene)), 20);
}

// Catches: surfaces that vanish while a target is typed, and ones that stay when the objects are others.
TEST_F(TargetSceneTest, AnotherTargetKeepsThePicture) {
    Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    show(scene);
    const QImage bare = grab(scene);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    const QImage before = grab(scene);
    experiment.objects[0].target_K += 0.04; // shown to a tenth
    scene.setExperiment(experiment);
    EXPECT_LT(test::differentPixels(before, grab(scene)), 20);
    experiment.objects[0].target_K += 3.0;
    scene.setExperiment(experiment);
    EXPECT_GT(test::differentPixels(before, grab(scene)), 10) << "the label";
    experiment.objects[0].shape = Disk{0.0151};
    scene.setExperiment(experiment);
    EXPECT_LT(test::differentPixels(bare, grab(scene)), 800);
}

// Catches: a cut in the wrong place or of the wrong numbers, and a bar in another unit than the operator's.
TEST_F(TargetSceneTest, TheCutHasTheFieldsColours) {
    Experiment experiment = test::threeObjects();
    const auto fields = fieldsOf(experiment);
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    const QImage before = grab(scene);
    const Above place = scaleOf(before);
    SceneCut cut{fields[0], 0, kZ, 0.1, false};
    scene.setCut(cut);
    const QImage factors = grab(scene);
    keepScreenshot(factors, QStringLiteral("targets-cut-F"));
    // Where the end-effector puts the circle, 5 cm towards +y of it, far from and over the source. F is on a
    // scale from 0 to 1 here.
    const RadiatingContour source(experiment.source.shape), object(experiment.objects[0].shape);
    for (const auto& [x_m, y_m] : {std::pair{-0.15, 0.12}, {0.151, -0.05}, {0.113, -0.14}}) {
        Pose X_SO = Pose::Identity();
        X_SO.translation() << x_m, y_m + 0.05, 0.1;
        const double F = viewFactor(source, object, X_SO).value;
        const QColor seen = colourAt(factors, place(x_m, y_m));
        EXPECT_LT(apart(seen, mapColour(F, false)), 30) << x_m << ' ' << y_m << ' ' << F;
    }
    cut.asTemperature = true;
    cut.axis = kY;
    cut.position = 0.05;
    scene.setCut(cut);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    scene.viewIsometric();
    const QImage temperatures = grab(scene);
    keepScreenshot(temperatures, QStringLiteral("targets-cut-T-light"));
    scene.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    const QImage fahrenheit = grab(scene);
    EXPECT_GT(test::differentPixels(temperatures, fahrenheit), 500);
    QApplication::setPalette(themePalette(true));
    QCoreApplication::processEvents();
    keepScreenshot(grab(scene), QStringLiteral("targets-cut-T-dark"));
    EXPECT_THROW(scene.setCut(SceneCut{fields[0], 3}), std::invalid_argument);
    EXPECT_THROW(scene.setCut(SceneCut{nullptr, 0}), std::invalid_argument);
    scene.setCut(std::nullopt);
}

// Catches: a click that picks another point than the one under it, or words of another pose; a drag that
// picks.
TEST_F(TargetSceneTest, AClickPicksWhatIsUnderIt) {
    Experiment experiment = test::threeObjects();
    experiment.start[kThetaX] = 0.2;
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    const Above place = scaleOf(grab(scene));
    scene.setSurfaces({square(0.14, 0.14, 0.08, 0.03), square(0.14, 0.14, 0.21, 0.03)}, experiment.start);
    const QImage before = grab(scene);
    QSignalSpy spy(&scene, &TargetScene::posePicked);
    QTest::mouseClick(pictureOf(scene), Qt::LeftButton, {}, place(0.15, 0.13));
    ASSERT_EQ(spy.count(), 1);
    const auto q = spy[0][0].value<Vector6d>();
    EXPECT_NEAR(q[kX], 0.15, 0.003);
    EXPECT_NEAR(q[kY], 0.13, 0.003);
    EXPECT_NEAR(q[kZ], 0.21, 1e-9) << "not the nearest one";
    EXPECT_EQ(q[kThetaX], 0.2) << "the held angle";
    const QStringList words = spy[0][1].toStringList();
    ASSERT_EQ(words.size(), 3);
    Pose X_SO = poseFromCoordinates(q) * poseFromCoordinates(experiment.objects[0].mounting);
    const double F = viewFactor(RadiatingContour(experiment.source.shape),
                                RadiatingContour(experiment.objects[0].shape), X_SO)
                         .value;
    EXPECT_TRUE(words[0].startsWith(QStringLiteral("circle: F %1, steady ").arg(F, 0, 'f', 3)))
        << words[0].toStdString();
    const QImage picked = grab(scene);
    keepScreenshot(picked, QStringLiteral("targets-picked"));
    EXPECT_GT(test::differentPixels(before, picked), 100) << "neither mark nor arrows";
    for (int i = 0; i < 3; ++i)
        EXPECT_GT(test::pixelsOf(picked, seriesColor(i, false), 8),
                  test::pixelsOf(before, seriesColor(i, false), 8) + 40)
            << "no arrow of object " << i;
    QSignalSpy dropped(&scene, &TargetScene::pickDropped);
    scene.clearPick();
    scene.clearPick();
    EXPECT_EQ(dropped.count(), 1);
    EXPECT_LT(test::differentPixels(before, grab(scene)), 20);

    QTest::mouseClick(pictureOf(scene), Qt::LeftButton, {}, place(-0.15, 0.13));
    EXPECT_EQ(spy.count(), 1) << "there is nothing";
    QTest::mousePress(pictureOf(scene), Qt::LeftButton, {}, place(0.15, 0.13));
    QTest::mouseMove(pictureOf(scene), place(0.15, 0.13) + QPoint(60, 20));
    QTest::mouseMove(pictureOf(scene), place(0.15, 0.13));
    QTest::mouseRelease(pictureOf(scene), Qt::LeftButton, {}, place(0.15, 0.13));
    EXPECT_EQ(spy.count(), 1) << "a drag";
}

// Catches: a picked point's arrows under a label, in a view so small that labels are close.
TEST_F(TargetSceneTest, NoLabelHidesAPickedPointsArrows) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    show(scene);
    scene.resize(374, 360);
    QCoreApplication::processEvents();
    QSignalSpy spy(&scene, &TargetScene::posePicked);
    for (const double y : {0.4, 0.45, 0.5, 0.55, 0.6}) {
        scene.clearPick();
        const QImage before = grab(scene);
        QTest::mouseClick(pictureOf(scene), Qt::LeftButton, {}, QPoint(150, static_cast<int>(360 * y)));
        const QImage picked = grab(scene);
        int more = 0;
        for (int i = 0; i < 3; ++i)
            more += test::pixelsOf(picked, seriesColor(i, false), 8) -
                    test::pixelsOf(before, seriesColor(i, false), 8);
        EXPECT_GT(more, 60) << y;
    }
    EXPECT_EQ(spy.count(), 5);
}

// Catches: a clearance plane that is not where an object would be too near: here a palm's width under E.
TEST_F(TargetSceneTest, TheClearancePlaneIsTheEndEffectorsLowest) {
    Experiment experiment = test::threeObjects();
    experiment.robot.clearance_m = 0.12;
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongX();
    show(scene);
    const QImage high = grab(scene);
    keepScreenshot(high, QStringLiteral("targets-clearance"));
    experiment.robot.clearance_m = 0.02;
    scene.setExperiment(experiment);
    EXPECT_GT(test::differentPixels(high, grab(scene)), 500);
}

// Catches: a saved picture of another size, or without the surfaces; a view that stays at the picture's size.
TEST_F(TargetSceneTest, SavesPicturesOfAnySize) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    show(scene);
    const QSize before = pictureOf(scene)->size();
    QTemporaryDir folder;
    for (const QSize size : {QSize(640, 480), QSize(1700, 1100), QSize(301, 900)}) {
        const QString path = folder.filePath(QStringLiteral("scene.png"));
        ASSERT_TRUE(scene.saveImage(path, size));
        const QImage image(path);
        EXPECT_EQ(image.size(), size);
        EXPECT_GT(test::coloursIn(image), 1500);
        keepScreenshot(image, QStringLiteral("targets-saved-%1").arg(size.width()));
    }
    EXPECT_EQ(pictureOf(scene)->size(), before);
    const auto refused = scene.saveImage(folder.filePath(QStringLiteral("no/such.png")), {640, 480});
    EXPECT_FALSE(refused);
    EXPECT_FALSE(TargetScene().saveImage(folder.filePath(QStringLiteral("never-shown.png")), {640, 480}));
}

// Catches: a picture that is cut off, or of the view's size, because the page was left while it is made.
TEST_F(TargetSceneTest, APictureIsWholeWhileTheSceneIsHidden) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    show(scene);
    const QSize size(900, 1100);
    const QImage shown = scene.image(size);
    scene.hide();
    const QImage hidden = scene.image(size);
    ASSERT_EQ(hidden.size(), size);
    EXPECT_LT(test::differentPixels(shown, hidden), 50);
    show(scene);
    EXPECT_LT(test::differentPixels(shown, scene.image(size)), 50);
}

// Catches: angles drawn as positions, on axes of centimetres, with a source that is nowhere in that space; a
// pick there that gives positions.
TEST_F(TargetSceneTest, OverTheAnglesTheAxesAreAngles) {
    Experiment experiment = test::threeObjects();
    experiment.start.head<3>() << 0.02, 0.0, 0.14;
    TargetScene scene;
    scene.setExperiment(experiment);
    show(scene);
    const QImage positions = grab(scene);
    scene.setSurfaces(surfacesOf(experiment, PoseSubset::Rotation), experiment.start, PoseSubset::Rotation);
    scene.setCut(SceneCut{fieldsOf(experiment, PoseSubset::Rotation)[0], 0, kThetaZ, -1.2, true});
    const QImage angles = grab(scene);
    keepScreenshot(angles, QStringLiteral("targets-angles-light"));
    EXPECT_GT(test::pixelsOf(positions, QColor(0xff, 0xb4, 0x5c), 40), 500);
    EXPECT_LT(test::pixelsOf(angles, QColor(0xff, 0xb4, 0x5c), 40), 20) << "the source is still there";
    EXPECT_THROW(scene.setCut(SceneCut{fieldsOf(experiment)[0], 0}), std::invalid_argument);

    scene.setCut(std::nullopt);
    scene.setSurfaces({square(0.5, 0.5, 0.3, 0.4)}, experiment.start, PoseSubset::Rotation);
    scene.viewAlongMinusZ();
    const QImage flat = grab(scene);
    const QColor ground = QApplication::palette().color(QPalette::Base);
    int left = flat.width(), right = 0, top = flat.height(), bottom = 0;
    for (int y = 0; y < flat.height(); ++y)
        for (int x = 0; x < flat.width(); ++x)
            if (likeness(QColor(flat.pixel(x, y)), ground, seriesColor(0, false)) > 0.98) {
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = std::max(bottom, y);
            }
    QSignalSpy spy(&scene, &TargetScene::posePicked);
    QTest::mouseClick(pictureOf(scene), Qt::LeftButton, {}, {(left + right) / 2, (top + bottom) / 2});
    ASSERT_EQ(spy.count(), 1);
    const auto q = spy[0][0].value<Vector6d>();
    EXPECT_NEAR(q[kThetaX], 0.5, 0.1); // its label has its colour too
    EXPECT_NEAR(q[kThetaY], 0.5, 0.1);
    EXPECT_NEAR(q[kThetaZ], 0.3, 1e-9);
    EXPECT_EQ(q[kX], 0.02) << "the held position";
    EXPECT_TRUE(spy[0][1].toStringList()[0].endsWith(QStringLiteral("K/°")));
}

/// Longest row of pixels in the marks' colour.
int longestLine(const QImage& image) {
    const QColor mark = QApplication::palette().color(QPalette::Text);
    int longest = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0, run = 0; x < image.width(); ++x) {
            run = apart(QColor(image.pixel(x, y)), mark) < 12 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    return longest;
}

// Catches: angles that the robot cannot turn to and that look as if it could: the range of its angle is a
// line as long as it, seen through a surface, and in words; an angle that it does not move has none.
TEST_F(TargetSceneTest, OverTheAnglesTheRobotsOwnAreShown) {
    Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.viewAlongMinusZ();
    show(scene);
    const auto pictureOf = [&](double max_deg, bool free) {
        experiment.robot.free[kThetaX] = free;
        experiment.robot.lower[kThetaX] = radFromDeg(-max_deg);
        experiment.robot.upper[kThetaX] = radFromDeg(max_deg);
        scene.setExperiment(experiment);
        scene.setSurfaces({square(0.0, 0.0, 0.3, 1.4)}, experiment.start, PoseSubset::Rotation);
        return grab(scene);
    };
    const QImage narrow = pictureOf(35.0, true), wide = pictureOf(70.0, true);
    keepScreenshot(narrow, QStringLiteral("targets-angles-limits"));
    EXPECT_GT(longestLine(narrow), 60);
    EXPECT_NEAR(longestLine(wide), 2 * longestLine(narrow), 12);
    EXPECT_LT(longestLine(pictureOf(35.0, false)), longestLine(narrow) / 2);
}

// Catches: an object without a surface that says nothing of it, in any space; and one that says so of a
// target whose surface is not known yet.
TEST_F(TargetSceneTest, ALabelSaysThatATargetIsNowhere) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    show(scene);
    for (const PoseSubset subset : {PoseSubset::Translation, PoseSubset::Rotation}) {
        scene.setSurfaces({}, experiment.start, subset);
        const QImage unknown = grab(scene);
        scene.setSurfaces({Isosurface(), Isosurface(), Isosurface()}, experiment.start, subset);
        const QImage nowhere = grab(scene);
        keepScreenshot(nowhere, QStringLiteral("targets-nowhere-%1").arg(static_cast<int>(subset)));
        EXPECT_GT(test::differentPixels(unknown, nowhere), 300);
    }
    scene.setSurfaces({}, experiment.start);
    scene.setStale(true);
    const QImage unknown = grab(scene);
    scene.setSurfaces({Isosurface(), Isosurface(), Isosurface()}, experiment.start);
    EXPECT_LT(test::differentPixels(unknown, grab(scene)), 20);
}

// Catches: a colour bar that does not say whose field it is.
TEST_F(TargetSceneTest, TheBarNamesTheObject) {
    Experiment experiment = test::threeObjects();
    const auto fields = fieldsOf(experiment);
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    const QRect title(700, 0, 300, 28);
    QImage before = grab(scene).copy(title);
    for (const bool asTemperature : {true, false})
        for (const int object : {0, 1}) {
            scene.setCut(SceneCut{fields[0], object, kZ, 0.1, asTemperature});
            const QImage now = grab(scene).copy(title);
            EXPECT_GT(test::differentPixels(before, now), 20) << asTemperature << object;
            before = now;
        }
}

// Catches: objects that do not stand on their own surfaces, axes that say nothing of whose positions they
// are, a mark where nothing meets, and a pick there that puts the end-effector where the object is.
TEST_F(TargetSceneTest, OverTheirOwnPositionsObjectsStandOnTheirSurfaces) {
    Experiment experiment = test::threeObjects();
    experiment.objects[0].mounting.head<3>() << 0.05, 0.0, 0.0;
    experiment.start[kThetaZ] = 1.5707963267948966; // the circle stands towards +y
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.viewAlongMinusZ();
    show(scene);
    SceneVerdict verdict;
    verdict.pose = experiment.start;
    verdict.pose.head<3>() << 0.1, 0.05, 0.1;
    verdict.feasible = true;
    scene.setVerdictPoint(verdict);
    scene.setSurfaces({}, experiment.start);
    const QColor mark = QApplication::palette().color(QPalette::Text);
    const int marked = test::pixelsOf(grab(scene), mark, 20);
    scene.setSurfaces({square(0.1, 0.1, 0.1, 0.03)}, experiment.start, PoseSubset::OwnTranslation);
    const QImage own = grab(scene);
    keepScreenshot(own, QStringLiteral("targets-own-square"));
    EXPECT_LT(test::pixelsOf(own, mark, 20), marked - 100) << "the common point is still marked";

    // The square's middle is where the circle's is: a click there picks the verdict's pose.
    const QColor ground = QApplication::palette().color(QPalette::Base);
    int left = own.width(), right = 0, top = own.height(), bottom = 0;
    for (int y = 0; y < own.height(); ++y)
        for (int x = 0; x < own.width(); ++x)
            if (likeness(QColor(own.pixel(x, y)), ground, seriesColor(0, false)) > 0.99 &&
                apart(QColor(own.pixel(x, y)), ground) > 40 && apart(QColor(own.pixel(x, y)), ground) < 120) {
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = std::max(bottom, y);
            }
    QSignalSpy spy(&scene, &TargetScene::posePicked);
    QTest::mouseClick(pictureOf(scene), Qt::LeftButton, {}, {(left + right) / 2, (top + bottom) / 2});
    ASSERT_EQ(spy.count(), 1);
    const auto q = spy[0][0].value<Vector6d>();
    EXPECT_NEAR(q[kX], 0.1, 0.004);
    EXPECT_NEAR(q[kY], 0.05, 0.004);
    EXPECT_NEAR(q[kZ], 0.1, 1e-9);
    keepScreenshot(grab(scene), QStringLiteral("targets-own-picked"));
}

// Catches: a point marked as common to surfaces that are held elsewhere and do not meet there.
TEST_F(TargetSceneTest, MarksNothingOnSurfacesHeldElsewhere) {
    Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    show(scene);
    SceneVerdict verdict;
    verdict.pose = experiment.start;
    verdict.pose[kThetaX] = 0.2;
    verdict.feasible = true;
    scene.setVerdictPoint(verdict);
    scene.setSurfaces({}, verdict.pose);
    const QColor mark = QApplication::palette().color(QPalette::Text);
    const int marked = test::pixelsOf(grab(scene), mark, 20);
    Vector6d tilted = verdict.pose;
    tilted[kThetaX] = -0.2;
    scene.setSurfaces({}, tilted);
    EXPECT_LT(test::pixelsOf(grab(scene), mark, 20), marked - 100);
}

// Catches: a large picture whose text and lines stay as small as on the screen.
TEST_F(TargetSceneTest, ALargePictureLooksAsASmallOne) {
    const Experiment experiment = test::threeObjects();
    TargetScene scene;
    scene.setExperiment(experiment);
    scene.setSurfaces(surfacesOf(experiment), experiment.start);
    show(scene);
    const QImage small = scene.image({1000, 750});
    const QImage large = scene.image({2000, 1500});
    EXPECT_EQ(large.size(), QSize(2000, 1500));
    keepScreenshot(large, QStringLiteral("targets-saved-2000"));
    const QImage shrunk = large.scaled(small.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    int off = 0;
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x)
            off += apart(QColor(small.pixel(x, y)), QColor(shrunk.pixel(x, y))) > 100 ? 1 : 0;
    EXPECT_LT(off, 1000);
}

// Catches: a setter that needs the picture to be there, or the experiment.
TEST_F(TargetSceneTest, TakesEverySetterBeforeItIsShown) {
    TargetScene scene;
    scene.setSurfaces({square(0.0, 0.0, 0.1, 0.03)}, Vector6d::Zero());
    scene.setVerdictPoint(SceneVerdict{});
    scene.setStale(true);
    scene.setTemperatureUnit(TemperatureUnit::Kelvin);
    scene.viewAlongX();
    show(scene);
    EXPECT_FALSE(grab(scene).isNull());
}

} // namespace
} // namespace bask
