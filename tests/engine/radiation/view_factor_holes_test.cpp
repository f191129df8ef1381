// Faces with holes, as objects and as sources.

#include "engine/radiation/coplanar.h"
#include "engine/radiation/gauss_rule.h"
#include "engine/radiation/paper_methods.h"
#include "engine/radiation/point_factor.h"
#include "tests/engine/radiation/face_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

using test::Draw;
using test::FacePair;
using test::kPi;
using test::kSharp;
using test::poseAt;

ViewFactor piercedFactor(const FacePair& pair, const ViewFactorOptions& options = kSharp) {
    return viewFactor(RadiatingContour(pair.source), RadiatingContour(pair.object), pair.X_SO, options);
}

Contour rectangle(double x0, double y0, double x1, double y1) {
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// A regular polygon of the circle's area.
Contour roundHole(double radius_m, int corners, double x = 0.0, double y = 0.0) {
    const double step = 2.0 * kPi / corners;
    Contour hole{shapeOutline(Disk{radius_m * std::sqrt(step / std::sin(step))}, corners)};
    for (Eigen::Vector2d& p : hole.points_m)
        p += Eigen::Vector2d(x, y);
    return hole;
}

/// A face of each kind with two or three holes of other kinds of polygon.
Shape drawPierced(Draw& draw, int kind, double radius_m) {
    const Shape outline = kind == 0   ? Shape{Disk{radius_m}}
                          : kind == 1 ? Shape{draw.fourier(radius_m, 0.25)}
                                      : Shape{test::star(radius_m, 7, 0.6)};
    std::vector<Contour> holes{roundHole(0.2 * radius_m, 24, 0.25 * radius_m, 0.1 * radius_m)};
    holes.push_back(rectangle(-0.3 * radius_m, -0.2 * radius_m, -0.1 * radius_m, 0.15 * radius_m));
    if (kind != 0)
        holes.push_back(rectangle(0.0, -0.3 * radius_m, 0.2 * radius_m, -0.2 * radius_m));
    return withHoles(outline, holes);
}

/// A pair of which one or both have holes, in the poses of drawPair.
FacePair drawPair(Draw& draw, int i) {
    FacePair pair = test::drawPair(draw, i % 3, i / 3 % 3, i / 9);
    const int which = i % 7 % 3; // source, object, both
    if (which != 1)
        pair.source = drawPierced(draw, i % 3, shapeRadius(pair.source));
    if (which != 0)
        pair.object = drawPierced(draw, i / 3 % 3, shapeRadius(pair.object));
    return pair;
}

/// F21 of coaxial disks of radii r1 (source) and r2 at a distance (closed form).
double disksFactor(double r1, double r2, double height) {
    const double x = 1.0 + (1.0 + r1 * r1 / (height * height)) / (r2 * r2 / (height * height));
    const double ratio = r1 / r2;
    return 2.0 * ratio * ratio / (x + std::sqrt(x * x - 4.0 * ratio * ratio));
}

/// A2 F21 between rings r < R, by the algebra of disks.
double ringsExchange(double r1, double R1, double r2, double R2, double height) {
    const auto exchange = [&](double source, double object) {
        return source > 0.0 && object > 0.0 ? kPi * object * object * disksFactor(source, object, height)
                                            : 0.0;
    };
    return exchange(R1, R2) - exchange(R1, r2) - exchange(r1, R2) + exchange(r1, r2);
}

// Catches: a hole added instead of taken off, forgotten in one of the faces or in the area.
TEST(ViewFactorHoles, coaxialRingsMeetTheClosedForm) {
    const auto ring = [](double r, double R) {
        return r > 0.0 ? withHoles(Disk{R}, {roundHole(r, 2048)}) : Shape{Disk{R}};
    };
    for (const auto& [r1, R1, r2, R2] : {std::array{0.0, 0.1, 0.01, 0.03},
                                         {0.04, 0.1, 0.0, 0.03},
                                         {0.04, 0.1, 0.01, 0.03},
                                         {0.02, 0.1, 0.02, 0.1},
                                         {0.05, 0.06, 0.001, 0.2}})
        for (const double height : {0.01, 0.05, 0.3}) {
            SCOPED_TRACE(testing::Message() << r1 << ' ' << R1 << ' ' << r2 << ' ' << R2 << ' ' << height);
            const double area = kPi * (R2 * R2 - r2 * r2);
            const ViewFactor f =
                piercedFactor({ring(r1, R1), ring(r2, R2), poseAt(0, 0, height)}, {.tolerance = 1e-10});
            EXPECT_NEAR(f.value, ringsExchange(r1, R1, r2, R2, height) / area, 1e-8);
            EXPECT_EQ(f.visibility, Visibility::Full);
        }
}

/// A2 F21 of a rectangle of the object by point factors.
double exchangeByPoints(const Shape& source, const Pose& X_SO, const Eigen::Vector2d& low,
                        const Eigen::Vector2d& high) {
    const GaussRule rule = gaussRule(16);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const Eigen::Vector2d p =
                low + (high - low).cwiseProduct(Eigen::Vector2d(rule.nodes[i], rule.nodes[k]));
            sum += rule.weights[i] * rule.weights[k] *
                   pointFactor(source, X_SO * Eigen::Vector3d(p.x(), p.y(), 0.0), -X_SO.linear().col(2));
        }
    return sum * (high - low).prod();
}

