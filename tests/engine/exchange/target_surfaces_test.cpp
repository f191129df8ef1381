// Surfaces of targets in the end-effector's coordinates, against the solver itself.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/control/rig_geometry.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/thermal/heat_balance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bask::test {
namespace {

const Disk kSource{0.10};
const std::vector<Shape> kShapes{Disk{0.015}, FourierContour({{0.003, 0.0}, {0.0, 0.0}, {0.025, 0.0}})};

std::vector<Vector6d> mountings() {
    std::vector<Vector6d> out(2, Vector6d::Zero());
    out[0][kY] = 0.05;
    out[1] << -0.0435, -0.025, 0.004, 0.1, -0.2, 0.7;
    return out;
}

/// The source off the robot's base, turned about every axis.
Vector6d movedSource() {
    return (Vector6d() << 0.03, -0.04, 0.02, 0.2, -0.15, 0.9).finished();
}

TargetGeometry geometry(const Vector6d& source, double step = kSurfaceStep_m) {
    TargetGeometry out{RadiatingContour(kSource), poseFromCoordinates(source), {}, {}, {}};
    for (std::size_t i = 0; i < kShapes.size(); ++i)
        out.objects.push_back({RadiatingContour(kShapes[i]), poseFromCoordinates(mountings()[i])});
    RobotLimits limits;
    limits.lower[kZ] = 0.08; // clear of steep places and of the source's plane
    limits.upper[kZ] = 0.22;
    out.axes = surfaceAxes(PoseSubset::Translation, limits, step);
    out.fixed << 0.0, 0.0, 0.0, 0.2, -0.1, 0.3;
    return out;
}

/// View factors at a point of a surface, by the solver that the controllers use.
double viewFactorAt(std::size_t object, const TargetGeometry& of, const Vector6d& source,
                    const Eigen::Vector3d& point) {
    const RigGeometry rig(kSource, kShapes, mountings(), {}, poseFromCoordinates(source));
    Vector6d q = of.fixed;
    for (int a = 0; a < 3; ++a)
        q[of.axes[static_cast<std::size_t>(a)].coordinate] = point[a];
    return rig.viewFactors(q).F[static_cast<Eigen::Index>(object)];
}

double worstOver(const TargetGeometry& of, const Vector6d& source, const std::vector<double>& values) {
    const auto fields = targetFields(of);
    EXPECT_TRUE(fields);
    const auto surfaces = targetSurfaces(*fields, values);
    EXPECT_TRUE(surfaces);
    EXPECT_EQ(surfaces->size(), values.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < surfaces->size(); ++i) {
        const Isosurface& surface = (*surfaces)[i];
        EXPECT_EQ(surface.value, values[i]);
        EXPECT_GT(surface.points.size(), 100U) << "object " << i;
        const std::size_t every = std::max<std::size_t>(1, surface.points.size() / 300);
        for (std::size_t k = 0; k < surface.points.size(); k += every)
            worst = std::max(worst, std::abs(viewFactorAt(i, of, source, surface.points[k]) - surface.value));
    }
    return worst;
}

// Catches: a mounting left out or on the wrong side (the objects' own centres instead of the end-effector),
// held angles forgotten, an object's value at another's field.
TEST(TargetSurfaces, hasEachObjectsViewFactorAtTheEndEffectorsPose) {
    EXPECT_LT(worstOver(geometry(Vector6d::Zero()), Vector6d::Zero(), {0.3, 0.2}), 4e-3);
}

// Catches: surfaces in the source's frame, where the picture and the robot are in R.
TEST(TargetSurfaces, areInTheRobotsAxesWhereverTheSourceLies) {
    EXPECT_LT(worstOver(geometry(movedSource()), movedSource(), {0.3, 0.2}), 4e-3);
}

// Catches: angles as positions, or the held position lost.
TEST(TargetSurfaces, overTheAnglesAreSurfacesToo) {
    TargetGeometry of = geometry(movedSource());
    of.axes = surfaceAxes(PoseSubset::Rotation, {}, kSurfaceStep_rad);
    of.fixed << 0.01, -0.02, 0.12, 0.0, 0.0, 0.0;
    EXPECT_LT(worstOver(of, movedSource(), {0.2, 0.2}), 1e-2);
}

// Catches: an object's own surface that is not where its centre is: the mounting's translation left in, not
// turned with the end-effector, or its rotation lost.
TEST(TargetSurfaces, overOwnPositionsAreWhereTheObjectsCentresAre) {
    TargetGeometry of = geometry(movedSource());
    of.ofOwnCentres = true;
    const auto fields = targetFields(of);
    ASSERT_TRUE(fields);
    const auto surfaces = targetSurfaces(*fields, std::array{0.3, 0.2});
    for (std::size_t i = 0; i < 2; ++i) {
        const Pose X_EO = poseFromCoordinates(mountings()[i]);
        Pose X_SO = poseFromCoordinates(of.fixed) * X_EO;
        double worst = 0.0;
        for (const Eigen::Vector3d& centre : (*surfaces)[i].points) {
            X_SO.translation() = centre;
            worst = std::max(worst, std::abs(viewFactor(of.source, of.objects[i].contour,
                                                        poseFromCoordinates(movedSource()).inverse() * X_SO)
                                                 .value -
                                             (*surfaces)[i].value));
        }
        EXPECT_LT(worst, 4e-3) << "object " << i;
        // As far as the end-effector's workspace carries it, and no farther.
        const double reach_m = of.axes[0].at(0) + centreOffset(X_EO, of.fixed).x();
        EXPECT_NEAR((*fields)[i]->axes[0].at(0), reach_m, 1e-12);
    }
    of.axes = surfaceAxes(PoseSubset::Rotation, {}, kSurfaceStep_rad);
    EXPECT_THROW((void)targetFields(of), std::invalid_argument);
}

// Catches: other values than MODEL's for 30, 40 and 50 C at 25 C of the room (the paper's 0.12, 0.37, 0.65),
// and surfaces that cross the axis elsewhere than coaxial disks have those values.
TEST(TargetSurfaces, ofThePapersTargetsCrossTheAxisWhereTheClosedFormSays) {
    const double room_K = kelvinFromCelsius(25.0);
    const HeatRates rates =
        heatRates({}, surroundingsOf(SourceModel::Paper, kelvinFromCelsius(200.0), 0.25, room_K));
    TargetGeometry of{RadiatingContour(kSource), Pose::Identity(), {{RadiatingContour(Disk{0.015})}}, {}, {}};
    of.axes = surfaceAxes(PoseSubset::Translation, {}, kSurfaceStep_m);
    const auto fields = targetFields(of);
    ASSERT_TRUE(fields);
    const std::pair<double, double> cases[] = {{30.0, 0.1175}, {40.0, 0.3705}, {50.0, 0.6488}};
    for (const auto& [target_degC, factor] : cases) {
        const double F = rates.steadyViewFactor(kelvinFromCelsius(target_degC));
        EXPECT_NEAR(F, factor, 1e-4);
        // Coaxial disks: F solved for the height.
        const auto coaxial = [](double h_m) {
            const double R1 = 0.015 / h_m, R2 = 0.10 / h_m, X = 1.0 + (1.0 + R2 * R2) / (R1 * R1);
            return 0.5 * (X - std::sqrt(X * X - 4.0 * (R2 / R1) * (R2 / R1)));
        };
        double low = 0.01, high = 0.3;
        for (int i = 0; i < 60; ++i)
            (coaxial(0.5 * (low + high)) > F ? low : high) = 0.5 * (low + high);
        const auto surfaces = targetSurfaces(*fields, std::array{F});
        const auto nearest = std::ranges::min_element(
            surfaces->front().points, {}, [](const Eigen::Vector3d& p) { return p.head<2>().norm(); });
        EXPECT_NEAR(nearest->head<2>().norm(), 0.0, 1e-9);
        EXPECT_NEAR(nearest->z(), low, 3e-4) << target_degC;
    }
}

// Catches: a grid that ends before the workspace does, a coarser step than asked for, and a workspace without
// extent that has no surface (VTK needs two samples).
TEST(TargetSurfaces, theGridHoldsTheWholeWorkspace) {
    RobotLimits limits;
    limits.lower.head<3>() << -0.2, -0.103, 0.05;
    limits.upper.head<3>() << 0.2, 0.1, 0.05;
    const auto axes = surfaceAxes(PoseSubset::Translation, limits, 0.01);
    ASSERT_EQ(axes.size(), 3U);
    EXPECT_EQ(axes[0].count, 41);
    EXPECT_NEAR(axes[0].step, 0.01, 1e-12);
    EXPECT_EQ(axes[1].count, 22);
    EXPECT_NEAR(axes[1].at(21), 0.1, 1e-12);
    EXPECT_LT(axes[1].step, 0.01);
    EXPECT_EQ(axes[2].count, 3);
    EXPECT_NEAR(axes[2].at(1), 0.05, 1e-12);
    const auto angles = surfaceAxes(PoseSubset::Rotation, limits, kSurfaceStep_rad);
    for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(angles[static_cast<std::size_t>(a)].coordinate, kThetaX + a);
        EXPECT_EQ(angles[static_cast<std::size_t>(a)].count, 37);
        EXPECT_NEAR(angles[static_cast<std::size_t>(a)].at(36), std::numbers::pi / 2.0, 1e-12);
    }
    EXPECT_THROW(surfaceAxes(PoseSubset::Rotation, limits, 0.0), std::invalid_argument);
}

