#include "engine/thermography/face_pixels.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace bask {
namespace {

/// 160 x 120 pixels; at 0.5 m a pixel is 2.5 mm wide.
CameraModel smallCamera(std::vector<double> distortion = {}) {
    CameraModel camera;
    camera.width = 160;
    camera.height = 120;
    camera.fx = camera.fy = 200.0;
    camera.cx = 79.5;
    camera.cy = 59.5;
    camera.distortion = std::move(distortion);
    return camera;
}

/// At a place in camera axes, turned about x and y; its front looks at the camera.
Pose placed(double x, double y, double z, double tilt_rad = 0.0, double turn_rad = 0.0) {
    return poseFromRotationVector({x, y, z}, {tilt_rad, turn_rad, 0.0});
}

FacePixels seen(const std::vector<PlacedPlate>& objects, std::size_t index,
                const std::vector<PlacedPlate>& screens = {}, const CameraModel& camera = smallCamera(),
                const FacePixelOptions& options = {}) {
    auto found = facePixels(PixelRays(camera), Pose::Identity(), objects, screens, options);
    EXPECT_TRUE(found[index]) << describe(found[index].error());
    return found[index].value();
}

int columnOf(int pixel) {
    return pixel % 160;
}
int rowOf(int pixel) {
    return pixel / 160;
}

MessageCode refusal(const std::vector<PlacedPlate>& objects, std::size_t index,
                    const std::vector<PlacedPlate>& screens = {}) {
    const auto found = facePixels(PixelRays(smallCamera()), Pose::Identity(), objects, screens);
    return found[index] ? MessageCode::None : found[index].error().code();
}

Contour square(double side_m) {
    const double h = side_m / 2.0;
    return Contour{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}};
}

} // namespace

// Catches: an outline that is drawn too large, too small or elsewhere; erosion that is not `blur_px`.
TEST(FacePixels, ofADiskAreThePixelsWithinItsEdge) {
    for (const double blur_px : {1.5, 4.0}) {
        const FacePixels found =
            seen({{Disk{0.05}, placed(0.02, -0.01, 0.5)}}, 0, {}, smallCamera(), {.blur_px = blur_px});
        EXPECT_TRUE(found.isFront);
        EXPECT_TRUE(found.isWhole);
        std::set<int> pixels(found.pixels.begin(), found.pixels.end());
        const double u = 79.5 + 200.0 * 0.02 / 0.5, v = 59.5 - 200.0 * 0.01 / 0.5,
                     radius = 200.0 * 0.05 / 0.5;
        for (int row = 0; row < 120; ++row)
            for (int column = 0; column < 160; ++column) {
                const double inside = radius - std::hypot(column - u, row - v);
                const bool isIn = pixels.contains(row * 160 + column);
                if (std::abs(inside - blur_px) > 0.02) { // the disk is drawn with 128 corners
                    EXPECT_EQ(isIn, inside > blur_px) << column << ' ' << row;
                }
            }
    }
}

// Catches: the uncertainty of the camera's pose left out, or not as large in the picture as before the
// camera.
TEST(FacePixels, keepOffWhereAnEdgeMayBe) {
    const double radius = 200.0 * 0.05 / 0.5, range_m = std::hypot(0.05, 0.5);
    for (const SightUncertainty& sight : {SightUncertainty{0.005, 0.0}, {0.0, 0.01}, {0.003, 0.008}}) {
        const double off_m = 2.0 * std::hypot(sight.across_m, sight.angle_rad * range_m);
        const double off_px = 200.0 * off_m * range_m / (0.5 * 0.5);
        const FacePixels found =
            seen({{Disk{0.05}, placed(0.0, 0.0, 0.5)}}, 0, {}, smallCamera(), {.sight = sight});
        const std::set<int> pixels(found.pixels.begin(), found.pixels.end());
        for (int row = 0; row < 120; ++row)
            for (int column = 0; column < 160; ++column) {
                const double inside = radius - std::hypot(column - 79.5, row - 59.5) - 1.5 - off_px;
                if (std::abs(inside) > 0.02) {
                    EXPECT_EQ(pixels.contains(row * 160 + column), inside > 0.0) << column << ' ' << row;
                }
            }
    }
    // What is nearer hides more, and by more pixels than it would from afar.
    const PlacedPlate far{Disk{0.1}, placed(0.0, 0.0, 0.8)}, near{Disk{0.01}, placed(0.0, 0.0, 0.4)};
    const FacePixels behind = seen({far}, 0, {near}, smallCamera(), {.sight = {0.004, 0.0}});
    for (const int pixel : behind.pixels) {
        const double from = std::hypot(columnOf(pixel) - 79.5, rowOf(pixel) - 59.5);
        EXPECT_GT(from, 200.0 * 0.01 / 0.4 + 1.5 + 4.0 - 0.02);
        EXPECT_LT(from, 200.0 * 0.1 / 0.8 - 1.5 - 2.0 + 0.02);
    }
    EXPECT_GT(behind.pixels.size(), 500U);
}

