// Pictures for reports: paths and surfaces are where they ought to be, in their colours.

#include "widgets/plots/figure_paths.h"
#include "widgets/plots/figure_surfaces.h"

#include <QImage>

#include <gtest/gtest.h>

#include <cmath>

namespace bask::test {
namespace {

/// Middle of the pixels that `wanted` picks, as parts of the picture; count 0: none.
struct Spot {
    int count = 0;
    double x = 0.0, y = 0.0;
};

template <class Wanted> Spot spotOf(const QImage& image, const Wanted& wanted) {
    Spot spot;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (wanted(image.pixelColor(x, y))) {
                ++spot.count;
                spot.x += x;
                spot.y += y;
            }
    spot.x /= std::max(spot.count, 1) * image.width();
    spot.y /= std::max(spot.count, 1) * image.height();
    return spot;
}

bool isBlue(const QColor& c) {
    return c.blue() > 150 && c.red() < 80;
}
bool isRed(const QColor& c) {
    return c.red() > 180 && c.blue() < 80 && c.green() < 80;
}

// Catches: axes that are swapped or turned round, hot that is blue, paths outside of their views.
TEST(PathsPng, GoesFromBlueToRedWhereThePathGoes) {
    PathsFigure figure;
    figure.title = "title";
    figure.coldest_degC = 20.0;
    figure.hottest_degC = 60.0;
    FigurePath path{"one", {}};
    for (int k = 0; k <= 40; ++k) // to greater x and y, downwards
        path.points << PathPoint{-8.0 + 0.4 * k, -8.0 + 0.4 * k, 20.0 - 0.4 * k, 20.0 + k};
    figure.paths = {path};
    for (int k = 0; k < 60; ++k)
        figure.source_cm << QPointF(10.0 * std::cos(M_PI * k / 30.0), 10.0 * std::sin(M_PI * k / 30.0));
    const QImage whole = QImage::fromData(pathsPng(figure, "comment"), "PNG");
    ASSERT_EQ(whole.size(), figure.size_px);
    EXPECT_EQ(whole.text("Description"), QString("comment"));
    EXPECT_NEAR(whole.dotsPerMeterX() * 0.0254, 300.0, 0.1) << "dots per inch";
    EXPECT_EQ(whole.dotsPerMeterX(), whole.dotsPerMeterY());
    const int half = static_cast<int>(0.46 * whole.width());
    const QImage above = whole.copy(0, 0, half, whole.height());
    const QImage aside = whole.copy(half, 0, static_cast<int>(0.44 * whole.width()), whole.height());
    const Spot coldAbove = spotOf(above, isBlue), hotAbove = spotOf(above, isRed);
    ASSERT_GT(coldAbove.count, 20);
    ASSERT_GT(hotAbove.count, 20);
    EXPECT_LT(coldAbove.x, hotAbove.x - 0.1) << "x goes to the right";
    EXPECT_GT(coldAbove.y, hotAbove.y + 0.1) << "y goes up";
    const Spot coldAside = spotOf(aside, isBlue), hotAside = spotOf(aside, isRed);
    ASSERT_GT(coldAside.count, 20);
    ASSERT_GT(hotAside.count, 20);
    EXPECT_GT(coldAside.x, hotAside.x + 0.1) << "y goes to the left, seen along x";
    EXPECT_LT(coldAside.y, hotAside.y - 0.1) << "z goes up";
}

// Catches colours whose order a black-and-white print loses, and paths that only colours tell apart.
TEST(PathsPng, IsReadInBlackAndWhite) {
    PathsFigure figure;
    figure.title = "title";
    figure.coldest_degC = 20.0;
    figure.hottest_degC = 60.0;
    for (int k = 0; k < 60; ++k)
        figure.source_cm << QPointF(10.0 * std::cos(M_PI * k / 30.0), 10.0 * std::sin(M_PI * k / 30.0));
    for (const double y_cm : {-4.0, 4.0}) {
        FigurePath path{y_cm < 0.0 ? "alpha" : "bravo", {}};
        for (int k = 0; k <= 40; ++k) // from the left to the right
            path.points << PathPoint{-8.0 + 0.4 * k, y_cm, 20.0, 20.0 + k};
        figure.paths << path;
    }
    const QImage image = QImage::fromData(pathsPng(figure, "comment"), "PNG");
    double total[3] = {}, count[3] = {}; // of the paths in the view from above, in thirds of its width
    for (int y = 0; y < image.height(); ++y)
        for (int x = image.width() / 10; x < image.width() * 4 / 10; ++x)
            if (const QColor color = image.pixelColor(x, y); color.hsvSaturation() > 140) {
                const int third = (x - image.width() / 10) * 10 / image.width();
                total[third] += qGray(color.rgb());
                ++count[third];
            }
    for (const double each : count)
        ASSERT_GT(each, 100);
    EXPECT_LT(total[0] / count[0] + 10.0, total[1] / count[1]);
    EXPECT_LT(total[1] / count[1] + 10.0, total[2] / count[2]);
    const QString svg = QString::fromUtf8(pathsPicture(figure, FigureFormat::Svg, "comment"));
    for (const char* name : {"alpha", "bravo"})
        EXPECT_EQ(svg.count(name), 2 + 1) << name << " at its start in both views, and in the legend";
}

/// A flat rectangle across the box at x = const or z = const.
FigureSurface sheet(const QColor& color, int axis, double at) {
    FigureSurface surface;
    surface.name = "sheet";
    surface.color = color;
    const int n = 20;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            Eigen::Vector3d point;
            point[axis] = at;
            point[(axis + 1) % 3] = static_cast<double>(i) / n;
            point[(axis + 2) % 3] = static_cast<double>(j) / n;
            surface.points.push_back(point);
            surface.normals.push_back(Eigen::Vector3d::Unit(axis));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            surface.triangles.push_back({a, a + 1, a + n + 2});
            surface.triangles.push_back({a, a + n + 2, a + n + 1});
        }
    return surface;
}

int redAbove(const QImage& image, const QColor& c) {
    return spotOf(image, [&](const QColor& p) { return p.red() > p.blue() + 60 && c.isValid(); }).count;
}

// Catches: surfaces behind that cover what is in front of them, the wrong quarter cut away.
TEST(SurfacesPng, WhatIsNearerCoversWhatIsFarther) {
    SurfacePanel panel;
    panel.title = "panel";
    panel.axes = {"x", "y", "z"};
    panel.tick = 0.5;
    const auto reds = [&](double red, double blue) {
        panel.surfaces = {sheet(Qt::blue, 2, blue), sheet(Qt::red, 2, red)};
        const QImage image = QImage::fromData(surfacesPng({"t", "n", {panel}, 1}, "c"), "PNG");
        return redAbove(image.copy(0, 0, image.width(), image.height() * 4 / 5), Qt::red);
    };
    // From above the upper sheet is the nearer one.
    EXPECT_GT(reds(0.55, 0.45), 1.5 * reds(0.45, 0.55));
    const auto spot = [&](double x) {
        panel.surfaces = {sheet(Qt::red, 0, x)};
        const QImage image = QImage::fromData(surfacesPng({"t", "n", {panel}, 1}, "c"), "PNG");
        return redAbove(image.copy(0, 0, image.width(), image.height() * 4 / 5), Qt::red);
    };
    EXPECT_NEAR(spot(0.75), 0.5 * spot(0.25), 0.05 * spot(0.25)) << "half of the nearer sheet is cut away";
}

// Catches: a box that runs out of the picture, words that are cut off at its border.
TEST(SurfacesPng, KeepsClearOfTheBorder) {
    SurfacePanel panel;
    panel.title = "panel";
    panel.axes = {"x (cm)", "y (cm)", "z (cm)"};
    panel.lower = {-20.0, -20.0, 0.0};
    panel.upper = {20.0, 20.0, 30.0};
    panel.tick = 10.0;
    panel.surfaces = {sheet(Qt::red, 2, 0.5)};
    const QImage image = QImage::fromData(surfacesPng({"t", "n", {panel}, 1}, "c"), "PNG");
    ASSERT_EQ(image.size(), QSize(900, 96 + 820));
    for (int y = 0; y < image.height(); ++y)
        for (const int x : {0, 1, image.width() - 2, image.width() - 1})
            ASSERT_EQ(image.pixelColor(x, y), QColor(Qt::white)) << x << ", " << y;
}

} // namespace
} // namespace bask::test
