// View factors where there is something to compare with or to refuse: closed forms, near contact, nonsense,
// extreme sizes, processors.

#include "engine/radiation/kernels/kernels.h"
#include "tests/engine/radiation/area_reference.h"
#include "tests/engine/radiation/face_pairs.h"

#include <gtest/gtest.h>

#include <limits>

namespace bask {
namespace {

using test::Draw;
using test::FacePair;
using test::kPi;
using test::kSharp;
using test::poseAt;

ViewFactor factorOfPair(const FacePair& pair, const ViewFactorOptions& options = kSharp) {
    return viewFactor(RadiatingContour(pair.source), RadiatingContour(pair.object), pair.X_SO, options);
}

double valueOf(const Shape& source, const Shape& object, const Pose& X_SO) {
    return factorOfPair({source, object, X_SO}).value;
}

Contour rectangleBetween(double x0, double x1, double y0, double y1) {
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

Contour regularPolygon(int corners, double radius) {
    Contour contour;
    for (int i = 0; i < corners; ++i)
        contour.points_m.emplace_back(radius * std::cos(2 * kPi * i / corners),
                                      radius * std::sin(2 * kPi * i / corners));
    return contour;
}

/// Aligned parallel rectangles a x b at the distance c (Howell, C-11).
double alignedRectangles(double a, double b, double c) {
    const double x = a / c, y = b / c;
    const double x2 = std::sqrt(1 + x * x), y2 = std::sqrt(1 + y * y);
    return 2.0 / (kPi * x * y) *
           (0.5 * (std::log1p(x * x) + std::log1p(y * y) - std::log1p(x * x + y * y)) +
            x * y2 * std::atan(x / y2) + y * x2 * std::atan(y / x2) - x * std::atan(x) - y * std::atan(y));
}

/// Parallel rectangles anywhere (Howell, C-13): [x0, x1] x [y0, y1] sees [u0, u1] x [v0, v1] at the distance
/// z.
double parallelRectangles(const std::array<double, 2>& x, const std::array<double, 2>& y,
                          const std::array<double, 2>& u, const std::array<double, 2>& v, double z) {
    const auto g = [&](double a, double b) {
        const double ra = std::hypot(a, z), rb = std::hypot(b, z);
        return (b * ra * std::atan(b / ra) + a * rb * std::atan(a / rb) -
                0.5 * z * z * std::log(a * a + b * b + z * z)) /
               (2.0 * kPi);
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            for (std::size_t k = 0; k < 2; ++k)
                for (std::size_t l = 0; l < 2; ++l)
                    sum += ((i + j + k + l) % 2 == 0 ? 1.0 : -1.0) * g(x[i] - u[k], y[j] - v[l]);
    return sum / ((x[1] - x[0]) * (y[1] - y[0]));
}

/// Perpendicular rectangles with a common edge (Howell, C-14): from h = height/edge to w = width/edge, times
/// w.
double perpendicularRectangles(double h, double w) {
    const double h2 = h * h, w2 = w * w, r = std::sqrt(h2 + w2);
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - r * std::atan(1 / r) +
            0.25 * (std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                    w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                    h2 * std::log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2))))) /
           kPi;
}

/// Coaxial disks (Howell, C-41), written without cancellation.
double coaxialDisks(double object, double source, double height) {
    const double ratio = source / object;
    const double x = 1.0 + (height * height + source * source) / (object * object);
    return 2.0 * ratio * ratio / (x + std::sqrt(x * x - 4.0 * ratio * ratio));
}