// Catches: a small object that is read although its pixels may be of something else, and a reason that sends
// people elsewhere.
TEST(FacePixels, sayThatThePoseIsNotKnownWellEnough) {
    const std::vector<PlacedPlate> objects{{Disk{0.012}, placed(0.0, 0.0, 0.5)},
                                           {Disk{0.05}, placed(1.0, 0.0, 0.5)},
                                           {Disk{0.05}, placed(0.1, 0.0, 0.5)}};
    const auto found = facePixels(PixelRays(smallCamera()), Pose::Identity(), objects, {},
                                  {.sight = {.across_m = 0.005, .angle_rad = 0.0}});
    ASSERT_FALSE(found[0]);
    EXPECT_EQ(found[0].error().code(), MessageCode::ThermalPlaceVague);
    ASSERT_FALSE(found[1]);
    EXPECT_EQ(found[1].error().code(), MessageCode::ThermalFaceOutside);
    EXPECT_TRUE(found[2]);
    EXPECT_EQ(refusal(objects, 0), MessageCode::None);
}

// Catches: a plate near the camera's plane, or behind it, that takes from others what it does not hide, or
// that has one beside the picture drawn into it, where the lens model turns back.
TEST(FacePixels, keepOffOnlyWhatMayBeInThePicture) {
    const FacePixelOptions options{.sight = {.across_m = 0.002, .angle_rad = 0.0}};
    const std::vector<PlacedPlate> objects{{Disk{0.05}, placed(0.0, 0.0, 0.5)}};
    const PlacedPlate behind{Disk{0.05}, placed(0.3, 0.0, -0.2)}, beside{Disk{0.03}, placed(0.3, 0.0, 0.2)};
    // From behind the camera up to z = 0.3 m, 14 px left of the disk's edge; farther on it would hide it.
    const PlacedPlate wall{square(0.78), placed(-0.225, 0.0, -0.05, 0.0, -std::atan(2.0))};
    for (const CameraModel& camera : {smallCamera(), smallCamera({-0.35, 0.0, 0.0, 0.0, 0.0})}) {
        const FacePixels alone = seen(objects, 0, {}, camera, options);
        EXPECT_GT(alone.pixels.size(), 500U);
        EXPECT_EQ(seen(objects, 0, {behind, beside}, camera, options).pixels, alone.pixels);
        EXPECT_EQ(seen(objects, 0, {wall}, camera, options).pixels, alone.pixels);
    }
}

// Catches: a plate of which nobody knows where it is that is read or seen through.
TEST(FacePixels, areNoneWhereAnEdgeMayBeAnywhere) {
    const std::vector<PlacedPlate> objects{{Disk{0.05}, placed(0.0, 0.0, 0.5)},
                                           {Disk{0.05}, placed(0.1, 0.0, 0.3)}};
    const auto found = facePixels(PixelRays(smallCamera()), Pose::Identity(), objects, {},
                                  {.sight = {.across_m = 1.0, .angle_rad = 0.0}});
    for (const Result<FacePixels>& face : found) {
        ASSERT_FALSE(face);
        EXPECT_EQ(face.error().code(), MessageCode::ThermalPlaceVague);
    }
}

// Catches: holes that are measured, and their edges.
TEST(FacePixels, leaveOutHoles) {
    const Shape ring =
        withHoles(Disk{0.06}, {Contour{{{-0.01, -0.01}, {0.01, -0.01}, {0.01, 0.01}, {-0.01, 0.01}}}});
    const FacePixels found = seen({{ring, placed(0.0, 0.0, 0.5)}}, 0);
    for (const int pixel : found.pixels) {
        const double x = columnOf(pixel) - 79.5, y = rowOf(pixel) - 59.5;
        EXPECT_FALSE(std::abs(x) < 4.0 + 1.4 && std::abs(y) < 4.0 + 1.4 && std::hypot(x, y) < 5.0)
            << x << ' ' << y;
    }
    EXPECT_LT(found.pixels.size(), seen({{Disk{0.06}, placed(0.0, 0.0, 0.5)}}, 0).pixels.size() - 80);
}