// Catches: surfaces at poses where an object would be in the source, and surfaces that end before the
// clearance does.
TEST(TargetSurfaces, endWhereTheClearanceDoes) {
    TargetGeometry of = geometry(Vector6d::Zero());
    of.axes = surfaceAxes(PoseSubset::Translation, {}, kSurfaceStep_m);
    of.fixed[kThetaX] = 0.5;
    of.clearance_m = 0.02;
    const auto fields = targetFields(of);
    ASSERT_TRUE(fields);
    const auto surfaces = targetSurfaces(*fields, std::array{0.2, 0.2});
    for (std::size_t i = 0; i < 2; ++i) {
        const RigGeometry rig(kSource, {kShapes[i]}, {mountings()[i]}, {});
        double lowest_m = 1.0;
        for (const Eigen::Vector3d& point : (*surfaces)[i].points) {
            Vector6d q = of.fixed;
            q.head<3>() = point;
            lowest_m = std::min(lowest_m, rig.lowestPoint_m(q));
        }
        EXPECT_GT(lowest_m, of.clearance_m - 0.0101);
        if (i == 1) { // the tilt lifts the other one over it all over the workspace
            EXPECT_LT(lowest_m, of.clearance_m);
        }
    }
}

// Catches: a job that goes on when nobody wants its answer any more, and half an answer that looks whole.
TEST(TargetSurfaces, stopsWhenAsked) {
    std::stop_source stop;
    const auto fields = targetFields(geometry(Vector6d::Zero(), 0.04));
    ASSERT_TRUE(fields);
    EXPECT_TRUE(targetSurfaces(*fields, std::array{0.3, 0.3}, stop.get_token()));
    stop.request_stop();
    const auto stopped = targetFields(geometry(Vector6d::Zero(), 0.04), stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code(), MessageCode::FieldCancelled);
    EXPECT_FALSE(targetSurfaces(*fields, std::array{0.3, 0.3}, stop.get_token()));
}