// Catches: a wrong edge term, down to gaps of a thousandth, and in the far field.
TEST(ViewFactorCatalogue, parallelRectangles) {
    EXPECT_NEAR(alignedRectangles(1, 1, 1), 0.199824895698387, 1e-14); // the book's table: 0.1998
    for (const double c : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0})
        for (const auto& [a, b] : {std::pair(0.1, 0.1), {0.1, 0.03}, {0.02, 0.5}}) {
            const Contour face = rectangleBetween(-a / 2, a / 2, -b / 2, b / 2);
            const double expected = alignedRectangles(a, b, c);
            EXPECT_NEAR(valueOf(face, face, poseAt(0, 0, c)), expected, 1e-10) << a << ' ' << b << ' ' << c;
        }
    for (const double z : {1e-3, 1e-2, 0.1})
        for (const double shift : {0.0, 0.03, 0.1, 0.4}) { // edges above each other, apart by half a hair
            const Contour object = rectangleBetween(-0.02, 0.03, -0.05, 0.01);
            const double expected = parallelRectangles({-0.02 + shift, 0.03 + shift}, {-0.05, 0.01},
                                                       {-0.1, 0.1}, {-0.05, 0.05}, z);
            EXPECT_NEAR(valueOf(rectangleBetween(-0.1, 0.1, -0.05, 0.05), object, poseAt(shift, 0, z)),
                        expected, 1e-10)
                << z << ' ' << shift;
        }
}

// Catches: a wrong answer where the two faces meet in an edge, and just before and after; an upright object
// above, through and below the source's plane.
TEST(ViewFactorCatalogue, perpendicularRectanglesWithACommonEdge) {
    EXPECT_NEAR(perpendicularRectangles(1, 1), 0.200043776075405, 1e-14); // the book's table: 0.2000
    for (const auto& [h, w] : {std::pair(1.0, 1.0), {0.3, 1.0}, {1.0, 0.2}, {2.0, 5.0}}) {
        // The object stands at the edge x = 0 of the source and looks along +x.
        const Contour source = rectangleBetween(0.0, w, -0.5, 0.5);
        const Contour object = rectangleBetween(0.0, h, -0.5, 0.5);
        Pose X_SO = Pose::Identity();
        X_SO.linear() << 0, 0, -1, 0, 1, 0, 1, 0, 0; // O's x upwards, its -z along S's x
        const auto expectAt = [&](const Contour& face, double x, double z, double expected, double change) {
            SCOPED_TRACE(testing::Message() << h << ' ' << w << " at " << x << ' ' << z);
            X_SO.translation() = Eigen::Vector3d(x, 0, z);
            const ViewFactor f = factorOfPair({face, object, X_SO}, {});
            EXPECT_NEAR(f.value, expected, f.errorEstimate + change);
            EXPECT_NEAR(f.value, expected, change > 0.0 ? 1e-6 + change : 1e-9);
        };
        const double expected = perpendicularRectangles(h, w) / h;
        expectAt(source, 0, 0, expected, 0.0);
        for (const double lift : {-1e-12, 1e-12, 1e-9})
            expectAt(source, -lift, lift, expected, 10.0 * std::abs(lift));
        // Standing in the middle of a source twice as wide it sees one half.
        expectAt(rectangleBetween(-w, w, -0.5, 0.5), 0, 0, expected, 0.0);
        // Sunk to the half, the upper half sees what a lower wall sees.
        expectAt(source, 0, -0.5 * h, perpendicularRectangles(0.5 * h, w) / h, 0.0);
    }
}

// Catches: the difference of two factors losing its digits; a disk told as Fourier contour or polygon.
TEST(ViewFactorCatalogue, disksAnnuliAndRegularPolygons) {
    for (const double height : {1e-3, 1e-2, 0.1, 1.0}) {
        const double inner = coaxialDisks(0.03, 0.05, height), outer = coaxialDisks(0.03, 0.1, height);
        const Disk object{0.03};
        const double annulus = valueOf(Disk{0.1}, object, poseAt(0, 0, height)) -
                               valueOf(FourierContour({0.0, 0.0, 0.05}), object, poseAt(0, 0, height));
        EXPECT_NEAR(annulus, outer - inner, 1e-12);
        // Polygons within and about the disk of the source are less and more.
        constexpr int kCorners = 64;
        const double about = 0.1 / std::cos(kPi / kCorners);
        const double less = valueOf(regularPolygon(kCorners, 0.1), object, poseAt(0, 0, height));
        const double more = valueOf(regularPolygon(kCorners, about), object, poseAt(0, 0, height));
        EXPECT_LT(less, outer);
        EXPECT_GT(more, outer);
        EXPECT_NEAR((2.0 * more + 1.0 * less) / 3.0, outer, 2e-3 * outer);
        // Among those with the disk's area and with 2 to the k corners the error falls by 16.
        const auto equalArea = [&](int n) {
            const double radius = 0.1 * std::sqrt(2 * kPi / (n * std::sin(2 * kPi / n)));
            return valueOf(regularPolygon(n, radius), object, poseAt(0, 0, height)) - outer;
        };
        EXPECT_NEAR(equalArea(16) / equalArea(32), 16.0, height < 0.1 ? 10.0 : 3.0) << height;
    }
}