// Catches: a wrong place of an off-centre hole, and a cut through outline and holes of either face that is
// joined wrongly: the object is summed up over the rectangles round its hole, in front of the source plane.
TEST(ViewFactorHoles, offCentreHolesAndCutsMeetPointFactors) {
    const Shape plate = rectangle(-0.03, -0.02, 0.03, 0.02);
    const double x0 = -0.02, x1 = 0.005, y0 = -0.01, y1 = 0.015;
    const Shape object = withHoles(plate, {rectangle(x0, y0, x1, y1)});
    Draw draw(5);
    const Shape sources[] = {drawPierced(draw, 0, 0.1), drawPierced(draw, 1, 0.1), drawPierced(draw, 2, 0.1),
                             Disk{0.1}};
    struct Case {
        Pose X_SO;
        double cut; ///< y of O under which the object lies behind the source plane
        Visibility visibility;
    };
    const Case cases[] = {
        {poseAt(0.02, -0.01, 0.06, 0.2, 0.3, 0.4), -1.0, Visibility::Full},
        {poseAt(0.01, 0.02, 0.05, 0.0, 1.2, 0.0), -1.0, Visibility::Partial}, // its plane cuts the source
        {poseAt(0.15, 0.0, 0.003, 1.1, 0.0, 0.0), -0.003 / std::sin(1.1), Visibility::Partial},
        {poseAt(0.0, -0.13, -0.004, 0.7, 0.0, 0.0), 0.004 / std::sin(0.7), Visibility::Partial}};
    for (const Shape& source : sources)
        for (const Case& one : cases) {
            SCOPED_TRACE(testing::Message() << source.index() << ' ' << one.cut);
            double exchange = 0.0;
            const double xs[] = {-0.03, x0, x1, 0.03}, ys[] = {-0.02, y0, y1, 0.02};
            for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 3; ++k)
                    if (const double from = std::max(ys[k], one.cut); !(i == 1 && k == 1) && from < ys[k + 1])
                        exchange += exchangeByPoints(source, one.X_SO, {xs[i], from}, {xs[i + 1], ys[k + 1]});
            const ViewFactor f = piercedFactor({source, object, one.X_SO});
            EXPECT_EQ(f.visibility, one.visibility);
            EXPECT_GT(f.value, 1e-3);
            EXPECT_NEAR(f.value, exchange / shapeArea(object), 1e-8);
        }
}

// Catches: an estimate or a tolerance that forgets that several outlines add up, a value clamped in parts.
TEST(ViewFactorHoles, toleranceHoldsAndTheEstimateIsHonest) {
    Draw draw(201);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const FacePair pair = drawPair(draw, i);
        const ViewFactor sharp = piercedFactor(pair);
        for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
            const ViewFactor f = piercedFactor(pair, {.tolerance = tolerance});
            const double error = std::abs(f.value - sharp.value);
            EXPECT_GE(f.value, 0.0);
            EXPECT_LE(f.value, 1.0);
            EXPECT_EQ(f.visibility, sharp.visibility);
            EXPECT_LE(error, f.errorEstimate + sharp.errorEstimate);
            EXPECT_LE(error, tolerance + sharp.errorEstimate);
            EXPECT_LE(f.errorEstimate, 2.0 * tolerance + 1e-10);
            EXPECT_NEAR(viewFactorValue(RadiatingContour(pair.source), RadiatingContour(pair.object),
                                        pair.X_SO, tolerance),
                        sharp.value, tolerance + sharp.errorEstimate);
        }
    }
}

// Catches: holes treated otherwise in the object than in the source.
TEST(ViewFactorHoles, isReciprocal) {
    Draw draw(202);
    int partial = 0;
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const FacePair pair = drawPair(draw, i);
        const ViewFactor there = piercedFactor(pair), here = piercedFactor(test::exchanged(pair));
        const double a2 = shapeArea(pair.object), a1 = shapeArea(pair.source);
        EXPECT_NEAR(a2 * there.value, a1 * here.value,
                    a2 * std::min(there.errorEstimate, 1e-9) + a1 * std::min(here.errorEstimate, 1e-9));
        EXPECT_EQ(there.visibility, here.visibility);
        partial += there.visibility == Visibility::Partial;
    }
    EXPECT_GT(partial, 50);
}