// Catches: a target out of reach that is an error, or another object's surface in its place.
TEST(TargetSurfaces, aValueOutOfReachIsAnEmptySurface) {
    const auto fields = targetFields(geometry(Vector6d::Zero(), 0.04));
    ASSERT_TRUE(fields);
    const auto surfaces = targetSurfaces(*fields, std::array{1.2, 0.2});
    EXPECT_TRUE((*surfaces)[0].empty());
    EXPECT_FALSE((*surfaces)[1].empty());
    EXPECT_THROW(targetSurfaces(*fields, std::array{0.3}), std::invalid_argument);
    EXPECT_FALSE(targetFields(geometry(Vector6d::Zero(), 1e-5))) << "too many samples";
}

// Catches: frames that are all of one value, or of the wrong coordinate.
TEST(TargetSurfaces, aSweepHasAFrameForEachValue) {
    const TargetGeometry of = geometry(movedSource());
    const auto frames = targetSweep(of, kThetaX, std::array{0.0, 0.4}, std::array{0.3, 0.2});
    ASSERT_TRUE(frames);
    ASSERT_EQ(frames->size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        const SurfaceFrame& frame = (*frames)[k];
        EXPECT_EQ(frame.fixed[kThetaX], k == 0 ? 0.0 : 0.4);
        EXPECT_EQ(frame.fixed[kThetaY], of.fixed[kThetaY]);
        TargetGeometry fixed = of;
        fixed.fixed = frame.fixed;
        for (std::size_t i = 0; i < 2; ++i) {
            const Isosurface& surface = frame.surfaces[i];
            ASSERT_FALSE(surface.empty());
            const Eigen::Vector3d& point = surface.points[surface.points.size() / 2];
            EXPECT_NEAR(viewFactorAt(i, fixed, movedSource(), point), surface.value, 4e-3);
        }
    }
    EXPECT_THROW(static_cast<void>(targetSweep(of, kX, std::array{0.0}, std::array{0.3, 0.2})),
                 std::invalid_argument);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(targetSweep(of, kThetaX, std::array{0.0}, std::array{0.3, 0.2}, stop.get_token()));
}

