#include "engine/control/dependent_objects.h"

#include "engine/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

enum Axis { X = 1, Y = 2, Z = 4, TurnX = 8, TurnY = 16, TurnZ = 32 };

struct MountedObject {
    double x_m, y_m;
    double radius_m = 0.015;
};

/// Disks over a disk of 10 cm, in the workspace of the standard scenarios.
struct DependentRig {
    int axes = X | Y | Z | TurnX;
    Shape source = Disk{0.10};
    Vector6d fixed = Vector6d{0.0, 0.0, 0.15, 0.0, 0.0, 0.0};

    std::vector<DependentObjects> dependent(const std::vector<MountedObject>& objects) const {
        RobotLimits limits;
        limits.lower << -0.2, -0.2, 0.01, radFromDeg(-35.0), radFromDeg(-35.0), radFromDeg(-90.0);
        limits.upper << 0.2, 0.2, 0.3, radFromDeg(35.0), radFromDeg(35.0), radFromDeg(90.0);
        for (int k = 0; k < 6; ++k) {
            limits.free[static_cast<std::size_t>(k)] = (axes >> k & 1) != 0;
            if ((axes >> k & 1) == 0)
                limits.lower[k] = limits.upper[k] = fixed[k];
        }
        std::vector<Shape> shapes;
        std::vector<Vector6d> mountings;
        for (const MountedObject& object : objects) {
            shapes.emplace_back(Disk{object.radius_m});
            mountings.push_back({object.x_m, object.y_m, 0.0, 0.0, 0.0, 0.0});
        }
        return dependentObjects(RigGeometry(source, shapes, mountings, limits), fixed);
    }
};

const std::vector<MountedObject> kTriangle{{0.0, 0.05}, {-0.0435, -0.025}, {0.0435, -0.025}};

std::vector<std::vector<int>> sets(const std::vector<DependentObjects>& found) {
    std::vector<std::vector<int>> out;
    for (const DependentObjects& set : found)
        out.push_back(set.objects);
    return out;
}

using Sets = std::vector<std::vector<int>>;

} // namespace

// Catches a sound arrangement called singular: the triangle, a line (which is a matter of targets, not of
// rank), and disks mounted at random, as many as the free axes or fewer.
TEST(DependentObjects, SoundArrangementsHaveNone) {
    EXPECT_TRUE(DependentRig{}.dependent(kTriangle).empty());
    EXPECT_TRUE(DependentRig{}.dependent({{0.0, -0.065}, {0.0, 0.0}, {0.0, 0.065}}).empty());
    EXPECT_TRUE(DependentRig{}.dependent({{0.0, 0.0}}).empty());
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-0.06, 0.06);
    for (int run = 0; run < 200; ++run) {
        std::vector<MountedObject> objects;
        const std::size_t count = 1 + static_cast<std::size_t>(run % 4);
        while (objects.size() < count) {
            const MountedObject next{place(random), place(random)};
            if (std::ranges::all_of(objects, [&](const MountedObject& o) {
                    return std::hypot(o.x_m - next.x_m, o.y_m - next.y_m) > 0.03;
                }))
                objects.push_back(next);
        }
        EXPECT_TRUE(DependentRig{}.dependent(objects).empty()) << "run " << run;
        EXPECT_TRUE(DependentRig{.axes = 63}.dependent(objects).empty()) << "run " << run;
    }
}

// Catches equal objects at mirror places of a round source whose free axes keep the mirror: they have the
// same view factor for ever.
TEST(DependentObjects, MirrorImagesAreAlike) {
    const std::vector<MountedObject> pair{{-0.04, 0.0}, {0.04, 0.0}};
    const auto found = DependentRig{.axes = Y | Z | TurnX}.dependent(pair);
    ASSERT_EQ(sets(found), (Sets{{0, 1}}));
    EXPECT_TRUE(found.front().alike);
    EXPECT_TRUE(DependentRig{.axes = X | Z}.dependent(pair).empty());
    // The third is not one of them.
    EXPECT_EQ(sets(DependentRig{.axes = Y | Z | TurnX}.dependent({{-0.04, 0.0}, {0.0, 0.05}, {0.04, 0.0}})),
              (Sets{{0, 2}}));
    // Another size: not alike, and independent.
    EXPECT_TRUE(DependentRig{.axes = Y | Z}.dependent({{-0.04, 0.0, 0.01}, {0.04, 0.0, 0.02}}).empty());
}

// Catches an object that nothing moves: a disk at E's origin, where only the turn about z is free.
TEST(DependentObjects, AnObjectThatNoAxisMovesIsASetOfOne) {
    EXPECT_EQ(sets(DependentRig{.axes = TurnZ}.dependent({{0.0, 0.0}})), (Sets{{0}}));
    DependentRig aside{.axes = TurnZ};
    aside.fixed[kX] = 0.06;
    EXPECT_TRUE(aside.dependent({{0.03, 0.0}}).empty());
    // With z free it moves; the turn adds nothing to either, so there is one way for two.
    const auto found = DependentRig{.axes = Z | TurnZ}.dependent({{0.0, 0.0}, {0.06, 0.0}});
    ASSERT_EQ(sets(found), (Sets{{0, 1}}));
    EXPECT_FALSE(found.front().alike);
}

// Catches the symmetry of a round source taken for a freedom: turning about its axis changes no view factor,
// so x, y, z and the turn about z serve three objects, and all six axes five.
TEST(DependentObjects, TheTurnAboutARoundSourcesAxisServesNoObject) {
    std::vector<MountedObject> four = kTriangle;
    four.push_back({0.01, 0.005, 0.01});
    EXPECT_EQ(sets(DependentRig{.axes = X | Y | Z | TurnZ}.dependent(four)), (Sets{{0, 1, 2, 3}}));
    EXPECT_TRUE(DependentRig{.axes = X | Y | Z | TurnZ}.dependent(kTriangle).empty());
    EXPECT_TRUE(DependentRig{}.dependent(four).empty());
    DependentRig square{.axes = X | Y | Z | TurnZ};
    square.source = Contour{{{-0.1, -0.06}, {0.1, -0.06}, {0.1, 0.06}, {-0.1, 0.06}}};
    EXPECT_TRUE(square.dependent(four).empty());
    std::vector<MountedObject> six = four;
    six.insert(six.end(), {{0.07, 0.04, 0.012}, {-0.08, 0.03, 0.009}});
    EXPECT_EQ(sets(DependentRig{.axes = 63}.dependent(six)), (Sets{{0, 1, 2, 3, 4, 5}}));
    six.pop_back();
    EXPECT_TRUE(DependentRig{.axes = 63}.dependent(six).empty());
}

// Catches sets that are told with more members than they need, or only the first of several.
TEST(DependentObjects, EachLeastSetIsTold) {
    EXPECT_EQ(sets(DependentRig{.axes = Y | Z | TurnX}.dependent(
                  {{-0.04, 0.0}, {0.04, 0.0}, {-0.04, 0.05}, {0.04, 0.05}})),
              (Sets{{0, 1}, {2, 3}}));
}

// Catches a verdict on nothing, and a workspace without any allowed pose told as a singular arrangement.
TEST(DependentObjects, NoObjectOrNoPoseNoVerdict) {
    EXPECT_TRUE(DependentRig{}.dependent({}).empty());
    DependentRig low{.axes = X | Y};
    low.fixed[kZ] = 0.005;
    EXPECT_TRUE(low.dependent({{-0.04, 0.0}, {0.04, 0.0}}).empty());
}

} // namespace bask
