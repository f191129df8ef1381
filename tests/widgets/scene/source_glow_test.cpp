// The glow of a source against the closed form of a disk, and where it must be dark.

#include "widgets/scene/source_glow.h"

#include "engine/shape/shape.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

constexpr int kCells = 64;

// Catches a glow that is not settled, or is shifted by half a cell.
TEST(SourceGlow, OfADiskFallsWithTheSquareOfTheRadius) {
    const auto outline = shapeOutline(Disk{0.1}, 160);
    const auto glow = sourceGlow(outline, boxOf(outline), kCells);
    ASSERT_EQ(glow.size(), std::size_t{kCells * kCells});
    for (int row = 0; row < kCells; ++row)
        for (int column = 0; column < kCells; ++column) {
            const Eigen::Vector2d q(2.0 * (column + 0.5) / kCells - 1.0, 2.0 * (row + 0.5) / kCells - 1.0);
            EXPECT_NEAR(glow[static_cast<std::size_t>(row * kCells + column)],
                        std::max(0.0, 1.0 - q.squaredNorm()), 0.06)
                << q.transpose();
        }
}

// Catches a notch that glows, and axes that are swapped: the outline is higher than wide and not symmetric.
TEST(SourceGlow, StaysWithinTheOutline) {
    const std::vector<Eigen::Vector2d> outline{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0},
                                               {0.5, 1.0}, {0.5, 4.0}, {0.0, 4.0}};
    const auto glow = sourceGlow(outline, boxOf(outline), kCells);
    for (int row = 0; row < kCells; ++row)
        for (int column = 0; column < kCells; ++column) {
            const bool notch = row >= kCells / 4 && column >= kCells / 2;
            EXPECT_EQ(glow[static_cast<std::size_t>(row * kCells + column)] > 0.0, !notch)
                << row << " " << column;
        }
    EXPECT_EQ(*std::ranges::max_element(glow), 1.0);
}

// Catches a line that enters an outline and never leaves it, which at a corner is easily so.
TEST(OutlineCrossings, AreEvenEvenThroughCornersAndAlongEdges) {
    const std::vector<Eigen::Vector2d> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (const double at : {-1.0, -0.5, 0.0, 0.5, 0.9999})
        for (const int axis : {0, 1})
            EXPECT_EQ(outlineCrossings(square, axis, at), (std::vector<double>{-1.0, 1.0})) << at;
    EXPECT_TRUE(outlineCrossings(square, 0, 1.5).empty());
    const std::vector<Eigen::Vector2d> diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    for (const double at : {-1.0, -0.25, 0.0, 0.25, 1.0})
        EXPECT_EQ(outlineCrossings(diamond, 0, at).size() % 2, 0u) << at;
}

} // namespace
} // namespace bask