// Catches: a lens that is passed over. Truth: each pixel's line of sight cut with the plate.
TEST(FacePixels, followTheLensAndTheTilt) {
    const CameraModel camera = smallCamera({-0.35, 0.12, 0.002, -0.003, 0.0});
    const Pose X_CO = placed(0.05, 0.03, 0.45, 0.5, -0.7);
    const FacePixels found = seen({{square(0.12), X_CO}}, 0, {}, camera);
    const std::set<int> pixels(found.pixels.begin(), found.pixels.end());
    EXPECT_GT(pixels.size(), 300U);
    const PixelRays rays(camera);
    const auto isInside = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= 160 || row >= 120)
            return false;
        const Eigen::Vector2d& ray =
            rays.ray(static_cast<std::size_t>(row) * 160 + static_cast<std::size_t>(column));
        const Eigen::Vector3d direction_O =
            X_CO.linear().transpose() * Eigen::Vector3d(ray.x(), ray.y(), 1.0);
        const Eigen::Vector3d eye_O = X_CO.inverse().translation();
        const Eigen::Vector3d at = eye_O - eye_O.z() / direction_O.z() * direction_O;
        return std::abs(at.x()) < 0.06 && std::abs(at.y()) < 0.06;
    };
    for (int row = 0; row < 120; ++row)
        for (int column = 0; column < 160; ++column) {
            bool isAllIn = true,
                 isAnyNear = true; // 1 px around: all in for pixels that count, 3 px: all in is enough
            for (int dy = -3; dy <= 3; ++dy)
                for (int dx = -3; dx <= 3; ++dx) {
                    isAnyNear = isAnyNear && isInside(column + dx, row + dy);
                    if (std::abs(dx) <= 1 && std::abs(dy) <= 1)
                        isAllIn = isAllIn && isInside(column + dx, row + dy);
                }
            const bool isIn = pixels.contains(row * 160 + column);
            if (isIn) {
                EXPECT_TRUE(isAllIn) << column << ' ' << row;
            }
            if (isAnyNear) {
                EXPECT_TRUE(isIn) << column << ' ' << row;
            }
        }
    EXPECT_NEAR(found.angle_rad,
                std::acos(std::abs(X_CO.linear().col(2).dot(X_CO.translation().normalized()))), 1e-9);
}

// Catches: the pose of the camera that is not taken, or taken the wrong way round; front and back exchanged.
TEST(FacePixels, dependOnWhereTheCameraIs) {
    const Pose X_WC =
        poseFromRotationVector({0.1, 0.2, 0.9}, {std::numbers::pi, 0.0, 0.0}); // from above, down
    const PlacedPlate object{Disk{0.05}, poseFromRotationVector({0.1, 0.2, 0.4}, {0.0, 0.0, 0.0})};
    const std::vector<PlacedPlate> objects{object};
    const auto found = facePixels(PixelRays(smallCamera()), X_WC, objects, {});
    ASSERT_TRUE(found[0]);
    EXPECT_FALSE(found[0]->isFront) << "the front looks down, at the source";
    const int middle = found[0]->pixels[found[0]->pixels.size() / 2];
    EXPECT_NEAR(rowOf(middle), 59.5, 1.0);
    const Pose X_WB = poseFromRotationVector({0.1, 0.2, -0.1}, {0.0, 0.0, 0.0}); // from below
    EXPECT_TRUE(facePixels(PixelRays(smallCamera()), X_WB, objects, {})[0]->isFront);
}

// Catches: an object that is measured through another, one that is hidden by what lies behind it, and the
// blurred rim of what is nearer.
TEST(FacePixels, nearerPlatesHideFartherOnes) {
    const PlacedPlate far{Disk{0.06}, placed(0.0, 0.0, 0.6)}, near{Disk{0.02}, placed(0.0, 0.0, 0.4)};
    const FacePixels alone = seen({far}, 0);
    const FacePixels behind = seen({far, near}, 0);
    const FacePixels front = seen({far, near}, 1);
    EXPECT_EQ(front.pixels, seen({near}, 0).pixels);
    const double shadow_px = 200.0 * 0.02 / 0.4;
    for (const int pixel : alone.pixels) {
        const double from = std::hypot(columnOf(pixel) - 79.5, rowOf(pixel) - 59.5);
        const bool isLeft = std::ranges::binary_search(behind.pixels, pixel);
        if (std::abs(from - shadow_px - 1.5) > 0.02) {
            EXPECT_EQ(isLeft, from > shadow_px + 1.5) << from;
        }
    }
    EXPECT_EQ(seen({far}, 0, {near}).pixels, behind.pixels) << "a screen hides as an object does";
    EXPECT_EQ(seen({near}, 0, {far}).pixels, front.pixels);
    // Two that touch in one plane do not hide each other.
    const PlacedPlate left{square(0.04), placed(-0.02, 0.0, 0.5)},
        right{square(0.04), placed(0.02, 0.0, 0.5)};
    EXPECT_EQ(seen({left, right}, 0).pixels, seen({left}, 0).pixels);
}

