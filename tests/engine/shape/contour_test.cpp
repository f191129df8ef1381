// makeContour's checks and what is measured of a contour.

#include "engine/base/message_code.h"
#include "tests/engine/shape/shape_samples.h"
#include "tests/support/thread_time.h"

#include "engine/shape/crossing.h"
#include "engine/shape/hausdorff.h"

#include <algorithm>
#include <limits>
#include <random>

namespace bask {
namespace {

using test::Points;

const Points kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

MessageCode refusalOf(const Points& points) {
    const auto contour = makeContour(points, "here");
    if (contour)
        return MessageCode::None;
    EXPECT_EQ(contour.error().where, "here");
    EXPECT_FALSE(describe(contour.error()).empty());
    return contour.error().code();
}

// Two edges without a common end meet: the definition, in n^2 steps.
bool crossesByAllPairs(const Points& p) {
    const std::size_t n = p.size();
    const auto side = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
        const double d = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
        return (d > 0) - (d < 0);
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if ((j + 1) % n == i)
                continue;
            const auto &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
            if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0)
                return true;
        }
    return false;
}

TEST(MakeContour, MeasuresASquareFarFromTheOrigin) {
    Points moved = kSquare;
    for (auto& p : moved)
        p += Eigen::Vector2d(1000.0, -500.0);
    const auto contour = makeContour(moved);
    ASSERT_TRUE(contour);
    EXPECT_NEAR(contourArea(*contour), 4.0, 1e-12);
    EXPECT_NEAR(contourPerimeter(*contour), 8.0, 1e-12);
    EXPECT_NEAR((contourCentroid(*contour) - Eigen::Vector2d(1001.0, -499.0)).norm(), 0.0, 1e-10);
    EXPECT_NEAR(contourCentroid(centred(*contour)).norm(), 0.0, 1e-10);
}

TEST(MakeContour, ReversesClockwiseInput) {
    Points clockwise = kSquare;
    std::ranges::reverse(clockwise);
    const auto contour = makeContour(clockwise);
    ASSERT_TRUE(contour);
    EXPECT_EQ(contour->points_m, kSquare);
    EXPECT_GT(contourArea(*contour), 0.0);
}

TEST(MakeContour, DropsRepeatedNeighboursAndARepeatedEnd) {
    const auto contour =
        makeContour({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}, {0, 0}, {0, 0}});
    ASSERT_TRUE(contour);
    EXPECT_EQ(contour->points_m, kSquare);
}

