// A source that lies anywhere in the robot's base: view factors, clearances and their gradients.

#include "engine/control/controller.h"
#include "engine/control/velocity_solve.h"
#include "tests/engine/radiation/random_poses.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace bask {
namespace {

using test::Draw;

Pose drawnPose(Draw& draw, double max_m, double max_rad) {
    return poseFromRotationVector(draw.vector(max_m), draw.vector(max_rad));
}

/// Three objects of different kinds over a source that is no disk.
struct Rig {
    explicit Rig(Draw& draw) : source(draw.fourier(0.1, 0.2)) {
        for (int i = 0; i < 3; ++i) {
            shapes.push_back(draw.shape(i, 0.02));
            Vector6d mounting;
            mounting << draw.vector(0.05), draw.vector(0.1);
            mountings.push_back(mounting);
        }
    }
    RigGeometry at(const Pose& X_RS) const { return RigGeometry(source, shapes, mountings, limits, X_RS); }

    Shape source;
    std::vector<Shape> shapes;
    std::vector<Vector6d> mountings;
    RobotLimits limits;
};

Vector6d poseOver(Draw& draw) {
    Vector6d q;
    q << draw.vector(0.08), draw.vector(0.4);
    q[kZ] += 0.18;
    return q;
}

/// Derivative of f by each coordinate, of fourth order in the step.
template <class Value> Vector6d differences(const Value& f, const Vector6d& q, double step) {
    Vector6d out;
    for (int k = 0; k < 6; ++k) {
        const Vector6d d = step * Vector6d::Unit(k);
        out[k] = (8.0 * (f(q + d) - f(q - d)) - (f(q + 2.0 * d) - f(q - 2.0 * d))) / (12.0 * step);
    }
    return out;
}

} // namespace

// Catches X_RS on the wrong side or not inverted: what matters is where robot and source are to each other.
TEST(RigGeometry, NothingChangesWhenSourceAndRobotMoveTogether) {
    Draw draw(1);
    const Rig rig(draw);
    for (int i = 0; i < 20; ++i) {
        const Pose X_RS = drawnPose(draw, 0.3, 1.0);
        const Vector6d q = poseOver(draw);
        const Vector6d moved = coordinatesFromPose(X_RS * poseFromCoordinates(q));
        const RigGeometry here = rig.at(Pose::Identity());
        const RigGeometry there = rig.at(X_RS);
        EXPECT_LT((there.viewFactors(moved).F - here.viewFactors(q).F).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT((there.viewFactorsFast(moved) - here.viewFactorsFast(q)).cwiseAbs().maxCoeff(), 1e-6);
        EXPECT_NEAR(there.lowestPoint_m(moved), here.lowestPoint_m(q), 1e-14);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(there.clearances(moved)[k].height_m, here.clearances(q)[k].height_m, 1e-14);
    }
}

// Catches gradients left in the source's axes.
TEST(RigGeometry, GradientsByTheRobotsCoordinatesMeetDifferencesOfTheValues) {
    Draw draw(2);
    const Rig rig(draw);
    for (int i = 0; i < 10; ++i) {
        const RigGeometry geometry = rig.at(drawnPose(draw, 0.05, 0.2));
        Vector6d q = poseOver(draw);
        q.tail<3>() *= 0.4; // no part of the source hidden: F is smooth
        const ViewFactors fields = geometry.viewFactors(q);
        const std::vector<Clearance> clearances = geometry.clearances(q);
        for (Eigen::Index k = 0; k < 3; ++k) {
            const auto F = [&](const Vector6d& at) { return geometry.viewFactors(at).F[k]; };
            const double close =
                geometry.mayShade() ? 1e-2 : 1e-5; // shade is known to 1e-5, in a step of 1e-3
            EXPECT_LT((fields.dF.row(k).transpose() - differences(F, q, 5e-4)).cwiseAbs().maxCoeff(), close)
                << i;
            const auto object = static_cast<std::size_t>(k);
            const auto height = [&](const Vector6d& at) { return geometry.clearances(at)[object].height_m; };
            EXPECT_LT((clearances[object].gradient - differences(height, q, 1e-6)).cwiseAbs().maxCoeff(),
                      1e-7)
                << i;
        }
    }
}

// Catches a clearance that is still the height over the robot's base: compared with outlines put there one by
// one.
TEST(RigGeometry, ClearanceIsTheHeightOverATiltedSource) {
    Vector6d source;
    source << 0.03, -0.02, 0.05, 0.3, -0.2, 0.4;
    Draw draw(3);
    const Rig rig(draw);
    const Pose X_RS = poseFromCoordinates(source);
    const RigGeometry geometry = rig.at(X_RS);
    for (int i = 0; i < 20; ++i) {
        const Vector6d q = poseOver(draw);
        double lowest_m = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 3; ++k) {
            double own_m = std::numeric_limits<double>::infinity();
            for (const Eigen::Vector2d& p : shapeOutline(rig.shapes[k], 72)) {
                const Eigen::Vector3d p_R = poseFromCoordinates(q) * poseFromCoordinates(rig.mountings[k]) *
                                            Eigen::Vector3d(p.x(), p.y(), 0.0);
                own_m = std::min(own_m, (X_RS.inverse() * p_R).z());
            }
            EXPECT_NEAR(geometry.clearances(q)[k].height_m, own_m, 1e-12);
            lowest_m = std::min(lowest_m, own_m);
        }
        EXPECT_NEAR(geometry.lowestPoint_m(q), lowest_m, 1e-12);
    }
}

