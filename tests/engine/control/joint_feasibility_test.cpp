// Targets of several objects together: verdicts against cases of known outcome, poses drawn at random and
// brute force; nearest targets, margins, reasons.

#include "engine/control/joint_feasibility.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/control/steady_search.h"
#include "engine/control/surface_gap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

HeatRates ratesUnder(SourceModel model, const Material& material = {}) {
    const double room_K = kelvinFromCelsius(25.0);
    return heatRates(material, surroundingsOf(model, kelvinFromCelsius(200.0), 0.25, room_K));
}

Vector6d mountedAt(double x_m, double y_m) {
    Vector6d mounting = Vector6d::Zero();
    mounting[kX] = x_m;
    mounting[kY] = y_m;
    return mounting;
}

FeasibilityRequest requestOf(std::shared_ptr<const RigGeometry> geometry, SourceModel model,
                             const std::vector<double>& targets_degC) {
    FeasibilityRequest request;
    request.geometry = std::move(geometry);
    request.rest = Vector6d(0.0, 0.0, 0.12, 0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < targets_degC.size(); ++i) {
        request.names.push_back("object " + std::to_string(i + 1));
        request.rates.push_back(ratesUnder(model));
        request.targets_K.push_back(kelvinFromCelsius(targets_degC[i]));
    }
    return request;
}

/// Circles of 1.5 and 4.5 cm, 2 cm each side of E, parallel to a source of 10 cm, kept from its plane.
FeasibilityRequest paperCircles(double clearance_m, const std::vector<double>& targets_degC) {
    RobotLimits limits;
    limits.free = {true, true, true, false, false, false};
    limits.lower[kZ] = 0.0;
    limits.clearance_m = clearance_m;
    const auto geometry =
        std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>{Disk{0.015}, Disk{0.045}},
                                      std::vector{mountedAt(0.0, -0.02), mountedAt(0.0, 0.02)}, limits);
    return requestOf(geometry, SourceModel::Paper, targets_degC);
}

/// Three disks on a triangle of 5 cm under the standard robot.
std::shared_ptr<const RigGeometry> triangle(const RobotLimits& limits = {}) {
    return std::make_shared<RigGeometry>(
        Disk{0.1}, std::vector<Shape>{Disk{0.015}, Disk{0.03}, Disk{0.027}},
        std::vector{mountedAt(0.0, 0.05), mountedAt(-0.0435, -0.025), mountedAt(0.0435, -0.025)}, limits);
}

/// Three disks 6.5 cm apart in a line, without any turning.
std::shared_ptr<const RigGeometry> line() {
    RobotLimits limits;
    limits.free = {true, true, true, false, false, false};
    return std::make_shared<RigGeometry>(
        Disk{0.1}, std::vector<Shape>(3, Disk{0.02}),
        std::vector{mountedAt(0.0, -0.065), mountedAt(0.0, 0.0), mountedAt(0.0, 0.065)}, limits);
}

JointVerdict verdictOf(const FeasibilityRequest& request) {
    return jointFeasibility(request).value();
}

// A disk of 1.5 cm 3 cm behind one of 3 cm: without its shade, both at 50 and 45 degC were called feasible.
TEST(JointFeasibility, ADiskBehindALargerOneIsInItsShade) {
    RobotLimits limits;
    limits.free = {true, true, true, false, false, false};
    const std::vector<Shape> shapes{Disk{0.03}, Disk{0.015}};
    Vector6d behind = Vector6d::Zero();
    behind[kZ] = 0.03;
    const auto verdict = [&](double second_degC) {
        return verdictOf(requestOf(std::make_shared<RigGeometry>(
                                       Disk{0.1}, shapes, std::vector{mountedAt(0.0, 0.0), behind}, limits),
                                   SourceModel::Gray, {50.0, second_degC}));
    };
    EXPECT_FALSE(verdict(45.0).feasible);
    EXPECT_TRUE(verdict(35.0).feasible);
}