/// Three disks one above the other and to the side, as nobody hides nobody in one plane.
TargetGeometry stacked() {
    TargetGeometry out = geometry(movedSource());
    out.objects.clear();
    for (const auto& [x, z, radius] :
         {std::array{0.0, 0.0, 0.015}, {0.01, -0.03, 0.02}, {-0.02, 0.03, 0.015}}) {
        Pose X_EO = Pose::Identity();
        X_EO.translation() << x, 0.0, z;
        out.objects.push_back({RadiatingContour(Disk{radius}), X_EO});
    }
    return out;
}

// Catches: surfaces of the view factors without shade, which an object does not have there.
TEST(TargetSurfaces, countTheShadeOfTheOtherObjects) {
    const TargetGeometry of = stacked();
    std::vector<Shape> shapes;
    std::vector<Vector6d> places;
    for (const MountedContour& object : of.objects) {
        shapes.push_back(object.contour.shape());
        places.push_back(coordinatesFromPose(object.X_EO));
    }
    const RigGeometry rig(kSource, shapes, places, {}, of.X_RS);
    const auto fields = targetFields(of);
    ASSERT_TRUE(fields);
    const std::array<double, 3> values{0.15, 0.25, 0.12};
    const auto surfaces = targetSurfaces(*fields, values);
    ASSERT_TRUE(surfaces);
    double gap = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<Eigen::Vector3d>& points = (*surfaces)[i].points;
        ASSERT_GT(points.size(), 100u) << i;
        for (std::size_t k = 0; k < points.size(); k += std::max<std::size_t>(1, points.size() / 60)) {
            Vector6d q = of.fixed;
            q.head<3>() = points[k];
            EXPECT_NEAR(rig.viewFactors(q).F[static_cast<Eigen::Index>(i)], values[i], 8e-3) << i << ' ' << k;
            Eigen::VectorXd unshaded;
            rig.unshadedViewFactors(q, unshaded);
            gap = std::max(gap, unshaded[static_cast<Eigen::Index>(i)] - values[i]);
        }
    }
    EXPECT_GT(gap, 0.05);
}

// Catches: the field of another object, or one without the shade of those that are not asked for.
TEST(TargetSurfaces, theOnlyFieldIsThatOneOfAll) {
    TargetGeometry of = stacked();
    of.axes = surfaceAxes(PoseSubset::Translation, {}, 0.04);
    const auto all = targetFields(of);
    of.only = 2;
    const auto one = targetFields(of);
    ASSERT_TRUE(all && one);
    ASSERT_EQ(one->size(), 1u);
    for (std::size_t k = 0; k < one->front()->values.size(); ++k)
        if (!std::isnan((*all)[2]->values[k])) {
            ASSERT_EQ(one->front()->values[k], (*all)[2]->values[k]);
        }
}

} // namespace
} // namespace bask::test
