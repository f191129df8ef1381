#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/mounting_check.h"

#include "engine/base/units.h"
#include "tests/support/sanitized.h"
#include "tests/support/thread_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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

std::vector<MessageCode> codesOf(const Experiment& experiment) {
    std::vector<MessageCode> out;
    for (const MountingRemark& remark : mountingRemarks(experiment))
        out.push_back(remark.message.code);
    return out;
}

std::vector<MessageCode> codesOf(const std::vector<ObjectSpec>& objects,
                                 const std::array<bool, 6>& free = RobotLimits{}.free) {
    Experiment experiment;
    experiment.objects = objects;
    experiment.robot.free = free;
    experiment.robot.lower[kThetaZ] = -0.5;
    experiment.robot.upper[kThetaZ] = 0.5;
    return codesOf(experiment);
}

} // namespace

// Catches remarks about a good arrangement, and about objects that only come close.
TEST(MountingCheck, ATriangleOfObjectsApartGivesNone) {
    EXPECT_TRUE(
        codesOf({disk("a", 0.0, 0.05), disk("b", -0.0435, -0.025), disk("c", 0.0435, -0.025)}).empty());
    EXPECT_TRUE(codesOf({disk("a", 0.0, 0.0), disk("b", 0.0301, 0.0)}).empty());
}

// Catches fixtures and shields that pass through what they cannot, unnamed or with another's place.
TEST(MountingCheck, FixturesAndShieldsCannotPassThroughOthers) {
    Experiment experiment;
    experiment.objects = {disk("hand", 0.0, 0.0), disk("cup", 0.06, 0.0)};
    const auto plate = [](const char* name, double x_m, double turned_rad) {
        PlateSpec spec{name, Disk{0.01}};
        spec.pose[kX] = x_m;
        spec.pose[kThetaY] = turned_rad;
        return spec;
    };
    experiment.fixtures = {plate("arm", 0.03, 1.5), plate("bolt", 0.06, 1.5)};
    experiment.shields = {plate("screen", 0.0, 0.0)};
    const auto refused = checkMounting(experiment);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::MountingOverlap);
    EXPECT_EQ(refused.error().where, "fixtures[1].mounting");
    EXPECT_NE(describe(refused.error()).find("cup and bolt"), std::string::npos);
    EXPECT_EQ(std::ranges::count(codesOf(experiment), MessageCode::MountingOverlap), 1);

    experiment.fixtures[1] = plate("bolt", 0.03, 0.0);
    EXPECT_EQ(checkMounting(experiment).error().where, "fixtures[1].mounting") << "through the arm";
    experiment.fixtures.pop_back();
    EXPECT_TRUE(checkMounting(experiment)) << "a shield is not held";
    experiment.shields.push_back(plate("second", 0.0, 1.0));
    EXPECT_EQ(checkMounting(experiment).error().where, "shields[1].pose");
}

