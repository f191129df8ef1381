// Measures of the three shapes.

#include "engine/shape/shape.h"

#include "tests/engine/shape/shape_samples.h"

#include <stdexcept>

namespace bask {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Shape, DiskAndItsSeriesAgree) {
    const Shape disk = Disk{0.015}, series = FourierContour({0.0, 0.0, 0.015});
    for (const Shape& shape : {disk, series}) {
        EXPECT_NEAR(shapeArea(shape), kPi * 0.015 * 0.015, 1e-15);
        EXPECT_NEAR(shapePerimeter(shape), 2 * kPi * 0.015, 1e-12);
        EXPECT_NEAR(shapeRadius(shape), 0.015, 1e-15);
    }
    const auto a = shapeOutline(disk, 12), b = shapeOutline(series, 12);
    ASSERT_EQ(a.size(), 12U);
    for (std::size_t k = 0; k < a.size(); ++k)
        EXPECT_NEAR((a[k] - b[k]).norm(), 0.0, 1e-15);
    EXPECT_NEAR(contourArea(*makeContour(a)), 6 * 0.015 * 0.015 * std::sin(kPi / 6), 1e-12);
}

TEST(Shape, RadiusOfASeriesIsItsFarthestPointNotASample) {
    // r^2 = 1 + e^2 + 2 e cos(2 pi (7 phi - a)): farthest 1 + e, at phases that no sample hits.
    const std::complex<double> e = std::polar(0.1, 1.2345);
    std::vector<std::complex<double>> c(13, 0.0);
    c[7] = 1.0;
    c[0] = e;
    EXPECT_NEAR(shapeRadius(FourierContour(c)), 1.1, 1e-12);
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
} // namespace bask