// A verdict that forgets the clearance, or the source model: the paper's example, whose third case becomes
// feasible between 1.7 and 1.6 cm.
TEST(JointFeasibility, TwoCirclesOfThePaper) {
    EXPECT_TRUE(verdictOf(paperCircles(0.03, {30.0, 30.0})).feasible);
    EXPECT_TRUE(verdictOf(paperCircles(0.03, {30.0, 40.0})).feasible);
    const JointVerdict apart = verdictOf(paperCircles(0.03, {50.0, 30.0}));
    EXPECT_FALSE(apart.feasible);
    EXPECT_EQ(apart.reason.code, MessageCode::TargetsTooFarApart);
    EXPECT_FALSE(verdictOf(paperCircles(0.017, {50.0, 30.0})).feasible);
    EXPECT_TRUE(verdictOf(paperCircles(0.016, {50.0, 30.0})).feasible);
}

// Poses that lie about: a rig at random with any free axes, 1 to 6 objects, tilted mountings, a source that
// is not at the base, disks, polygons and a disk with a hole. Whatever a pose holds is feasible, the pose
// found is one of the workspace and holds it, and the necessary conditions agree.
TEST(JointFeasibility, WhatARandomPoseHoldsIsFeasible) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Contour square{{{-0.02, -0.02}, {0.02, -0.02}, {0.02, 0.02}, {-0.02, 0.02}}};
    const Contour hole{{{-0.01, -0.01}, {0.01, -0.01}, {0.01, 0.01}, {-0.01, 0.01}}};
    int asked = 0, feasible = 0, disagreeing = 0;
    for (int rig = 0; rig < 18; ++rig) {
        RobotLimits limits;
        limits.lower.tail<3>().setConstant(rig % 2 == 0 ? -0.6 : -1.5);
        limits.upper.tail<3>() = -limits.lower.tail<3>();
        std::array<std::size_t, 6> axes{0, 1, 2, 3, 4, 5};
        std::ranges::shuffle(axes, random);
        const auto freedom = static_cast<std::size_t>(1 + rig % 6);
        limits.free.fill(false);
        for (std::size_t k = 0; k < freedom; ++k)
            limits.free[axes[k]] = true;
        const int N = 1 + static_cast<int>(unit(random) * static_cast<double>(freedom));
        std::vector<Shape> shapes;
        std::vector<Vector6d> mountings;
        for (int i = 0; i < N; ++i) {
            shapes.push_back(i % 3 == 0   ? Shape(Disk{0.01 + 0.02 * unit(random)})
                             : i % 3 == 1 ? Shape(square)
                                          : Shape(PiercedShape{Disk{0.03}, {hole}}));
            const double angle = 2.0 * M_PI * unit(random), radius_m = 0.03 + 0.09 * unit(random);
            mountings.push_back(mountedAt(radius_m * std::cos(angle), radius_m * std::sin(angle)));
            mountings.back()[kThetaX] = i % 2 == 0 ? 0.0 : 0.3 * (unit(random) - 0.5);
        }
        Vector6d source = Vector6d::Zero();
        if (rig % 3 == 2)
            source << 0.02, -0.01, 0.005, 0.1, -0.05, 0.3;
        const auto geometry =
            std::make_shared<RigGeometry>(Disk{0.1}, shapes, mountings, limits, poseFromCoordinates(source));
        FeasibilityRequest request = requestOf(geometry, SourceModel::Gray, std::vector<double>(N, 40.0));
        for (HeatRates& rates : request.rates) {
            Material material;
            material.emittance = 0.4 + 0.5 * unit(random);
            material.absorptance = 0.4 + 0.5 * unit(random);
            rates = ratesUnder(SourceModel::Gray, material);
        }
        request.lookup = feasibilityLookup(geometry, request.rest);
        const SteadySearch search(geometry, request.lookup, request.rates);
        for (int pose = 0; pose < 5 && !search.empty(); ++pose) {
            Vector6d q = request.rest;
            do {
                for (const int c : geometry->freeCoordinates())
                    q[c] = limits.lower[c] + unit(random) * (limits.upper[c] - limits.lower[c]);
            } while (!geometry->allowed(q));
            const Eigen::VectorXd T_K = search.at(q).T_K;
            request.targets_K.assign(T_K.begin(), T_K.end());
            const JointVerdict verdict = verdictOf(request);
            ++asked;
            feasible += verdict.feasible ? 1 : 0;
            disagreeing += std::ranges::any_of(verdict.conditions1,
                                               [](const TargetVerdict& v) {
                                                   return v.verdict != FeasibilityVerdict::Reachable;
                                               }) ||
                                   std::ranges::any_of(verdict.conditions2,
                                                       [](const PairVerdict& v) { return !v.holds; })
                               ? 1
                               : 0;
            EXPECT_TRUE(geometry->allowed(verdict.pose));
            const Eigen::VectorXd there_K = search.at(verdict.pose).T_K;
            for (int i = 0; i < N; ++i)
                EXPECT_NEAR(there_K[i], verdict.steady_K[static_cast<std::size_t>(i)], 1e-9);
        }
    }
    EXPECT_GE(asked, 75);
    EXPECT_EQ(feasible, asked);
    EXPECT_EQ(disagreeing, 0);
}

