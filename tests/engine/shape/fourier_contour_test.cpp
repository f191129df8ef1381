// The descriptor series and its fit, against closed forms and against figures computed by another program.

#include "engine/base/message_code.h"
#include "engine/shape/fourier_contour.h"

#include "engine/shape/winding.h"

#include "engine/shape/contour_import.h"
#include "tests/engine/shape/shape_samples.h"

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

Contour example(const std::string& name) {
    return readContourCsv(test::examplePath(name), std::nullopt).value();
}

TEST(FourierContour, EvaluatesAnEllipse) {
    const double a = 3.0, b = 2.0; // z = (a+b)/2 e^{it} + (a-b)/2 e^{-it}
    const FourierContour ellipse({(a - b) / 2, Complex(0.5, -0.25), (a + b) / 2});
    EXPECT_NEAR(
        std::abs(ellipse.point(0.125) - Complex(0.5 + a * std::sqrt(0.5), -0.25 + b * std::sqrt(0.5))), 0,
        1e-14);
    EXPECT_NEAR(std::abs(ellipse.derivative(0.25) - Complex(-2 * kPi * a, 0.0)), 0.0, 1e-13);
    EXPECT_NEAR(ellipse.area(), kPi * a * b, 1e-13);
    EXPECT_NEAR(ellipse.perimeter(), 15.865439589290589, 1e-8); // 4 a E(sqrt(1 - b^2/a^2))
    EXPECT_NEAR(std::abs(ellipse.centroid() - Complex(0.5, -0.25)), 0.0, 1e-13);
    EXPECT_EQ(ellipse.harmonics(), 1);
    EXPECT_THROW(ellipse.coefficient(2), std::out_of_range);
    EXPECT_THROW(FourierContour({1.0, 2.0}), std::invalid_argument);
}

TEST(FourierContour, CentroidIsThatOfTheAreaItEncloses) {
    const FourierContour egg({0.05, Complex(0.02, 0.1), Complex(0.3, -0.2), 1.0, Complex(0.1, 0.15)});
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k < 20000; ++k)
        points.emplace_back(egg.point(k / 20000.0).real(), egg.point(k / 20000.0).imag());
    const Contour polygon = *makeContour(points);
    EXPECT_NEAR(egg.area(), contourArea(polygon), 1e-6);
    EXPECT_NEAR(egg.perimeter(), contourPerimeter(polygon), 1e-6);
    EXPECT_NEAR(egg.centroid().real(), contourCentroid(polygon).x(), 1e-6);
    EXPECT_NEAR(egg.centroid().imag(), contourCentroid(polygon).y(), 1e-6);
}

TEST(FitFourier, CircleIsOneHarmonic) {
    const auto fit = fitFourier(*makeContour(test::ellipse(0.015, 0.015, 5000, {0.3, -0.2})), 5);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(std::abs(fit->contour.coefficient(1)), 0.015, 1e-8);
    for (const int j : {-5, -4, -3, -2, -1, 0, 2, 3, 4, 5})
        EXPECT_NEAR(std::abs(fit->contour.coefficient(j)), 0.0, 1e-12) << j;
    EXPECT_LT(fit->rms_m, 2e-8);
    EXPECT_FALSE(fit->crossesItself);
}

TEST(FitFourier, SquareHasItsClosedForm) {
    // Side 2: by the fourfold symmetry only j = 1 + 4m is not zero, and |c_j| = 16 |sin(pi j/4)| / (pi j)^2.
    const auto fit = fitFourier(*makeContour({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}), 9);
    ASSERT_TRUE(fit);
    for (int j = -9; j <= 9; ++j) {
        const double expected =
            (j - 1) % 4 != 0 ? 0.0 : 16.0 * std::abs(std::sin(kPi * j / 4)) / (kPi * kPi * j * j);
        EXPECT_NEAR(std::abs(fit->contour.coefficient(j)), expected, 1e-14) << j;
    }
}