// Catches: a rule chosen too coarse, or a trial passed by luck, where the outlines run above each other a
// hundredth to a fiftieth of their size apart: the same face twice, crossing edges, a face within the other;
// parallel and tilted.
TEST(ViewFactorNearContact, agreesWithTheDoubleContourIntegral) {
    Draw draw(201);
    for (int sourceKind = 0; sourceKind < test::kKinds; ++sourceKind)
        for (int objectKind = 0; objectKind < test::kKinds; ++objectKind)
            for (int i = 0; i < 4; ++i) {
                SCOPED_TRACE(testing::Message() << test::kKindNames[objectKind] << " over "
                                                << test::kKindNames[sourceKind] << ' ' << i);
                const double gap = 2e-3, size = i < 2 ? 0.1 : 0.04;
                const Shape source = test::drawShape(draw, sourceKind, 0.1);
                const bool same = i < 2 && sourceKind == objectKind;
                const Shape object = same ? source : test::drawShape(draw, objectKind, size);
                const double lean = i % 2 == 0 ? 0.0 : 0.01;
                const double shift = i < 2 ? 0.0 : 0.1 - 0.02 * i;
                const FacePair pair{source, object, poseAt(shift, 0, gap + lean * size, 0, lean, 0)};
                const double expected = test::contourViewFactor(source, object, pair.X_SO, 0.8 * gap);
                const ViewFactor sharp = factorOfPair(pair);
                EXPECT_NEAR(sharp.value, expected, 1e-10);
                const ViewFactor f = factorOfPair(pair, {});
                EXPECT_NEAR(f.value, expected, 1e-9);
                EXPECT_LE(f.errorEstimate, 2e-9);
                EXPECT_LE((f.gradient - sharp.gradient).norm(), 1e-5 * (1.0 + sharp.gradient.norm()));
            }
}

// Catches: two rules that agree by chance where both are wrong: poses met among a hundred thousand.
TEST(ViewFactorNearContact, takesNoAgreementByChance) {
    struct Case {
        double radius;
        Pose X_SO;
    };
    for (const Case& one :
         {Case{0.3, poseAt(0.1, 0, 0.093, 0, 0.3, 0)},
          Case{0.43212885856951788, poseAt(0.077031282865467884, 0.046178143163227214, 0.039001929983612009,
                                           0, 0.079252897661736099, 0)}}) {
        const FacePair pair{Disk{0.1}, Disk{one.radius}, one.X_SO};
        const ViewFactor f = factorOfPair(pair, {}), sharp = factorOfPair(pair);
        EXPECT_LE(std::abs(f.value - sharp.value), f.errorEstimate + sharp.errorEstimate);
        EXPECT_NEAR(f.value, sharp.value, 1e-9);
    }
}

// The paper's observation. Catches: a sign of dF/dz that "away is colder" would never notice.
TEST(ViewFactorAtALevel, movingAwayFromTheSourceCanHeat) {
    const RadiatingContour source(Disk{0.1}), object(Disk{0.015});
    int found = 0;
    for (double x = 0.0; x <= 0.3; x += 0.01)
        for (double z = 0.01; z <= 0.3; z += 0.01) {
            const ViewFactor f = viewFactor(source, object, poseAt(x, 0, z));
            if (std::abs(f.value - 0.1) > 0.02 || f.gradient[2] < 0.05)
                continue;
            ++found;
            EXPECT_GT(x, 0.1); // beside the source only
            EXPECT_GT(viewFactorValue(source, object, poseAt(x, 0, z + 1e-3)), f.value + 4e-5);
        }
    EXPECT_GT(found, 10);
}