// Extremes of a pair's difference that are not the extremes: no pose of a fine grid lies beyond them, and
// they are not far beyond the grid.
TEST(JointFeasibility, DifferencesAgreeWithAGrid) {
    const auto geometry = triangle();
    const FeasibilityRequest request = requestOf(geometry, SourceModel::Paper, {50.0, 40.0, 40.0});
    const SteadySearch fine(geometry, std::make_shared<PoseLookup>(geometry, request.rest, 200000),
                            request.rates);
    for (const PairVerdict& pair : verdictOf(request).conditions2) {
        const Eigen::ArrayXd difference = fine.table_K().col(pair.first) - fine.table_K().col(pair.second);
        EXPECT_LE(pair.min_K, difference.minCoeff() + 1e-3);
        EXPECT_GE(pair.largest_K, difference.maxCoeff() - 1e-3);
        EXPECT_NEAR(pair.min_K, difference.minCoeff(), 1.0);
        EXPECT_NEAR(pair.largest_K, difference.maxCoeff(), 1.0);
    }
}

// Nearest targets that are not feasible, not the nearest, or not those that were to be kept. Rounded to a
// tenth, as an operator types them, they are feasible still.
TEST(JointFeasibility, NearestTargetsAreFeasibleAndKeepTheHeldOnes) {
    FeasibilityRequest request = requestOf(line(), SourceModel::Paper, {44.0, 43.0, 45.0});
    const JointVerdict plain = verdictOf(request);
    ASSERT_FALSE(plain.feasible);
    request.fixed = {true, false, false};
    const JointVerdict fixed = verdictOf(request);
    EXPECT_TRUE(fixed.fixedKept);
    EXPECT_EQ(fixed.nearest_K[0], request.targets_K[0]);
    const auto distance_K = [&](const std::vector<double>& nearest_K) {
        return std::hypot(nearest_K[0] - request.targets_K[0], nearest_K[1] - request.targets_K[1],
                          nearest_K[2] - request.targets_K[2]);
    };
    EXPECT_GT(distance_K(fixed.nearest_K), distance_K(plain.nearest_K));
    for (std::vector<double> nearest_K : {plain.nearest_K, fixed.nearest_K}) {
        FeasibilityRequest again = request;
        again.targets_K = nearest_K;
        EXPECT_TRUE(verdictOf(again).feasible);
        for (double& target_K : again.targets_K)
            target_K = kelvinFromCelsius(std::round(celsiusFromKelvin(target_K) * 10.0) / 10.0);
        EXPECT_TRUE(verdictOf(again).feasible);
    }
}