TEST(FitFourier, ClockwiseInputGivesTheSameCurve) {
    auto points = example("bunny_mm.csv").points_m;
    const auto forward = fitFourier(*makeContour(points), 8);
    std::ranges::reverse(points);
    const auto backward = fitFourier(*makeContour(points), 8);
    EXPECT_NEAR(forward->contour.area(), backward->contour.area(), 1e-15);
    EXPECT_GT(backward->contour.area(), 0.0);
    EXPECT_NEAR(forward->rms_m, backward->rms_m, 1e-9);
    for (int j = -8; j <= 8; ++j)
        EXPECT_NEAR(std::abs(forward->contour.coefficient(j)), std::abs(backward->contour.coefficient(j)),
                    1e-12);
}

TEST(FitFourier, MoreHarmonicsNeverFitWorseAndOnlyAddTerms) {
    const Contour hand = example("hand_mm.csv");
    double previous = 1.0;
    std::vector<double> first;
    for (int h = 1; h <= kMaxHarmonics; ++h) {
        const auto fit = fitFourier(hand, h);
        ASSERT_TRUE(fit);
        EXPECT_LT(fit->rms_m, previous);
        EXPECT_GE(fit->max_m, fit->rms_m);
        EXPECT_NEAR(std::abs(fit->contour.centroid()), 0.0, 1e-13);
        previous = fit->rms_m;
        first.push_back(std::abs(fit->contour.coefficient(1)));
        EXPECT_NEAR(first.back(), first.front(), 1e-15);
    }
}

TEST(FitFourier, LeastSquaresMeansNoCoefficientCanBeImproved) {
    // Parseval: what is left of the mean square is what the coefficients left out hold.
    const Contour hand = example("hand_mm.csv");
    const auto few = fitFourier(hand, 6), many = fitFourier(hand, 7);
    const double step = std::norm(many->contour.coefficient(7)) + std::norm(many->contour.coefficient(-7));
    EXPECT_NEAR(few->rms_m * few->rms_m - many->rms_m * many->rms_m, step, 1e-5 * step);
}

struct Row {
    int harmonics;
    double rms_mm, max_mm, area_mm2;
};

// Computed with pyefd (elliptic Fourier descriptors by arc length) and an FFT of 131072 points; the maximum
// was taken over 4096 points, which miss the corners, so it may only be exceeded: by 2 % at most, and 4 %
// with the 30 harmonics that reach into corners.
void expectRows(const Contour& outline, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        const auto fit = fitFourier(outline, row.harmonics);
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->rms_m * 1e3, row.rms_mm, 1e-4 * row.rms_mm) << row.harmonics;
        EXPECT_GT(fit->max_m * 1e3, row.max_mm * (1 - 1e-4)) << row.harmonics;
        EXPECT_LT(fit->max_m * 1e3, row.max_mm * (row.harmonics < 30 ? 1.02 : 1.04)) << row.harmonics;
        EXPECT_NEAR(fit->contour.area() * 1e6, row.area_mm2, 1e-3) << row.harmonics;
    }
}

TEST(FitFourier, BunnyReachesTheFiguresOfAnotherProgram) {
    expectRows(example("bunny_mm.csv"), {{1, 9.87495, 21.74182, 2566.4259},
                                         {2, 5.91528, 13.57684, 2833.2965},
                                         {3, 4.08993, 10.41515, 2918.5881},
                                         {5, 2.49189, 5.92367, 2851.1269},
                                         {8, 1.38249, 4.03093, 2896.0112},
                                         {10, 0.97564, 2.76911, 2875.9456},
                                         {15, 0.47444, 1.50462, 2892.2326},
                                         {20, 0.23396, 0.86287, 2893.4153},
                                         {30, 0.121, 0.66263, 2894.2132}});
}

TEST(FitFourier, HandReachesTheFiguresOfAnotherProgram) {
    expectRows(example("hand_mm.csv"), {{1, 13.11162, 24.08796, 1875.1002},
                                        {2, 9.42107, 17.45631, 2292.7414},
                                        {3, 8.53847, 17.241, 2389.4907},
                                        {5, 5.33114, 10.79609, 1981.5113},
                                        {8, 1.6727, 3.16657, 2283.2445},
                                        {10, 1.20592, 2.81108, 2299.6656},
                                        {15, 0.81081, 2.25355, 2313.8867},
                                        {20, 0.44885, 1.14131, 2325.2278},
                                        {30, 0.19424, 0.6743, 2328.1914}});
}

