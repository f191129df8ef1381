#include "widgets/scene/source_pattern.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

constexpr int kPatternCells = 41; // the middle one is at the origin

double atCell(const std::vector<double>& pattern, std::size_t column, std::size_t row) {
    return pattern.at(row * kPatternCells + column);
}

Experiment plate() {
    Experiment e;
    e.source.shape = Disk{0.1};
    return e;
}

const Eigen::AlignedBox2d kPatternBox(Eigen::Vector2d(-0.1, -0.1), Eigen::Vector2d(0.1, 0.1));

} // namespace

TEST(SourcePattern, PartsAreWhereTheyLie) {
    Experiment e = plate();
    SourcePartSpec part;
    part.shape = Disk{0.03};
    part.pose[kX] = 0.05;
    part.emittance = 0.5 * e.source.emittance;
    e.source.uneven.parts = {part};
    const std::vector<double> pattern = sourcePattern(e, kPatternBox, kPatternCells);
    EXPECT_NEAR(atCell(pattern, 30, 20), 0.5, 1e-12);
    EXPECT_EQ(atCell(pattern, 20, 20), 0.0);
    EXPECT_EQ(atCell(pattern, 10, 20), 0.0);
    EXPECT_EQ(partRings(e.source.uneven, 60).size(), 1U);
}

TEST(SourcePattern, AProfileFallsAlongTheRadius) {
    Experiment e = plate();
    e.source.uneven.profile = {{0.02, 1.0}, {0.08, 0.5}};
    const std::vector<double> pattern = sourcePattern(e, kPatternBox, kPatternCells);
    EXPECT_DOUBLE_EQ(atCell(pattern, 20, 20), 1.0);
    EXPECT_DOUBLE_EQ(atCell(pattern, 22, 20), 1.0);
    double before = 1.0;
    for (std::size_t column = 25; column < 36; ++column) {
        EXPECT_LT(atCell(pattern, column, 20), before);
        before = atCell(pattern, column, 20);
    }
    EXPECT_EQ(atCell(pattern, 38, 20), atCell(pattern, 40, 20));
    EXPECT_EQ(atCell(pattern, 20, 30), atCell(pattern, 30, 20));
}

} // namespace bask
