// Measures of the three shapes.

#include "engine/base/message_code.h"
#include "engine/shape/shape.h"

#include "tests/engine/shape/shape_samples.h"
#include "tests/support/thread_time.h"

#include <stdexcept>
#include <utility>

namespace bask {
namespace {

TEST(Shape, DiskAndItsSeriesAgree) {
    const Shape disk = Disk{0.015}, series = FourierContour({0.0, 0.0, 0.015});
    for (const Shape& shape : {disk, series}) {
        EXPECT_NEAR(shapeArea(shape), std::numbers::pi * 0.015 * 0.015, 1e-15);
        EXPECT_NEAR(shapePerimeter(shape), 2 * std::numbers::pi * 0.015, 1e-12);
        EXPECT_NEAR(shapeRadius(shape), 0.015, 1e-15);
    }
    const auto a = shapeOutline(disk, 12), b = shapeOutline(series, 12);
    ASSERT_EQ(a.size(), 12U);
    for (std::size_t k = 0; k < a.size(); ++k)
        EXPECT_NEAR((a[k] - b[k]).norm(), 0.0, 1e-15);
    EXPECT_NEAR(contourArea(*makeContour(a)), 6 * 0.015 * 0.015 * std::sin(std::numbers::pi / 6), 1e-12);
}

TEST(Shape, RadiusOfASeriesIsItsFarthestPointNotASample) {
    // r^2 = 1 + e^2 + 2 e cos(2 pi (7 phi - a)): farthest 1 + e, at phases that no sample hits.
    const std::complex<double> e = std::polar(0.1, 1.2345);
    std::vector<std::complex<double>> c(13, 0.0);
    c[7] = 1.0;
    c[0] = e;
    EXPECT_NEAR(shapeRadius(FourierContour(c)), 1.1, 1e-12);
}

Contour square(double half, double x = 0.0) {
    return {{{x - half, -half}, {x + half, -half}, {x + half, half}, {x - half, half}}};
}

// Catches: holes not counted off, or counted where the outline alone is meant; holes that stay when taken
// off.
TEST(Shape, HolesCountOffTheAreaAlone) {
    for (const Shape& outline :
         {Shape(Disk{1.0}), Shape(FourierContour({0.0, 0.0, 1.0})), Shape(square(1.0))}) {
        const std::vector<Contour> holes{square(0.1), square(0.05, 0.4)};
        const Shape pierced = withHoles(outline, holes);
        EXPECT_NEAR(shapeArea(pierced), shapeArea(outline) - 0.05, 1e-15);
        EXPECT_EQ(shapePerimeter(pierced), shapePerimeter(outline));
        EXPECT_EQ(shapeRadius(pierced), shapeRadius(outline));
        EXPECT_EQ(shapeOutline(pierced, 9), shapeOutline(outline, 9));
        EXPECT_EQ(shapeRings(pierced, 9).size(), 3u);
        EXPECT_EQ(shapeRings(pierced, 9)[2], holes[1].points_m);
        EXPECT_EQ(holesOf(pierced), holes);
        EXPECT_TRUE(holesOf(outline).empty());
        EXPECT_EQ(withHoles(pierced, {}), outline);
        EXPECT_EQ(withHoles(pierced, {holes[0]}), withHoles(outline, {holes[0]}));
    }
    EXPECT_NE(outlineAs<Disk>(withHoles(Disk{1.0}, {square(0.1)})), nullptr);
    EXPECT_EQ(outlineAs<Contour>(withHoles(Disk{1.0}, {square(0.1)})), nullptr);
}

// Catches: a hole in the air, across the outline, touching it or another, within another, or too many, that
// is taken; a Fourier outline not looked at as it is drawn.
TEST(Shape, HolesMustFit) {
    const auto codeOf = [](const Shape& outline, std::vector<Contour> holes) {
        const auto checked = checkHoles(withHoles(outline, std::move(holes)), "holes");
        return checked ? MessageCode::None : checked.error().code();
    };
    for (const Shape& outline :
         {Shape(Disk{1.0}), Shape(FourierContour({0.0, 0.0, 1.0})), Shape(square(1.0))}) {
        EXPECT_EQ(codeOf(outline, {}), MessageCode::None);
        EXPECT_EQ(codeOf(outline, {square(0.1), square(0.1, 0.3), square(0.1, -0.3)}), MessageCode::None);
        EXPECT_EQ(codeOf(outline, {square(0.1, 1.0)}), MessageCode::HoleOutside);
        EXPECT_EQ(codeOf(outline, {square(0.1, 0.9)}), MessageCode::HoleOutside);
        EXPECT_EQ(codeOf(outline, {square(0.1, 3.0)}), MessageCode::HoleOutside);
        EXPECT_EQ(codeOf(outline, {square(2.0)}), MessageCode::HoleOutside);
        EXPECT_EQ(codeOf(outline, {square(0.1), square(0.1, 0.15)}), MessageCode::HolesMeet);
        EXPECT_EQ(codeOf(outline, {square(0.125), square(0.125, 0.25)}), MessageCode::HolesMeet);
        EXPECT_EQ(codeOf(outline, {square(0.3), square(0.1)}), MessageCode::HolesMeet);
        EXPECT_EQ(codeOf(outline, {square(0.1), square(0.3)}), MessageCode::HolesMeet);
        EXPECT_EQ(codeOf(outline, {{{{0.0, 0.0}, {0.1, 0.1}, {0.1, 0.0}, {0.0, 0.1}}}}),
                  MessageCode::ContourCrossing);
        EXPECT_EQ(codeOf(outline, std::vector<Contour>(kMaxHoles + 1, square(0.01))),
                  MessageCode::HolesTooMany);
    }
    EXPECT_EQ(codeOf(Disk{1.0}, {square(0.1, 0.85)}), MessageCode::None);
    EXPECT_EQ(codeOf(Disk{1.0}, {square(0.1, 0.899)}), MessageCode::HoleOutside);
    EXPECT_EQ(checkHoles(withHoles(Disk{1.0}, {square(0.1), square(2.0)}), "holes").error().where,
              "holes[1]");
}

TEST(Shape, PolygonGivesItsOwnPoints) {
    const Contour square = *makeContour({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    EXPECT_EQ(shapeOutline(square, 100), square.points_m);
    EXPECT_DOUBLE_EQ(shapeArea(square), 4.0);
    EXPECT_DOUBLE_EQ(shapePerimeter(square), 8.0);
    EXPECT_DOUBLE_EQ(shapeRadius(square), std::sqrt(2.0));
    EXPECT_THROW(shapeOutline(Disk{1.0}, 2), std::invalid_argument);
}

} // namespace
// Catches: rings close to each other tried out edge by edge, which takes a minute; a meeting in the middle of
// long runs of edges overlooked.
TEST(Shape, HolesOfManyCornersAreCheckedInTime) {
    const auto ring = [](double radius_m) { return Contour{shapeOutline(Disk{radius_m}, 100000)}; };
    const double before_s = test::threadTime_s();
    EXPECT_TRUE(checkHoles(withHoles(ring(1.0), {ring(0.97)})));
    Contour reaching = ring(0.97);
    for (const int k : {37501, 37502})
        reaching.points_m[static_cast<std::size_t>(k)] *= 1.0 / 0.96;
    EXPECT_EQ(checkHoles(withHoles(ring(1.0), {reaching})).error().code(), MessageCode::HoleOutside);
    EXPECT_LT(test::threadTime_s() - before_s, 10.0);
}

} // namespace bask