TEST(FitFourier, SaysWhenTheTruncatedCurveCrossesItself) {
    // Five harmonics turn the hand's finger tips into small loops; four and six do not.
    const Contour hand = example("hand_mm.csv");
    EXPECT_FALSE(fitFourier(hand, 4)->crossesItself);
    EXPECT_TRUE(fitFourier(hand, 5)->crossesItself);
    EXPECT_FALSE(fitFourier(hand, 6)->crossesItself);
}

FourierContour series(std::vector<std::pair<int, std::complex<double>>> terms) {
    int harmonics = 1;
    for (const auto& [j, value] : terms)
        harmonics = std::max(harmonics, std::abs(j));
    std::vector<std::complex<double>> coefficients(static_cast<std::size_t>(2 * harmonics + 1));
    for (const auto& [j, value] : terms)
        coefficients[static_cast<std::size_t>(j + harmonics)] = value;
    return FourierContour(coefficients);
}

// Catches: a circle traced twice, or a limacon's inner loop, taken for an outline whose ends overlap a
// little.
TEST(UnevenShare, isTheShareThatIsNotGoneRoundOnce) {
    const auto share = [](std::initializer_list<std::complex<double>> c) {
        return unevenShare(FourierContour(std::vector<std::complex<double>>(c)));
    };
    EXPECT_EQ(share({0.0, 0.0, 0.1}), 0.0);                    // a circle
    EXPECT_EQ(share({0.1, 0.0, 0.0}), 1.0);                    // clockwise
    EXPECT_NEAR(share({0.0, 0.0, 0.0, 0.0, 0.1}), 1.0, 1e-4);  // twice round
    EXPECT_NEAR(share({0.0, 0.0, 0.0, 0.02, 0.1}), 0.6, 0.01); // a limacon with a large inner loop
    EXPECT_EQ(share({0.0, 0.0, 0.0, 0.1, 0.02}), 0.0);         // one without
}

// Catches a curve traced twice, loops and a figure of eight taken for simple outlines.
TEST(FindCrossing, FindsLoopsLapsAndEights) {
    EXPECT_TRUE(findCrossing(series({{2, 0.1}})));
    EXPECT_TRUE(findCrossing(series({{39, 0.1}})));
    EXPECT_TRUE(findCrossing(series({{1, 0.1}, {2, 0.2}})));
    EXPECT_TRUE(findCrossing(series({{1, 0.6}, {-1, 0.4}, {2, 0.5}, {-2, -0.5}})));
    // z = exp(i t) + a exp(-2 i t) has cusps at a = 1/2 and loops beyond it.
    EXPECT_TRUE(findCrossing(series({{1, 0.1}, {-2, 0.05 * 1.0001}})));
    // The place is told where the curve is, far from the origin too.
    const auto place = findCrossing(series({{0, {7.0, -3.0}}, {1, 0.1}, {2, 0.2}}));
    ASSERT_TRUE(place);
    EXPECT_LT((*place - Eigen::Vector2d(7.0, -3.0)).norm(), 0.31);
}

// Catches outlines refused because they come close to themselves.
TEST(FindCrossing, LeavesSimpleCurvesAlone) {
    EXPECT_FALSE(findCrossing(series({{1, 0.1}})));
    EXPECT_FALSE(findCrossing(series({{0, {1e5, -1e5}}, {1, {0.0, 1e-9}}})));
    EXPECT_FALSE(findCrossing(series({{1, 0.1}, {40, 0.1 / 1700.0}})));
    EXPECT_FALSE(findCrossing(series({{1, 0.1}, {-2, 0.05 * 0.9999}}))) << "all but cusps";
    EXPECT_FALSE(findCrossing(series({{1, 0.1}, {-1, 0.0999999}}))) << "a sliver";
    // Pinched at x = 0 down to a neck of 2e-7 of the length:
    const double neck = 1e-7;
    // x = cos t, y = neck sin t + sin t cos^2 t = (neck + 1/4) sin t + 1/4 sin 3t
    const double one = 0.5 * (neck + 0.25), three = 0.125;
    EXPECT_FALSE(findCrossing(series({{1, 0.5 + one}, {-1, 0.5 - one}, {3, three}, {-3, -three}})));
    Contour hand = example("hand_mm.csv");
    for (const int h : {4, 6, 8, 20, 40})
        EXPECT_FALSE(findCrossing(fitFourier(hand, h)->contour)) << h;
}

