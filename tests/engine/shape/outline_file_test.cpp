#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/hausdorff.h"
#include "engine/shape/shape.h"

#include <gtest/gtest.h>

#include <utility>

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

// Catches holes that the solver cannot have, taken or left out without a word, and holes of another outline.
TEST(OutlineFile, PickedWithTheHolesThatFit) {
    OutlineFile file;
    FileOutline bowtie = square(0.01, 0.06, 0);
    std::swap(bowtie.points_m[1], bowtie.points_m[2]);
    bowtie.points_m[0].x() -= 0.005; // else it has no area
    file.outlines = {square(0.1, 0.0, 0),  square(0.011, 0.02, 0), square(0.01, 0.03, 0), bowtie,
                     square(0.05, 0.2, 0), square(0.02, 0.21, 0)};
    file.arrange();
    const auto picked = pickOutline(file, std::nullopt, "");
    ASSERT_TRUE(picked);
    ASSERT_EQ(picked->holes.size(), 1U) << "the squares touch, the bow tie crosses itself";
    EXPECT_EQ(picked->holes[0].points_m, square(0.011, 0.02, 0).points_m);
    EXPECT_EQ(picked->warnings.back(), (Message{MessageCode::HolesLeftOut, {"2", "200"}}));
    const auto other = pickOutline(file, 1, "");
    ASSERT_TRUE(other);
    EXPECT_TRUE(other->warnings.empty());
    ASSERT_EQ(other->holes.size(), 1U);

    OutlineFile sieve;
    sieve.outlines = {square(1.0, 0.0, 0)};
    for (int k = 0; k < 210; ++k)
        sieve.outlines.push_back(square(0.002, 0.1 + 0.003 * k, 0));
    sieve.arrange();
    const auto limited = pickOutline(sieve, std::nullopt, "");
    ASSERT_TRUE(limited);
    EXPECT_EQ(limited->holes.size(), kMaxHoles);
    EXPECT_EQ(limited->warnings.back(), (Message{MessageCode::HolesLeftOut, {"10", "200"}}));
}

// Catches corners of holes thinned without need, without a word, or farther than is said.
TEST(OutlineFile, HolesOfManyCornersAreThinned) {
    const auto pickedWith = [](int holes) {
        OutlineFile file;
        file.outlines = {square(1.0, 0.0, 0)};
        for (int k = 0; k < holes; ++k) {
            FileOutline round;
            for (const Eigen::Vector2d& p : shapeOutline(Disk{0.0025}, 96))
                round.points_m.push_back(p + Eigen::Vector2d(0.1 + 0.006 * k, 0.5));
            file.outlines.push_back(round);
        }
        file.arrange();
        return pickOutline(file, std::nullopt, "").value();
    };
    const PickedOutline few = pickedWith(40);
    EXPECT_EQ(few.holes[0].points_m.size(), 96U);
    EXPECT_TRUE(few.warnings.empty());
    const PickedOutline many = pickedWith(100);
    ASSERT_EQ(many.holes.size(), 100U);
    std::size_t corners = 0;
    for (const Contour& hole : many.holes) {
        corners += hole.points_m.size();
        EXPECT_NEAR(hausdorffDistance(
                        hole.points_m,
                        shifted(few.holes[0], contourCentroid(hole) - contourCentroid(few.holes[0])).points_m,
                        1e-7),
                    0.0, 5e-5);
    }
    EXPECT_LE(corners, 4000U);
    ASSERT_EQ(many.warnings.size(), 1U);
    EXPECT_EQ(many.warnings[0].code, MessageCode::HolesThinned);
    EXPECT_EQ(many.warnings[0].args[0], "9600");
    EXPECT_EQ(many.warnings[0].args[1], std::to_string(corners));
    EXPECT_LT(std::stod(many.warnings[0].args[2].text()), 0.05) << "mm";
}

// Catches an open outline that is closed in silence.
TEST(OutlineFile, AnOpenOutlineIsNoContour) {
    const auto refused = contourOf(square(0.1, 0.0, 0, false), "plate.dxf");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ContourOpen);
    EXPECT_TRUE(contourOf(square(0.1, 0.0, 0)));
}

} // namespace bask
