// True lengths from a picture: by pixels per mm, by a known length, by a marker in any perspective.

#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/hausdorff.h"
#include "tests/engine/shape/picture_samples.h"

#include <Eigen/Geometry>

namespace bask {
namespace {

constexpr double kSide_mm = 40.0;

/// A pinhole camera over the plane z = 0, tilted about x and turned about its axis; px as in `rendered`.
struct Camera {
    double tilt = 0.0, turn = 0.0; // rad
    double distance_mm = 500.0, focal_px = 1500.0;
    cv::Size size{1200, 900};
    Eigen::Vector2d aim_mm{70.0, 20.0};

    /// Where on the plane a pixel looks.
    Eigen::Vector2d seen(double x, double y) const {
        const Eigen::Matrix3d R = (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                                   Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()))
                                      .toRotationMatrix();
        const Eigen::Vector3d ray =
            R * Eigen::Vector3d((x - 0.5 * size.width) / focal_px, -(y - 0.5 * size.height) / focal_px, -1.0);
        const Eigen::Vector3d eye = R * Eigen::Vector3d(0.0, 0.0, distance_mm);
        const Eigen::Vector3d p = eye - eye.z() / ray.z() * ray;
        return aim_mm + p.head<2>();
    }
};

constexpr double kA_mm = 30.0, kB_mm = 18.0, kHole_mm = 6.0;
const Eigen::Vector2d kMiddle_mm(105.0, 20.0);

/// Marker at the origin, white ground, a grey ellipse with a round hole beside it.
cv::Vec3d scene(const Eigen::Vector2d& p_mm) {
    const Eigen::Vector2d m = p_mm / kSide_mm;
    if (m.minCoeff() > 0.0 && m.maxCoeff() < 1.0)
        return cv::Vec3d::all(test::isMarkerBlack(m.x(), m.y()) ? 0.05 : 0.9);
    const Eigen::Vector2d d = p_mm - kMiddle_mm;
    const bool inside = std::hypot(d.x() / kA_mm, d.y() / kB_mm) < 1.0 && d.norm() > kHole_mm;
    return cv::Vec3d::all(inside ? 0.3 : 0.9);
}

cv::Mat3b photo(const Camera& camera) {
    cv::Mat3b image =
        test::rendered(camera.size, 5, [&](double x, double y) { return scene(camera.seen(x, y)); });
    cv::GaussianBlur(image, image, cv::Size(), 0.7);
    cv::Mat noise(image.size(), CV_16SC3), noisy;
    cv::RNG(7).fill(noise, cv::RNG::NORMAL, 0, 2);
    image.convertTo(noisy, CV_16SC3);
    noisy += noise;
    noisy.convertTo(image, CV_8UC3);
    return image;
}

ContourImportOptions byMarker(double side_m = kSide_mm * 1e-3, const char* dictionary = "4X4_50") {
    return {.marker = ReferenceMarker{side_m, dictionary}};
}

// Catches: perspective not undone, corners half a pixel off, the marker taken for an object, holes lost.
TEST(PictureScale, AMarkerUndoesThePerspective) {
    test::Points truth = test::ellipse(kA_mm * 1e-3, kB_mm * 1e-3, 720, kMiddle_mm * 1e-3);
    const double area_m2 = std::numbers::pi * kA_mm * kB_mm * 1e-6;
    for (const Camera& camera : {Camera{}, Camera{.tilt = 0.5, .turn = 0.4},
                                 Camera{.tilt = 0.8, .turn = -1.2}, Camera{.tilt = -0.8, .turn = 2.8}}) {
        const std::string where = "tilt " + formatNumber(camera.tilt);
        const auto file = readOutlines(test::picture(photo(camera)), byMarker());
        ASSERT_TRUE(file) << where << describe(file.error());
        ASSERT_EQ(file->outlines.size(), 2U) << where;
        EXPECT_TRUE(file->warnings.empty());
        const FileOutline &outer = file->outlines[0], &hole = file->outlines[1];
        EXPECT_NEAR(outer.area_m2(), area_m2, 3e-3 * area_m2) << where;
        EXPECT_LT(hausdorffDistance(outer.points_m, truth, 1e-7), 0.12e-3) << where;
        EXPECT_TRUE(hole.hole);
        const double hole_m2 = std::numbers::pi * kHole_mm * kHole_mm * 1e-6;
        EXPECT_NEAR(hole.area_m2(), hole_m2, 0.01 * hole_m2) << where;
    }
}

// Catches a marker of another dictionary or none taken for one, and bad sizes accepted.
TEST(PictureScale, RefusesAMarkerThatIsNotThere) {
    const std::string path = test::picture(photo(Camera{}));
    const auto code = [&](const std::string& file, const ContourImportOptions& options) {
        const auto outlines = readOutlines(file, options);
        return outlines ? MessageCode::None : outlines.error().code();
    };
    EXPECT_EQ(code(path, byMarker(0.04, "6X6_250")), MessageCode::MarkerNotFound);
    EXPECT_EQ(code(test::examplePath("bunny_1200.png"), byMarker()), MessageCode::MarkerNotFound);
    EXPECT_EQ(code(path, byMarker(0.04, "9X9")), MessageCode::ValueUnknown);
    for (const double side_m : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_EQ(code(path, byMarker(side_m)), MessageCode::ValueNotPositive);
    EXPECT_EQ(code(path, byMarker(0.04, "dict_4x4_50")), MessageCode::None);
}

// Catches a scale silently taken from one of two, and a picture read without any.
TEST(PictureScale, IsOneOfThree) {
    const std::string bunny = test::examplePath("bunny_1200.png");
    const auto typed = readContour(bunny, {.scale_px_per_mm = 15.0});
    ContourImportOptions known{.knownLength = KnownLength{{100.0, 100.0}, {1000.0, 1300.0}, 0.1}}; // 1500 px
    const auto measured = readContour(bunny, known);
    ASSERT_TRUE(typed);
    ASSERT_TRUE(measured) << describe(measured.error());
    EXPECT_EQ(typed->points_m, measured->points_m);
    known.scale_px_per_mm = 15.0;
    EXPECT_EQ(readOutlines(bunny, known).error().code(), MessageCode::ScaleTwice);
    EXPECT_EQ(readOutlines(bunny, {}).error().code(), MessageCode::ScaleMissing);
    for (const double length_m : {0.0, -0.1, std::nan("")}) {
        const ContourImportOptions bad{.knownLength = KnownLength{{0.0, 0.0}, {9.0, 0.0}, length_m}};
        EXPECT_EQ(readOutlines(bunny, bad).error().code(), MessageCode::ScaleNotPositive) << length_m;
    }
    const ContourImportOptions onePoint{.knownLength = KnownLength{{5.0, 5.0}, {5.0, 5.0}, 0.1}};
    EXPECT_EQ(readOutlines(bunny, onePoint).error().code(), MessageCode::ScaleNotPositive);
}

} // namespace
} // namespace bask