// Held targets that are impossible by themselves must not be passed off as kept.
TEST(JointFeasibility, HeldTargetsThatCannotBeAreSaidNotToBeKept) {
    FeasibilityRequest request = requestOf(triangle(), SourceModel::Paper, {70.0, 40.0, 40.0});
    request.fixed = {true, false, false};
    EXPECT_FALSE(verdictOf(request).fixedKept);
}

// A verdict that flips between two runs, or depends on who made the look-up.
TEST(JointFeasibility, TheSameQuestionHasTheSameAnswer) {
    for (const double target_degC : {41.0, 45.0}) {
        FeasibilityRequest request = requestOf(line(), SourceModel::Paper, {40.0, target_degC, 40.0});
        const JointVerdict first = verdictOf(request);
        request.lookup = feasibilityLookup(request.geometry, request.rest);
        const JointVerdict second = verdictOf(request);
        EXPECT_EQ(first.pose, second.pose);
        EXPECT_EQ(first.steady_K, second.steady_K);
        EXPECT_EQ(first.reason, second.reason);
        EXPECT_EQ(first.surfacePoints, second.surfacePoints);
    }
}

// A margin that is not there: far from all limits it is the distance to the nearest of them, at a corner
// nothing, and an object on the axis of a source that the robot cannot leave is not independent.
TEST(JointFeasibility, MarginNamesTheNearestLimit) {
    const auto geometry = triangle();
    LimitDistance nearest = nearestLimit(*geometry, Vector6d(0.0, 0.19, 0.15, 0.0, 0.0, 0.0));
    EXPECT_NEAR(nearest.distance_m, 0.01, 1e-12);
    EXPECT_EQ(nearest.limit, Limit::Workspace);
    EXPECT_EQ(nearest.coordinate, kY);
    nearest = nearestLimit(*geometry, Vector6d(0.0, 0.0, 0.15, 0.6, 0.0, 0.0));
    EXPECT_NEAR(nearest.distance_m, 0.1 * (radFromDeg(35.0) - 0.6), 1e-12);
    EXPECT_EQ(nearest.coordinate, kThetaX);
    RobotLimits deep;
    deep.lower[kZ] = -0.3;
    nearest = nearestLimit(*triangle(deep), Vector6d(0.0, 0.0, 0.03, 0.0, 0.0, 0.0));
    EXPECT_NEAR(nearest.distance_m, 0.02, 1e-12);
    EXPECT_EQ(nearest.limit, Limit::Clearance);

    const FeasibilityRequest request = requestOf(geometry, SourceModel::Paper, {40.0, 40.0, 40.0});
    const PoseMargin margin = verdictOf(request).margin;
    EXPECT_GT(margin.distance_m, 0.03);
    EXPECT_GT(margin.smallestSingularValue_K_m, 20.0);
    RobotLimits upDown;
    upDown.free = {false, false, true, false, false, false};
    const auto one = std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>{Disk{0.01}},
                                                   std::vector{mountedAt(0.0, 0.0)}, upDown);
    const JointVerdict hot = verdictOf(requestOf(one, SourceModel::Paper, {61.2}));
    EXPECT_FALSE(hot.feasible);
    EXPECT_EQ(hot.margin.distance_m, 0.0);
}

