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

// Catches: nodes outside a face, holes counted twice, shadows of the wrong sign, a gradient about another
// point.
TEST(MountedObjects, AreRoughlyShadedByFixedRules) {
    ShadedScenes scenes(11);
    double worst = 0.0, worstSlope = 0.0;
    std::vector<double> misses;
    for (int i = 0; i < 200; ++i) {
        const ShadedScene scene = scenes.next(2);
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
    }
    std::ranges::sort(misses);
    EXPECT_LT(misses[misses.size() / 2], 0.002);
    EXPECT_LT(worst, 0.03);
    EXPECT_LT(worstSlope, 0.1);
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

// Catches: a share told of an object that sees nothing of the source.
TEST(MountedObjects, WhoHasNoLightLosesNone) {
    const MountedObjects objects({{RadiatingContour(Disk{0.015}), mountedAt(0, 0, 0)},
                                  {RadiatingContour(Disk{0.03}), mountedAt(0, 0, -0.03)}});
    const Pose away = poseFromRotationVector({0, 0, 0.1}, {3.14159, 0, 0});
    EXPECT_TRUE(objects.takenLight(RadiatingContour(Disk{0.08}), away).empty());
}

} // namespace
} // namespace bask