// Catches: moments of a hole left out or of the wrong sign.
TEST(ViewFactorHoles, gradientIsTheDerivativeOfTheValue) {
    Draw draw(203);
    int compared = 0;
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        const FacePair pair = drawPair(draw, i);
        const ViewFactor f = piercedFactor(pair);
        if (f.visibility == Visibility::Hidden || f.value < 1e-4 || test::runThroughEachOther(pair))
            continue;
        for (int k = 0; k < 6; ++k) {
            const double step = 1e-5 * (k < 3 ? pair.size_m : 1.0);
            const auto moved = [&](double by) {
                FacePair at = pair;
                if (k < 3)
                    at.X_SO.translation()[k] += by;
                else
                    at.X_SO.linear() = Eigen::AngleAxisd(by, Eigen::Vector3d::Unit(k - 3)) * at.X_SO.linear();
                return piercedFactor(at).value;
            };
            const double slope =
                (8.0 * (moved(step) - moved(-step)) - (moved(2 * step) - moved(-2 * step))) / (12.0 * step);
            EXPECT_NEAR(f.gradient[k] * step, slope * step, 1e-10) << k;
        }
        ++compared;
    }
    EXPECT_GT(compared, 40);
}

// Catches: a plug in a hole, which lies in the source's plane but covers nothing of it, refused or seen; a
// cover refused by its middle, which lies in the hole.
TEST(ViewFactorHoles, inOnePlaneOnlyWhatIsCoveredIsRefused) {
    const Shape washer = withHoles(Disk{0.1}, {roundHole(0.04, 64)});
    const Shape plug = Disk{0.03};
    const auto overlaps = [](const Shape& source, const Shape& object, double x) {
        return overlapInPlane(source, object, poseAt(x, 0, 0));
    };
    EXPECT_FALSE(overlaps(washer, plug, 0.0));
    EXPECT_FALSE(overlaps(plug, washer, 0.0));
    EXPECT_FALSE(overlaps(washer, roundHole(0.04, 64), 0.0)); // shared edges
    EXPECT_TRUE(overlaps(washer, plug, 0.03));
    EXPECT_TRUE(overlaps(washer, plug, 0.07));
    EXPECT_TRUE(overlaps(washer, washer, 0.0));
    EXPECT_TRUE(overlaps(washer, withHoles(Disk{0.05}, {roundHole(0.03, 64)}), 0.0));
    EXPECT_EQ(piercedFactor({washer, plug, poseAt(0, 0, 0)}).value, 0.0);
    EXPECT_THROW(piercedFactor({washer, plug, poseAt(0.03, 0, 0)}), std::invalid_argument);
}

// Catches: the limits: a hair over a washer its plug sees nothing, what lies on the face sees nothing else.
TEST(ViewFactorHoles, nearContactGoesToItsLimits) {
    const Shape washer = withHoles(Disk{0.1}, {roundHole(0.04, 64)});
    for (const double height : {1e-4, 1e-6, 1e-8}) {
        EXPECT_NEAR(piercedFactor({washer, Disk{0.03}, poseAt(0, 0, height)}, {.tolerance = 1e-9}).value, 0.0,
                    10.0 * height);
        EXPECT_NEAR(piercedFactor({washer, Disk{0.01}, poseAt(0.07, 0, height)}, {.tolerance = 1e-9}).value,
                    1.0, 1e3 * height);
    }
}

// Catches: point factors and the surface integral without holes; a contour integral that leaves them out.
TEST(ViewFactorHoles, otherMethodsKnowThemOrRefuse) {
    const Shape washer = withHoles(Disk{0.1}, {roundHole(0.04, 512)});
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    const auto diskAbove = [](double r, double h) { return r * r / (r * r + h * h); };
    EXPECT_NEAR(pointFactor(washer, {0, 0, 0.05}, down), diskAbove(0.1, 0.05) - diskAbove(0.04, 0.05), 1e-5);
    EXPECT_EQ(pointFactor(washer, {0.01, 0, 0}, down), 0.0);
    EXPECT_THROW(pointFactor(washer, {0.07, 0, 0}, down), std::invalid_argument);
    const Shape frame = withHoles(rectangle(-0.1, -0.1, 0.1, 0.1), {rectangle(-0.02, -0.02, 0.02, 0.02)});
    EXPECT_THROW(pointFactor(frame, {0.02, 0, 0}, down), std::invalid_argument); // the hole's edge
    const Pose X_SO = poseAt(0.02, 0.01, 0.08, 0.3, 0.2, 0.0);
    EXPECT_NEAR(discreteSurfaceIntegral(washer, frame, X_SO, 3000),
                piercedFactor({washer, frame, X_SO}).value, 5e-3);
    EXPECT_THROW(simpsonViewFactor(Disk{0.1}, washer, X_SO, 64), std::invalid_argument);
    EXPECT_THROW(simpsonViewFactor(washer, Disk{0.1}, X_SO, 64), std::invalid_argument);
}

// Catches: a hole as large as its outline, which leaves no face.
TEST(ViewFactorHoles, aFaceOfNoAreaIsRefused) {
    const Contour square = rectangle(-0.1, -0.1, 0.1, 0.1);
    EXPECT_THROW(RadiatingContour(withHoles(square, {square})), std::invalid_argument);
}

} // namespace
} // namespace bask