// Catches a workspace that wanders with the source, and a clearance that does not.
TEST(RigGeometry, TheWorkspaceStaysTheRobotsAndTheClearanceIsTheSources) {
    Draw draw(4);
    const Rig rig(draw);
    Vector6d q = Vector6d::Zero();
    q[kZ] = 0.15;
    EXPECT_TRUE(rig.at(Pose::Identity()).allowed(q));
    EXPECT_TRUE(rig.at(Pose(Eigen::Translation3d(0.5, 0.0, 0.0))).allowed(q));
    EXPECT_FALSE(rig.at(Pose(Eigen::Translation3d(0.0, 0.0, 0.2))).allowed(q));
    q[kX] = 0.21;
    EXPECT_FALSE(rig.at(Pose(Eigen::Translation3d(0.21, 0.0, 0.0))).allowed(q));
}

// Catches a robot that may not leave a place where it should not be, or may go farther into it.
TEST(RigGeometry, AStepOutOfAForbiddenPlaceIsAllowedAndNoneIntoIt) {
    Draw draw(4);
    const Rig rig(draw);
    const RigGeometry geometry = rig.at(Pose::Identity());
    const RobotLimits& limits = geometry.limits();
    const auto at = [](double x, double z) {
        Vector6d q = Vector6d::Zero();
        q[kX] = x;
        q[kZ] = z;
        return q;
    };
    EXPECT_TRUE(geometry.mayStep(at(0.0, 0.15), at(0.1, 0.2), limits));
    EXPECT_FALSE(geometry.mayStep(at(0.0, 0.15), at(0.0, -0.05), limits)) << "into the source";
    EXPECT_FALSE(geometry.mayStep(at(0.19, 0.15), at(0.21, 0.15), limits));
    EXPECT_TRUE(geometry.mayStep(at(0.25, 0.15), at(0.22, 0.15), limits));
    EXPECT_FALSE(geometry.mayStep(at(0.25, 0.15), at(0.26, 0.15), limits));
    EXPECT_FALSE(geometry.mayStep(at(0.25, 0.15), at(0.22, -0.05), limits)) << "one way back, another out";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(geometry.mayStep(at(0.0, 0.15), at(nan, 0.15), limits));
    EXPECT_FALSE(geometry.mayStep(at(0.0, 0.15), at(0.0, nan), limits));
    const RigGeometry risen = rig.at(Pose(Eigen::Translation3d(0.0, 0.0, 0.2)));
    EXPECT_TRUE(risen.mayStep(at(0.0, 0.15), at(0.0, 0.18), limits)) << "off a source that came nearer";
    EXPECT_FALSE(risen.mayStep(at(0.0, 0.15), at(0.0, 0.149), limits));
}

// Catches a copy that keeps something of where the source was.
TEST(RigGeometry, ASourceMovedElsewhereIsTheRigBuiltThere) {
    Draw draw(5);
    const Rig rig(draw);
    const Pose X_RS = drawnPose(draw, 0.1, 0.5);
    const auto moved = rig.at(drawnPose(draw, 0.1, 0.5)).withSourceAt(X_RS);
    const RigGeometry built = rig.at(X_RS);
    const auto back = moved->withSourceAt(Pose::Identity());
    const RigGeometry home(rig.source, rig.shapes, rig.mountings, rig.limits);
    for (int i = 0; i < 5; ++i) {
        const Vector6d q = poseOver(draw);
        EXPECT_EQ(moved->viewFactors(q).dF, built.viewFactors(q).dF);
        EXPECT_EQ(moved->viewFactorsFast(q), built.viewFactorsFast(q));
        EXPECT_EQ(moved->clearances(q)[1].gradient, built.clearances(q)[1].gradient);
        EXPECT_EQ(back->viewFactors(q).dF, home.viewFactors(q).dF);
        EXPECT_EQ(back->lowestPoint_m(q), home.lowestPoint_m(q));
    }
    EXPECT_TRUE(moved->away().isApprox(X_RS.linear() * Eigen::Vector3d::UnitZ()));
}

