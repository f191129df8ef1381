#include "engine/base/message_code.h"
#include "engine/shape/outline_file.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

FileOutline square(double side_m, double at_m, int region, bool closed = true) {
    return {{{at_m, at_m}, {at_m + side_m, at_m}, {at_m + side_m, at_m + side_m}, {at_m, at_m + side_m}},
            closed,
            region};
}

} // namespace

// Catches holes found by size or order alone, across regions, and islands in holes that count as holes.
TEST(OutlineFile, LargestFirstAndHolesWithinTheirRegion) {
    OutlineFile file;
    file.outlines = {square(0.005, 0.045, 0), square(0.5, 0.0, 1, false), square(0.1, 0.0, 0),
                     square(0.02, 0.04, 0),   square(0.03, 0.2, 0),       square(0.01, 0.01, 1)};
    file.arrange();
    ASSERT_EQ(file.outlines.size(), 6U);
    const std::vector<double> areas_m2{0.01, 0.0009, 0.0004, 0.0001, 0.000025, 0.0};
    const std::vector<bool> holes{false, false, true, false, false, false};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(file.outlines[i].area_m2(), areas_m2[i], 1e-12) << i;
        EXPECT_EQ(file.outlines[i].hole, holes[i]) << i;
    }
    EXPECT_FALSE(file.outlines[5].closed);
    EXPECT_NEAR(file.outlines[5].perimeter_m(), 1.5, 1e-12);
    EXPECT_NEAR(file.outlines[0].perimeter_m(), 0.4, 1e-12);
}

// Catches an open outline that is closed in silence.
TEST(OutlineFile, AnOpenOutlineIsNoContour) {
    const auto refused = contourOf(square(0.1, 0.0, 0, false), "plate.dxf");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ContourOpen);
    EXPECT_TRUE(contourOf(square(0.1, 0.0, 0)));
}

} // namespace bask