// Catches: a tilted plate that is called nearer as a whole.
TEST(FacePixels, theNearerPlateIsToldPixelByPixel) {
    // Both through (0, 0, 0.5); turned opposite ways, so that each is nearer on one side.
    const PlacedPlate a{square(0.1), placed(0.0, 0.0, 0.5, 0.0, 0.4)},
        b{square(0.1), placed(0.0, 0.0, 0.5, 0.0, -0.4)};
    const FacePixels ofA = seen({a, b}, 0), ofB = seen({a, b}, 1);
    const auto isLeft = [](int pixel) { return pixel % 160 < 79.5; };
    EXPECT_EQ(std::ranges::count_if(ofA.pixels, isLeft) > 0, std::ranges::count_if(ofB.pixels, isLeft) == 0);
    EXPECT_GT(ofA.pixels.size(), 300U);
    EXPECT_GT(ofB.pixels.size(), 300U);
    std::vector<int> both;
    std::ranges::set_intersection(ofA.pixels, ofB.pixels, std::back_inserter(both));
    EXPECT_TRUE(both.empty());
}

// Catches: a reading of what is not seen.
TEST(FacePixels, sayWhyAnObjectIsNotSeen) {
    const PlacedPlate good{Disk{0.05}, placed(0.0, 0.0, 0.5)};
    EXPECT_EQ(refusal({good}, 0), MessageCode::None);
    EXPECT_EQ(refusal({{Disk{0.05}, placed(1.0, 0.0, 0.5)}}, 0), MessageCode::ThermalFaceOutside);
    EXPECT_EQ(refusal({{Disk{0.05}, placed(0.0, 0.0, -0.5)}}, 0), MessageCode::ThermalFaceOutside);
    EXPECT_EQ(refusal({{Disk{0.005}, placed(0.0, 0.0, 0.5)}}, 0), MessageCode::ThermalFaceSmall);
    EXPECT_EQ(refusal({good, {Disk{0.05}, placed(0.0, 0.0, 0.4)}}, 0), MessageCode::ThermalFaceHidden);
    EXPECT_EQ(refusal({good}, 0, {{Disk{0.05}, placed(0.0, 0.0, 0.4)}}), MessageCode::ThermalFaceHidden);
    const double edge = std::numbers::pi / 2.0;
    EXPECT_EQ(refusal({{Disk{0.05}, placed(0.0, 0.0, 0.5, edge - radFromDeg(0.9))}}, 0),
              MessageCode::ThermalFaceGrazing);
    EXPECT_EQ(refusal({{Disk{0.05}, placed(0.0, 0.0, 0.5, edge)}}, 0), MessageCode::ThermalFaceGrazing);
    EXPECT_NE(refusal({{Disk{0.05}, placed(0.0, 0.0, 0.5, edge - radFromDeg(1.1))}}, 0),
              MessageCode::ThermalFaceGrazing);
}

// Catches: an object at the rim, or one that reaches behind the camera, that is drawn elsewhere.
TEST(FacePixels, whatLeavesThePictureIsSeenInPart) {
    const FacePixels half = seen({{Disk{0.05}, placed(0.2, 0.0, 0.5)}}, 0); // its middle on column 159.5
    EXPECT_FALSE(half.isWhole);
    for (const int pixel : half.pixels)
        EXPECT_LT(std::hypot(columnOf(pixel) - 159.5, rowOf(pixel) - 59.5), 20.0);
    EXPECT_TRUE(std::ranges::any_of(half.pixels, [](int pixel) { return pixel % 160 == 159; }))
        << "the rim of the picture is no edge of the object";
    // A ground of 4 m that reaches below and behind the camera fills the lower part of the picture.
    const FacePixels ground = seen({{square(4.0), placed(0.0, 0.3, 0.5, std::numbers::pi / 2.0)}}, 0, {},
                                   smallCamera({-0.35, 0.12, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(ground.isWhole);
    for (const int pixel : ground.pixels)
        EXPECT_GT(pixel / 160, 59);
    EXPECT_TRUE(std::ranges::binary_search(ground.pixels, 119 * 160 + 80));
}

TEST(FacePixels, aBrokenContractThrows) {
    const PixelRays rays(smallCamera());
    const std::vector<PlacedPlate> objects{{Disk{0.05}, placed(0.0, 0.0, 0.5)}};
    EXPECT_THROW((void)facePixels(rays, Pose::Identity(), objects, {}, {.blur_px = 1.0}),
                 std::invalid_argument);
    EXPECT_THROW((void)facePixels(rays, Pose::Identity(), objects, {}, {.minPixels = 0}),
                 std::invalid_argument);
    EXPECT_THROW((void)facePixels(rays, Pose::Identity(), objects, {}, {.sight = {-0.001, 0.0}}),
                 std::invalid_argument);
    CameraModel camera = smallCamera();
    camera.width = 0;
    EXPECT_THROW(PixelRays{camera}, std::invalid_argument);
}

} // namespace bask