// Catches shields left where they were to the source, or something held that may go down to one.
TEST(RigGeometry, ShieldsStandInTheRoomAndHeldPlatesStayAboveThem) {
    Draw draw(9);
    const Rig rig(draw);
    const Pose X_RS = drawnPose(draw, 0.05, 0.2);
    Screens screens;
    screens.shields.push_back(
        {RadiatingContour(Disk{0.05}), X_RS * Pose(Eigen::Translation3d(0.04, 0, 0.03))});
    screens.fixtures.push_back({RadiatingContour(Disk{0.02}), Pose(Eigen::Translation3d(0, 0, -0.15))});
    const RigGeometry built(rig.source, rig.shapes, rig.mountings, rig.limits, X_RS, {}, screens);
    const auto moved =
        RigGeometry(rig.source, rig.shapes, rig.mountings, rig.limits, Pose::Identity(), {}, screens)
            .withSourceAt(X_RS);
    const RigGeometry open = rig.at(X_RS);
    EXPECT_TRUE(built.mayShade());
    EXPECT_NEAR(built.floor_m(), 0.03, 1e-9);
    for (int i = 0; i < 5; ++i) {
        Vector6d q = poseOver(draw);
        q[kZ] += 0.3;
        const std::vector<Clearance> clearances = built.clearances(q);
        ASSERT_EQ(clearances.size(), rig.shapes.size() + 1);
        EXPECT_NEAR(clearances[0].height_m, open.clearances(q)[0].height_m - 0.03, 1e-12);
        EXPECT_EQ(built.lowestPoint_m(q), moved->lowestPoint_m(q));
        EXPECT_NEAR(built.lowestPoint_m(q), clearances.back().height_m, 1e-12) << "the fixture is lowest";
        EXPECT_EQ(built.viewFactors(q).dF, moved->viewFactors(q).dF);
        const auto height = [&](const Vector6d& at) { return built.clearances(at).back().height_m; };
        EXPECT_LT((differences(height, q, 1e-4) - clearances.back().gradient).norm(), 1e-5);
        Vector6d low = q;
        low.head<3>() -= (built.lowestPoint_m(q) - rig.limits.clearance_m + 1e-4) * built.away();
        const RobotLimits limits = built.limits();
        EXPECT_FALSE(built.mayStep(q, low, limits)) << "under the clearance from the shield";
        low.head<3>() += 2e-4 * built.away();
        EXPECT_GE(built.lowestPoint_m(low), limits.clearance_m);
    }
}

// Catches a retreat that goes up instead of off the source: into a source that stands upright beside it.
TEST(PoseOffSource, GoesAlongTheSourcesNormalToTheEndOfTheWorkspace) {
    Draw draw(6);
    const Rig rig(draw);
    Vector6d q;
    q << 0.05, -0.1, 0.1, 0.2, 0.0, 0.0;
    Vector6d up = q;
    up[kZ] = rig.limits.upper[kZ];
    EXPECT_EQ(poseOffSource(rig.at(Pose::Identity()), q), up);

    Vector6d upright = Vector6d::Zero();
    upright[kY] = 0.3;
    upright[kThetaX] = M_PI / 2.0; // its normal along -y
    Vector6d off = q;
    off[kY] = rig.limits.lower[kY];
    EXPECT_LT((poseOffSource(rig.at(poseFromCoordinates(upright)), q) - off).norm(), 1e-12);

    for (int i = 0; i < 50; ++i) {
        const RigGeometry geometry = rig.at(drawnPose(draw, 0.1, 1.5));
        const Vector6d from = poseOver(draw).cwiseMax(rig.limits.lower).cwiseMin(rig.limits.upper);
        const Vector6d goal = poseOffSource(geometry, from);
        EXPECT_GE((goal - from).head<3>().dot(geometry.away()), -1e-12);
        EXPECT_EQ(goal.tail<3>(), from.tail<3>());
        EXPECT_LE((goal - rig.limits.upper).head<3>().maxCoeff(), 1e-12);
        EXPECT_LE((rig.limits.lower - goal).head<3>().maxCoeff(), 1e-12);
    }
}

// Catches a controller that goes on with the geometry that it was made with.
TEST(Controllers, GoByTheNewGeometryAsIfTheyHadBeenMadeWithIt) {
    Draw draw(7);
    Rig rig(draw);
    rig.source = Disk{0.1}; // the controllers look at many poses
    const auto here = std::make_shared<RigGeometry>(rig.at(Pose::Identity()));
    const auto there = here->withSourceAt(Pose(Eigen::Translation3d(0.04, 0.0, 0.01)));
    for (const ControllerKind kind :
         {ControllerKind::ModelBased, ControllerKind::Adaptive, ControllerKind::LevelServo}) {
        ControllerSettings settings;
        settings.kind = kind;
        ControlModel model;
        model.geometry = here;
        model.estimated.assign(3, HeatRates{0.2, 3e-11, 0.1});
        model.targets_K.assign(3, 315.0);
        Observation observation;
        observation.coordinates[kZ] = 0.15;
        observation.objects = {{305.0, 0.01}, {306.0, 0.02}, {307.0, 0.03}};
        const auto told = makeController(settings, model);
        told->setGeometry(there);
        model.geometry = there;
        const ControlOutput wanted = makeController(settings, model)->step(observation, 1.0);
        EXPECT_EQ(told->step(observation, 1.0).rates, wanted.rates) << kind.key();
        EXPECT_GT(wanted.rates.norm(), 0.0);
    }
}

} // namespace bask
