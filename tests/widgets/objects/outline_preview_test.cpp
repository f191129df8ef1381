#include "widgets/objects/outline_preview.h"

#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QImage>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bask {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Points ring(int n, double radius_m, double wave_m = 0.0) {
    Points points;
    for (int k = 0; k < n; ++k) {
        const double t = 2.0 * std::numbers::pi * k / n, r = radius_m + wave_m * std::cos(7.0 * t);
        points.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    return points;
}

FourierFit circle(double radius_m) {
    FourierFit fit;
    fit.contour = FourierContour({0.0, 0.0, radius_m});
    return fit;
}

/// The drawing alone, without legend, colour bar, scale and size.
QImage drawing(OutlinePreview& preview) {
    preview.resize(520, 460);
    return preview.grab().toImage().copy(20, 90, 410, 320);
}

int count(const QImage& picture, const QColor& color) {
    int found = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            found += std::abs(pixel.red() - color.red()) + std::abs(pixel.green() - color.green()) +
                         std::abs(pixel.blue() - color.blue()) <
                     24;
        }
    return found;
}

// Catches colours in the wrong order or place, and one that vanishes into the ground.
TEST(OutlinePreview, ColoursTheRawOutlineByItsDistance) {
    const FourierFit fit = circle(0.03);
    const Points raw = ring(400, 0.036);
    std::vector<double> distances_m;
    for (const auto& p : raw)
        distances_m.push_back(p.x() < 0.0 ? 0.0 : 0.006);
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        OutlinePreview preview;
        preview.setObject("ring", fit.contour, {raw}, seriesColor(0, dark));
        const QColor near = mapColour(dark ? 0.016 : 0.984, dark),
                     far = mapColour(dark ? 0.984 : 0.016, dark);
        EXPECT_EQ(count(drawing(preview), far), 0) << "no distances yet";
        preview.setDistances(fit, raw, distances_m);
        const QImage picture = drawing(preview);
        const QImage left = picture.copy(0, 0, 150, 320), right = picture.copy(260, 0, 150, 320);
        EXPECT_GT(count(left, near), 300) << dark;
        EXPECT_EQ(count(left, far), 0) << dark;
        EXPECT_GT(count(right, far), 300) << dark;
        EXPECT_EQ(count(right, near), 0) << dark;
        EXPECT_TRUE(preview.accessibleDescription().contains("6.000 mm from"));
    }
    applyTheme(*qApp, Theme::Light);
}

// Catches an outline coloured by its distances from a curve that is not shown.
TEST(OutlinePreview, TakesNoDistancesOfAnotherCurve) {
    const Points raw = ring(400, 0.036);
    OutlinePreview preview;
    preview.setObject("ring", circle(0.03).contour, {raw}, Qt::blue);
    const QImage before = drawing(preview);
    preview.setDistances(circle(0.031), raw, std::vector<double>(raw.size(), 0.005));
    EXPECT_EQ(drawing(preview), before);
    preview.setObject("disk", Disk{0.03}, {}, Qt::blue);
    preview.setDistances(circle(0.03), raw, std::vector<double>(raw.size(), 0.006));
    EXPECT_FALSE(preview.accessibleDescription().contains("Fourier"));
}

// Catches points left out that can be seen, and colours lost with the points that are.
TEST(OutlinePreview, ManyPointsDrawTheSamePicture) {
    const FourierFit fit = circle(0.03);
    const auto picture = [&](int n) {
        const Points raw = ring(n, 0.032, 0.002);
        std::vector<double> distances_m;
        for (const auto& p : raw)
            distances_m.push_back(p.norm() - 0.03);
        OutlinePreview preview;
        preview.setObject("ring", fit.contour, {raw}, Qt::blue);
        preview.setDistances(fit, raw, distances_m);
        return drawing(preview);
    };
    const QImage few = picture(1500), many = picture(60000);
    int differ = 0;
    for (int y = 0; y < few.height(); ++y)
        for (int x = 0; x < few.width(); ++x)
            differ += std::abs(qGray(few.pixel(x, y)) - qGray(many.pixel(x, y))) > 60;
    EXPECT_LT(differ, 60);
}

// Catches radii in the wrong unit or order.
TEST(OutlinePreview, TellsThePrincipalAxes) {
    OutlinePreview preview;
    preview.setObject("bar", Contour{{{-0.01, -0.03}, {0.01, -0.03}, {0.01, 0.03}, {-0.01, 0.03}}}, {},
                      Qt::blue);
    EXPECT_TRUE(preview.accessibleDescription().contains("radii of gyration 17.3 mm and 5.8 mm"))
        << preview.accessibleDescription().toStdString();
}

} // namespace
} // namespace bask
