#include "widgets/scene/cut_sheet.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches: samples of another layer, rows and columns mixed up, a cut between layers that jumps to one of
// them.
TEST(CutSheet, IsTheFieldOnThePlane) {
    Field field;
    field.axes = {{kX, -1.0, 0.5, 5}, {kY, 0.0, 0.25, 4}, {kZ, 2.0, 1.0, 3}};
    const auto value = [](const Eigen::Vector3d& p) { return 100.0 * p.x() + 10.0 * p.y() + p.z(); };
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 5; ++i)
                field.values.push_back(
                    value({field.axes[0].at(i), field.axes[1].at(j), field.axes[2].at(k)}));
    const double places[] = {0.3, 0.6, 3.7};
    for (int axis = 0; axis < 3; ++axis) {
        const CutSheet sheet = sheetOf(field, axis, places[axis]);
        const auto next = static_cast<std::size_t>((axis + 1) % 3);
        EXPECT_EQ(sheet.columns, field.axes[next].count);
        ASSERT_EQ(sheet.points.size(),
                  field.values.size() / field.axes[static_cast<std::size_t>(axis)].count);
        for (std::size_t i = 0; i < sheet.points.size(); ++i) {
            EXPECT_NEAR(sheet.points[i][axis], places[axis], 1e-12);
            EXPECT_NEAR(sheet.values[i], value(sheet.points[i]), 1e-9);
        }
    }
    EXPECT_NEAR(sheetOf(field, 2, 99.0).points[0].z(), 4.0, 1e-12) << "its end";
    EXPECT_NEAR(sheetOf(field, 2, 99.0).values[0], value({-1.0, 0.0, 4.0}), 1e-9);
}

} // namespace
} // namespace bask