// Catches: a number made of nonsense.
TEST(ViewFactorRefuses, posesAndToleranceThatMeanNothing) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (const Shape& shape :
         {Shape{Disk{0.05}}, Shape{test::clover(0.05, 3, 0.5)}, Shape{test::star(0.05, 5, 0.4)}}) {
        const RadiatingContour face(shape);
        for (const double bad : {nan, infinite, -infinite})
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 4; ++column) {
                    Pose X_SO = poseAt(0.01, 0.02, 0.1, 0.3);
                    X_SO(row, column) = bad;
                    EXPECT_THROW(viewFactor(face, face, X_SO), std::invalid_argument);
                    EXPECT_THROW(viewFactorValue(face, face, X_SO), std::invalid_argument);
                }
        for (const double tolerance : {nan, -1e-9, -infinite}) {
            EXPECT_THROW(viewFactor(face, face, poseAt(0, 0, 0.1), {.tolerance = tolerance}),
                         std::invalid_argument)
                << tolerance;
            EXPECT_THROW(viewFactorValue(face, face, poseAt(0, 0, 0.1), tolerance), std::invalid_argument)
                << tolerance;
        }
        for (const int points : {0, -1})
            EXPECT_THROW(viewFactor(face, face, poseAt(0, 0, 0.1), {.maxPoints = points}),
                         std::invalid_argument)
                << points;
        // Too much asked is no nonsense: the estimate tells.
        for (const double tolerance : {0.0, 1e-300, 1e-20}) {
            const ViewFactor f = viewFactor(face, face, poseAt(0, 0, 0.1), {.tolerance = tolerance});
            EXPECT_TRUE(f.errorEstimate > tolerance && f.errorEstimate < 1e-11) << f.errorEstimate;
        }
    }
}

// Catches: an outline that is none taken for one.
TEST(ViewFactorRefuses, outlinesWithoutArea) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (const double radius : {0.0, -0.1, nan, infinite})
        EXPECT_THROW(RadiatingContour(Disk{radius}), std::invalid_argument) << radius;
    EXPECT_THROW(RadiatingContour(Contour{}), std::invalid_argument);
    EXPECT_THROW(RadiatingContour(Contour{{{0, 0}, {1, 0}}}), std::invalid_argument);
    EXPECT_THROW(RadiatingContour(Contour{{{0, 0}, {0, 1}, {1, 0}}}), std::invalid_argument); // clockwise
    EXPECT_THROW(RadiatingContour(Contour{{{0, 0}, {1, 0}, {nan, 1}}}), std::invalid_argument);
    EXPECT_THROW(RadiatingContour(Contour{{{0, 0}, {1, 0}, {0, infinite}}}), std::invalid_argument);
    EXPECT_THROW(RadiatingContour(Contour{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}),
                 std::invalid_argument);                                                    // bow tie
    EXPECT_THROW(RadiatingContour(FourierContour({0.1, 0.0, 0.0})), std::invalid_argument); // clockwise
    EXPECT_THROW(RadiatingContour(FourierContour({0.0, 0.0, nan})), std::invalid_argument);
    EXPECT_THROW(RadiatingContour{FourierContour{}}, std::invalid_argument);
    // A repeated point is no crossing; the numbers must not suffer.
    const Contour twice{{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}};
    EXPECT_NEAR(valueOf(twice, rectangleBetween(0, 1, 0, 1), poseAt(0, 0, 1)), alignedRectangles(1, 1, 1),
                1e-10);
    EXPECT_NEAR(valueOf(rectangleBetween(0, 1, 0, 1), twice, poseAt(0, 0, 1)), alignedRectangles(1, 1, 1),
                1e-10);
}

// Catches: 1 or 0 by a rounding error where one face lies on the other, for every two kinds.
TEST(ViewFactorRefuses, facesOnEachOther) {
    Draw draw(202);
    for (int source = 0; source < test::kKinds; ++source)
        for (int object = 0; object < test::kKinds; ++object)
            for (const double size : {0.002, 0.03, 0.1, 2.0}) {
                SCOPED_TRACE(testing::Message() << test::kKindNames[object] << " on "
                                                << test::kKindNames[source] << ' ' << size);
                // A convex source, so that anything about its centre lies on it.
                const Shape face = source == 2   ? Shape{regularPolygon(6, 0.1)}
                                   : source == 1 ? Shape{draw.fourier(0.1, 0.05)}
                                                 : Shape{Disk{0.1}};
                const Shape other =
                    object == 2 ? Shape{draw.polygon(size, 7)} : test::drawShape(draw, object, size);
                const RadiatingContour a(face), b(other);
                for (const Pose& X_SO :
                     {poseAt(0, 0, 0, 0, 0, 0.3), poseAt(0.01, 0, 0, kPi), poseAt(0, 0, 1e-16)}) {
                    EXPECT_THROW(viewFactor(a, b, X_SO), std::invalid_argument);
                    EXPECT_THROW(viewFactorValue(a, b, X_SO), std::invalid_argument);
                }
                EXPECT_EQ(viewFactor(a, b, poseAt(3.0, 0, 0, 0, 0, 0.3)).value, 0.0);
            }
}

