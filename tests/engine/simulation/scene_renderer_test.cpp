// What hides what, and scenes that no one would set up but anybody can.

#include "engine/simulation/scene_renderer.h"

#include "engine/simulation/rig_faces.h"
#include "engine/simulation/simulated_camera.h"
#include "tests/engine/calibration/calibration_samples.h"

#include <limits>

namespace bask {
namespace {

SceneFace plate(double side_m, float front, float behind, int layer = 0) {
    const double h = 0.5 * side_m;
    return {{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}}, front, behind, {}, 0.0F, layer};
}

/// Facing the camera, so far from it, and then turned about its own axes.
Pose facing(const Eigen::Vector3d& p_m, const Eigen::Vector3d& turn_rad = Eigen::Vector3d::Zero()) {
    return poseFromRotationVector(p_m, {std::numbers::pi, 0, 0}) *
           poseFromRotationVector(Eigen::Vector3d::Zero(), turn_rad);
}

std::uint8_t greyAt(const GreyPicture& picture, double u, double v) {
    return picture.values[static_cast<std::size_t>(std::lround(v) * picture.width + std::lround(u))];
}

GreyPicture pictureOf(const CameraModel& camera, std::span<const PlacedFace> faces) {
    return SceneRenderer(camera, Pose::Identity(), {}).render(faces, {}, 1);
}

// Catches: an order by the distance of middles only, which puts a large plate before the small thing in front
// of its far end; a card drawn under what it lies on; the wrong side shown.
TEST(SceneRenderer, NearerThingsHideFartherOnes) {
    const CameraModel camera = test::smallCamera();
    const SceneFace large = plate(0.6, 100, 110), small = plate(0.06, 200, 210),
                    card = plate(0.03, 250, 240, 1);
    // The plate leans away steeply; the small face stands a little above its far end: farther than its
    // middle.
    const Pose X_CL = facing({0, 0, 0.8}, {-1.2, 0, 0});
    const Pose X_CN = X_CL * Eigen::Translation3d(0.0, 0.25, 0.03),
               X_CU = X_CL * Eigen::Translation3d(0, 0.25, -0.03);
    ASSERT_GT(X_CN.translation().norm(), X_CL.translation().norm());
    const Eigen::Vector2d at = test::shown(camera, X_CN.translation());
    const std::vector<PlacedFace> above{{&card, X_CN}, {&small, X_CN}, {&large, X_CL}};
    EXPECT_EQ(greyAt(pictureOf(camera, above), at.x(), at.y()), 250);
    const std::vector<PlacedFace> under{{&small, X_CU}, {&large, X_CL}};
    const Eigen::Vector2d below = test::shown(camera, X_CU.translation());
    EXPECT_EQ(greyAt(pictureOf(camera, under), below.x(), below.y()), 100);
    const Pose turned = X_CN * poseFromRotationVector(Eigen::Vector3d::Zero(), {std::numbers::pi, 0, 0});
    const std::vector<PlacedFace> behind{{&large, X_CL}, {&small, turned}};
    EXPECT_EQ(greyAt(pictureOf(camera, behind), at.x(), at.y()), 210);
}

// Catches: an order that depends on how the faces are listed, or that loses some of faces that pass through
// one another.
TEST(SceneRenderer, EveryFaceIsPaintedOnceInAnyOrder) {
    const SceneFace a = plate(0.2, 1, 1), b = plate(0.2, 2, 2), c = plate(0.2, 3, 3);
    std::vector<PlacedFace> faces{{&a, facing({0, 0, 0.5}, {0.8, 0, 0})},
                                  {&b, facing({0.01, 0, 0.52}, {-0.8, 0.3, 0})},
                                  {&c, facing({0, 0.01, 0.54}, {0, 0.8, 0})}};
    const auto names = [&] {
        std::string text;
        for (const PlacedFace& face : inPaintingOrder(faces))
            text += std::to_string(static_cast<int>(face.face->front));
        return text;
    };
    const std::string order = names();
    EXPECT_EQ(order.size(), 3U);
    std::ranges::reverse(faces);
    EXPECT_EQ(names(), order);
}

// Catches: a line that is straight in the scene drawn straight through a lens that bends it.
TEST(SceneRenderer, ALongEdgeIsBentAsTheLensBendsIt) {
    CameraModel camera = test::sampleCamera();
    const SceneFace face = plate(0.5, 255, 255);
    const Pose X_CF = facing({0, -0.05, 0.6});
    const GreyPicture picture = pictureOf(camera, std::vector<PlacedFace>{{&face, X_CF}});
    for (double x = -0.24; x <= 0.24; x += 0.04) { // the lower edge: brightness summed down a column
        const Eigen::Vector2d edge = test::shown(camera, X_CF * Eigen::Vector3d(x, -0.25, 0));
        const auto u = static_cast<int>(std::lround(edge.x()));
        double sum = 0.0;
        for (int v = static_cast<int>(edge.y()) - 20; v < static_cast<int>(edge.y()) + 20; ++v)
            sum += (picture.values[static_cast<std::size_t>(v * picture.width + u)] -
                    greyAt(picture, u, edge.y() + 21)) /
                   static_cast<double>(255 - greyAt(picture, u, edge.y() + 21));
        const double slope = (test::shown(camera, X_CF * Eigen::Vector3d(x + 1e-3, -0.25, 0)) - edge).y() /
                             (test::shown(camera, X_CF * Eigen::Vector3d(x + 1e-3, -0.25, 0)) - edge).x();
        const double seen = std::floor(edge.y()) - 20.5 + sum;
        EXPECT_NEAR(seen, edge.y() + slope * (u - edge.x()), 0.03) << x;
    }
}

// Catches: crashes, endless loops and numbers that are none, in scenes with the camera within a face, faces
// edge-on, behind it, of no size, very far, and cameras of a pixel or with impossible lenses.
TEST(SceneRenderer, StrangeScenesAreDrawnSomehow) {
    const SceneFace face = plate(0.2, 200, 180), point = plate(0.0, 200, 180), endless = plate(1e6, 200, 180);
    std::vector<PlacedFace> faces;
    for (const SceneFace* f : {&face, &point, &endless})
        for (const Pose& X_CF :
             {Pose::Identity(), facing({0, 0, 0}), facing({0, 0, 1e-9}), facing({0, 0, -0.5}),
              facing({0, 0, 0.5}, {0.5 * std::numbers::pi, 0, 0}), facing({0.05, 0, 0.02}, {0, 1.5, 0}),
              facing({1e7, 0, 1.0}), facing({0, 0, 1e9}), facing({0, 0, 0.1}, {0, 0.9, 0})})
            faces.push_back({f, X_CF});
    for (const std::vector<double>& distortion : {std::vector<double>{},
                                                  {-0.1, 0.03, 0, 0, 0},
                                                  {-5, 0, 0, 0, 0},
                                                  {50, 0, 1, -1, 0},
                                                  {0, 0, 0, 0, 0, -1, 0, 0}})
        for (const auto& [width, height] : {std::pair(1, 1), {64, 2}, {3, 50}, {160, 120}}) {
            CameraModel camera = test::smallCamera();
            camera.width = width;
            camera.height = height;
            camera.fx = camera.fy = width == 64 ? 1.0 : 100.0;
            camera.distortion = distortion;
            SceneRenderer renderer(camera, lookingAt({0.3, 0.2, 0.4}, {0, 0, 0}), {2.0, 0.7, 0.3, 1});
            const GreyPicture picture = renderer.render(faces, faces, 1);
            EXPECT_EQ(picture.values.size(), static_cast<std::size_t>(width * height));
        }
    EXPECT_THROW(SceneRenderer(CameraModel(), Pose::Identity(), {}), std::invalid_argument);
}

// Catches: axes of the usual camera exchanged or upside down, also when it looks straight down.
TEST(SceneRenderer, LookingAtIsUprightAndCentred) {
    for (const Eigen::Vector3d& eye :
         {Eigen::Vector3d(0.5, -0.3, 0.6), {0, 0, 1}, {0, 0, -1}, {-0.2, 0.4, 0}}) {
        const Pose X_RC = lookingAt(eye, {0, 0, 0});
        EXPECT_NEAR(X_RC.linear().determinant(), 1.0, 1e-12);
        const Eigen::Vector3d middle = X_RC.inverse() * Eigen::Vector3d::Zero();
        EXPECT_LT((middle - Eigen::Vector3d(0, 0, eye.norm())).norm(), 1e-12);
        EXPECT_LE((X_RC.inverse().linear() * Eigen::Vector3d::UnitZ()).y(), 1e-12) << "up is up";
    }
}

} // namespace
} // namespace bask
