#include "engine/radiation/mounted_objects.h"

#include "engine/radiation/interaction_matrix.h"
#include "tests/support/shaded_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bask {
namespace {

Pose mountedAt(double x, double y, double z) {
    return Pose(Eigen::Translation3d(x, y, z));
}

RadiatingContour lobed(double radius) {
    return RadiatingContour(
        FourierContour({{0.002, 0.001}, {0.0, 0.0}, {0.001, 0.002}, {radius, 0.0}, {0.0, 0.0}}));
}

// Catches: a plane that rounding tilts, a margin of a Fourier outline taken for a height.
TEST(MountedObjects, DoNotShadeOneAnotherInOnePlane) {
    const RadiatingContour source(Disk{0.1});
    const MountedObjects objects({{RadiatingContour(Disk{0.015}), mountedAt(0.04, 0, 0)},
                                  {lobed(0.02), mountedAt(-0.03, 0.02, 0)},
                                  {lobed(0.015), mountedAt(-0.02, -0.03, 0)}});
    const Pose X_SE = poseFromRotationVector({0.01, 0.02, 0.1}, {0.3, -0.2, 0.1});
    for (std::size_t i = 0; i < objects.size(); ++i) {
        EXPECT_TRUE(objects.inFrontOf(i).empty());
        const ViewFactor alone = viewFactor(source, objects[i].contour, X_SE * objects[i].X_EO);
        const ViewFactor together = objects.viewFactor(source, i, X_SE);
        EXPECT_EQ(together.value, alone.value);
        EXPECT_EQ(together.gradient, alone.gradient);
        EXPECT_EQ(objects.viewFactorValue(source, i, X_SE, 1e-6),
                  viewFactorValue(source, objects[i].contour, X_SE * objects[i].X_EO, 1e-6));
    }
}

// 1.5 cm behind 3 cm, coaxial, 3 cm apart: what version 0.1 called feasible.
TEST(MountedObjects, HideOneBehindAnother) {
    const RadiatingContour source(Disk{0.1});
    const MountedObjects objects({{RadiatingContour(Disk{0.03}), mountedAt(0, 0, 0)},
                                  {RadiatingContour(Disk{0.015}), mountedAt(0, 0, 0.03)}});
    EXPECT_TRUE(objects.inFrontOf(0).empty());
    EXPECT_EQ(objects.inFrontOf(1), std::vector<std::size_t>{0});
    const Pose X_SE = mountedAt(0, 0, 0.1);
    const double alone = viewFactorValue(source, objects[1].contour, X_SE * objects[1].X_EO);
    const ViewFactor hidden = objects.viewFactor(source, 1, X_SE);
    EXPECT_LT(hidden.value, 0.35 * alone);
    EXPECT_NEAR(objects.viewFactorValue(source, 1, X_SE, 1e-6), hidden.value, 2e-6);
    EXPECT_NEAR(objects.roughShare(source, 1, X_SE, alone) * alone, hidden.value,
                0.02 * (alone - hidden.value));
}

// Catches: the gradient of the object alone, or about another point, in the interaction matrix.
TEST(MountedObjects, MoveAsOneInTheInteractionMatrix) {
    const RadiatingContour source(Disk{0.1});
    const MountedObjects objects(
        {{RadiatingContour(Disk{0.015}), mountedAt(0.01, 0, -0.02)},
         {RadiatingContour(Disk{0.02}), poseFromRotationVector({0.03, 0.01, 0.01}, {0.1, 0.0, 0.0})}});
    const Pose X_SE = poseFromRotationVector({0.03, 0.0, 0.09}, {0.0, 0.2, 0.0});
    const InteractionMatrix matrix = interactionMatrix(source, objects, X_SE);
    EXPECT_LT(matrix.F[1], viewFactorValue(source, objects[1].contour, X_SE * objects[1].X_EO) - 0.01);
    for (int k = 0; k < 6; ++k) {
        const double step = k < 3 ? 1e-4 : 1e-3;
        const auto moved = [&](double by) {
            const Vector6d twist = by * Vector6d::Unit(k);
            Pose X = X_SE;
            X.translation() += twist.head<3>();
            X.linear() =
                poseFromRotationVector(Eigen::Vector3d::Zero(), twist.tail<3>()).linear() * X_SE.linear();
            return interactionMatrix(source, objects, X).F;
        };
        const Eigen::VectorXd difference = (moved(step) - moved(-step)) / (2.0 * step);
        for (int i = 0; i < 2; ++i)
            EXPECT_NEAR(matrix.J(i, k), difference[i], 2e-3) << i << k;
    }
}

namespace {

Contour rectangle(double halfX_m, double halfY_m) {
    return {{{-halfX_m, -halfY_m}, {halfX_m, -halfY_m}, {halfX_m, halfY_m}, {-halfX_m, halfY_m}}};
}

/// Two objects, a fixture before the second and a shield that hides a part of the source; R is not S.
struct Screened {
    RadiatingContour source{Disk{0.1}};
    std::vector<MountedContour> both{
        {RadiatingContour(Disk{0.015}), mountedAt(-0.03, 0, 0)},
        {RadiatingContour(Disk{0.02}), poseFromRotationVector({0.03, 0.01, 0.01}, {0.1, 0.0, 0.0})}};
    Pose X_RS = poseFromRotationVector({0.2, -0.1, 0.05}, {0.1, 0.2, 0.5});
    Pose X_SB = poseFromRotationVector({0.05, 0.0, 0.03}, {0.0, 0.1, 0.2});
    RadiatingContour fixture{rectangle(0.01, 0.015)}, shield{rectangle(0.05, 0.2)};
    Pose X_EF = mountedAt(0.035, 0, -0.02);
    Screens screens{{{fixture, X_EF}}, {{shield, X_RS* X_SB}}};
    Pose X_SE = poseFromRotationVector({0.02, 0.0, 0.1}, {0.0, 0.15, 0.0});
};

} // namespace

// Catches: fixtures or shields left out, in a wrong frame, or as if shields moved with the end-effector.
TEST(MountedObjects, AreShadedByFixturesAndShields) {
    const Screened s;
    const MountedObjects objects(s.both, s.screens, s.X_RS);
    EXPECT_EQ(objects.inFrontOf(1), (std::vector<std::size_t>{0, 2})) << "counted on from the objects";
    EXPECT_TRUE(objects.mayBeShaded(0));
    for (std::size_t i = 0; i < 2; ++i) {
        const Pose X_SO = s.X_SE * s.both[i].X_EO;
        std::vector<Blocker> blockers{{s.fixture, s.X_SE * s.X_EF}, {s.shield, s.X_SB, false}};
        if (i == 1)
            blockers.push_back({s.both[0].contour, s.X_SE * s.both[0].X_EO});
        ShadeOptions options;
        options.tolerance = kShadeTolerance;
        const ShadedViewFactor direct =
            shadedViewFactor(s.source, s.both[i].contour, X_SO, blockers, options);
        const ViewFactor factor = objects.viewFactor(s.source, i, s.X_SE);
        EXPECT_NEAR(factor.value, direct.value, 3e-5);
        EXPECT_LT(factor.value, direct.unshaded - 0.02);
        EXPECT_LT((factor.gradient - direct.gradientRigid).norm(), 1e-3 * direct.gradientRigid.norm());
    }
    const MountedObjects none(s.both, {}, s.X_RS), plain(s.both);
    EXPECT_EQ(none.viewFactor(s.source, 1, s.X_SE).gradient, plain.viewFactor(s.source, 1, s.X_SE).gradient);
    EXPECT_EQ(none.viewFactorValue(s.source, 0, s.X_SE, 1e-6),
              plain.viewFactorValue(s.source, 0, s.X_SE, 1e-6));
    MountedObjects moved(s.both, s.screens);
    moved.setSourceAt(s.X_RS);
    EXPECT_EQ(moved.viewFactorValue(s.source, 0, s.X_SE, 1e-6),
              objects.viewFactorValue(s.source, 0, s.X_SE, 1e-6));
    EXPECT_NEAR(shieldTop_m(s.screens, s.X_RS), s.X_SB.translation().z() + 0.05 * std::sin(0.1), 2e-3);
    EXPECT_EQ(shieldTop_m({s.screens.fixtures, {}}, s.X_RS), 0.0);
}

// Catches: a shield that moves with the objects in a gradient, exact or rough.
TEST(MountedObjects, LeaveShieldsBehindInTheInteractionMatrix) {
    const Screened s;
    const MountedObjects objects(s.both, s.screens, s.X_RS);
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    const InteractionMatrix exact = interactionMatrix(s.source, objects, s.X_SE);
    const InteractionMatrix rough = roughInteractionMatrix(s.source, objects, s.X_SE, axes, 1e-6);
    const double size = exact.J.norm();
    for (int k = 0; k < 6; ++k) {
        const double step = k < 3 ? 1e-4 : 1e-3;
        const auto moved = [&](double by) -> Eigen::VectorXd {
            const Vector6d twist = by * Vector6d::Unit(k);
            Pose X = s.X_SE;
            X.translation() += twist.head<3>();
            X.linear() =
                poseFromRotationVector(Eigen::Vector3d::Zero(), twist.tail<3>()).linear() * s.X_SE.linear();
            return interactionMatrix(s.source, objects, X, kAllFree, axes, {.tolerance = 1e-7}).F;
        };
        const Eigen::VectorXd difference = (moved(step) - moved(-step)) / (2.0 * step);
        for (int i = 0; i < 2; ++i) {
            EXPECT_NEAR(exact.J(i, k), difference[i], 1e-2 * size) << i << k;
            EXPECT_NEAR(rough.J(i, k), difference[i], 5e-2 * size) << i << k;
        }
    }
}

// Catches: nodes outside a face, holes counted twice, shadows of the wrong sign, a gradient about another
// point.
TEST(MountedObjects, AreRoughlyShadedByFixedRules) {
    ShadedScenes scenes(11);
    double worst = 0.0, worstSlope = 0.0, worstStanding = 0.0;
    std::vector<double> misses;
    for (int i = 0; i < 200; ++i) {
        ShadedScene scene = scenes.next(2);
        const ShadedViewFactor exact =
            shadedViewFactor(scene.source, scene.object, scene.X_SO, scene.blockers);
        const RigidViewFactor rough =
            roughShadedViewFactor(scene.source, scene.object, scene.X_SO, scene.blockers, 1e-6);
        EXPECT_NEAR(exact.unshaded - roughShade(scene.source, scene.object, scene.X_SO, scene.blockers),
                    rough.value, 2e-6);
        EXPECT_LE(rough.value, exact.unshaded + 1e-6);
        worst = std::max(worst, std::abs(rough.value - exact.value));
        if (const double size = exact.gradientRigid.norm(); size > 0.1)
            worstSlope = std::max(worstSlope, (rough.gradient - exact.gradientRigid).norm() / size);
        if (exact.unshaded - exact.value > 1e-4)
            misses.push_back(std::abs(rough.value - exact.value) / (exact.unshaded - exact.value));
        scene.blockers[1].isHeld = false;
        const ShadedViewFactor beside =
            shadedViewFactor(scene.source, scene.object, scene.X_SO, scene.blockers);
        const RigidViewFactor roughly =
            roughShadedViewFactor(scene.source, scene.object, scene.X_SO, scene.blockers, 1e-6);
        EXPECT_EQ(roughly.value, rough.value);
        if (const double size = beside.gradientRigid.norm(); size > 0.1)
            worstStanding = std::max(worstStanding, (roughly.gradient - beside.gradientRigid).norm() / size);
    }
    std::ranges::sort(misses);
    EXPECT_LT(misses[misses.size() / 2], 0.002);
    EXPECT_LT(worst, 0.03);
    EXPECT_LT(worstSlope, 0.1);
    EXPECT_LT(worstStanding, 0.15);
}

// Catches: a share of what is left instead of what there was, of the one that shades instead of the shaded,
// or of all takers together. Coaxial disks: BEYOND.md's closed forms.
TEST(MountedObjects, TellWhoTakesWhoseLight) {
    const RadiatingContour source(Disk{0.08});
    const Pose X_SE = mountedAt(0, 0, 0.1);
    const MountedContour behind{RadiatingContour(Disk{0.015}), Pose::Identity()};
    const MountedContour low{RadiatingContour(Disk{0.02}), mountedAt(0, 0, -0.06)};
    const MountedContour high{RadiatingContour(Disk{0.02}), mountedAt(0, 0, -0.04)};
    const MountedContour aside{RadiatingContour(Disk{0.01}), mountedAt(0.3, 0, -0.02)};
    const double unshaded = viewFactorValue(source, behind.contour, X_SE);
    const MountedObjects objects({low, behind, high, aside});
    const std::vector<TakenLight> taken = objects.takenLight(source, X_SE);
    const auto share = [&](std::size_t object, std::size_t taker) {
        for (const TakenLight& each : taken)
            if (each.object == object && each.taker == taker)
                return each.share;
        return 0.0;
    };
    EXPECT_NEAR(share(1, 0), 1.0 - 0.2918324772 / unshaded, 2e-3);
    EXPECT_NEAR(share(1, 2), 1.0 - 0.203821211 / unshaded, 2e-3);
    EXPECT_GT(share(2, 0), 0.3);
    ASSERT_EQ(taken.size(), 3u) << "nothing of one that hides nobody";
    EXPECT_EQ(taken[0].object, 1u);
    EXPECT_EQ(taken[0].taker, 0u);
    const double together = 1.0 - objects.viewFactorValue(source, 1, X_SE, 1e-6) / unshaded;
    EXPECT_GT(share(1, 0) + share(1, 2), together + 0.1) << "each is charged with its own shadow";
    EXPECT_EQ(objects.takenLight(source, X_SE, 0.55).size(), 1u);
    EXPECT_TRUE(MountedObjects({low, aside}).takenLight(source, X_SE, 0.05).empty());
}

// Catches: a fixture or shield named as another taker.
TEST(MountedObjects, TellWhatFixturesAndShieldsTake) {
    const Screened s;
    const std::vector<TakenLight> taken =
        MountedObjects(s.both, s.screens, s.X_RS).takenLight(s.source, s.X_SE);
    const auto share = [&](std::size_t object, std::size_t taker) {
        const auto it = std::ranges::find_if(
            taken, [&](const TakenLight& t) { return t.object == object && t.taker == taker; });
        return it == taken.end() ? 0.0 : it->share;
    };
    EXPECT_GT(share(1, 2), 0.05) << "the fixture";
    EXPECT_GT(share(0, 3), 0.05) << "the shield";
    EXPECT_GT(share(1, 3), 0.05);
    for (const TakenLight& t : taken)
        EXPECT_LT(t.taker, 4u);
}

// Catches: a share told of an object that sees nothing of the source.
TEST(MountedObjects, WhoHasNoLightLosesNone) {
    const MountedObjects objects({{RadiatingContour(Disk{0.015}), mountedAt(0, 0, 0)},
                                  {RadiatingContour(Disk{0.03}), mountedAt(0, 0, -0.03)}});
    const Pose away = poseFromRotationVector({0, 0, 0.1}, {3.14159, 0, 0});
    EXPECT_TRUE(objects.takenLight(RadiatingContour(Disk{0.08}), away).empty());
}

} // namespace
} // namespace bask
