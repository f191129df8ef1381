// The exact gradient against the paper's own expressions for the interaction matrix.

#include "engine/radiation/paper_methods.h"
#include "engine/radiation/view_factor.h"
#include "tests/engine/radiation/interaction_matrix_oracle.h"
#include "tests/engine/radiation/random_poses.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

using test::Draw;

/// Coordinates over a source of 10 cm, tilted by up to `tilt` a turn.
Vector6d drawnCoordinates(Draw& draw, double tilt) {
    Vector6d q;
    q << draw.between(-0.15, 0.15), draw.between(-0.15, 0.15), draw.between(0.05, 0.25), draw.vector(tilt);
    return q;
}

/// Largest difference of the rows; the scale of a row is at least 1.
double apart(const Vector6d& row, const Vector6d& exact) {
    return (row - exact).norm() / std::max(1.0, exact.norm());
}

// Catches: a wrong sign, factor or axis of the translations; the paper's closed expressions are exact.
TEST(InteractionMatrix, meetsThePapersTranslationsOfParallelCircles) {
    Draw draw(21);
    for (int i = 0; i < 60; ++i) {
        const double r1 = draw.between(0.05, 0.15), r2 = draw.between(0.01, 0.04);
        const Eigen::Vector3d p(draw.between(-0.2, 0.2), draw.between(-0.2, 0.2), draw.between(0.03, 0.3));
        Pose X_SO = Pose::Identity();
        X_SO.translation() = p;
        const ViewFactor f =
            viewFactor(RadiatingContour(Disk{r1}), RadiatingContour(Disk{r2}), X_SO, {1e-12});
        const Eigen::Vector3d row = test::paperTranslationRow(r1, r2, p);
        EXPECT_LE((f.gradient.head<3>() - row).norm(), 1e-9 * std::max(1.0, row.norm())) << i;
    }
}

// Catches: a gradient that is not the derivative, rotations above all: the paper's forward differences come
// closer as the step, and no faster.
TEST(InteractionMatrix, meetsThePapersForwardDifferencesToTheirStep) {
    Draw draw(22);
    const RadiatingContour source(Disk{0.1});
    for (int i = 0; i < 60; ++i) {
        const RadiatingContour object(draw.shape(i, 0.03));
        const Vector6d q = drawnCoordinates(draw, i % 2 == 0 ? 0.3 : 1.2);
        const auto value = [&](const Vector6d& at) {
            return viewFactor(source, object, poseFromCoordinates(at), {1e-13}).value;
        };
        const Vector6d exact =
            coordinateGradient(q, viewFactor(source, object, poseFromCoordinates(q), {1e-12}).gradient);
        for (double step : {1e-4, 1e-5, 1e-6}) // the second derivatives stay below 2000 (1/m2)
            EXPECT_LE(apart(test::paperForwardDifferences(value, q, step, 10.0 * step), exact),
                      1000.0 * step + 1e-6)
                << i << ' ' << step;
    }
}

// Catches: the baseline of the benchmark doing something else than the solver: Simpson on both contours and
// seven evaluations, source whole and cut.
TEST(InteractionMatrix, meetsThePapersSevenEvaluations) {
    Draw draw(23);
    const Disk disk{0.1};
    const RadiatingContour source(disk);
    int cut = 0;
    for (int i = 0; i < 40; ++i) {
        const Shape shape = draw.shape(i % 2, 0.03);
        const Vector6d q = drawnCoordinates(draw, i % 4 < 2 ? 0.2 : 1.0);
        const ViewFactor f = viewFactor(source, RadiatingContour(shape), poseFromCoordinates(q), {1e-12});
        // The paper does not treat an object that dips below the source plane.
        double lowest = 1.0;
        for (const Eigen::Vector2d& p : shapeOutline(shape, 256))
            lowest = std::min(lowest, (poseFromCoordinates(q) * Eigen::Vector3d(p.x(), p.y(), 0.0)).z());
        if (lowest < 0.01)
            continue;
        const SimpsonGradient paper = simpsonGradient(disk, shape, q, 256, 1e-6, 1e-5);
        EXPECT_NEAR(paper.value, f.value, 1e-7) << i;
        EXPECT_LE(apart(paper.gradient, coordinateGradient(q, f.gradient)), 5e-3) << i;
        cut += f.visibility == Visibility::Partial ? 1 : 0;
    }
    EXPECT_GE(cut, 5);
}

// Catches: the transport to the end-effector's origin, with the object mounted off centre and turned.
TEST(InteractionMatrix, rowOfAMountedObjectMeetsForwardDifferencesOfTheEndEffector) {
    Draw draw(24);
    const RadiatingContour source(Disk{0.1});
    for (int i = 0; i < 30; ++i) {
        const RadiatingContour object(draw.shape(i, 0.02));
        const Pose X_EO = poseFromRotationVector(draw.vector(0.05), draw.vector(0.2));
        Vector6d q = drawnCoordinates(draw, 0.3);
        q.z() += 0.1;
        const auto factorAt = [&](const Vector6d& at) {
            return viewFactor(source, object, poseFromCoordinates(at) * X_EO, {1e-13});
        };
        const Pose X_SE = poseFromCoordinates(q);
        const Vector6d row =
            gradientAbout(factorAt(q).gradient, (X_SE * X_EO).translation(), X_SE.translation());
        const auto value = [&](const Vector6d& at) { return factorAt(at).value; };
        EXPECT_LE(apart(test::paperForwardDifferences(value, q, 1e-6, 1e-5), coordinateGradient(q, row)),
                  1e-3)
            << i;
    }
}

} // namespace
} // namespace bask
