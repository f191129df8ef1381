#include "engine/radiation/point_factor.h"

#include "engine/radiation/view_factor.h"
#include "tests/engine/radiation/random_poses.h"

#include <gtest/gtest.h>

#include <limits>

namespace bask {
namespace {

using Eigen::Vector3d;
using test::Draw;

constexpr double kPi = std::numbers::pi;

/// A disk as a polygon of `n` corners on its rim.
Contour ring(double radius, int n) {
    return Contour{shapeOutline(Disk{radius}, n)};
}

/// A disk as a Fourier outline.
FourierContour circle(double radius) {
    return FourierContour({0.0, 0.0, radius});
}

/// Lambert's cosine law summed over `n` x `n` cells of a disk in polar coordinates, or of a polygon's square
/// hull with a test of each cell's centre: shares nothing with the contour formulas. Error about 1/n^2
/// (disk).
double bruteForceDisk(double radius, const Vector3d& p, const Vector3d& n, int cells) {
    double sum = 0.0;
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
            const double rho = radius * (i + 0.5) / cells;
            const double angle = 2.0 * kPi * (k + 0.5) / cells;
            const Vector3d r = Vector3d(rho * std::cos(angle), rho * std::sin(angle), 0.0) - p;
            const double area = rho * radius / cells * 2.0 * kPi / cells;
            const double cosines = std::max(0.0, n.dot(r)) * -r.z();
            sum += area * cosines / (kPi * r.squaredNorm() * r.squaredNorm());
        }
    return sum;
}

// A star-shaped source in polar cells, its radius from a function of the angle.
template <class Radius>
double bruteForceStar(const Radius& radius, const Vector3d& p, const Vector3d& n, int cells) {
    double sum = 0.0;
    for (int k = 0; k < cells; ++k) {
        const double angle = 2.0 * kPi * (k + 0.5) / cells;
        const double reach = radius(angle);
        for (int i = 0; i < cells; ++i) {
            const double rho = reach * (i + 0.5) / cells;
            const Vector3d r = Vector3d(rho * std::cos(angle), rho * std::sin(angle), 0.0) - p;
            const double area = rho * reach / cells * 2.0 * kPi / cells;
            sum += area * std::max(0.0, n.dot(r)) * -r.z() / (kPi * r.squaredNorm() * r.squaredNorm());
        }
    }
    return sum;
}

// Catches: a wrong sign or factor, against a heat-transfer catalogue's element parallel to a disk: on the
// axis and off it (Howell's B-13 and B-12).
TEST(PointFactor, meetsTheParallelElementOverADisk) {
    const double r = 0.1;
    for (double h : {0.001, 0.02, 0.05, 0.3, 2.0})
        for (double a : {0.0, 1e-9, 0.03, 0.099, 0.15, 0.7}) {
            const double t = a * a + h * h - r * r;
            const double root = std::sqrt(t * t + 4.0 * r * r * h * h);
            EXPECT_NEAR(pointFactor(Disk{r}, {a, 0, h}, {0, 0, -1}), 0.5 * (1.0 - t / root), 1e-13)
                << h << ' ' << a;
            EXPECT_NEAR(pointFactor(Disk{r}, {0, a, h}, {0, 0, -7}), 0.5 * (1.0 - t / root), 1e-13);
        }
}

// Catches: a horizon cut treated wrong: the element at right angles to the disk, outside of it so that it
// sees all of it, and above the middle so that it sees one half.
TEST(PointFactor, meetsTheElementAtRightAnglesToADisk) {
    const double r = 0.1;
    for (double h : {0.01, 0.05, 0.4})
        for (double a : {0.1, 0.13, 0.5}) {
            const double sum = h * h + a * a + r * r;
            const double expected = h / (2.0 * a) * (sum / std::sqrt(sum * sum - 4.0 * a * a * r * r) - 1.0);
            EXPECT_NEAR(pointFactor(Disk{r}, {a, 0, h}, {-1, 0, 0}), expected, 1e-13) << h << ' ' << a;
            EXPECT_EQ(pointFactor(Disk{r}, {a, 0, h}, {1, 0, 0}), 0.0);
        }
    // Above the middle: half of the disk, (atan(r/h) - (r/h)/(1 + (r/h)^2)) / pi.
    for (double h : {0.01, 0.05, 0.4}) {
        const double x = r / h;
        EXPECT_NEAR(pointFactor(Disk{r}, {0, 0, h}, {0, 1, 0}), (std::atan(x) - x / (1.0 + x * x)) / kPi,
                    1e-13);
    }
}

// Catches: the tilt mishandled: above the disk's middle an uncut tilted element has the cosine of its tilt.
TEST(PointFactor, meetsTheTiltedElementOverTheMiddle) {
    for (double tilt : {0.1, 0.4, 0.78}) {
        const Vector3d n(std::sin(tilt), 0, -std::cos(tilt));
        EXPECT_NEAR(pointFactor(Disk{0.1}, {0, 0, 0.1}, n), 0.5 * std::cos(tilt), 1e-13);
    }
}

// Catches: the polygon's edge terms, against the catalogue's element above the corner of a rectangle,
// parallel (B-4) and at right angles (B-3).
TEST(PointFactor, meetsTheElementAtTheCornerOfARectangle) {
    for (double a : {0.05, 0.2})
        for (double b : {0.03, 0.3})
            for (double c : {0.02, 0.1, 0.6}) {
                const Contour rectangle{{{0, 0}, {a, 0}, {a, b}, {0, b}}};
                const double x = a / c, y = b / c;
                const double parallel = (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                                         y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
                                        (2.0 * kPi);
                EXPECT_NEAR(pointFactor(rectangle, {0, 0, c}, {0, 0, -1}), parallel, 1e-14);
                // The element's plane goes through the rectangle's side of length b.
                const double across = (std::atan(b / c) - c / std::sqrt(a * a + c * c) *
                                                              std::atan(b / std::sqrt(a * a + c * c))) /
                                      (2.0 * kPi);
                EXPECT_NEAR(pointFactor(rectangle, {0, 0, c}, {1, 0, 0}), across, 1e-14);
            }
}

// Catches: a closed form of the cut disk or a Fourier outline that is off: one circle in three descriptions.
TEST(PointFactor, agreesBetweenTheDescriptionsOfACircle) {
    Draw draw(5);
    int cut = 0;
    for (int i = 0; i < 400; ++i) {
        const Vector3d p(draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), draw.between(0.005, 0.3));
        const Vector3d n = draw.vector(1.0);
        const double f = pointFactor(Disk{0.1}, p, n);
        EXPECT_NEAR(pointFactor(circle(0.1), p, n), f, 1e-11) << i;
        EXPECT_NEAR(pointFactor(ring(0.1, 4000), p, n), f, 1e-5) << i;
        const double tilt = 0.1 * std::hypot(n.x(), n.y());
        cut += std::abs(n.dot(p)) < tilt ? 1 : 0;
    }
    EXPECT_GT(cut, 50);
}

// Catches: any wrong cut of a disk, and of outlines with several arms, by Lambert's law cell by cell.
TEST(PointFactor, meetsLambertsLawSummedCellByCell) {
    Draw draw(6);
    const double size = 0.1;
    // Arms and bays: a cut leaves several pieces. rho(angle) = size (1 + 0.45 cos 5 angle).
    const auto reach = [&](double angle) { return size * (1.0 + 0.45 * std::cos(5.0 * angle)); };
    std::vector<std::complex<double>> c(13);
    c[7] = size;
    c[12] = c[2] = 0.225 * size; // j = 6 and j = -4
    const FourierContour flower(c);
    const Contour chain{shapeOutline(flower, 3000)};
    for (int i = 0; i < 25; ++i) {
        const Vector3d p(draw.between(-0.15, 0.15), draw.between(-0.15, 0.15), draw.between(0.04, 0.2));
        const Vector3d n = draw.vector(1.0).normalized();
        EXPECT_NEAR(pointFactor(Disk{size}, p, n), bruteForceDisk(size, p, n, 1000), 3e-6) << i;
        const double f = pointFactor(flower, p, n);
        EXPECT_NEAR(f, bruteForceStar(reach, p, n, 1000), 5e-6) << i;
        EXPECT_NEAR(pointFactor(chain, p, n), f, 1e-5) << i;
    }
}

// Catches: pieces of a comb joined in the wrong order on the horizon: its teeth alone give the same sum.
TEST(PointFactor, addsUpOverTheTeethOfAComb) {
    Contour comb{{{0, 0},
                  {0.09, 0},
                  {0.09, 0.1},
                  {0.07, 0.1},
                  {0.07, 0.01},
                  {0.05, 0.01},
                  {0.05, 0.1},
                  {0.03, 0.1},
                  {0.03, 0.01},
                  {0.01, 0.01},
                  {0.01, 0.1},
                  {0, 0.1}}};
    const auto box = [](double x0, double x1, double y0, double y1) {
        return Contour{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    };
    Draw draw(7);
    for (int i = 0; i < 200; ++i) {
        const Vector3d p(draw.between(-0.1, 0.2), draw.between(-0.1, 0.2), draw.between(0.001, 0.1));
        const Vector3d n = draw.vector(1.0);
        double parts = pointFactor(box(0, 0.09, 0, 0.01), p, n);
        for (const auto& [x0, x1] : {std::pair(0.0, 0.01), std::pair(0.03, 0.05), std::pair(0.07, 0.09)})
            parts += pointFactor(box(x0, x1, 0.01, 0.1), p, n);
        EXPECT_NEAR(pointFactor(comb, p, n), parts, 1e-13) << i;
    }
}

// Catches: another sign or normal than viewFactor's: a tiny object is an element.
TEST(PointFactor, isTheLimitOfASmallObject) {
    Draw draw(8);
    const RadiatingContour speck(Disk{1e-5});
    for (int i = 0; i < 150; ++i) {
        const Shape source = draw.shape(i, 0.1);
        const Vector3d at(draw.between(-0.2, 0.2), draw.between(-0.2, 0.2), draw.between(0.02, 0.3));
        const Pose X_SO = poseFromRotationVector(at, draw.vector(1.5));
        const double f = viewFactor(RadiatingContour(source), speck, X_SO, {1e-12}).value;
        // Where the horizon touches the outline the factor is not smooth, hence not 1e-8.
        EXPECT_NEAR(pointFactor(source, at, -X_SO.linear().col(2)), f, 1e-6) << i;
    }
}

// Catches: loss of digits or endless refinement close to the source and far from it.
TEST(PointFactor, holdsCloseToTheSourceAndFarAway) {
    for (double h : {1e-3, 1e-6, 1e-9, 1e-12}) {
        EXPECT_NEAR(pointFactor(Disk{0.1}, {0.05, 0.02, h}, {0, 0, -1}), 1.0, 1e-12 + h);
        EXPECT_NEAR(pointFactor(circle(0.1), {0.05, 0.02, h}, {0, 0, -1}), 1.0, 1e-9 + h);
        EXPECT_NEAR(pointFactor(ring(0.1, 100), {0.05, 0.02, h}, {0, 0, -1}), 1.0, 1e-9 + h);
        // Over the rim, half of what there is to see; the answer must come in time.
        EXPECT_NEAR(pointFactor(circle(0.1), {0.1, 0, h}, {0, 0, -1}), 0.5, 0.02) << h;
    }
    const double far = 1000.0;
    EXPECT_NEAR(pointFactor(circle(0.1), {0, 0, far}, {0, 0, -1}) / (0.01 / (far * far)), 1.0, 1e-4);
}

// Catches: an answer where there is none, and a refusal where there is one.
TEST(PointFactor, refusesWhatHasNoAnswer) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Contour bracket{{{0, 0}, {0.1, 0}, {0.1, 0.02}, {0.02, 0.02}, {0.02, 0.1}, {0, 0.1}}};
    for (const Shape& source : {Shape(Disk{0.1}), Shape(circle(0.1)), Shape(bracket)}) {
        EXPECT_THROW(pointFactor(source, {nan, 0, 1}, {0, 0, -1}), std::invalid_argument);
        EXPECT_THROW(pointFactor(source, {0, 0, 1}, {0, nan, -1}), std::invalid_argument);
        EXPECT_THROW(pointFactor(source, {0, 0, 1}, {0, 0, 0}), std::invalid_argument);
        EXPECT_THROW(pointFactor(source, {0.01, 0.01, 0}, {0, 0, -1}), std::invalid_argument);
        EXPECT_EQ(pointFactor(source, {0.3, 0.01, 0}, {-1, 0, 0}), 0.0);
        EXPECT_EQ(pointFactor(source, {0.01, 0.01, -0.1}, {0, 0, 1}), 0.0);
        EXPECT_EQ(pointFactor(source, {0.01, 0.01, 0.1}, {0, 0, 1}), 0.0);
    }
    EXPECT_EQ(pointFactor(bracket, {0.08, 0.08, 0}, {-1, 0, 0}), 0.0);                      // in the bay
    EXPECT_THROW(pointFactor(bracket, {0.05, 0.02, 0}, {0, 0, -1}), std::invalid_argument); // on the outline
    EXPECT_THROW(pointFactor(Disk{0.0}, {0, 0, 1}, {0, 0, -1}), std::invalid_argument);
}

} // namespace
} // namespace bask
