#include "engine/radiation/paper_methods.h"

#include "engine/radiation/view_factor.h"
#include "tests/engine/radiation/random_poses.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

using test::Draw;

constexpr double kDegree = std::numbers::pi / 180.0;

Pose poseAt(double x, double y, double z, double rx = 0.0) {
    return poseFromRotationVector({x, y, z}, {rx, 0.0, 0.0});
}

FourierContour mirrored(const FourierContour& contour) {
    std::vector<std::complex<double>> c = contour.coefficients();
    for (std::complex<double>& one : c)
        one = std::conj(one);
    return FourierContour(c);
}

double exact(const Shape& source, const Shape& object, const Pose& X_SO) {
    return viewFactor(RadiatingContour(source), RadiatingContour(object), X_SO, {1e-13}).value;
}

// Catches: a wrong weight, area or cosine of the surface integral, and of its visibility under either cut.
// Its error goes as n^(-3/4): the area of a staircase's squares is off by a random number of its edge
// squares.
TEST(SurfaceIntegral, convergesAsAStaircaseDoes) {
    const Disk source{0.15}, object{0.015};
    for (const Pose& X_SO : {poseAt(0.04, 0.03, 0.05), poseAt(0.03, -0.02, 0.08, 40 * kDegree),
                             poseAt(0.0, -0.19, 0.005, 60 * kDegree)}) {
        const double value = exact(source, object, X_SO);
        // The mean over neighbouring n; single values jump about.
        const auto meanError = [&](int n) {
            double sum = 0.0;
            for (int k = 0; k < 12; ++k)
                sum += std::abs(discreteSurfaceIntegral(source, object, X_SO, n + n * k / 24) - value);
            return sum / 12.0;
        };
        const double coarse = meanError(100), fine = meanError(1600);
        EXPECT_LT(fine, 6e-3);
        const double order = std::log(coarse / fine) / std::log(16.0);
        EXPECT_GT(order, 0.5) << coarse << ' ' << fine;
        EXPECT_LT(order, 1.3) << coarse << ' ' << fine;
    }
}

// Catches: an outline with bays filled in or cut off at its corners.
TEST(SurfaceIntegral, meetsTheSolverOnAPolygonWithBays) {
    const Contour bracket{
        {{-0.03, -0.03}, {0.03, -0.03}, {0.03, -0.01}, {-0.01, -0.01}, {-0.01, 0.03}, {-0.03, 0.03}}};
    const Pose X_SO = poseAt(0.05, 0.0, 0.06, 0.3);
    EXPECT_NEAR(discreteSurfaceIntegral(Disk{0.1}, bracket, X_SO, 3000), exact(Disk{0.1}, bracket, X_SO),
                2e-3);
}

// Catches: a wrong sign, weight or area of the double contour integral: the 15-digit values, source whole and
// cut, and Fourier contours on both sides.
TEST(SimpsonContours, meetTheKnownValues) {
    const Disk source{0.15}, object{0.015};
    EXPECT_NEAR(simpsonViewFactor(source, object, poseAt(0, 0, 0.05), 128), 0.89918413173929207, 1e-12);
    EXPECT_NEAR(simpsonViewFactor(source, object, poseAt(0.04, 0.03, 0.05), 128), 0.87832723802998868, 1e-12);
    EXPECT_NEAR(simpsonViewFactor(source, object, poseAt(0.03, -0.02, 0.08, 40 * kDegree), 512),
                0.61353047145569561, 1e-9);
    EXPECT_NEAR(simpsonViewFactor(source, object, poseAt(0, 0, 0.05, 80 * kDegree), 512), 0.38333986486825526,
                1e-9);
    Draw draw(31);
    const FourierContour wavy = draw.fourier(0.08, 0.2), small = draw.fourier(0.02, 0.2);
    const Pose X_SO = poseAt(0.03, 0.01, 0.06, 0.2);
    const Pose flip = poseAt(0, 0, 0, std::numbers::pi);
    // Reciprocity: the faces change places and are seen from behind.
    const double there = simpsonViewFactor(wavy, small, X_SO, 256);
    const double back = simpsonViewFactor(mirrored(small), mirrored(wavy), flip * X_SO.inverse() * flip, 256);
    EXPECT_NEAR(there * small.area(), back * wavy.area(), 1e-13);
    EXPECT_NEAR(discreteSurfaceIntegral(wavy, small, X_SO, 2500), there, 5e-3);
    EXPECT_NEAR(simpsonViewFactor(Disk{0.08}, small, X_SO, 256), exact(Disk{0.08}, small, X_SO), 1e-11);
}

// Catches: a rule other than composite Simpson. On whole smooth contours it converges exponentially, like the
// trapezoidal rule with half of the points; on arc and chord with order 4.
TEST(SimpsonContours, convergeAsPredicted) {
    const Disk source{0.15}, object{0.015};
    const auto error = [&](const Pose& X_SO, int n) {
        return std::abs(simpsonViewFactor(source, object, X_SO, n) - exact(source, object, X_SO));
    };
    const Pose whole = poseAt(0.04, 0.03, 0.05);
    EXPECT_LT(error(whole, 64), error(whole, 32) / 60.0);
    EXPECT_LT(error(whole, 128), 1e-14);
    const Pose cut = poseAt(0.03, -0.02, 0.08, 40 * kDegree);
    const double order = std::log2(error(cut, 64) / error(cut, 128));
    EXPECT_NEAR(order, 4.0, 0.3);
}

// Catches: numbers where the paper has no formula.
TEST(SimpsonContours, refuseWhatThePaperDoesNotTreat) {
    const Contour square{{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}}};
    const FourierContour circle({0.0, 0.0, 0.1});
    EXPECT_THROW(simpsonViewFactor(Disk{0.1}, square, poseAt(0, 0, 0.1), 64), std::invalid_argument);
    EXPECT_THROW(simpsonViewFactor(square, Disk{0.1}, poseAt(0, 0, 0.1), 64), std::invalid_argument);
    EXPECT_THROW(simpsonViewFactor(Disk{0.1}, Disk{0.1}, poseAt(0, 0, 0.1), 63), std::invalid_argument);
    EXPECT_THROW(simpsonViewFactor(circle, Disk{0.01}, poseAt(0, 0, 0.05, 80 * kDegree), 64),
                 std::invalid_argument);
    EXPECT_THROW(discreteSurfaceIntegral(Disk{0.1}, Disk{0.1}, poseAt(0, 0, 0.1), 0), std::invalid_argument);
    EXPECT_THROW(discreteSurfaceIntegral(Disk{0.1}, Disk{0.1}, poseAt(0, 0, 0.1), 1), std::invalid_argument);
    // Turned away: nothing of the source is in front.
    EXPECT_EQ(simpsonViewFactor(Disk{0.1}, Disk{0.01}, poseAt(0, 0, 0.1, 180 * kDegree), 64), 0.0);
    EXPECT_EQ(simpsonViewFactor(circle, Disk{0.01}, poseAt(0, 0, 0.1, 180 * kDegree), 64), 0.0);
}

} // namespace
} // namespace bask
