#include "widgets/scene/planned_path.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

double drawn_m(const std::vector<Eigen::Vector3d>& ends) {
    double sum_m = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        sum_m += (ends[i + 1] - ends[i]).norm();
    return sum_m;
}

// Catches a planned path that looks like the solid trail, or dashes that lie beside it.
TEST(PlannedPath, DashesAndGapsAreOfTheSameLength) {
    const std::vector<Eigen::Vector3d> ends = dashedLine({{0.0, 0.0, 0.2}, {0.095, 0.0, 0.2}}, 0.01);
    ASSERT_EQ(ends.size(), 10U);
    EXPECT_NEAR(drawn_m(ends), 0.05, 1e-9);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        EXPECT_NEAR(ends[i].x(), 0.01 * static_cast<double>(i), 1e-9);
        EXPECT_EQ(ends[i].z(), 0.2);
    }
}

// Catches dashes that begin anew at each sample: a slow robot's path would be solid.
TEST(PlannedPath, DashesGoOnAcrossTheSamples) {
    std::vector<Eigen::Vector3d> line;
    line.reserve(1001);
    for (int i = 0; i <= 1000; ++i)
        line.emplace_back(1e-4 * i, 0.0, 0.0);
    EXPECT_NEAR(drawn_m(dashedLine(line, 0.01)), 0.05, 2e-4);
    EXPECT_NEAR(drawn_m(dashedLine({{0, 0, 0}, {0.015, 0, 0}, {0.015, 0.015, 0}}, 0.01)), 0.02, 1e-9)
        << "around a corner";
}

// Catches an end that is not marked, also of a run that stays where it is, and a mark without a path.
TEST(PlannedPath, ItsEndIsMarked) {
    const Eigen::Vector3d end(0.0, 0.1, 0.05);
    const std::vector<Eigen::Vector3d> ends = plannedPath({end, end}, 0.01);
    ASSERT_EQ(ends.size(), 6U) << "a cross";
    for (std::size_t i = 0; i < ends.size(); i += 2)
        EXPECT_LT((0.5 * (ends[i] + ends[i + 1]) - end).norm(), 1e-12);
    EXPECT_EQ(plannedPath({{0, 0, 0}, {0.095, 0, 0}}, 0.01).size(), 16U);
    EXPECT_TRUE(plannedPath({}, 0.01).empty());
}

} // namespace
} // namespace bask