// Catches: overflow, underflow and points without end where one face is a speck beside the other.
TEST(ViewFactorExtremes, aSpeckAndAPlain) {
    for (int kind = 0; kind < test::kKinds; ++kind) {
        SCOPED_TRACE(test::kKindNames[kind]);
        const auto disk = [&](double radius) -> Shape {
            if (kind == 0)
                return Disk{radius};
            if (kind == 1)
                return FourierContour({0.0, 0.0, radius});
            return rectangleBetween(-radius, radius, -radius, radius);
        };
        for (const double ratio : {1e3, 1e6}) {
            const double height = 0.1;
            // A speck below a plain, and a plain that sees a speck: reciprocal.
            const ViewFactor speck = factorOfPair({disk(0.1), disk(0.1 / ratio), poseAt(0, 0, height)}, {});
            const double expected =
                kind == 2 ? 4.0 / (kPi * std::sqrt(2.0)) * std::atan(1 / std::sqrt(2.0)) : 0.5;
            EXPECT_NEAR(speck.value, expected, 1.0 / (ratio * ratio) + 1e-9 * ratio / 1e3);
            EXPECT_LE(std::abs(speck.value - expected), 1.0 / (ratio * ratio) + speck.errorEstimate);
            const ViewFactor plain = factorOfPair({disk(0.1 / ratio), disk(0.1), poseAt(0, 0, height)}, {});
            EXPECT_LE(std::abs(plain.value - expected / (ratio * ratio)),
                      2.0 / std::pow(ratio, 4) + plain.errorEstimate);
            EXPECT_LE(plain.errorEstimate, 1e-9);
        }
        const ViewFactor far = factorOfPair({disk(0.1), disk(0.1), poseAt(0, 0, 1e6)}, {});
        EXPECT_NEAR(far.value, shapeArea(disk(0.1)) / (kPi * 1e12), 1e-15);
    }
}

// Catches: a processor on which the numbers are others.
TEST(ViewFactorKernels, allProcessorsAgree) {
    const kernels::Kernels& usual = kernels::kernels();
    const kernels::KernelList sets = kernels::runnableKernels();
    Draw draw(203);
    for (int source = 0; source < test::kKinds; ++source)
        for (int object = 0; object < test::kKinds; ++object)
            for (int i = 0; i < 20; ++i) {
                SCOPED_TRACE(testing::Message()
                             << test::kKindNames[object] << " over " << test::kKindNames[source] << ' ' << i);
                const FacePair pair = test::drawPair(draw, source, object, i);
                const RadiatingContour a(pair.source), b(pair.object);
                kernels::useKernels(*sets.sets[0]);
                const ViewFactor plain = viewFactor(a, b, pair.X_SO);
                const double value = viewFactorValue(a, b, pair.X_SO);
                for (int k = 1; k < sets.count; ++k) {
                    kernels::useKernels(*sets.sets[k]);
                    const ViewFactor f = viewFactor(a, b, pair.X_SO);
                    EXPECT_NEAR(f.value, plain.value, 1e-12) << sets.sets[k]->name;
                    EXPECT_NEAR(viewFactorValue(a, b, pair.X_SO), value, 1e-12) << sets.sets[k]->name;
                    EXPECT_LE((f.gradient - plain.gradient).norm(), 1e-12 * (1.0 + 10.0 / pair.size_m))
                        << sets.sets[k]->name;
                    EXPECT_EQ(f.visibility, plain.visibility) << sets.sets[k]->name;
                }
            }
    kernels::useKernels(usual);
}

} // namespace
} // namespace bask