// Catches a distance that follows the arc length, or one way only: brute force over points of both curves.
TEST(FitFourier, TellsTheHausdorffDistanceAndTheAreaError) {
    const Contour bunny = example("bunny_mm.csv");
    for (const int h : {3, 10, 20}) {
        const auto fit = fitFourier(bunny, h);
        test::Points series, outline;
        for (int k = 0; k < 3000; ++k) {
            const Complex z = fit->contour.point(k / 3000.0);
            series.push_back(fit->centre_m + Eigen::Vector2d(z.real(), z.imag()));
        }
        for (std::size_t k = 0; k < bunny.points_m.size(); ++k)
            for (int s = 0; s < 20; ++s)
                outline.push_back(bunny.points_m[k] +
                                  s / 20.0 *
                                      (bunny.points_m[(k + 1) % bunny.points_m.size()] - bunny.points_m[k]));
        double max = 0.0;
        for (const auto& [from, to] : {std::pair(series, outline), std::pair(outline, series)})
            for (const auto& p : from) {
                double min = 1.0;
                for (const auto& q : to)
                    min = std::min(min, (p - q).norm());
                max = std::max(max, min);
            }
        EXPECT_NEAR(fit->hausdorff_m, max, 2e-5) << h;
        EXPECT_LE(fit->hausdorff_m, fit->max_m + 1e-6);
        EXPECT_NEAR(fit->areaError, fit->contour.area() / contourArea(bunny) - 1.0, 1e-12);
    }
}

// Catches distances at equal arc length, and a curve left in its own frame: brute force over the curve.
TEST(FitFourier, DistancesAreThoseToTheCurveInTheOutlinesFrame) {
    const Contour bunny = example("bunny_mm.csv"); // its centroid is not at the origin
    for (const int h : {3, 20}) {
        const auto fit = fitFourier(bunny, h);
        const auto points = pointsAlong(bunny, 1e-3);
        const std::vector<double> distances = distancesTo(*fit, points);
        ASSERT_EQ(distances.size(), points.size());
        for (std::size_t k = 0; k < points.size(); k += 7) {
            double min = 1.0;
            for (int s = 0; s < 20000; ++s) {
                const Complex z = fit->contour.point(s / 20000.0);
                min = std::min(min, (points[k] - fit->centre_m - Eigen::Vector2d(z.real(), z.imag())).norm());
            }
            EXPECT_NEAR(distances[k], min, 8e-6) << h; // points 14 um apart stand for the curve
        }
        EXPECT_LE(*std::ranges::max_element(distances), fit->hausdorff_m + 1e-6);
    }
}

// Catches more harmonics than are needed, fewer than that, and a curve with loops taken for a fit.
TEST(FitFourierWithin, TakesTheFewestHarmonicsThatDo) {
    const Contour hand = example("hand_mm.csv");
    for (const double tolerance_m : {20e-3, 8e-3, 5e-3, 1e-3, 0.5e-3}) {
        const auto found = fitFourierWithin(hand, tolerance_m);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_LE(found->hausdorff_m, tolerance_m);
        EXPECT_FALSE(found->crossesItself);
        for (int h = 1; h < found->contour.harmonics(); ++h) {
            const auto fewer = fitFourier(hand, h);
            EXPECT_TRUE(fewer->hausdorff_m > tolerance_m || fewer->crossesItself) << h;
        }
    }
    EXPECT_EQ(fitFourierWithin(hand, 1e-6).error().code(), MessageCode::ToleranceUnreachable);
    for (const double tolerance_m : {0.0, -1.0, std::nan("")})
        EXPECT_EQ(fitFourierWithin(hand, tolerance_m).error().code(), MessageCode::ValueNotPositive);
}

TEST(FitFourier, RefusesHarmonicsOutOfRange) {
    const Contour square = *makeContour({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    for (const int h : {-1, 0, kMaxHarmonics + 1})
        EXPECT_EQ(fitFourier(square, h).error().code(), MessageCode::HarmonicsOutOfRange) << h;
    EXPECT_TRUE(fitFourier(square, 1));
    EXPECT_TRUE(fitFourier(square, kMaxHarmonics));
    EXPECT_EQ(fitFourier(Contour{}, 5).error().code(), MessageCode::ContourTooFewPoints);
}

} // namespace
} // namespace bask