// Catches a sentence about shade with the wrong taker, or a fixture taken for an object.
TEST(MountingCheck, TellsWhatAScreenTakes) {
    Experiment experiment;
    experiment.objects = {disk("hand", 0.0, 0.0), disk("cup", 0.06, 0.0)};
    PlateSpec screen{"screen", Disk{0.03}};
    screen.pose[kZ] = 0.03;
    experiment.shields = {screen};
    const auto remarks = shadeRemarks(experiment, experiment.start, ShadedPose::Start);
    ASSERT_FALSE(remarks.empty());
    EXPECT_EQ(describe(remarks[0].message).rfind("screen takes ", 0), 0U) << describe(remarks[0].message);
    EXPECT_EQ(remarks[0].objects, std::vector<int>{0});
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

// Catches edges of one line taken for edges that meet.
TEST(MountingCheck, AlignedObjectsApartDoNotOverlap) {
    ObjectSpec one = disk("one", 0.0, 0.0), other = disk("other", 0.0, 0.02);
    one.shape = other.shape = Contour{{{-0.005, -0.005}, {0.005, -0.005}, {0.005, 0.005}, {-0.005, 0.005}}};
    EXPECT_TRUE(codesOf({one, other}).empty());
    other.mounting[kY] = 0.009;
    EXPECT_EQ(codesOf({one, other}), std::vector{MessageCode::MountingOverlap});
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

// Catches an overlap that is told below what is only unwise, where a list shows its first lines.
TEST(MountingCheck, OverlapsAreToldFirst) {
    using enum MessageCode;
    const auto codes =
        codesOf({disk("a", -0.19, 0.0), disk("b", 0.0, 0.0), disk("c", 0.06, 0.0), disk("d", 0.08, 0.0)});
    ASSERT_GE(codes.size(), 4U);
    EXPECT_EQ(codes[0], MountingOverlap);
    EXPECT_EQ(codes[1], MountingFar);
    EXPECT_EQ(codes[2], MountingInLine);
}

// Catches arrangements that the free axes cannot heat as wanted and of which nothing is said, or the wrong
// thing: never moved, always alike, fewer ways than objects, and none left over.
TEST(MountingCheck, WhatTheFreeAxesCannotDoIsTold) {
    using enum MessageCode;
    const std::array<bool, 6> turnOnly{false, false, false, false, false, true};
    const std::array<bool, 6> symmetric{false, true, true, true, false, false};
    const std::array<bool, 6> raiseAndTurn{false, false, true, false, false, true};
    EXPECT_EQ(codesOf({disk("a", 0.0, 0.0)}, turnOnly), std::vector{MountingUnmoved});
    EXPECT_EQ(codesOf({disk("a", -0.04, 0.0), disk("b", 0.04, 0.0)}, symmetric), std::vector{MountingAlike});
    EXPECT_EQ(codesOf({disk("a", 0.0, 0.0), disk("b", 0.04, 0.0)}, raiseAndTurn),
              std::vector{MountingDependent});
    EXPECT_EQ(codesOf({disk("a", 0.0, 0.05), disk("b", -0.0435, -0.025), disk("c", 0.0435, -0.025),
                       disk("d", 0.0, 0.0)}),
              std::vector{MountingNoneLeft});
}

// Catches outlines of many points compared edge by edge, which takes minutes, and thinned ones whose corners
// are gone.
TEST(MountingCheck, PolygonsOfManyPointsAreThinned) {
    Contour bar;
    for (int k = 0; k < 60000; ++k) // most points on one short side
        bar.points_m.emplace_back(0.05, -0.005 + 0.01 * k / 60000.0);
    bar.points_m.insert(bar.points_m.end(), {{0.05, 0.005}, {-0.05, 0.005}, {-0.05, -0.005}});
    EXPECT_LT(std::get<Contour>(thinned(bar)).points_m.size(), 10u);
    EXPECT_NEAR(shapeArea(thinned(bar)), 0.001, 1e-5);
    ObjectSpec one = disk("one", 0.0, 0.0), other = disk("other", 0.0, 0.02);
    one.shape = other.shape = bar;
    EXPECT_TRUE(codesOf({one, other}).empty());
    other.mounting[kY] = 0.0099;
    EXPECT_EQ(codesOf({one, other}), std::vector{MessageCode::MountingOverlap});
    const Shape few = Contour{{{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.00001}, {0.0, 0.01}}};
    EXPECT_EQ(thinned(few), few);
}

// Catches a remark that names others than it is about.
TEST(MountingCheck, TheAlikeOnesAreNamed) {
    Experiment experiment;
    experiment.objects = {disk("left", -0.04, 0.0), disk("middle", 0.0, 0.05), disk("right", 0.04, 0.0)};
    experiment.robot.free = {false, true, true, true, false, false};
    const std::vector<MountingRemark> remarks = mountingRemarks(experiment);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_EQ(argTexts(remarks[0].message), (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(remarks[0].objects, (std::vector{0, 2}));
}

// Catches remarks about the examples that come with Bask, but for the one that is meant to be in a line.
TEST(MountingCheck, TheExamplesAreSound) {
    for (const char* name : {"three-objects", "two-circles", "bare-aluminium", "rectangular-plate"}) {
        const auto experiment = readExperiment(std::string(BASK_EXAMPLES "/") + name + ".json");
        ASSERT_TRUE(experiment.ok()) << name;
        EXPECT_TRUE(mountingRemarks(*experiment).empty()) << name;
    }
    const auto line = readExperiment(BASK_EXAMPLES "/three-objects-in-line.json");
    ASSERT_TRUE(line.ok());
    // The axes can move these three independently: what a line cannot do is a matter of its targets. Bunny
    // and hand do touch.
    using enum MessageCode;
    EXPECT_EQ(codesOf(*line), (std::vector{MountingOverlap, MountingInLine}));
}

namespace {

Result<void> checkOf(const std::vector<ObjectSpec>& objects) {
    Experiment experiment;
    experiment.objects = objects;
    return checkMounting(experiment);
}

ObjectSpec plate(const char* name, double width_m, double height_m) {
    ObjectSpec object = disk(name, 0.0, 0.0);
    const double x = 0.5 * width_m, y = 0.5 * height_m;
    object.shape = Contour{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
    return object;
}

} // namespace

// Catches what nobody can build taken for an arrangement: two objects in one place, one within another, and
// two that cross, at right angles or less, anywhere along the line where their planes meet.
TEST(MountingPassage, ObjectsInOnePlaceAndThroughEachOtherAreRefused) {
    const auto refused = [](const ObjectSpec& one, const ObjectSpec& other) {
        for (const double turn : {0.0, 0.7}) { // together, which changes nothing
            const Pose X = poseFromRotationVector({0.02, -0.01, 0.03}, {turn, -0.5 * turn, 2.0 * turn});
            std::vector<ObjectSpec> both{one, disk("far", 0.5, 0.5), other};
            for (ObjectSpec& object : both)
                object.mounting = coordinatesFromPose(X * poseFromCoordinates(object.mounting));
            const auto check = checkOf(both);
            ASSERT_FALSE(check);
            EXPECT_EQ(check.error().code(), MessageCode::MountingOverlap);
            EXPECT_EQ(check.error().where, "objects[2].mounting");
            const auto window = codesOf(both);
            EXPECT_EQ(std::ranges::count(window, MessageCode::MountingOverlap), 1);
            EXPECT_EQ(argTexts(check.error().message), (std::vector<std::string>{"one", "other"}));
        }
    };
    const ObjectSpec one = disk("one", 0.0, 0.05);
    refused(one, disk("other", 0.0, 0.05));
    refused(one, disk("other", 0.0, 0.05, 0.04));
    refused(one, disk("other", 0.001, 0.05));
    refused(plate("one", 0.1, 0.01), plate("other", 0.008, 0.008));
    for (const double lean_deg : {1.0, 30.0, 90.0, 150.0})
        for (const double shift_m : {0.0, 0.02}) {
            ObjectSpec other = disk("other", 0.0, 0.05 + shift_m);
            other.mounting[kThetaX] = radFromDeg(90.0);
            other.mounting[kThetaY] = radFromDeg(lean_deg - 90.0);
            ObjectSpec upright = disk("one", 0.0, 0.05);
            upright.mounting[kThetaX] = radFromDeg(90.0);
            upright.mounting[kZ] = 0.5 * shift_m;
            if (shift_m == 0.0)
                refused(upright, other);
            ObjectSpec crossing = disk("other", 0.0, 0.05 + 0.5 * shift_m);
            crossing.mounting[kThetaX] = radFromDeg(lean_deg);
            refused(one, crossing);
        }
}

// Catches what can be built refused: side by side, edge on edge, one behind the other, leaning over it, its
// plane through the other but not itself, and a rod through a ring.
TEST(MountingPassage, ObjectsThatTouchShadeOrReachThroughAHoleAreAccepted) {
    const auto accepted = [](const ObjectSpec& one, const ObjectSpec& other) {
        const auto check = checkOf({one, other}), back = checkOf({other, one});
        EXPECT_TRUE(check) << describe(check.error());
        EXPECT_TRUE(back) << describe(back.error());
    };
    const ObjectSpec one = disk("one", 0.0, 0.0);
    accepted(one, disk("other", 0.0, 0.0301));
    accepted(one, disk("other", 0.0, 0.03));
    ObjectSpec behind = disk("other", 0.0, 0.005);
    behind.mounting[kZ] = 0.001;
    accepted(one, behind);
    behind.mounting[kThetaX] = radFromDeg(3.0);
    accepted(one, behind);
    ObjectSpec beside = disk("other", 0.0, 0.031);
    beside.mounting[kThetaX] = radFromDeg(90.0);
    accepted(one, beside);
    ObjectSpec standing = plate("other", 0.02, 0.02); // on the face, which it touches with an edge
    standing.mounting[kThetaX] = radFromDeg(90.0);
    standing.mounting[kZ] = 0.01;
    accepted(one, standing);
    ObjectSpec square = plate("one", 0.02, 0.02), next = plate("other", 0.02, 0.02);
    next.mounting[kX] = 0.02;
    accepted(square, next);
    ObjectSpec ring = disk("ring", 0.0, 0.0);
    ring.shape = withHoles(Disk{0.06}, {Contour{shapeOutline(Disk{0.03}, 90)}});
    ObjectSpec rod = plate("rod", 0.02, 0.2);
    rod.mounting[kThetaX] = radFromDeg(90.0);
    accepted(ring, rod);
    accepted(ring, disk("other", 0.0, 0.0));
    rod.mounting[kX] = 0.03;
    EXPECT_FALSE(checkOf({ring, rod})) << "through the edge of the hole";
}

// Catches an overlap in one plane that is not told or, being the paper's own, refused; and one told where
// objects touch or stand apart.
TEST(MountingPassage, APartialOverlapInOnePlaneIsToldNotRefused) {
    const auto told = [](const std::vector<ObjectSpec>& objects) {
        Experiment experiment;
        experiment.objects = objects;
        EXPECT_TRUE(checkMounting(experiment));
        return overlapsInPlane(experiment);
    };
    const auto remarks = told({disk("one", 0.0, 0.05), disk("far", 0.5, 0.0), disk("other", 0.0, 0.06)});
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_EQ(remarks[0].message.code, MessageCode::MountingOverlap);
    EXPECT_EQ(argTexts(remarks[0].message), (std::vector<std::string>{"one", "other"}));
    EXPECT_EQ(remarks[0].objects, (std::vector{0, 2}));
    EXPECT_EQ(told({plate("one", 0.1, 0.01), plate("other", 0.01, 0.1)}).size(), 1u);
    EXPECT_EQ(told({disk("small", 0.0, 0.02), disk("large", 0.0, -0.02, 0.045)}).size(), 1u);
    EXPECT_TRUE(told({disk("one", 0.0, 0.05), disk("other", 0.0, 0.08)}).empty());
    ObjectSpec behind = disk("other", 0.0, 0.06);
    behind.mounting[kZ] = 0.001;
    EXPECT_TRUE(told({disk("one", 0.0, 0.05), behind}).empty());
}

// Catches an example that its own commands refuse; bunny and hand of the line touch.
TEST(MountingPassage, EveryExampleIsAccepted) {
    int seen = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(BASK_EXAMPLES)) {
        const auto experiment = readExperiment(entry.path().string());
        if (entry.path().extension() != ".json" || !experiment)
            continue;
        ++seen;
        const auto check = checkMounting(*experiment);
        EXPECT_TRUE(check) << entry.path() << describe(check.error());
    }
    EXPECT_GT(seen, 25);
}

// Catches a page that waits at every edit for objects of many holes.
TEST(MountingCheck, IsQuickWithManyHoles) {
    std::vector<Contour> holes;
    for (int i = -7; i <= 7; ++i)
        for (int k = -7; k <= 7; ++k)
            if (const Eigen::Vector2d at(0.0019 * i, 0.0019 * k); at.norm() < 0.0139)
                holes.push_back(shifted(Contour{shapeOutline(Disk{0.0008}, 24)}, at));
    ASSERT_GT(holes.size(), 150u);
    ASSERT_TRUE(checkHoles(withHoles(Disk{0.015}, holes)));
    std::vector<ObjectSpec> objects;
    for (int k = 0; k < 6; ++k) {
        objects.push_back(disk(std::to_string(k).c_str(), 0.06 * std::cos(k), 0.06 * std::sin(k)));
        objects.back().shape = withHoles(objects.back().shape, holes);
    }
    const double before_s = test::threadTime_s();
    codesOf(objects);
    EXPECT_LT(test::threadTime_s() - before_s, test::kIsSanitized ? 9.0 : 0.9);
}

// Catches: an object above another taken for one that overlaps it; a shade that is not told, or told of the
// wrong two, with the wrong pose or a share that is nothing.
TEST(MountingCheck, WhoShadesWhomIsToldFromHalfAPercent) {
    Experiment experiment;
    experiment.objects = {disk("hand", 0.0, 0.0), disk("bunny", 0.02, 0.0)};
    experiment.start[kZ] = 0.15;
    EXPECT_TRUE(shadeRemarks(experiment, experiment.start, ShadedPose::Start).empty());
    experiment.objects[1].mounting[kZ] = -0.03;
    EXPECT_EQ(std::ranges::count(codesOf(experiment), MessageCode::MountingOverlap), 0);
    const auto told = shadeRemarks(experiment, experiment.start, ShadedPose::Start);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].objects, (std::vector<int>{0, 1}));
    const double percent = std::stod(told[0].message.args.at(1).text());
    EXPECT_GT(percent, 5.0);
    EXPECT_LT(percent, 60.0);
    EXPECT_EQ(describe(told[0].message),
              "bunny takes " + told[0].message.args[1].text() + " % of the light of hand at the start pose");
    const auto here = shadeRemarks(experiment, experiment.start, ShadedPose::Here);
    ASSERT_EQ(here.size(), 1u);
    EXPECT_TRUE(describe(here[0].message).ends_with(" of the light of hand at this pose"));
    experiment.objects.push_back(disk("little", 0.01, 0.0, 0.004)); // just above the bunny
    experiment.objects[2].mounting[kZ] = -0.02;
    const auto largestFirst = shadeRemarks(experiment, experiment.start, ShadedPose::Here);
    ASSERT_GE(largestFirst.size(), 2u);
    EXPECT_EQ(largestFirst[0].objects[0], 2) << "the last in the order of the objects";
    for (std::size_t i = 1; i < largestFirst.size(); ++i)
        EXPECT_GE(std::stod(largestFirst[i - 1].message.args[1].text()),
                  std::stod(largestFirst[i].message.args[1].text()));
    experiment.objects.pop_back();
    experiment.objects[1].mounting[kX] = 0.3;
    EXPECT_TRUE(shadeRemarks(experiment, experiment.start, ShadedPose::Start).empty()) << "less than 0.5 %";
}

} // namespace bask
