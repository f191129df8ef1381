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

// Catches a tree that misses edges or stops too early.
TEST(Hausdorff, EqualsBruteForce) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto ring = [&](int n) {
        test::Points points;
        for (int k = 0; k < n; ++k)
            points.emplace_back(number(random), number(random));
        return points;
    };
    const auto toEdges = [](const Eigen::Vector2d& p, const test::Points& r) {
        double best = 1e9;
        for (std::size_t k = 0; k < r.size(); ++k) {
            const Eigen::Vector2d a = r[k], e = r[(k + 1) % r.size()] - a;
            best =
                std::min(best, (p - a - std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm());
        }
        return best;
    };
    for (int trial = 0; trial < 40; ++trial) {
        const test::Points a = ring(3 + trial), b = ring(3 + 2 * (trial % 7));
        double most = 0.0;
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
            for (std::size_t k = 0; k < from.size(); ++k)
                for (int s = 0; s < 400; ++s)
                    most = std::max(
                        most, toEdges(from[k] + s / 400.0 * (from[(k + 1) % from.size()] - from[k]), to));
        const double found = hausdorffDistance(a, b, 1e-6);
        EXPECT_GT(found, most - 2e-6) << trial;
        EXPECT_LT(found, most + 0.005) << trial;
    }
}

} // namespace
} // namespace bask
