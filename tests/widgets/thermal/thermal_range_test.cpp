// Limits of colours and histograms, and the colours themselves.

#include "widgets/thermal/thermal_colours.h"

#include "tests/widgets/thermal/thermal_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

/// CIE 1976 lightness.
double lightnessOf(QRgb rgb) {
    const auto linear = [](int channel) {
        const double value = channel / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    const double Y = 0.2126 * linear(qRed(rgb)) + 0.7152 * linear(qGreen(rgb)) + 0.0722 * linear(qBlue(rgb));
    return Y > 0.008856 ? 116.0 * std::cbrt(Y) - 16.0 : 903.3 * Y;
}

int apart(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

// Catches percentiles of the wrong rank, and limits set by pixels that tell nothing.
TEST(ThermalRange, LeavesOutHalfAPercentAtEitherEnd) {
    ThermalPicture picture{100, 10, {}};
    for (int k = 0; k < 1000; ++k)
        picture.T_K.push_back(300.0 + 0.1 * k);
    std::ranges::shuffle(picture.T_K, std::mt19937(1));
    const auto range = rangeOfPicture(picture);
    ASSERT_TRUE(range);
    EXPECT_NEAR(range->min_K, 300.4, 1e-9); // the fifth of 1000
    EXPECT_NEAR(range->max_K, 399.5, 1e-9);
    picture.T_K.assign(1000, test::kNaN);
    EXPECT_FALSE(rangeOfPicture(picture));
    picture.T_K[3] = 310.0;
    picture.T_K[4] = test::kInfinity;
    EXPECT_EQ(rangeOfPicture(picture), (ThermalRange{309.0, 311.0})) << "two kelvin at least";
}

TEST(ThermalRange, OfObjectsIsThatOfTheirPixels) {
    ThermalView view;
    view.picture = std::make_shared<ThermalPicture>(
        ThermalPicture{3, 2, {300.0, 310.0, 320.0, test::kNaN, 500.0, 305.0}});
    EXPECT_FALSE(rangeOfObjects(view));
    view.objects.resize(2);
    view.objects[0].pixels = {1, 2, 3, 77, -1}; // the last two are in no picture
    view.objects[1].pixels = {5};
    const auto range = rangeOfObjects(view);
    ASSERT_TRUE(range);
    EXPECT_NEAR(range->min_K, 303.5, 1e-9);
    EXPECT_NEAR(range->max_K, 321.5, 1e-9);
}

// Catches colours that flicker with the noise, and limits that never follow.
TEST(ThermalRange, StaysWhileItChangesLittle) {
    const ThermalRange shown{300.0, 320.0};
    EXPECT_EQ(steadied({300.5, 319.6}, shown), shown);
    EXPECT_EQ(steadied({301.0, 320.0}, shown), (ThermalRange{301.0, 320.0}));
    EXPECT_EQ(steadied({301.0, 320.0}, std::nullopt), (ThermalRange{301.0, 320.0}));
}

TEST(ThermalHistogram, CountsEveryPixelOnce) {
    std::vector<double> pixels_K(5000);
    std::mt19937 random(3);
    std::normal_distribution<double> normal(312.0, 0.4);
    std::ranges::generate(pixels_K, [&] { return normal(random); });
    const auto histogram = thermalHistogram(pixels_K);
    ASSERT_TRUE(histogram);
    int sum = 0;
    for (const int count : histogram->counts)
        sum += count;
    EXPECT_EQ(sum, 5000);
    EXPECT_EQ(histogram->pixels, 5000);
    EXPECT_NEAR(histogram->bin_K, 0.1, 1e-12) << "round, in kelvin";
    EXPECT_NEAR(histogram->mean_K, 312.0, 0.02);
    EXPECT_NEAR(histogram->deviation_K, 0.4, 0.01);
    const auto most = std::ranges::max_element(histogram->counts) - histogram->counts.begin();
    EXPECT_NEAR(histogram->from_K + (static_cast<double>(most) + 0.5) * histogram->bin_K, 312.0, 0.2);
    EXPECT_FALSE(thermalHistogram({}));
    const auto one = thermalHistogram({300.0, 300.0});
    ASSERT_TRUE(one);
    EXPECT_EQ(one->deviation_K, 0.0);
    EXPECT_EQ(*std::ranges::max_element(one->counts), 2);
}

// Catches a palette in which equal steps of temperature do not look equal.
TEST(ThermalColours, GetLighterInEvenSteps) {
    for (const ThermalPalette palette : {ThermalPalette::Inferno, ThermalPalette::Grey})
        for (int k = 1; k <= 20; ++k) {
            const double step =
                lightnessOf(thermalRgb(k / 20.0, palette)) - lightnessOf(thermalRgb((k - 1) / 20.0, palette));
            EXPECT_NEAR(step, 4.85, 2.2) << k;
        }
    EXPECT_LT(apart(thermalRgb(0.5, ThermalPalette::Inferno), 0xffbc3754), 12) << "matplotlib's";
    EXPECT_EQ(thermalRgb(-3.0, ThermalPalette::Inferno), thermalRgb(0.0, ThermalPalette::Inferno));
    EXPECT_EQ(thermalRgb(7.0, ThermalPalette::Grey), thermalRgb(1.0, ThermalPalette::Grey));
}

// Catches a marked pixel that could be a temperature.
TEST(ThermalColours, MarksAreInNeitherPalette) {
    for (const ThermalPalette palette : {ThermalPalette::Inferno, ThermalPalette::Grey})
        for (int k = 0; k <= 100; ++k)
            for (const QRgb mark : {kIsothermRgb, kSaturatedRgb, kBelowRgb})
                EXPECT_GT(apart(mark, thermalRgb(k / 100.0, palette)), 100) << k;
}

TEST(ThermalColours, PicturesShowEachPixelByItsValue) {
    const ThermalPicture picture{3, 2, {300.0, 310.0, test::kInfinity, -test::kInfinity, test::kNaN, 305.0}};
    ThermalLook look{ThermalPalette::Grey, {300.0, 310.0}, {}};
    const ThermalImage plain = thermalImage(picture, look);
    EXPECT_EQ(plain.image.pixel(0, 0), thermalRgb(0.0, ThermalPalette::Grey));
    EXPECT_EQ(plain.image.pixel(1, 0), thermalRgb(1.0, ThermalPalette::Grey));
    EXPECT_EQ(plain.image.pixel(2, 0), kSaturatedRgb);
    EXPECT_EQ(plain.image.pixel(0, 1), kBelowRgb);
    EXPECT_EQ(plain.image.pixel(1, 1), kNoValueRgbs[0]);
    EXPECT_EQ(plain.image.pixel(2, 1), thermalRgb(305.0, look));
    EXPECT_TRUE(plain.saturated == 1 && plain.below == 1 && plain.withoutValue == 1);
    look.isotherm = Isotherm{305.0};
    EXPECT_EQ(thermalImage(picture, look).image.pixel(1, 0), kIsothermRgb);
    EXPECT_NE(thermalImage(picture, look).image.pixel(2, 1), kIsothermRgb) << "not above";
    EXPECT_EQ(thermalImage(picture, look).image.pixel(2, 0), kSaturatedRgb);
    look.isotherm->halfBand_K = 0.5;
    EXPECT_NE(thermalImage(picture, look).image.pixel(1, 0), kIsothermRgb);
    EXPECT_EQ(thermalImage(picture, look).image.pixel(2, 1), kIsothermRgb);
}

} // namespace
} // namespace bask
