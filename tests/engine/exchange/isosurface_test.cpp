// Surfaces of equal view factor against closed forms.

#include "engine/exchange/isosurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace bask::test {
namespace {

/// View factor of a small parallel disk over the centre of a disk of radius r1 at height h: r1^2/(r1^2+h^2)
/// for a point, coaxial disks in closed form for a disk of radius r2.
double coaxialDisks(double r1_m, double r2_m, double h_m) {
    const double R1 = r2_m / h_m, R2 = r1_m / h_m; // seen from the object
    const double X = 1.0 + (1.0 + R2 * R2) / (R1 * R1);
    return 0.5 * (X - std::sqrt(X * X - 4.0 * (R2 / R1) * (R2 / R1)));
}

std::shared_ptr<const Field> overTheDisk(double step_m) {
    const int half = static_cast<int>(std::lround(0.2 / step_m));
    FieldRequest request{RadiatingContour(Disk{0.10}), RadiatingContour(Disk{0.015}), {}};
    request.axes = {{kX, -0.2, step_m, 2 * half + 1},
                    {kY, -0.2, step_m, 2 * half + 1},
                    {kZ, 0.01, step_m, static_cast<int>(std::lround(0.29 / step_m)) + 1}};
    const auto field = sampleField(request);
    EXPECT_TRUE(field);
    return *field;
}

// Catches: surfaces at another value, in other units or axes, points of other samples.
TEST(Isosurface, CrossesTheAxisWhereCoaxialDisksHaveTheValue) {
    const auto field = overTheDisk(0.01);
    for (const double h_m : {0.05, 0.083, 0.121}) {
        const double value = coaxialDisks(0.10, 0.015, h_m);
        const auto surfaces = isosurfaces(*field, {value});
        ASSERT_EQ(surfaces.size(), 1U);
        EXPECT_EQ(surfaces[0].value, value);
        double nearest_m = 1.0, height_m = 0.0;
        for (const Eigen::Vector3d& point : surfaces[0].points)
            if (point.head<2>().norm() < nearest_m) {
                nearest_m = point.head<2>().norm();
                height_m = point.z();
            }
        EXPECT_NEAR(nearest_m, 0.0, 1e-9);
        EXPECT_NEAR(height_m, h_m, 2e-4) << "F = " << value;
    }
}

// Catches: linear interpolation that is not, points off the surface: the error must fall with the square of
// the step.
TEST(Isosurface, EveryPointHasTheValue) {
    const RadiatingContour source(Disk{0.10}), object(Disk{0.015});
    std::array<double, 2> worst{};
    for (const int fine : {0, 1}) {
        const auto surfaces = isosurfaces(*overTheDisk(fine == 0 ? 0.01 : 0.005), {0.3});
        ASSERT_GT(surfaces[0].triangles.size(), 1000U);
        for (const Eigen::Vector3d& point : surfaces[0].points) {
            Pose X_SO = Pose::Identity();
            X_SO.translation() = point;
            if (point.z() < 0.05) // steep near the source's edge
                continue;
            const double F = viewFactor(source, object, X_SO).value;
            worst[static_cast<std::size_t>(fine)] =
                std::max(worst[static_cast<std::size_t>(fine)], std::abs(F - 0.3));
        }
    }
    EXPECT_LT(worst[0], 4e-3);
    EXPECT_LT(worst[1], 0.35 * worst[0]);
}

// Catches: holes, points that are there twice, triangles that are turned over, normals that look inwards.
TEST(Isosurface, IsOneSheetWithNormalsThatLookWhereTheValueFalls) {
    Field field;
    field.axes = {{kX, -1.0, 0.1, 21}, {kY, -1.0, 0.1, 21}, {kZ, -1.0, 0.1, 21}};
    for (int k = 0; k < 21; ++k)
        for (int j = 0; j < 21; ++j)
            for (int i = 0; i < 21; ++i)
                field.values.push_back(
                    -Eigen::Vector3d(field.axes[0].at(i), field.axes[1].at(j), field.axes[2].at(k)).norm());
    const Isosurface sphere = isosurfaces(field, {-0.8}).front();
    std::map<std::pair<int, int>, int> edges;
    double area = 0.0;
    for (const auto& t : sphere.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[std::minmax(t[k], t[(k + 1) % 3])];
        area += 0.5 * (sphere.points[t[1]] - sphere.points[t[0]])
                          .cross(sphere.points[t[2]] - sphere.points[t[0]])
                          .norm();
    }
    for (const auto& [edge, count] : edges)
        EXPECT_EQ(count, 2) << "a hole at the points " << edge.first << " and " << edge.second;
    EXPECT_NEAR(area, 4.0 * M_PI * 0.64, 0.01 * 4.0 * M_PI * 0.64);
    for (std::size_t i = 0; i < sphere.points.size(); ++i)
        EXPECT_GT(sphere.normals[i].dot(sphere.points[i].normalized()), 0.99);
}

// Catches: a value out of reach that is an error or gives triangles; samples without a number that get into
// points; a field of two axes that is read beyond its end.
TEST(Isosurface, LeavesOutWhatIsNotThere) {
    auto field = *overTheDisk(0.02);
    EXPECT_TRUE(isosurfaces(field, {1.5}).front().empty());
    field.values[field.values.size() / 2] = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Isosurface> surfaces = isosurfaces(field, {0.2});
    for (const Eigen::Vector3d& point : surfaces.front().points)
        EXPECT_TRUE(point.allFinite());
    field.axes.pop_back();
    EXPECT_THROW(isosurfaces(field, {0.2}), std::invalid_argument);
}

} // namespace
} // namespace bask::test