// Reasons that blame the wrong thing.
TEST(JointFeasibility, TheReasonIsTheBindingOne) {
    const auto reason = [](const FeasibilityRequest& request) { return verdictOf(request).reason; };
    EXPECT_EQ(reason(requestOf(triangle(), SourceModel::Paper, {40.0, 40.0, 40.0})).code, MessageCode::None);
    const Message ceiling = reason(requestOf(triangle(), SourceModel::Paper, {70.0, 35.0, 35.0}));
    EXPECT_EQ(describe(ceiling), "\"object 1\" cannot be held at 70 °C: with this source it settles at 61.42 "
                                 "°C at most, even at a view factor of 1");
    RobotLimits far;
    far.clearance_m = 0.05;
    far.lower[kZ] = 0.05;
    const Message more = reason(requestOf(triangle(far), SourceModel::Paper, {40.0, 61.0, 40.0}));
    EXPECT_EQ(more.code, MessageCode::TargetNeedsMore);
    EXPECT_EQ(more.args[0], "object 2");
    const Message floor = reason(requestOf(triangle(), SourceModel::Paper, {40.0, 40.0, 20.0}));
    EXPECT_EQ(floor.code, MessageCode::TargetBelowFloor);
    RobotLimits near;
    near.upper[kZ] = 0.05;
    near.lower.head<2>().setConstant(-0.02);
    near.upper.head<2>().setConstant(0.02);
    const Message less = reason(requestOf(triangle(near), SourceModel::Paper, {50.0, 50.0, 26.0}));
    EXPECT_EQ(less.code, MessageCode::TargetNeedsLess);
    EXPECT_EQ(less.args[0], "object 3");
    // Of two alike the colder one first: told of the hotter all the same.
    const Message apart = reason(paperCircles(0.03, {28.0, 58.0}));
    EXPECT_EQ(apart.code, MessageCode::TargetsTooFarApart);
    EXPECT_EQ(apart.args[0], "object 2");
    // A poor absorber in the same place as a good one is always colder in front of the source.
    const auto alike = std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>(2, Disk{0.02}),
                                                     std::vector(2, mountedAt(0.0, 0.0)), near);
    FeasibilityRequest unlike = requestOf(alike, SourceModel::Paper, {57.0, 51.0});
    Material poor;
    poor.absorptance = 0.8;
    unlike.rates[1] = ratesUnder(SourceModel::Paper, poor);
    const Message close = reason(unlike);
    EXPECT_EQ(close.code, MessageCode::TargetsTooClose);
    EXPECT_EQ(close.args[0], "object 1");
}

// Surfaces that are followed to where they meet, beyond the workspace's edge: two disks kept 5 cm aside of
// the source's axis and 6 cm above it can be at a temperature each by itself, in the middle, but both at once
// only nearer.
TEST(JointFeasibility, SurfacesThatMeetOutsideTheWorkspaceAreApart) {
    RobotLimits limits;
    limits.free = {true, true, true, false, false, false};
    limits.lower[kX] = 0.05;
    limits.lower[kZ] = 0.06;
    const auto geometry =
        std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>(2, Disk{0.015}),
                                      std::vector{mountedAt(0.0, -0.04), mountedAt(0.0, 0.04)}, limits);
    FeasibilityRequest request = requestOf(geometry, SourceModel::Gray, {40.0, 40.0});
    const SteadySearch search(geometry, feasibilityLookup(geometry, request.rest), request.rates);
    const double both_K = search.at(Vector6d(0.05, 0.0, 0.06, 0.0, 0.0, 0.0)).T_K[0];
    const double alone_K = search.at(Vector6d(0.05, 0.04, 0.06, 0.0, 0.0, 0.0)).T_K[0];
    ASSERT_GT(alone_K, both_K + 1.0);
    request.targets_K.assign(2, 0.5 * (both_K + alone_K));
    const JointVerdict verdict = verdictOf(request);
    EXPECT_FALSE(verdict.feasible);
    EXPECT_EQ(verdict.reason.code, MessageCode::TargetsSurfacesApart) << describe(verdict.reason);
    EXPECT_EQ(verdict.margin.distance_m, 0.0);
    ASSERT_TRUE(verdict.surfaceGap_m);
    EXPECT_GT(*verdict.surfaceGap_m, 0.005);
    for (const Eigen::Vector3d& point : verdict.surfacePoints)
        EXPECT_GE(std::min(point.x() - 0.05, point.z() - 0.06), -1e-9);
    // Without any way along a line there are no surfaces to draw.
    limits.free = {false, false, false, true, false, false};
    const auto turning =
        std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>(2, Disk{0.015}),
                                      std::vector{mountedAt(0.0, -0.04), mountedAt(0.0, 0.04)}, limits);
    request.geometry = turning;
    const SteadySearch turned(turning, feasibilityLookup(turning, request.rest), request.rates);
    request.targets_K.assign(2, turned.at(request.rest).T_K[0] + 0.5);
    const JointVerdict still = verdictOf(request);
    EXPECT_FALSE(still.surfaceGap_m);
    EXPECT_EQ(still.reason.code, MessageCode::TargetsNotTogether) << describe(still.reason);
}

