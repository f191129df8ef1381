// The distance of two outlines against closed forms and against brute force.

#include "engine/shape/hausdorff.h"
#include "tests/engine/shape/shape_samples.h"

#include <random>

namespace bask {
namespace {

// Catches one way only, and corners only: the largest distance is that of the middle of an edge.
TEST(Hausdorff, CountsBothWaysAndEveryPointOfAnEdge) {
    const test::Points square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const test::Points spike{{-1, -1}, {1, -1}, {1, 1}, {0.001, 1}, {0, 3}, {-0.001, 1}, {-1, 1}};
    EXPECT_NEAR(hausdorffDistance(square, spike, 1e-9), 2.0, 1e-6);
    EXPECT_NEAR(hausdorffDistance(spike, square, 1e-9), 2.0, 1e-6);
    const test::Points notched{{-1, -1}, {1, -1}, {1, 1}, {0.5, 1}, {0.5, 0}, {-0.5, 0}, {-0.5, 1}, {-1, 1}};
    EXPECT_NEAR(hausdorffDistance(square, notched, 1e-9), 1.0, 1e-6) << "the notch's floor";
    EXPECT_NEAR(hausdorffDistance({{-1, 0}, {1, 0}, {1, 1e-9}}, {{-1, 0}, {0, 0.7}, {1, 0}, {0, -0.2}}, 1e-9),
                0.7, 1e-6);
    EXPECT_EQ(hausdorffDistance(square, square, 1e-9), 0.0);
    EXPECT_NEAR(hausdorffDistance({{0, 0}}, {{3, 4}}, 1e-9), 5.0, 1e-12);
}

test::Points randomRing(std::mt19937& random, int n) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    test::Points points;
    for (int k = 0; k < n; ++k) {
        const double x = number(random);
        points.emplace_back(x, number(random));
    }
    return points;
}

double toEdges(const Eigen::Vector2d& p, const test::Points& ring) {
    double best = 1e9;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector2d a = ring[k], e = ring[(k + 1) % ring.size()] - a;
        best = std::min(best, (p - a - std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm());
    }
    return best;
}

// Catches a tree that misses edges or stops too early.
TEST(Hausdorff, EqualsBruteForce) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 40; ++trial) {
        const test::Points a = randomRing(random, 3 + trial), b = randomRing(random, 3 + 2 * (trial % 7));
        double max = 0.0;
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
            for (std::size_t k = 0; k < from.size(); ++k)
                for (int s = 0; s < 400; ++s)
                    max = std::max(
                        max, toEdges(from[k] + s / 400.0 * (from[(k + 1) % from.size()] - from[k]), to));
        const double found = hausdorffDistance(a, b, 1e-6);
        EXPECT_GT(found, max - 2e-6) << trial;
        EXPECT_LT(found, max + 0.005) << trial;
    }
}

// Catches distances to corners only, and a search that stops at the nearest edge of the point before.
TEST(DistancesTo, EqualBruteForcePointByPoint) {
    std::mt19937 random(12);
    for (int trial = 0; trial < 40; ++trial) {
        const test::Points ring = randomRing(random, 1 + trial), points = randomRing(random, 200);
        const std::vector<double> distances = distancesTo(ring, points);
        ASSERT_EQ(distances.size(), points.size());
        for (std::size_t k = 0; k < points.size(); ++k)
            EXPECT_NEAR(distances[k],
                        ring.size() == 1 ? (points[k] - ring[0]).norm() : toEdges(points[k], ring), 1e-12);
    }
}

} // namespace
} // namespace bask