TEST(MakeContour, KeepsPointsInTheMiddleOfEdges) {
    const auto contour = makeContour({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    ASSERT_TRUE(contour);
    EXPECT_EQ(contour->points_m.size(), 7U);
}

TEST(MakeContour, RefusesTooFewPoints) {
    EXPECT_EQ(refusalOf({}), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(refusalOf({{1, 1}}), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(refusalOf({{1, 1}, {2, 2}}), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(refusalOf({{1, 1}, {2, 2}, {1, 1}, {1, 1}}), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(refusalOf(Points(50, Eigen::Vector2d(3, 4))), MessageCode::ContourTooFewPoints);
}

TEST(MakeContour, RefusesWhatIsNotFiniteOrAbsurd) {
    Points bad = kSquare;
    bad[2].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusalOf(bad), MessageCode::ContourNotFinite);
    EXPECT_NE(describe(makeContour(bad).error()).find("point 3"), std::string::npos);
    bad[2].y() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusalOf(bad), MessageCode::ContourNotFinite);
    bad[2].y() = 1e300;
    EXPECT_EQ(refusalOf(bad), MessageCode::ValueOutOfRange);
}

TEST(MakeContour, RefusesALine) {
    EXPECT_EQ(refusalOf({{0, 0}, {1, 2}, {2, 4}}), MessageCode::ContourZeroArea);
    EXPECT_EQ(refusalOf({{0, 0}, {0.1, 0.1}, {0.7, 0.7}, {0.3, 0.3}}), MessageCode::ContourZeroArea);
}

TEST(MakeContour, NamesTheEdgesThatCrossByTheInputsNumbers) {
    // A repeated first point must not shift the numbers: edge 3 runs from point 3 to point 4.
    const auto contour = makeContour({{0, 0}, {0, 0}, {0.002, 0.002}, {0.002, 0}, {0, 0.002}}, "file");
    ASSERT_FALSE(contour);
    EXPECT_EQ(contour.error().code(), MessageCode::ContourCrossing);
    EXPECT_EQ(describe(contour.error()),
              "file: the outline crosses itself: edges 1 and 4 meet near (1, 1) mm");
}

TEST(MakeContour, RefusesEveryKindOfTouch) {
    EXPECT_EQ(refusalOf({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), MessageCode::ContourCrossing)
        << "vertex on edge";
    EXPECT_EQ(refusalOf({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}), MessageCode::ContourCrossing)
        << "two vertices in one place";
    EXPECT_EQ(refusalOf({{0, 0}, {4, 0}, {4, 4}, {6, 4}, {4, 4.0}, {0, 4}}), MessageCode::ContourCrossing)
        << "a hair that folds back";
    EXPECT_EQ(refusalOf({{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 0}, {2, 0}, {2, 2}, {0, 2}}),
              MessageCode::ContourCrossing)
        << "edges on each other";
    EXPECT_EQ(refusalOf({{0, 0}, {0, 4}, {2, 4}, {2, 3}, {0, 3}, {0, 1}, {3, 1}, {3, 0}}),
              MessageCode::ContourCrossing)
        << "upright edges on each other";
}

TEST(MakeContour, RefusesStarsAndEights) {
    Points star;
    for (int k = 0; k < 7; ++k)
        star.emplace_back(std::cos(3 * 2 * std::numbers::pi * k / 7),
                          std::sin(3 * 2 * std::numbers::pi * k / 7));
    EXPECT_EQ(refusalOf(star), MessageCode::ContourCrossing);
    EXPECT_EQ(refusalOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), MessageCode::ContourCrossing)
        << "eight of no net area";
}

TEST(MakeContour, AgreesWithAllPairsOnRandomPolygons) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    int simple = 0;
    for (int trial = 0; trial < 1200; ++trial) {
        const int n = 4 + trial % 9;
        Points p;
        for (int k = 0; k < n;
             ++k) { // half of them star-shaped and so simple, then one point is moved at times
            const double t = 2 * std::numbers::pi * k / n, r = 0.2 + number(random);
            p.push_back(trial % 2 ? Eigen::Vector2d(r * std::cos(t), r * std::sin(t))
                                  : Eigen::Vector2d(number(random), number(random)));
        }
        if (trial % 3 == 0)
            p[1] = {number(random) - 0.5, number(random) - 0.5};
        const bool crossing = crossesByAllPairs(p);
        simple += !crossing;
        EXPECT_EQ(findCrossing(p).has_value(), crossing) << "trial " << trial;
    }
    EXPECT_GT(simple, 300);
}

TEST(MakeContour, IsNotMisledByUprightAndLevelEdges) {
    // Upright and level edges and equal x are where a sweep goes wrong: combs of random teeth.
    std::mt19937 random(11);
    for (int trial = 0; trial < 300; ++trial) {
        Points p{{0, 0}};
        const int teeth = 3 + trial % 6;
        for (int k = 0; k < teeth; ++k) {
            const double height = 1 + static_cast<int>(random() % 5);
            p.insert(
                p.end(),
                {{2.0 * k, 10 + height}, {2.0 * k + 1, 10 + height}, {2.0 * k + 1, 10}, {2.0 * k + 2, 10}});
        }
        p.emplace_back(2.0 * teeth, 0);
        EXPECT_FALSE(findCrossing(p)) << trial;
        p.back() = {2.0 * teeth + 1, 10.5};
        p.emplace_back(-1, 10.5); // the way back cuts every tooth
        EXPECT_TRUE(findCrossing(p)) << trial;
    }
}

TEST(MakeContour, TakesSixtyThousandPointsAtOnce) {
    const auto takes = [](const Points& points, MessageCode expected) {
        const double before_s = test::threadTime_s();
        EXPECT_EQ(refusalOf(points), expected);
        EXPECT_LT(test::threadTime_s() - before_s, 2.0);
    };
    takes(test::wavy(60000, 40), MessageCode::None);
    Points comb; // long slanted teeth, where grids and boxes degrade to all pairs
    for (int k = 0; k < 30000; ++k) {
        comb.emplace_back(k, 0.0);
        comb.emplace_back(k + 20000.5, 20000.0);
    }
    comb.emplace_back(60000.0, -1.0);
    comb.emplace_back(0.0, -1.0);
    takes(comb, MessageCode::None);
    Points crossing = test::wavy(60000, 40);
    std::swap(crossing[30000], crossing[30500]);
    takes(crossing, MessageCode::ContourCrossing);
}

TEST(Simplified, LeavesOutWhatLiesWithinTheTolerance) {
    const Contour fine = *makeContour(test::ellipse(1.0, 1.0, 4000));
    const Contour coarse = simplified(fine, 1e-3);
    EXPECT_LE(coarse.points_m.size(), 128U); // bisected; 71 would do
    EXPECT_GT(coarse.points_m.size(), 20U);
    for (const auto& p : coarse.points_m)
        EXPECT_TRUE(std::ranges::find(fine.points_m, p) != fine.points_m.end());
    EXPECT_NEAR(contourArea(coarse), contourArea(fine), 2e-3 * contourPerimeter(fine));
    const Contour square = *makeContour({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    EXPECT_EQ(simplified(square, 1e-6).points_m, (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(Simplified, StaysSimpleAndKeepsWhatCannotBeThinned) {
    const Contour wavy = *makeContour(test::wavy(2000, 25));
    for (const double tolerance : {0.0, 0.01, 0.1, 0.5, 10.0}) {
        const Contour thin = simplified(wavy, tolerance);
        EXPECT_TRUE(makeContour(thin.points_m)) << tolerance;
        EXPECT_EQ(thin == wavy, tolerance == 0.0);
    }
    const Contour triangle = *makeContour({{0, 0}, {1, 0}, {0, 1}});
    EXPECT_EQ(simplified(triangle, 100.0), triangle);
}

// Catches an outline thinned that need not be, one left with too many points, and one thinned beyond need.
TEST(SimplifiedTo, LeavesAsManyPointsAsAreAllowed) {
    const Contour wavy = *makeContour(test::wavy(60000, 12));
    EXPECT_EQ(simplifiedTo(wavy, 60000), wavy);
    const Contour few = simplifiedTo(wavy, 5000);
    EXPECT_LE(few.points_m.size(), 5000U);
    EXPECT_LT(hausdorffDistance(few.points_m, wavy.points_m, 1e-7), 2e-6 * contourPerimeter(wavy));
    EXPECT_LE(simplifiedTo(wavy, 50).points_m.size(), 50U);
}

// Catches corners lost, points beside the outline, and gaps.
TEST(PointsAlong, KeepTheCornersAndFillLongEdges) {
    const Contour contour = *makeContour(kSquare);
    const Points points = pointsAlong(contour, 0.3);
    EXPECT_EQ(points.size(), 28U);
    for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_NEAR((points[(k + 1) % points.size()] - points[k]).norm(), 2.0 / 7.0, 1e-12);
        EXPECT_EQ(points[k] == kSquare[k / 7], k % 7 == 0);
    }
    EXPECT_EQ(pointsAlong(contour, 5.0), kSquare);
}

} // namespace
} // namespace bask