// A workspace without any allowed pose must be told, not searched.
TEST(JointFeasibility, AWorkspaceBelowTheClearanceHasNoPose) {
    RobotLimits limits;
    limits.clearance_m = 0.5;
    const JointVerdict verdict =
        verdictOf(requestOf(triangle(limits), SourceModel::Gray, {40.0, 40.0, 40.0}));
    EXPECT_FALSE(verdict.feasible);
    EXPECT_FALSE(verdict.anyPose);
    EXPECT_EQ(verdict.reason.code, MessageCode::TargetsNoPose);
}

// A workspace that reaches into the source's plane, where there is no view factor, must not end the program.
TEST(JointFeasibility, WithoutAClearanceObjectsStopShortOfThePlane) {
    RobotLimits limits;
    limits.clearance_m = limits.lower[kZ] = 0.0;
    const JointVerdict verdict =
        verdictOf(requestOf(triangle(limits), SourceModel::Paper, {60.0, 60.0, 30.0}));
    EXPECT_TRUE(verdict.feasible);
    EXPECT_GT(verdict.pose[kZ], 0.0);
}

// A job that nobody waits for any more.
TEST(JointFeasibility, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(
        jointFeasibility(requestOf(triangle(), SourceModel::Gray, {40.0, 40.0, 40.0}), stop.get_token()));
}

// Points that do not lie on the surfaces, or are not the nearest ones: three disks in a line want the same
// temperature, so the outer surfaces are the middle one moved aside, and the points lie on a line by
// symmetry.
TEST(JointFeasibility, SurfacesOfALineMissOneAnother) {
    const auto geometry = line();
    const FeasibilityRequest request = requestOf(geometry, SourceModel::Paper, {40.0, 40.0, 40.0});
    const JointVerdict verdict = verdictOf(request);
    EXPECT_FALSE(verdict.feasible);
    EXPECT_EQ(verdict.reason.code, MessageCode::TargetsSurfacesApart);
    ASSERT_TRUE(verdict.surfaceGap_m);
    const SteadySearch search(geometry, feasibilityLookup(geometry, request.rest), request.rates);
    for (int i = 0; i < 3; ++i) {
        Vector6d q = request.rest;
        q.head<3>() = verdict.surfacePoints[static_cast<std::size_t>(i)];
        EXPECT_NEAR(search.at(q).T_K[i], request.targets_K[0], 1e-3);
        EXPECT_NEAR(q[kX], 0.0, 1e-3);
    }
    // Below the middle one's surface by the difference of heights on the axis and 6.5 cm off it.
    double low_m = 0.01, high_m = 0.3, lowAside_m = 0.01, highAside_m = 0.3;
    for (int i = 0; i < 60; ++i) {
        const double middle_m = 0.5 * (low_m + high_m), aside_m = 0.5 * (lowAside_m + highAside_m);
        Vector6d q = Vector6d::Zero();
        q[kZ] = middle_m;
        (search.at(q).T_K[1] > request.targets_K[1] ? low_m : high_m) = middle_m;
        q[kZ] = aside_m;
        (search.at(q).T_K[0] > request.targets_K[0] ? lowAside_m : highAside_m) = aside_m;
    }
    EXPECT_LT(*verdict.surfaceGap_m, low_m - lowAside_m + 1e-4);
    EXPECT_GT(*verdict.surfaceGap_m, 0.5 * (low_m - lowAside_m));
}

} // namespace
} // namespace bask
