#include "engine/base/message_code.h"
#include "engine/session/mounting_check.h"

#include "engine/base/units.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

ObjectSpec disk(const char* name, double x_m, double y_m, double radius_m = 0.015) {
    ObjectSpec object;
    object.name = name;
    object.shape = Disk{radius_m};
    object.mounting[kX] = x_m;
    object.mounting[kY] = y_m;
    return object;
}

std::vector<MessageCode> codesOf(const std::vector<ObjectSpec>& objects) {
    Experiment experiment;
    experiment.objects = objects;
    std::vector<MessageCode> out;
    for (const MountingRemark& remark : mountingRemarks(experiment))
        out.push_back(remark.message.code);
    return out;
}

} // namespace

// Catches remarks about a good arrangement, and about objects that only come close.
TEST(MountingCheck, ATriangleOfObjectsApartGivesNone) {
    EXPECT_TRUE(
        codesOf({disk("a", 0.0, 0.05), disk("b", -0.0435, -0.025), disk("c", 0.0435, -0.025)}).empty());
    EXPECT_TRUE(codesOf({disk("a", 0.0, 0.0), disk("b", 0.0301, 0.0)}).empty());
}

// Catches overlaps missed where one object lies within another, or where a turned edge reaches over.
TEST(MountingCheck, OverlapsAreToldWithBothNames) {
    using enum MessageCode;
    EXPECT_EQ(codesOf({disk("a", 0.0, 0.0), disk("b", 0.029, 0.0)}), std::vector{MountingOverlap});
    EXPECT_EQ(codesOf({disk("a", 0.0, 0.0, 0.05), disk("b", 0.01, 0.0)}), std::vector{MountingOverlap});
    ObjectSpec bar = disk("bar", 0.0, 0.0);
    bar.shape = Contour{{{-0.05, -0.005}, {0.05, -0.005}, {0.05, 0.005}, {-0.05, 0.005}}};
    const ObjectSpec above = disk("above", 0.0, 0.03);
    EXPECT_TRUE(codesOf({bar, above}).empty());
    bar.mounting[kThetaZ] = radFromDeg(90.0);
    EXPECT_EQ(codesOf({bar, above}), std::vector{MountingOverlap});
}

// Catches an object in the hole of another taken to shade it, and one that reaches over the hole's edge not.
TEST(MountingCheck, OneInTheHoleOfAnotherDoesNotOverlap) {
    ObjectSpec ring = disk("ring", 0.0, 0.0);
    ring.shape = withHoles(Disk{0.06}, {Contour{shapeOutline(Disk{0.03}, 90)}});
    for (const bool first : {true, false}) {
        const auto with = [&](double x_m) {
            const ObjectSpec small = disk("small", x_m, 0.0);
            return codesOf(first ? std::vector{ring, small} : std::vector{small, ring});
        };
        EXPECT_TRUE(with(0.0).empty());
        EXPECT_TRUE(with(0.014).empty());
        EXPECT_EQ(with(0.02), std::vector{MessageCode::MountingOverlap});
        EXPECT_EQ(with(0.045), std::vector{MessageCode::MountingOverlap});
    }
}

// Catches a limit that is measured to the centre instead of the outline.
TEST(MountingCheck, ObjectsFartherOutThanTheRobotCarriesAreTold) {
    EXPECT_TRUE(codesOf({disk("a", 0.18, 0.0)}).empty());
    EXPECT_EQ(codesOf({disk("a", 0.19, 0.0)}), std::vector{MessageCode::MountingFar});
}

// Catches lines told only along an axis, and flat triangles taken for good ones.
TEST(MountingCheck, ThreeInALineAreTold) {
    EXPECT_EQ(codesOf({disk("a", -0.05, -0.05), disk("b", 0.0, 0.002), disk("c", 0.05, 0.05)}),
              std::vector{MessageCode::MountingInLine});
}

} // namespace bask
